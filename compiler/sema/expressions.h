// Type-checking of expressions (language reference, section 6): from what the user wrote to typed trees.
#pragma once

#include <optional>
#include <string>

#include "compiler/algebra/group.h"
#include "compiler/ir/rule_scheme.h"
#include "compiler/sema/dimensions.h"
#include "compiler/syntax/ast.h"

namespace jrule::sema {

struct Externs;

/// What an expression may refer to. `rule` has its modeler, parameters and nodes, and the lets declared so far; null where
/// only constants may stand (defaults of embeddings and parameters).
struct ExprContext {
  ir::RuleScheme const* rule = nullptr;
  algebra::Group const* group = nullptr;  ///< of the rule's model; null iff `rule` is
  DimensionValues const* dimensions = nullptr;
  Externs const* externs = nullptr;  ///< the extern functions that it may call; null if there are none
};

/// A typed tree, or null if something was reported (J0203 … J0207, J024x, J049x). If `expected` is given, the result has
/// exactly that type: an Int becomes a Real where a Real is expected (the only implicit conversion), anything else is J0240.
ir::ExprPtr check_expression(ast::Expr const& expr, ExprContext const& context, std::optional<ir::ExprType> expected,
                             source::Diagnostics& diagnostics);

/// The generators of ⟨a ∩ b⟩: those of each that lie in the other. Exact for sets of dimensions. The `by` of an ir::Collect is
/// that of its orbit and the embedding's, where none is written.
OrbitType common_orbit(algebra::Group const& group, OrbitType const& a, OrbitType const& b);

}  // namespace jrule::sema
