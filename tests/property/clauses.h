// Values that random rules assign.
#pragma once

#include "compiler/ir/rule_scheme.h"
#include "tests/property/random.h"

namespace jrule::property {

/// An accepted rule on a modeler whose values are of type Int or Real, with some clauses added, where it stays accepted: sums of
/// numbers, of values at darts of the left side and behind paths from there, of aggregates over orbits, of conditionals. The spans
/// of clause k and of its expressions begin at k.
ir::RuleScheme with_clauses(ir::RuleScheme rule, Random& random);

}  // namespace jrule::property
