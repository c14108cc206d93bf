// Sound operations of geometric modelling and of algebra, as rule schemes: what random rules start from.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "compiler/ir/rule_scheme.h"
#include "tests/property/random.h"

namespace jrule::property {

/// None if the model does not have the operation, or if the random choices did not lead to one.
using Operation = std::optional<ir::RuleScheme> (*)(std::shared_ptr<ir::Modeler const> const& modeler, Random& random);
/// Subdivisions, cones, insertions and removals of cells, …
std::vector<Operation> modelling_operations();

/// One of those, or of the operations that every model has.
ir::RuleScheme random_operation(std::shared_ptr<ir::Modeler const> const& modeler, Random& random);

}  // namespace jrule::property
