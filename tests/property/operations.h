// Sound operations of geometric modelling and of algebra, as rule schemes: what random rules start from.
#pragma once

#include <memory>

#include "compiler/ir/rule_scheme.h"
#include "tests/property/random.h"

namespace jrule::property {

/// One of the operations that the model has.
ir::RuleScheme random_operation(std::shared_ptr<ir::Modeler const> const& modeler, Random& random);

}  // namespace jrule::property
