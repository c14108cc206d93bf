// One application of an accepted rule, held against what the rule promises.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "compiler/analysis/plan.h"
#include "compiler/backend/interpreter/interpreter.h"
#include "tests/property/sites.h"

namespace jrule::property {

/// Applies one rule to a map at these darts, one for each hook: by whatever means is to be examined.
using Application = std::function<Result<interpreter::Applied>(Map& map, std::vector<Dart> const& hooks)>;

/// By the interpreter. Refers to the rule and its plan.
Application interpreted(ir::RuleScheme const& rule, analysis::Plan const& plan);

struct Examined {
  bool applied = false;
  std::optional<std::string> fault;  ///< none if all is well
};

/// Applies the rule, and derives what the reference engine makes of it. They have to agree on whether it applies and,
/// up to a renaming of the added darts, on the result, which has to be a map of the model; where the rule does not
/// apply, the map has to stay as it was, bit for bit.
Examined examine(ir::RuleScheme const& rule, Site const& site, Application const& apply);

/// The same for a modeler with embeddings, on `with_values` of the site's map: after the application each orbit has one
/// value, of the orbits whose darts it took over one's, else the default.
Examined examine_values(ir::RuleScheme const& rule, Site const& site, Application const& apply);

/// The map with the embeddings of the modeler `embedded`, whose values differ from orbit to orbit.
Map with_values(ir::Modeler const& modeler, Map const& bare);

/// What two ways of applying a rule differ in: the error, the copies or the map, to the last value. None if they agree.
std::optional<std::string> difference(Map const& start, std::vector<Dart> const& hooks, Application const& a,
                                      Application const& b);

}  // namespace jrule::property
