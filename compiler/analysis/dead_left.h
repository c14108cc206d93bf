// Left sides that no map can match (theory: section 3): an error, not a vacuous success.
#pragma once

#include "compiler/analysis/refusal.h"
#include "compiler/analysis/relations.h"

namespace jrule::analysis {

/// Two nodes that would be matched to the same darts (J0334); in a closed model, a word that would fix a dart (J0335).
/// Contradictions between arcs are found by completion (J0331, J0332).
Refusals check_dead_left(ir::RuleScheme const& rule, algebra::Group const& group, Placement const& placement, PatternWords const& words);

}  // namespace jrule::analysis
