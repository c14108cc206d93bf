// Which orbits a rule creates, extends, assigns and merges, and whether each gets a value (theory: section 5).
#pragma once

#include <vector>

#include "compiler/analysis/plan.h"
#include "compiler/analysis/refusal.h"
#include "compiler/analysis/relations.h"

namespace jrule::analysis {

struct EmbeddingAnalysis {
  std::vector<OrbitComponent> orbits;  ///< those that the application has to touch, by embedding, then by root
  Refusals refusals;                   ///< J040x
  std::vector<source::Diagnostic> warnings;  ///< J0411: a clause whose value depends on the dart that it is computed at
};

/// Every wholly new orbit gets a value from a clause, else from the embedding's default (J0401); orbits that the rule may
/// merge get one from a clause, else from the `merge` policy (J0402); no orbit gets two clauses (J0403). The rule must be
/// completed and satisfy the topological conditions; `words` are of the rule as written.
EmbeddingAnalysis analyze_embeddings(ir::RuleScheme const& completed, PatternWords const& words);

}  // namespace jrule::analysis
