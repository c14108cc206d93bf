#include "tests/stdlib/application.h"

#include "compiler/backend/interpreter/interpreter.h"
#include "compiler/sema/elaborate.h"

namespace jrule::test {

std::vector<Value> defaults(ir::RuleScheme const& rule) {
  std::vector<Value> values;
  for (ir::Parameter const& parameter : rule.parameters) {
    if (!parameter.default_value) throw std::invalid_argument(rule.name + " needs a value for " + parameter.name);
    values.push_back(*parameter.default_value);
  }
  return values;
}

std::vector<std::vector<Dart>> apply(Module::Rule const& rule, Map& map, std::vector<Dart> const& hooks,
                                     std::vector<Value> const& arguments) {
  rewrite::Workspace workspace;
  auto applied = interpreter::apply(rule.scheme, rule.plan, map, hooks,
                                    arguments.empty() ? defaults(rule.scheme) : arguments, workspace);
  if (!applied) {
    ADD_FAILURE() << rule.scheme.name << ": " << to_string(applied.error());
    return {};
  }
  auto const violation = find_violation(map);
  EXPECT_FALSE(violation) << rule.scheme.name << ": " << violation->text;
  return std::move(applied->copies);
}

std::string refusal(Module::Rule const& rule, Map const& map, std::vector<Dart> const& hooks,
                    std::vector<Value> const& arguments) {
  Map changed = map;
  rewrite::Workspace workspace;
  auto const applied = interpreter::apply(rule.scheme, rule.plan, changed, hooks,
                                          arguments.empty() ? defaults(rule.scheme) : arguments, workspace);
  if (applied) return {};
  EXPECT_EQ(print_jmap(changed), print_jmap(map)) << rule.scheme.name;
  return to_string(applied.error());
}

std::optional<Module::Rule> find_instance(std::string const& family, std::vector<int> const& dimensions, int n) {
  static source::Sources sources;
  static source::Diagnostics loading;
  static sema::Modules const modules =
      sema::load(JRULE_SOURCE_DIR "/stdlib/std/basic.jrule", {JRULE_SOURCE_DIR "/stdlib", {}}, sources, loading);
  source::Diagnostics diagnostics;
  auto scheme = sema::instantiate(modules, family, dimensions, n, diagnostics);
  if (!scheme || diagnostics.has_errors()) return {};
  analysis::Verdict verdict = analysis::analyze(*scheme);
  if (!verdict.accepted()) return {};
  return Module::Rule{std::move(*scheme), std::move(verdict.plan)};
}

Module::Rule instance(std::string const& family, std::vector<int> const& dimensions, int n) {
  auto found = find_instance(family, dimensions, n);
  if (!found) throw std::runtime_error("there is no such " + family);
  return std::move(*found);
}

}  // namespace jrule::test
