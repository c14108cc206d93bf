// Questions to the maps of a plugin, and values set by hand.
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

#include "opaque_map.h"
#include "values.h"

namespace jrule::plugin {

namespace {

Map const& map_of(jrule_map const* map) { return std::as_const(*map->content).map(); }

Outcome check_dart(jrule_map const* map, Dart dart) {
  if (map_of(map).contains(dart)) return {};
  return bad_argument(fmt::format("the map has no dart {}", dart));
}

Outcome check_dimension(jrule_map const* map, std::int32_t dimension) {
  if (map_of(map).model().has(dimension)) return {};
  return bad_argument(fmt::format("the map has no arcs of dimension {}", dimension));
}

// The map, the dart and the embedding, of a type of the language.
Outcome check_value(Table const& table, jrule_map const* map, std::uint32_t embedding, Dart dart, void const* value) {
  if (auto const valid = check_map(table, map); !valid) return valid;
  if (auto const given = check_pointer(value, "the pointer to the value"); !given) return given;
  if (auto const there = check_dart(map, dart); !there) return there;
  std::size_t const count = map_of(map).embedding_count();
  if (embedding >= count)
    return bad_argument(fmt::format("there is no embedding {}: the map has {}", embedding, count));
  EmbeddingSpec const& spec = map_of(map).embedding(embedding).spec();
  if (spec.type != Type::Extern) return {};
  return bad_argument(fmt::format("the values of `{}` are of the C++ type `{}`", spec.name, spec.extern_name));
}

// As many darts as there is room for, and how many they are.
Outcome hand_out(std::vector<Dart> const& found, Dart* darts, std::uint32_t capacity, std::uint32_t* count) {
  *count = static_cast<std::uint32_t>(found.size());
  std::copy_n(found.begin(), std::min<std::size_t>(capacity, found.size()), darts);
  return {};
}

Outcome check_room(Dart const* darts, std::uint32_t capacity, std::uint32_t const* count) {
  if (capacity != 0 && darts == nullptr) return bad_argument("the pointer to the darts is null");
  return check_pointer(count, "the pointer to the count");
}

// `read` is Map::target or Map::source.
template <class Read>
std::int32_t follow(Table const& table, jrule_map const* map, Dart dart, std::int32_t dimension, Dart* end,
                    jrule_error* error, Read read) noexcept {
  return guarded(error, [&]() -> Outcome {
    if (auto const valid = check_map(table, map); !valid) return valid;
    if (auto const given = check_pointer(end, "the pointer to the dart"); !given) return given;
    if (auto const there = check_dart(map, dart); !there) return there;
    if (auto const known = check_dimension(map, dimension); !known) return known;
    *end = read(map_of(map), dart, dimension);
    return {};
  });
}

}  // namespace

std::int32_t modeler_of(Table const& table, jrule_map const* map, std::uint32_t* modeler, jrule_error* error) noexcept {
  return guarded(error, [&]() -> Outcome {
    if (auto const valid = check_map(table, map); !valid) return valid;
    if (auto const given = check_pointer(modeler, "the pointer to the modeler"); !given) return given;
    *modeler = map->modeler;
    return {};
  });
}

std::int32_t summarize(Table const& table, jrule_map const* map, jrule_summary* summary, jrule_error* error) noexcept {
  return guarded(error, [&]() -> Outcome {
    if (auto const valid = check_map(table, map); !valid) return valid;
    if (auto const given = check_pointer(summary, "the pointer to the summary"); !given) return given;
    Summary const found = jrule::summarize(map_of(map));
    jrule_summary result{};
    static_assert(std::size(jrule_summary{}.cells) == max_dimension + 1);
    result.darts = found.darts;
    std::copy(found.cells.begin(), found.cells.end(), result.cells);
    result.components = found.components;
    result.euler = found.euler;
    result.boundary_darts = found.boundary_darts;
    result.orientable = found.orientable ? 1 : 0;
    result.valid = found.valid ? 1 : 0;
    *summary = result;
    return {};
  });
}

std::int32_t count_darts(Table const& table, jrule_map const* map, std::uint32_t* count, std::uint32_t* limit,
                         jrule_error* error) noexcept {
  return guarded(error, [&]() -> Outcome {
    if (auto const valid = check_map(table, map); !valid) return valid;
    if (count != nullptr) *count = static_cast<std::uint32_t>(map_of(map).dart_count());
    if (limit != nullptr) *limit = map_of(map).dart_limit();
    return {};
  });
}

std::int32_t contains(Table const& table, jrule_map const* map, jrule_dart dart, std::int32_t* is_there,
                      jrule_error* error) noexcept {
  return guarded(error, [&]() -> Outcome {
    if (auto const valid = check_map(table, map); !valid) return valid;
    if (auto const given = check_pointer(is_there, "the pointer to the answer"); !given) return given;
    *is_there = map_of(map).contains(dart) ? 1 : 0;
    return {};
  });
}

std::int32_t target(Table const& table, jrule_map const* map, jrule_dart dart, std::int32_t dimension, jrule_dart* to,
                    jrule_error* error) noexcept {
  return follow(table, map, dart, dimension, to, error, [](Map const& m, Dart d, int i) { return m.target(d, i); });
}

std::int32_t source(Table const& table, jrule_map const* map, jrule_dart dart, std::int32_t dimension, jrule_dart* from,
                    jrule_error* error) noexcept {
  return follow(table, map, dart, dimension, from, error, [](Map const& m, Dart d, int i) { return m.source(d, i); });
}

std::int32_t cells(Table const& table, jrule_map const* map, std::int32_t dimension, jrule_dart* darts,
                   std::uint32_t capacity, std::uint32_t* count, jrule_error* error) noexcept {
  return guarded(error, [&]() -> Outcome {
    if (auto const valid = check_map(table, map); !valid) return valid;
    if (auto const room = check_room(darts, capacity, count); !room) return room;
    if (!cell_orbit(map_of(map).model(), dimension))
      return bad_argument(fmt::format("the map has no cells of dimension {}", dimension));
    return hand_out(jrule::cells(map_of(map), dimension), darts, capacity, count);
  });
}

std::int32_t orbit(Table const& table, jrule_map const* map, jrule_dart dart, std::int32_t const* dimensions,
                   std::uint32_t dimension_count, jrule_dart* darts, std::uint32_t capacity, std::uint32_t* count,
                   jrule_error* error) noexcept {
  return guarded(error, [&]() -> Outcome {
    if (auto const valid = check_map(table, map); !valid) return valid;
    if (auto const room = check_room(darts, capacity, count); !room) return room;
    if (auto const there = check_dart(map, dart); !there) return there;
    if (dimension_count > static_cast<std::uint32_t>(max_dimension) + 1)
      return bad_argument("an orbit has each dimension once at most");
    if (dimension_count != 0 && dimensions == nullptr) return bad_argument("the pointer to the dimensions is null");
    std::vector<int> const words(dimensions, dimensions + dimension_count);
    for (int const dimension : words) {
      if (auto const known = check_dimension(map, dimension); !known) return known;
    }
    return hand_out(jrule::orbit(map_of(map), orbit_of_dimensions(words), dart), darts, capacity, count);
  });
}

std::int32_t value(Table const& table, jrule_map const* map, std::uint32_t embedding, jrule_dart dart,
                   jrule_value* value, jrule_error* error) noexcept {
  return guarded(error, [&]() -> Outcome {
    if (auto const valid = check_value(table, map, embedding, dart, value); !valid) return valid;
    Embedding const& values = map_of(map).embedding(embedding);
    Handle const handle = values.handle(dart);
    if (handle == no_handle) return bad_argument(fmt::format("dart {} has no value of `{}`", dart, values.spec().name));
    *value = to_c(values.value(handle));
    return {};
  });
}

std::int32_t set_value(Table const& table, jrule_map* map, std::uint32_t embedding, jrule_dart dart,
                       jrule_value const* value, jrule_error* error) noexcept {
  return guarded(error, [&]() -> Outcome {
    if (auto const valid = check_value(table, map, embedding, dart, value); !valid) return valid;
    EmbeddingSpec const& spec = map_of(map).embedding(embedding).spec();
    auto const converted = from_c(*value, spec.type, fmt::format("the embedding `{}`", spec.name));
    if (!converted) return tl::unexpected(converted.error());
    rewrite::set_value(map->content->map(), embedding, dart, *converted, map->content->workspace());
    return {};
  });
}

}  // namespace jrule::plugin
