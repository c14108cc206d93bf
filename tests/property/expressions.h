// Random typed expressions, as sema makes them: operands converted where the language converts, constants folded.
#pragma once

#include "compiler/algebra/group.h"
#include "compiler/ir/rule_scheme.h"
#include "tests/property/random.h"

namespace jrule::property {

/// An expression of that type on the left side of the rule, its parameters, lets and embeddings; `depth` bounds its height.
/// Null for a dart or a list, if the rule has none.
ir::ExprPtr random_expression(ir::RuleScheme const& rule, algebra::Group const& group, ir::ExprType type, int depth, Random& random);

/// embedded(), but with all types of values, also one from outside, documented, with defaults and merge policies of all kinds.
std::shared_ptr<ir::Modeler const> of_all_types(Model const& model);

/// The rule with random documentation, parameters, lets, requirements and clauses.
ir::RuleScheme with_expressions(ir::RuleScheme rule, Random& random);

}  // namespace jrule::property
