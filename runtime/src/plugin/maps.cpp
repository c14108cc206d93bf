// Maps of a plugin: where they come from and where they go.
#include <fmt/format.h>

#include <utility>

#include "jrule/io.h"
#include "opaque_map.h"

namespace jrule::plugin {

namespace {

Outcome check_modeler(Table const& table, std::uint32_t modeler) {
  if (modeler < table.modelers.size()) return {};
  return bad_argument(fmt::format("there is no modeler {}: the plugin has {}", modeler, table.modelers.size()));
}

jrule_map* hand_out(Table const& table, std::uint32_t modeler, std::unique_ptr<AnyMap> content) {
  return new jrule_map{&table, modeler, std::move(content)};
}

}  // namespace

Outcome check_pointer(void const* pointer, char const* what) {
  if (pointer != nullptr) return {};
  return bad_argument(fmt::format("{} is null", what));
}

Outcome check_map(Table const& table, jrule_map const* map) {
  if (auto const given = check_pointer(map, "the map"); !given) return given;
  if (map->table != &table) return bad_argument("the map is not of this plugin");
  return {};
}

std::int32_t create(Table const& table, std::uint32_t modeler, jrule_map** map, jrule_error* error) noexcept {
  return guarded(error, [&]() -> Outcome {
    if (auto const given = check_pointer(map, "the pointer to the new map"); !given) return given;
    if (auto const known = check_modeler(table, modeler); !known) return known;
    *map = hand_out(table, modeler, table.modeler_code[modeler].create());
    return {};
  });
}

std::int32_t read(Table const& table, std::uint32_t modeler, char const* path, jrule_map** map,
                  jrule_error* error) noexcept {
  return guarded(error, [&]() -> Outcome {
    if (auto const given = check_pointer(map, "the pointer to the new map"); !given) return given;
    if (auto const given = check_pointer(path, "the path"); !given) return given;
    if (auto const known = check_modeler(table, modeler); !known) return known;
    auto content = table.modeler_code[modeler].read(path);
    if (!content) return failed(std::move(content).error());
    *map = hand_out(table, modeler, std::move(*content));
    return {};
  });
}

std::int32_t copy(Table const& table, jrule_map const* map, jrule_map** other, jrule_error* error) noexcept {
  return guarded(error, [&]() -> Outcome {
    if (auto const valid = check_map(table, map); !valid) return valid;
    if (auto const given = check_pointer(other, "the pointer to the new map"); !given) return given;
    *other = hand_out(table, map->modeler, map->content->copy());
    return {};
  });
}

std::int32_t write(Table const& table, jrule_map const* map, char const* path, jrule_error* error) noexcept {
  return guarded(error, [&]() -> Outcome {
    if (auto const valid = check_map(table, map); !valid) return valid;
    if (auto const given = check_pointer(path, "the path"); !given) return given;
    if (auto written = write_map(std::as_const(*map->content).map(), path); !written)
      return failed(std::move(written).error());
    return {};
  });
}

void destroy(Table const& table, jrule_map* map) noexcept {
  if (map != nullptr && map->table == &table) delete map;
}

}  // namespace jrule::plugin
