// Values that random rules assign.
#pragma once

#include "compiler/ir/rule_scheme.h"
#include "tests/property/random.h"

namespace jrule::property {

/// An accepted rule on the modeler `embedded` with some clauses added, where it stays accepted: sums of numbers, of
/// values at darts of the left side and behind paths from there, and of values over orbits.
ir::RuleScheme with_clauses(ir::RuleScheme rule, Random& random);

}  // namespace jrule::property
