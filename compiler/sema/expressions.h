// Type-checking of expressions (language reference, section 6): from what the user wrote to typed trees.
#pragma once

#include <optional>
#include <string>

#include "compiler/algebra/group.h"
#include "compiler/ir/rule_scheme.h"
#include "compiler/sema/dimensions.h"
#include "compiler/syntax/ast.h"

namespace jrule::sema {

/// What an expression may refer to. `rule` has its modeler, parameters and nodes, and the lets declared so far; null where
/// only constants may stand (defaults of embeddings and parameters).
struct ExprContext {
  ir::RuleScheme const* rule = nullptr;
  algebra::Group const* group = nullptr;  ///< of the rule's model; null iff `rule` is
  DimensionValues const* dimensions = nullptr;
};

/// A typed tree, or null if something was reported (J0203 … J0206, J024x, J049x). If `expected` is given, the result has
/// exactly that type: an Int becomes a Real where a Real is expected (the only implicit conversion), anything else is J0240.
ir::ExprPtr check_expression(ast::Expr const& expr, ExprContext const& context, std::optional<ir::ExprType> expected,
                             source::Diagnostics& diagnostics);

/// The built-in type of that name; reported if unknown (J0204), `Dart` (J0204) or a list (J0491).
std::optional<Type> resolve_type(ast::TypeName const& type, source::Diagnostics& diagnostics);

/// `mean min max first`, if values of that type can be merged so (J0405: min and max need Int or Real, mean needs Real,
/// Vec2, Vec3, Point2, Point3 or Color).
std::optional<MergePolicy> resolve_merge(ast::Name const& policy, Type type, source::Diagnostics& diagnostics);

/// The value of an expression without names but constants (`pi`), of that type.
std::optional<Value> evaluate_constant(ast::Expr const& expr, Type type, source::Diagnostics& diagnostics);

}  // namespace jrule::sema
