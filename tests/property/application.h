// One application of an accepted rule, held against what the rule promises.
#pragma once

#include <optional>
#include <string>

#include "compiler/analysis/plan.h"
#include "tests/property/sites.h"

namespace jrule::property {

struct Examined {
  bool applied = false;
  std::optional<std::string> fault;  ///< none if all is well
};

/// Applies the rule by the interpreter and by the reference engine. They have to agree on whether it applies and, up to a
/// renaming of the added darts, on the result, which has to be a map of the model; where the rule does not apply, the map has
/// to stay byte for byte as it was.
Examined examine(ir::RuleScheme const& rule, analysis::Plan const& plan, Site const& site);

/// The same for a modeler with embeddings, whose values are set to differ from orbit to orbit: after the application each orbit
/// has one value, of the orbits whose darts it took over one's, else the default.
Examined examine_values(ir::RuleScheme const& rule, analysis::Plan const& plan, Site const& site);

}  // namespace jrule::property
