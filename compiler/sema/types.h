// The types that declarations name, and what goes with them: defaults and merge policies.
#pragma once

#include <optional>
#include <string>

#include "compiler/ir/rule_scheme.h"
#include "compiler/sema/externs.h"
#include "compiler/syntax/ast.h"

namespace jrule::sema {

/// The language's own type of that name, without Dart; none if there is none.
std::optional<Type> find_type(std::string const& name);

/// A type of the language, an extern type, or a list; none, reported, if it is unknown (J0204) or `Dart` (J0204).
/// Nothing is said again of an extern type whose declaration was reported.
std::optional<ir::ExprType> resolve_type(ast::TypeName const& type, Externs const& externs,
                                         source::Diagnostics& diagnostics);
/// The same for an embedding or a parameter, which is no list (J0491).
std::optional<ir::ExprType> resolve_stored_type(ast::TypeName const& type, Externs const& externs,
                                                source::Diagnostics& diagnostics);

struct Merge {
  MergePolicy policy = MergePolicy::none;
  ir::ExternFunctionPtr function{};  ///< of MergePolicy::function
};
/// `mean min max first`, if values of that type can be merged so (min and max need Int or Real, mean needs Real, Vec2,
/// Vec3, Point2, Point3 or Color), or an extern function (T, T) -> T or ([T]) -> T. Else J0405.
std::optional<Merge> resolve_merge(ast::Name const& policy, ir::ExprType const& type, Externs const& externs,
                                   source::Diagnostics& diagnostics);

/// A default: one of the two.
struct Default {
  std::optional<Value> value;
  ir::ExprPtr computed;  ///< null unless it calls an extern function
};
/// What an expression without names but constants (`pi`) means, of that type.
std::optional<Default> evaluate_default(ast::Expr const& expr, ir::ExprType const& type, Externs const& externs,
                                        source::Diagnostics& diagnostics);

}  // namespace jrule::sema
