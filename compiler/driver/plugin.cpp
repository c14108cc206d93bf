// `jrule apply --plugin` and `jrule info` of a plugin.
#include <fmt/format.h>

#include <stdexcept>

#include "compiler/driver/arguments.h"
#include "compiler/driver/commands.h"
#include "compiler/driver/plugin_host.h"
#include "compiler/driver/report.h"
#include "compiler/driver/summary.h"

namespace jrule::driver {

namespace {

jrule_value to_c(std::optional<Value> const& value) {
  jrule_value result{};
  result.type = JRULE_DEFAULT;
  if (!value) return result;
  result.type = static_cast<std::int32_t>(type_of(*value));
  if (auto const* b = std::get_if<bool>(&*value)) {
    result.integer = *b ? 1 : 0;
  } else if (auto const* i = std::get_if<std::int64_t>(&*value)) {
    result.integer = *i;
  } else {
    for (int k = 0; k < component_count(type_of(*value)); ++k) result.numbers[k] = component(*value, k);
  }
  return result;
}

Value from_c(jrule_value const& value) {
  Type const type = static_cast<Type>(value.type);
  if (type == Type::Bool) return value.integer != 0;
  if (type == Type::Int) return value.integer;
  return from_components(type, value.numbers);
}

Result<std::vector<jrule_value>> parse_arguments(jrule_rule const& rule, std::vector<std::string> const& arguments) {
  std::vector<NamedType> parameters;
  for (std::uint32_t p = 0; p < rule.parameter_count; ++p) {
    jrule_parameter const& parameter = rule.parameters[p];
    parameters.push_back(
        {parameter.name, static_cast<Type>(parameter.type), parameter.default_kind != JRULE_NO_DEFAULT});
  }
  auto const values = parse_arguments(rule.name, parameters, arguments);
  if (!values) return tl::unexpected(values.error());
  std::vector<jrule_value> result;
  for (auto const& value : *values) result.push_back(to_c(value));
  return result;
}

// What is said after "NAME: applied ".
Result<std::string> apply_at(Plugin const& plugin, std::uint32_t number, PluginMap const& map, std::string const& at,
                             std::vector<jrule_value> const& arguments) {
  jrule_rule const& rule = plugin.entry().rules[number];
  std::vector<Dart> hooks;
  if (rule.hook_count == 0) {
    if (!at.empty())
      return fail(Error::Kind::bad_input, fmt::format("`{}` has no hook: `--at` says nothing here", rule.name));
  } else if (number >= plugin.entry().first_operation && (at.empty() || at == "all")) {
    return fail(Error::Kind::bad_input, fmt::format("`{}` takes {} dart{}: give {}, `--at dart:3`", rule.name, rule.hook_count,
                                                    rule.hook_count == 1 ? "" : "s", rule.hook_count == 1 ? "it" : "them"));
  } else if (at.empty() || at == "all") {
    if (rule.hook_count > 1) {
      return fail(Error::Kind::bad_input, fmt::format("`{}` has {} hooks: give a dart for each, `--at dart:3,dart:17`",
                                                      rule.name, rule.hook_count));
    }
    auto const applied = plugin.apply_everywhere(map, number, arguments);
    if (!applied) return tl::unexpected(applied.error());
    return "everywhere";
  } else {
    auto const selected = plugin.select(map, at);
    if (!selected) return tl::unexpected(selected.error());
    hooks = *selected;
  }
  auto const applied = plugin.apply(map, number, hooks, arguments);
  if (!applied) return tl::unexpected(applied.error());
  return "once";
}

Result<PluginMap> read_input(Plugin const& plugin, jrule_rule const& rule, std::string const& path) {
  if (!path.empty()) return plugin.read(rule.modeler, path);
  if (rule.hook_count == 0) return plugin.create(rule.modeler);
  return fail(Error::Kind::bad_input, fmt::format("`{}` is applied to a mesh: give one with `--in`", rule.name));
}

Result<void> apply_and_print(ApplyOptions const& options) {
  if (!options.picture.empty())
    return fail(Error::Kind::bad_input, "`--picture` draws what rules of a source file give, not those of a plugin");
  if (options.threads != 0)
    return fail(Error::Kind::bad_input, "`--threads` is for rules of a source file: those of a plugin take one");
  auto const plugin = Plugin::load(options.plugin);
  if (!plugin) return tl::unexpected(plugin.error());
  auto const number = plugin->find_rule(options.rule);
  if (!number) return tl::unexpected(number.error());
  jrule_rule const& rule = plugin->entry().rules[*number];
  if (rule.not_callable != nullptr)
    return fail(Error::Kind::bad_input,
                fmt::format("`{}` cannot be applied from here: {}", rule.name, rule.not_callable));
  auto const arguments = parse_arguments(rule, options.values);
  if (!arguments) return tl::unexpected(arguments.error());
  auto const map = read_input(*plugin, rule, options.in);
  if (!map) return tl::unexpected(map.error());
  auto const applied = apply_at(*plugin, *number, *map, options.at, *arguments);
  if (!applied) return tl::unexpected(applied.error());
  auto const summary = plugin->summarize(*map);
  if (!summary) return tl::unexpected(summary.error());
  // As of rules of a source file: what is proved is checked all the same.
  if (!summary->valid) throw std::logic_error(fmt::format("applying the accepted rule `{}` broke the map", rule.name));
  if (auto const written = plugin->write(*map, options.out); !written) return written;
  if (options.stats_json) {
    fmt::print("{}\n", summary_json(*summary));
  } else {
    fmt::print("{}: applied {}\n{}", rule.name, *applied, summary_text(*summary));
  }
  return {};
}

// ---- info ----

void print_doc(char const* doc, int indent) {
  for (std::string_view rest = doc; !rest.empty();) {
    std::size_t const end = std::min(rest.find('\n'), rest.size());
    fmt::print("{:{}}{}\n", "", indent, rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
}

std::string default_text(std::int32_t kind, jrule_value const& value) {
  if (kind == JRULE_NO_DEFAULT) return "";
  return kind == JRULE_COMPUTED_DEFAULT ? " = (computed)" : " = " + to_string(from_c(value));
}

std::string counted(std::uint32_t count, char const* noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

void print_modeler(jrule_modeler const& modeler) {
  fmt::print("\nmodeler {} on {}({})\n", modeler.name, modeler.model, modeler.dimension);
  print_doc(modeler.doc, 2);
  for (std::uint32_t e = 0; e < modeler.embedding_count; ++e) {
    jrule_embedding const& embedding = modeler.embeddings[e];
    fmt::print("  embedding {} : {} -> {}{}\n", embedding.name, embedding.orbit,
               to_string(static_cast<Type>(embedding.type)),
               default_text(embedding.default_kind, embedding.default_value));
    print_doc(embedding.doc, 4);
  }
}

void print_rule(jrule_plugin const& plugin, jrule_rule const& rule, bool is_operation) {
  fmt::print("\n{} {} on {} ({})\n", is_operation ? "operation" : "rule", rule.name, plugin.modelers[rule.modeler].name, rule.module);
  print_doc(rule.doc, 2);
  if (rule.not_callable != nullptr) fmt::print("  not callable: {}\n", rule.not_callable);
  for (std::uint32_t h = 0; h < rule.hook_count; ++h) {
    fmt::print("  {} {} {}\n", is_operation ? "dart" : "hook", rule.hooks[h].name, rule.hooks[h].orbit);
    print_doc(rule.hooks[h].doc, 4);
  }
  for (std::uint32_t p = 0; p < rule.parameter_count; ++p) {
    jrule_parameter const& parameter = rule.parameters[p];
    std::string const unit = parameter.unit[0] == '\0' ? "" : fmt::format(" [{}]", parameter.unit);
    fmt::print("  parameter {} : {}{}{}\n", parameter.name, to_string(static_cast<Type>(parameter.type)), unit,
               default_text(parameter.default_kind, parameter.default_value));
    print_doc(parameter.doc, 4);
  }
}

}  // namespace

int apply_plugin(ApplyOptions const& options) {
  auto const applied = apply_and_print(options);
  if (applied) return exit_ok;
  print_error(applied.error());
  using enum Error::Kind;
  return applied.error().kind == not_applicable || applied.error().kind == limit ? exit_refused : exit_usage;
}

int info_plugin(InfoOptions const& options) {
  if (options.stats_json) {
    print_error("`--stats` counts the cells of a mesh: a plugin has none");
    return exit_usage;
  }
  auto const loaded = Plugin::load(options.mesh);
  if (!loaded) {
    print_error(loaded.error());
    return loaded.error().kind == Error::Kind::bad_input ? exit_refused : exit_usage;
  }
  jrule_plugin const& plugin = loaded->entry();
  std::uint32_t const operations = plugin.rule_count - plugin.first_operation;
  fmt::print("plugin {}: {}, {}{}\n", plugin.name, counted(plugin.modeler_count, "modeler"), counted(plugin.first_operation, "rule"),
             operations == 0 ? "" : ", " + counted(operations, "operation"));
  for (std::uint32_t m = 0; m < plugin.modeler_count; ++m) print_modeler(plugin.modelers[m]);
  for (std::uint32_t r = 0; r < plugin.rule_count; ++r) print_rule(plugin, plugin.rules[r], r >= plugin.first_operation);
  return exit_ok;
}

}  // namespace jrule::driver
