// Expressions on the map before the application.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "compiler/ir/evaluate.h"
#include "jrule/rewrite.h"

namespace jrule::interpreter {

/// What a variable of an operation holds; nothing before it is declared.
struct CallResult {
  std::size_t rule;                       ///< in the program
  std::optional<ir::NodeId> hook;         ///< whose copies are the pattern, if the rule keeps it
  std::vector<std::vector<Dart>> copies;  ///< by node
};
using Local = std::variant<std::monostate, ir::Evaluated, CallResult>;
struct Locals {
  std::string const& operation;
  std::vector<Local> variables;
};

/// Where an expression is evaluated: m(u_k, s) for each left node s.
struct Scene {
  Map const& map;
  ir::RuleScheme const& rule;
  std::vector<std::vector<Dart>> const& match;  ///< by node, then pattern dart
  std::span<Value const> arguments;
  std::span<ir::Evaluated const> lets;          ///< those evaluated so far
  Locals const* locals = nullptr;               ///< in an operation: what it reads must be in the map, or operation::Failure is thrown
};

ir::Evaluated evaluate(ir::Expr const& expr, Scene const& scene, rewrite::Index k);
/// The same for an expression that is no list.
Value evaluate_value(ir::Expr const& expr, Scene const& scene, rewrite::Index k);

}  // namespace jrule::interpreter
