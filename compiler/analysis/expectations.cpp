#include "compiler/analysis/expectations.h"

#include <fmt/format.h>

#include <algorithm>

#include "compiler/algebra/group.h"
#include "compiler/analysis/effects.h"
#include "compiler/analysis/wording.h"

namespace jrule::analysis {

using source::Code;

namespace {

struct Check {
  ir::RuleScheme const& rule;
  Effects const& effects;
  OrbitCounter const& counter;

  CellEffects const* cells_of(ir::Expectation const& expected) const {
    if (!expected.cell) return nullptr;
    return &*std::find_if(effects.cells.begin(), effects.cells.end(), [&](CellEffects const& c) { return c.dimension == *expected.cell; });
  }

  Refusal refusal(Code code, ir::Expectation const& expected, std::string message) const {
    ir::NodeId const node = rule.hooks.empty() ? 0 : rule.hooks.front();
    return {{.code = code, .span = expected.span, .message = std::move(message)}, node, -1, -1};
  }

  // Where the new cells come from, node by node.
  void explain(source::Diagnostic& diagnostic, CellEffects const& cells) const {
    std::string const name = orbit_name(rule.model(), cells.orbit);
    for (CellClass const& c : cells.created) {
      auto const per = c.single ? std::string("one") : fmt::format("one for each {}", c.per.words.empty() ? "dart" : orbit_name(rule.model(), c.per));
      diagnostic.labels.push_back({*rule.nodes[c.nodes.front()].right_span, fmt::format("a new {}: {}", name, per)});
    }
    std::sort(diagnostic.labels.begin(), diagnostic.labels.end(), [](auto const& a, auto const& b) { return a.span < b.span; });
  }

  std::optional<Refusal> operator()(ir::Expectation const& expected) const {
    CellEffects const* const cells = cells_of(expected);
    std::optional<OrbitCount> const& count = cells ? cells->count : effects.darts;
    char const name = ir::count_name(expected.cell);
    if (!count) {
      return refusal(Code::undecided_expectation, expected, fmt::format("it is not known what {}' is: {}", name, why_no_count(rule, effects, cells)));
    }
    if (!count->others.empty()) {
      Refusal found = refusal(Code::undecided_expectation, expected,
                              fmt::format("it is not known what {}' is: V, E, F, C and D do not say how many orbits {} the component has", name,
                                          to_string(count->others.front())));
      found.diagnostic.notes.push_back(fmt::format("one of the {} is there for each of these", orbit_names(rule.model(), cells->orbit)));
      return found;
    }
    if (expected.count == count->count || counter.normal(expected.count) == counter.normal(count->count)) return {};
    Refusal found = refusal(Code::wrong_expectation, expected,
                            fmt::format("the rule makes {0}' = {1}, not {0}' = {2}", name, to_string(count->count), to_string(expected.count)));
    if (cells) explain(found.diagnostic, *cells);
    if (!effects.whole) found.diagnostic.notes.emplace_back("V, E, F, C and D are the numbers in the map before the rule is applied");
    return found;
  }
};

}  // namespace

Refusals check_expectations(ir::RuleScheme const& rule, Plan const& plan) {
  if (rule.expectations.empty()) return {};
  Effects const effects = analyze_effects(rule, plan);
  algebra::Group const group(rule.model());
  OrbitCounter const counter(group);
  Refusals refusals;
  for (ir::Expectation const& expected : rule.expectations) {
    if (auto found = Check{rule, effects, counter}(expected)) refusals.push_back(std::move(*found));
  }
  return refusals;
}

}  // namespace jrule::analysis
