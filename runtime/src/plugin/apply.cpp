// Rules of a plugin, applied.
#include <fmt/format.h>

#include <utility>
#include <vector>

#include "opaque_map.h"
#include "values.h"

namespace jrule::plugin {

namespace {

Outcome check_count(jrule_rule const& rule, char const* what, void const* given, std::uint32_t count,
                    std::uint32_t expected) {
  if (count != expected)
    return bad_argument(
        fmt::format("`{}` has {} {}{}, not {}", rule.name, expected, what, expected == 1 ? "" : "s", count));
  if (count != 0 && given == nullptr) return bad_argument(fmt::format("the {}s of `{}` are null", what, rule.name));
  return {};
}

// The rule, if it can be applied to the map.
tl::expected<jrule_rule const*, Failure> find_rule(Table const& table, jrule_map const* map, std::uint32_t rule) {
  if (auto const valid = check_map(table, map); !valid) return tl::unexpected(valid.error());
  if (rule >= table.rules.size())
    return bad_argument(fmt::format("there is no rule {}: the plugin has {}", rule, table.rules.size()));
  jrule_rule const& found = table.rules[rule];
  if (found.not_callable != nullptr)
    return bad_argument(fmt::format("`{}` cannot be called: {}", found.name, found.not_callable));
  if (found.modeler != map->modeler) {
    return bad_argument(fmt::format("`{}` works on maps of `{}`, not of `{}`", found.name,
                                    table.modelers[found.modeler].name, table.modelers[map->modeler].name));
  }
  return &found;
}

tl::expected<Value, Failure> default_of(jrule_rule const& rule, RuleCode const& code, std::size_t p) {
  jrule_parameter const& parameter = rule.parameters[p];
  std::string const what = fmt::format("the parameter `{}` of `{}`", parameter.name, rule.name);
  if (parameter.default_kind == JRULE_COMPUTED_DEFAULT) return code.computed_default(p);
  if (parameter.default_kind == JRULE_NO_DEFAULT) return bad_argument(what + " has no default");
  return from_c(parameter.default_value, static_cast<Type>(parameter.type), what);
}

tl::expected<std::vector<Value>, Failure> convert(jrule_rule const& rule, RuleCode const& code,
                                                  jrule_value const* arguments, std::uint32_t count) {
  if (auto const counted = check_count(rule, "parameter", arguments, count, rule.parameter_count); !counted) {
    return tl::unexpected(counted.error());
  }
  std::vector<Value> values;
  for (std::uint32_t p = 0; p < count; ++p) {
    jrule_parameter const& parameter = rule.parameters[p];
    auto value = arguments[p].type == JRULE_DEFAULT
                     ? default_of(rule, code, p)
                     : from_c(arguments[p], static_cast<Type>(parameter.type),
                              fmt::format("the parameter `{}` of `{}`", parameter.name, rule.name));
    if (!value) return tl::unexpected(std::move(value).error());
    values.push_back(*value);
  }
  return values;
}

// True: go on.
bool go_on(jrule_progress const* progress, double done) {
  return progress == nullptr || progress->report == nullptr || progress->report(progress->user, done) == 0;
}

struct Cancelled {};

// On a copy, so that neither an error nor a host that cancels leaves the map half done.
Outcome apply_in_turn(jrule_map& map, jrule_rule const& rule, RuleCode const& code, std::vector<Value> const& arguments,
                      jrule_progress const* progress) {
  std::unique_ptr<AnyMap> changed = map.content->copy();
  std::vector<Dart> darts(rule.node_count);
  Dart const limit = changed->map().dart_limit();
  try {
    auto const applied = rewrite::apply_everywhere(changed->map(), code.orbit(), [&](Dart at) -> Result<void> {
      // The smallest darts of the orbits ascend.
      if (!go_on(progress, static_cast<double>(at) / limit)) throw Cancelled{};
      return code.apply(*changed, &at, arguments.data(), darts.data());
    });
    if (!applied) return failed(applied.error());
  } catch (Cancelled const&) {
    return cancelled(rule.name);
  }
  map.content = std::move(changed);
  return {};
}

}  // namespace

namespace {

// `progress` is asked by operations only.
Outcome apply_once(Table const& table, jrule_map* map, std::uint32_t rule, jrule_dart const* hooks, std::uint32_t hook_count,
                   jrule_value const* arguments, std::uint32_t argument_count, jrule_progress const* progress,
                   jrule_dart* darts, std::uint32_t capacity) {
  auto const found = find_rule(table, map, rule);
  if (!found) return tl::unexpected(found.error());
  jrule_rule const& known = **found;
  RuleCode const& code = table.rule_code[rule];
  if (auto const counted = check_count(known, "hook", hooks, hook_count, known.hook_count); !counted) return counted;
  if (darts == nullptr ? capacity != 0 : capacity < known.node_count) {
    return bad_argument(
        fmt::format("`{}` gives {} darts: there has to be room for them, or null and 0", known.name, known.node_count));
  }
  auto const values = convert(known, code, arguments, argument_count);
  if (!values) return tl::unexpected(values.error());
  std::vector<Dart> result(known.node_count);
  auto const ask = [&](std::size_t) { return go_on(progress, 0); };
  auto const applied = code.run == nullptr ? code.apply(*map->content, hooks, values->data(), result.data())
                                           : code.run(*map->content, hooks, values->data(), ask, result.data());
  if (!applied) return failed(applied.error());
  if (darts != nullptr) std::copy(result.begin(), result.end(), darts);
  return {};
}

}  // namespace

std::int32_t apply(Table const& table, jrule_map* map, std::uint32_t rule, jrule_dart const* hooks,
                   std::uint32_t hook_count, jrule_value const* arguments, std::uint32_t argument_count,
                   jrule_dart* darts, std::uint32_t capacity, jrule_error* error) noexcept {
  return guarded(error, [&] {
    return apply_once(table, map, rule, hooks, hook_count, arguments, argument_count, nullptr, darts, capacity);
  });
}

std::int32_t run(Table const& table, jrule_map* map, std::uint32_t operation, jrule_dart const* darts,
                 std::uint32_t dart_count, jrule_value const* arguments, std::uint32_t argument_count,
                 jrule_progress const* progress, jrule_dart* results, std::uint32_t capacity,
                 jrule_error* error) noexcept {
  return guarded(error, [&]() -> Outcome {
    if (operation < table.first_operation) return bad_argument(fmt::format("{} is a rule, not an operation", operation));
    return apply_once(table, map, operation, darts, dart_count, arguments, argument_count, progress, results, capacity);
  });
}

std::int32_t apply_everywhere(Table const& table, jrule_map* map, std::uint32_t rule, jrule_value const* arguments,
                              std::uint32_t argument_count, jrule_progress const* progress,
                              jrule_error* error) noexcept {
  return guarded(error, [&]() -> Outcome {
    auto const found = find_rule(table, map, rule);
    if (!found) return tl::unexpected(found.error());
    jrule_rule const& known = **found;
    RuleCode const& code = table.rule_code[rule];
    if (code.run != nullptr) return bad_argument(fmt::format("`{}` is an operation, which is not applied everywhere", known.name));
    if (known.hook_count != 1) {
      return bad_argument(fmt::format("`{}` has {} hooks: only a rule of one hook can be applied everywhere",
                                      known.name, known.hook_count));
    }
    auto const values = convert(known, code, arguments, argument_count);
    if (!values) return tl::unexpected(values.error());
    if (!go_on(progress, 0)) return cancelled(known.name);
    if (code.apply_at_once != nullptr) {
      if (auto const applied = code.apply_at_once(*map->content, values->data()); !applied)
        return failed(applied.error());
    } else if (auto const applied = apply_in_turn(*map, known, code, *values, progress); !applied) {
      return applied;
    }
    // All is done: what the host answers, or throws, comes too late.
    try {
      (void)go_on(progress, 1);
    } catch (...) {
    }
    return {};
  });
}

}  // namespace jrule::plugin
