// The arcs that the model forces beside those that a left side matches (paper, section 5.2.1).
#pragma once

#include "compiler/analysis/refusal.h"
#include "compiler/analysis/relations.h"

namespace jrule::analysis {

/// The rule with the implied arcs added to both sides: the reverse of a preserved single arc of a non-oriented dimension; the
/// fourth arc of each iji-path of the left side, {i,j} exchangeable; and between preserved nodes of the first hook's component
/// every arc that the model alone puts there, x_s·d = w·x_t with w in the pattern. Only paths of the left side license completion:
/// completing from the right side would make unsound rules pass. The rule must satisfy the incident-arcs condition.
struct Completed {
  ir::RuleScheme rule;
  std::vector<ImpliedEvidence> implied;  ///< of the arcs added, on either side the last ones
  Refusals dead;  ///< J033x: no map can match the left side
};
Completed complete(ir::RuleScheme const& rule, algebra::Group const& group, Placement const& placement, PatternWords const& words);

}  // namespace jrule::analysis
