// A map that a refused rule breaks: the evidence that a refusal is right (theory: section 4).
#pragma once

#include <optional>
#include <vector>

#include "compiler/analysis/counterexample/graph.h"
#include "compiler/ir/rule_scheme.h"
#include "jrule/map.h"

namespace jrule::analysis {

struct Counterexample {
  Map before;               ///< a map of the rule's model, without embeddings
  std::vector<Dart> hooks;  ///< where the rule matches it
  /// By node, the darts of its copies in `after` (in `before` for deleted nodes).
  std::vector<std::vector<Dart>> copies;
  Graph after;          ///< what the paper's construction makes of it: arcs of L deleted, arcs of R added (DPO)
  Violation violation;  ///< the first constraint that `after` breaks
};

/// What a search came to.
struct Search {
  std::optional<Counterexample> counterexample;
  std::size_t applications = 0;  ///< places where the left side matched; if none, it may be that it matches nowhere
};

/// The smallest counterexample found among instances of the left side: on small patterns, completed to maps of the
/// model, by size. None if none is found: then the rule may be sound for a reason that the analysis does not see.
/// `budget` bounds the search in maps tried. Equal rules give equal results. The rule need not satisfy any condition.
Search search_counterexample(ir::RuleScheme const& rule, std::size_t budget = 20000);

/// The same, the counterexample alone.
std::optional<Counterexample> find_counterexample(ir::RuleScheme const& rule, std::size_t budget = 20000);

}  // namespace jrule::analysis
