// The verdict on a rule: every condition, and for an accepted rule the plan of its application.
#pragma once

#include "compiler/analysis/plan.h"
#include "compiler/analysis/refusal.h"

namespace jrule::analysis {

struct Verdict {
  Refusals refusals;  ///< empty iff the rule is accepted: then every application turns a map of the model into one
  Plan plan;          ///< meaningful only if accepted
  std::vector<source::Diagnostic> warnings;  ///< of rules that satisfy the topological conditions
  bool accepted() const { return refusals.empty(); }
};

/// Incident arcs and non-orientation first, since the other conditions need them; then completion, cycles, closedness; then
/// embeddings. Cost: O(nodes · dimensions²), apart from comparing words.
Verdict analyze(ir::RuleScheme const& rule);

}  // namespace jrule::analysis
