// Expressions as C++: the same functions of jrule/value.h that the interpreter calls, so that both agree to the last
// bit.
#pragma once

#include <string>

#include "compiler/backend/cpp/function.h"

namespace jrule::cpp {

/// Where an expression is evaluated: at the hooks; at the pattern dart of the surrounding loop's index; at that dart, which is
/// the hook's of one of several applications.
enum class Where { at_hooks, in_loop, at_each_hook };

/// The expression, fit to stand as an argument or behind `=` or `return`.
std::string expression(ir::Expr const& expr, Function const& f, Where where);

/// The same for a default that calls extern functions: an expression that reads nothing.
std::string constant_expression(ir::Expr const& expr);
/// The default of an embedding that has one.
std::string default_value(ir::Modeler const& modeler, std::size_t embedding);

}  // namespace jrule::cpp
