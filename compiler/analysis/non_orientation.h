// The non-orientation condition O(d), d non-oriented (paper, Def. 24).
#pragma once

#include "compiler/analysis/refusal.h"
#include "compiler/analysis/relations.h"

namespace jrule::analysis {

/// Each added (deleted) arc of a non-oriented dimension has a reverse that is added (deleted) too, its word equal on the
/// pattern to the conjugate. A single arc may stand only if it is preserved. A node may still
/// have a wrong number of arcs: then the first ones count.
Refusals check_non_orientation(ir::RuleScheme const& rule, algebra::Group const& group, PatternWords const& words);

}  // namespace jrule::analysis
