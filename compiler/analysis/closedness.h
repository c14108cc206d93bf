// Closed models: no arc is a loop.
#pragma once

#include "compiler/analysis/refusal.h"
#include "compiler/analysis/relations.h"

namespace jrule::analysis {

/// In a closed model an added arc between different nodes is never a loop. From a node to itself it is one exactly where its
/// word fixes a pattern dart: accepted only if the word leads, on the pattern, where one does that is conjugate in Γ to a single
/// letter, which fixes nothing in a closed map. No refusals for other models.
Refusals check_closedness(ir::RuleScheme const& rule, PatternWords const& words);

}  // namespace jrule::analysis
