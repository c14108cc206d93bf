// What the generated part of a plugin is made with. That part is tables, and for each rule a function that passes plain
// arguments on; everything else of plugin.h is here.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <utility>

#include "jrule/map.h"
#include "jrule/operation.h"
#include "jrule/plugin.h"
#include "jrule/result.h"
#include "jrule/rewrite.h"

#if defined(_WIN32)
#define JRULE_PLUGIN_EXPORT __declspec(dllexport)
#else
#define JRULE_PLUGIN_EXPORT __attribute__((visibility("default")))
#endif

namespace jrule::plugin {

/// An object of a modeler's class, whichever it is.
class AnyMap {
 public:
  AnyMap() = default;
  virtual ~AnyMap() = default;
  AnyMap(AnyMap const&) = delete;
  AnyMap& operator=(AnyMap const&) = delete;

  virtual std::unique_ptr<AnyMap> copy() const = 0;
  virtual Map const& map() const = 0;
  virtual Map& map() = 0;
  virtual rewrite::Workspace& workspace() = 0;
};

template <class Modeler>
class MapOf final : public AnyMap {
 public:
  explicit MapOf(Modeler value) : modeler(std::move(value)) {}
  std::unique_ptr<AnyMap> copy() const override {
    return std::make_unique<MapOf>(Modeler::from_map(modeler.map()).value());  // without the scratch memory
  }
  Map const& map() const override { return modeler.map(); }
  Map& map() override { return modeler.map(); }
  rewrite::Workspace& workspace() override { return modeler.workspace(); }

  Modeler modeler;
};

/// The modeler's object that it is known to be.
template <class Modeler>
Modeler& as(AnyMap& map) {
  return static_cast<MapOf<Modeler>&>(map).modeler;
}

struct ModelerCode {
  std::unique_ptr<AnyMap> (*create)();
  Result<std::unique_ptr<AnyMap>> (*read)(std::string const& path);
};
template <class Modeler>
constexpr ModelerCode modeler_code{[] { return std::unique_ptr<AnyMap>(std::make_unique<MapOf<Modeler>>(Modeler())); },
                                   [](std::string const& path) -> Result<std::unique_ptr<AnyMap>> {
                                     auto modeler = Modeler::read(path);
                                     if (!modeler) return tl::unexpected(std::move(modeler).error());
                                     return std::make_unique<MapOf<Modeler>>(std::move(*modeler));
                                   }};

/// The code of a rule. The map is of its modeler, hooks and arguments are as many as its hooks and parameters, the
/// arguments of their types.
struct RuleCode {
  /// Writes a dart for each node. Null: the rule is not callable.
  Result<void> (*apply)(AnyMap& map, Dart const* hooks, Value const* arguments, Dart* darts) = nullptr;
  /// All orbits of the hook at once. Null: they are not independent.
  Result<void> (*apply_at_once)(AnyMap& map, Value const* arguments) = nullptr;
  OrbitType (*orbit)() = nullptr;                              ///< of the hook; null unless there is one hook
  Value (*computed_default)(std::size_t parameter) = nullptr;  ///< of JRULE_COMPUTED_DEFAULT; null if there is none
  /// Of an operation, which has nothing else but defaults. Writes its result, if that is a dart.
  Result<void> (*run)(AnyMap& map, Dart const* darts, Value const* arguments, operation::Progress const& progress,
                      Dart* result) = nullptr;
};

/// What a plugin consists of. `code` is by modeler, `rule_code` by rule.
struct Table {
  char const* name;
  std::span<jrule_modeler const> modelers;
  std::span<ModelerCode const> modeler_code;
  std::span<jrule_rule const> rules;
  std::span<RuleCode const> rule_code;
  std::uint32_t first_operation;  ///< among the rules
};

/// The functions of plugin.h, of the plugin of a table. They have C++ linkage, for their names are not to be seen; how
/// they are called is the same.
std::int32_t create(Table const& table, std::uint32_t modeler, jrule_map** map, jrule_error* error) noexcept;
std::int32_t read(Table const& table, std::uint32_t modeler, char const* path, jrule_map** map,
                  jrule_error* error) noexcept;
std::int32_t copy(Table const& table, jrule_map const* map, jrule_map** other, jrule_error* error) noexcept;
std::int32_t write(Table const& table, jrule_map const* map, char const* path, jrule_error* error) noexcept;
void destroy(Table const& table, jrule_map* map) noexcept;
std::int32_t apply(Table const& table, jrule_map* map, std::uint32_t rule, jrule_dart const* hooks,
                   std::uint32_t hook_count, jrule_value const* arguments, std::uint32_t argument_count,
                   jrule_dart* darts, std::uint32_t capacity, jrule_error* error) noexcept;
std::int32_t apply_everywhere(Table const& table, jrule_map* map, std::uint32_t rule, jrule_value const* arguments,
                              std::uint32_t argument_count, jrule_progress const* progress,
                              jrule_error* error) noexcept;
std::int32_t run(Table const& table, jrule_map* map, std::uint32_t operation, jrule_dart const* darts,
                 std::uint32_t dart_count, jrule_value const* arguments, std::uint32_t argument_count,
                 jrule_progress const* progress, jrule_dart* results, std::uint32_t capacity,
                 jrule_error* error) noexcept;
std::int32_t modeler_of(Table const& table, jrule_map const* map, std::uint32_t* modeler, jrule_error* error) noexcept;
std::int32_t summarize(Table const& table, jrule_map const* map, jrule_summary* summary, jrule_error* error) noexcept;
std::int32_t count_darts(Table const& table, jrule_map const* map, std::uint32_t* count, std::uint32_t* limit,
                         jrule_error* error) noexcept;
std::int32_t contains(Table const& table, jrule_map const* map, jrule_dart dart, std::int32_t* is_there,
                      jrule_error* error) noexcept;
std::int32_t target(Table const& table, jrule_map const* map, jrule_dart dart, std::int32_t dimension, jrule_dart* to,
                    jrule_error* error) noexcept;
std::int32_t source(Table const& table, jrule_map const* map, jrule_dart dart, std::int32_t dimension, jrule_dart* from,
                    jrule_error* error) noexcept;
std::int32_t cells(Table const& table, jrule_map const* map, std::int32_t dimension, jrule_dart* darts,
                   std::uint32_t capacity, std::uint32_t* count, jrule_error* error) noexcept;
std::int32_t orbit(Table const& table, jrule_map const* map, jrule_dart dart, std::int32_t const* dimensions,
                   std::uint32_t dimension_count, jrule_dart* darts, std::uint32_t capacity, std::uint32_t* count,
                   jrule_error* error) noexcept;
std::int32_t value(Table const& table, jrule_map const* map, std::uint32_t embedding, jrule_dart dart,
                   jrule_value* value, jrule_error* error) noexcept;
std::int32_t set_value(Table const& table, jrule_map* map, std::uint32_t embedding, jrule_dart dart,
                       jrule_value const* value, jrule_error* error) noexcept;

/// A function of plugin.h from one of the above: `Of<table, write>::call`.
template <Table const& table, auto function>
struct Of;
template <Table const& table, class Result, class... Arguments, Result (*function)(Table const&, Arguments...) noexcept>
struct Of<table, function> {
  static Result call(Arguments... arguments) noexcept { return function(table, arguments...); }
};

/// The entry of the plugin of a table, which is a constant.
template <Table const& table>
constexpr jrule_plugin entry() {
  return {
      .abi_version = JRULE_PLUGIN_ABI_VERSION,
      .struct_size = sizeof(jrule_plugin),
      .error_size = sizeof(jrule_error),
      .value_size = sizeof(jrule_value),
      .embedding_size = sizeof(jrule_embedding),
      .modeler_size = sizeof(jrule_modeler),
      .hook_size = sizeof(jrule_hook),
      .parameter_size = sizeof(jrule_parameter),
      .node_size = sizeof(jrule_node),
      .rule_size = sizeof(jrule_rule),
      .summary_size = sizeof(jrule_summary),
      .progress_size = sizeof(jrule_progress),
      .name = table.name,
      .modeler_count = static_cast<std::uint32_t>(table.modelers.size()),
      .rule_count = static_cast<std::uint32_t>(table.rules.size()),
      .modelers = table.modelers.data(),
      .rules = table.rules.data(),
      .create = Of<table, plugin::create>::call,
      .read = Of<table, plugin::read>::call,
      .copy = Of<table, plugin::copy>::call,
      .write = Of<table, plugin::write>::call,
      .destroy = Of<table, plugin::destroy>::call,
      .apply = Of<table, plugin::apply>::call,
      .apply_everywhere = Of<table, plugin::apply_everywhere>::call,
      .modeler_of = Of<table, plugin::modeler_of>::call,
      .summarize = Of<table, plugin::summarize>::call,
      .count_darts = Of<table, plugin::count_darts>::call,
      .contains = Of<table, plugin::contains>::call,
      .target = Of<table, plugin::target>::call,
      .source = Of<table, plugin::source>::call,
      .cells = Of<table, plugin::cells>::call,
      .orbit = Of<table, plugin::orbit>::call,
      .value = Of<table, plugin::value>::call,
      .set_value = Of<table, plugin::set_value>::call,
      .first_operation = table.first_operation,
      .run = Of<table, plugin::run>::call,
  };
}

}  // namespace jrule::plugin
