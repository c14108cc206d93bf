// Expressions as C++: the same functions of jrule/value.h that the interpreter calls, so that both agree to the last
// bit.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "compiler/backend/cpp/function.h"

namespace jrule::cpp {

/// Where an expression is evaluated: at the hooks; at the pattern dart of the surrounding loop's index; at that dart, which is
/// the hook's of one of several applications.
enum class Where { at_hooks, in_loop, at_each_hook };

/// The expression, fit to stand as an argument or behind `=` or `return`.
std::string expression(ir::Expr const& expr, Function const& f, Where where);

/// The C++ names of what an operation's expressions mention. They read the map as it is when they are computed.
struct OperationNames {
  ir::Modeler const* modeler;
  std::string object, map;                                         ///< "surface", "map"
  std::string alive, at;                                           ///< the test that a dart is in the map; a lambda's parameter
  std::string operation;                                           ///< its name in messages, quoted
  std::vector<std::string> variables;                              ///< those of the operation
  std::vector<std::vector<std::string>> members;                   ///< by variable, then node: "a" of "base.a"
  std::map<std::pair<std::size_t, ir::NodeId>, std::string> copies;  ///< by variable and node: the copies that are chosen from
  std::map<std::pair<OrbitType, OrbitType>, std::string> walks;    ///< that it ranges over, with their `by`
  std::map<std::string, std::string> bound;                        ///< variables of comprehensions
};
std::string expression(ir::Expr const& expr, OperationNames const& names);
/// A dart at which an operation reads the map: it must be in it.
std::string dart_in_map(ir::Expr const& expr, OperationNames const& names);

/// The same for a default that calls extern functions: an expression that reads nothing.
std::string constant_expression(ir::Expr const& expr);
/// The default of an embedding that has one.
std::string default_value(ir::Modeler const& modeler, std::size_t embedding);

}  // namespace jrule::cpp
