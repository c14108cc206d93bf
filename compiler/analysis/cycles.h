// The cycle condition C(i,j) (paper, Def. 16, 26, 27), with words compared in Γ.
#pragma once

#include "compiler/analysis/refusal.h"
#include "compiler/analysis/relations.h"

namespace jrule::analysis {

/// For every exchangeable pair {i,j}:
///  - each added arc of dimension i or j lies on the right side in an ijij-cycle whose word is ε on the pattern, or in a maximal
///    alternating path of added arcs that replaces a deleted one: same ends, same labels, words equal on the pattern;
///  - each maximal alternating path of deleted arcs that lies in no ijij-cycle of the left side is so replaced.
/// Cycles of the left side are facts about any match, not obligations; preserved arcs need no cycle (the printed Algorithm 3
/// asks for both and refuses sound rules). The rule must be completed and satisfy the first two conditions.
Refusals check_cycles(ir::RuleScheme const& completed, algebra::Group const& group, PatternWords const& words);

}  // namespace jrule::analysis
