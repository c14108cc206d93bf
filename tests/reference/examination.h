// What the analysis says of the cells that a rule changes, held against one application: cells are followed by their darts.
#pragma once

#include <optional>
#include <string>

#include "compiler/analysis/effects.h"
#include "tests/reference/engine.h"

namespace jrule::reference {

/// How often something was compared.
struct Tally {
  int applications = 0;
  int created = 0, deleted = 0, kept = 0, never_split = 0, never_merged = 0, counts = 0, regular_counts = 0, local_counts = 0;
};

/// What is not as `effects`, which are the rule's, say it is; none if all is. Adds to `tally`.
std::optional<std::string> examine(ir::RuleScheme const& rule, analysis::Effects const& effects, PlainMap const& before,
                                   Derivation const& derivation, Tally& tally);

}  // namespace jrule::reference
