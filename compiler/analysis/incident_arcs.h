// The incident-arcs condition I(d) (paper, Def. 22 on the core; Def. 11 and 12).
#pragma once

#include "compiler/analysis/refusal.h"

namespace jrule::analysis {

/// For every dimension d: an added node has exactly one outgoing and one incoming d-arc on the right; a deleted node exactly
/// one of each on the left (the dangling condition); a preserved node has an outgoing (incoming) d-arc on the left iff it
/// has one on the right; no node has two (Def. 11 as printed forgets this). Necessary and sufficient (Theorem 4),
/// but for single arcs of a non-oriented dimension at added, deleted or newly joined nodes, which check_non_orientation refuses.
Refusals check_incident_arcs(ir::RuleScheme const& rule);

/// Does some node have two arcs of one dimension on this side, leaving or entering it?
bool gives_two_arcs(ir::Side const& side);

}  // namespace jrule::analysis
