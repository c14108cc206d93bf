// What ir::verify asks of the expressions of rules and operations alike.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compiler/ir/operation.h"

namespace jrule::ir {

using Fault = std::optional<std::string>;

/// What an expression of an operation may name besides.
struct VisibleVariables {
  std::vector<Variable> const& variables;
  std::vector<bool> const& declared;  ///< by variable
  std::vector<RuleScheme> const& rules;
};

/// None if ids are in range and darts stand where the map is read. `variables` is null in a rule. `depth` comprehensions are
/// around the expression.
Fault verify_expr(RuleScheme const& rule, ExprPtr const& expr, VisibleVariables const* variables = nullptr, std::size_t depth = 0);

}  // namespace jrule::ir
