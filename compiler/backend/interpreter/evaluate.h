// Expressions on the map before the application.
#pragma once

#include <span>
#include <vector>

#include "compiler/ir/evaluate.h"
#include "jrule/rewrite.h"

namespace jrule::interpreter {

/// Where an expression is evaluated: m(u_k, s) for each left node s.
struct Scene {
  Map const& map;
  ir::RuleScheme const& rule;
  std::vector<std::vector<Dart>> const& match;  ///< by node, then pattern dart
  std::span<Value const> arguments;
  std::span<ir::Evaluated const> lets;          ///< those evaluated so far
};

ir::Evaluated evaluate(ir::Expr const& expr, Scene const& scene, rewrite::Index k);
/// The same for an expression that is no list.
Value evaluate_value(ir::Expr const& expr, Scene const& scene, rewrite::Index k);

}  // namespace jrule::interpreter
