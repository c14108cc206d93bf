// Type-checking of expressions (language reference, section 6): from what the user wrote to typed trees.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "compiler/algebra/group.h"
#include "compiler/ir/program.h"
#include "compiler/sema/dimensions.h"
#include "compiler/syntax/ast.h"

namespace jrule::sema {

struct Externs;

/// What the names in an operation mean besides.
struct OperationScope {
  ir::Operation const* operation = nullptr;
  ir::Program const* program = nullptr;               ///< of whose rules there are results
  std::map<std::string, std::size_t> visible{};       ///< the variables that may be read here
  std::map<std::string, source::Span> declarations{}; ///< the first one of each name: for what is read before it or behind its block
  std::set<std::string> broken{};                     ///< whose declarations are reported: nothing is said again of them
  std::function<bool(std::string const&)> is_callee;  ///< is that the name of a rule or operation?
};

/// What an expression may refer to. `rule` has its modeler, parameters and nodes, and the lets declared so far; null where
/// only constants may stand (defaults of embeddings and parameters).
struct ExprContext {
  ir::RuleScheme const* rule = nullptr;
  algebra::Group const* group = nullptr;  ///< of the rule's model; null iff `rule` is
  DimensionValues const* dimensions = nullptr;
  Externs const* externs = nullptr;  ///< the extern functions that it may call; null if there are none
  OperationScope const* operation = nullptr;  ///< null in a rule; else `rule` is ir::expression_scope()
};

/// A typed tree, or null if something was reported (J0203 … J0207, J024x, J049x). If `expected` is given, the result has
/// exactly that type: an Int becomes a Real where a Real is expected (the only implicit conversion), anything else is J0240.
ir::ExprPtr check_expression(ast::Expr const& expr, ExprContext const& context, std::optional<ir::ExprType> expected,
                             source::Diagnostics& diagnostics);

/// The darts that an orbit `<o>(d) by <o'>` means, for `user`, such as "a `for`"; none if something was reported.
std::optional<ir::Darts> check_darts(ast::Expr const& expr, ExprContext const& context, std::string const& user,
                                     source::Diagnostics& diagnostics);

/// The generators of ⟨a ∩ b⟩: those of each that lie in the other. Exact for sets of dimensions. The `by` of an ir::Collect is
/// that of its orbit and the embedding's, where none is written.
OrbitType common_orbit(algebra::Group const& group, OrbitType const& a, OrbitType const& b);

}  // namespace jrule::sema
