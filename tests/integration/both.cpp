#include "tests/integration/both.h"

#include "compiler/analysis/independence.h"
#include "compiler/backend/interpreter/interpreter.h"
#include "compiler/sema/elaborate.h"

namespace jrule::test {

Module::Module(std::string const& path) {
  source::Sources sources;
  source::Diagnostics diagnostics;
  sema::Modules const modules = sema::load(path, {JRULE_SOURCE_DIR "/stdlib", {}}, sources, diagnostics);
  ir::Program program = sema::elaborate(modules, diagnostics);
  for (ir::RuleScheme& scheme : program.rules) {
    analysis::Verdict verdict = analysis::analyze(scheme);
    EXPECT_TRUE(verdict.accepted()) << scheme.name;
    rules_.push_back({std::move(scheme), std::move(verdict.plan)});
  }
  for (source::Diagnostic const& d : diagnostics.all()) ADD_FAILURE() << source::render_human(sources, d);
}

Module::Rule const& Module::rule(std::string const& name) const {
  for (Rule const& rule : rules_) {
    if (rule.scheme.name == name) return rule;
  }
  throw std::out_of_range("there is no rule " + name);
}

void PrintTo(Outcome const& outcome, std::ostream* out) {
  *out << "error: " << outcome.error << "\ncount: " << outcome.count << "\ncopies:\n";
  for (auto const& column : outcome.copies) {
    for (Dart const d : column) *out << ' ' << d;
    *out << '\n';
  }
  // Large maps only by their beginning.
  *out << outcome.map.substr(0, 4000);
}

Outcome interpret(Module::Rule const& rule, Map map, std::vector<Dart> const& hooks,
                  std::vector<Value> const& arguments) {
  rewrite::Workspace workspace;
  Outcome outcome;
  if (auto const applied = interpreter::apply(rule.scheme, rule.plan, map, hooks, arguments, workspace)) {
    for (ir::NodeId id = 0; id < rule.scheme.nodes.size(); ++id) {
      if (!rule.scheme.nodes[id].deleted()) outcome.copies.push_back(applied->copies[id]);
    }
  } else {
    outcome.error = to_string(applied.error());
  }
  outcome.map = print_jmap(map);
  return outcome;
}

Outcome interpret_everywhere(Module::Rule const& rule, Map map, std::vector<Value> const& arguments) {
  rewrite::Workspace workspace;
  Outcome outcome;
  bool const at_once = analysis::analyze_independence(rule.scheme, rule.plan).independent();
  auto const count = at_once ? interpreter::apply_all(rule.scheme, rule.plan, map, arguments, workspace)
                             : interpreter::apply_everywhere(rule.scheme, rule.plan, map, arguments, workspace);
  if (count) {
    outcome.count = *count;
  } else {
    outcome.error = to_string(count.error());
  }
  outcome.map = print_jmap(map);
  return outcome;
}

void number_values(Map& map) {
  rewrite::Workspace workspace;
  for (std::size_t e = 0; e < map.embedding_count(); ++e) {
    EmbeddingSpec const spec = map.embedding(e).spec();
    std::vector<Dart> const orbits = number_orbits(map, spec.orbit).first;
    for (std::size_t i = 0; i < orbits.size(); ++i) {
      // No two sums of them round alike by chance.
      double const x = static_cast<double>(i + 1) / 7.0;
      double const components[] = {x, x * x - 3.0, 1.0 / (x + 0.1)};
      Value value = from_components(spec.type, components);
      if (spec.type == Type::Bool) value = i % 3 == 0;
      if (spec.type == Type::Int) value = static_cast<std::int64_t>(i * 5) - 11;
      rewrite::set_value(map, e, orbits[i], value, workspace);
    }
  }
}

}  // namespace jrule::test
