// What every look at a rule's pattern starts from: where its left nodes lie, and which words are equal on it.
#pragma once

#include "compiler/analysis/completion.h"

namespace jrule::analysis {

/// Of a rule with its hooks, which must outlive it; what is completed is of use only if the rule satisfies the incident-arcs
/// condition. The parts refer to each other, so that it is neither copied nor moved.
struct Pattern {
  explicit Pattern(ir::RuleScheme const& of) : rule(of) {}
  Pattern(Pattern const&) = delete;

  ir::RuleScheme const& rule;
  OrbitType const hook_orbit = rule.hook_orbit();
  algebra::Group const group{rule.model()};
  Placement const placement{rule, group};
  PatternWords const words{rule, group, placement};
  Completed const completed = complete(rule, group, placement, words);

  /// Is the orbit of the hook its whole component, in every map?
  bool fills_components() const;
};

}  // namespace jrule::analysis
