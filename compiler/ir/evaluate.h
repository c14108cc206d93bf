// What the built-in functions compute, on values: used for constants at compile time and by the interpreter.
#pragma once

#include <functional>
#include <span>
#include <variant>
#include <vector>

#include "compiler/ir/rule_scheme.h"

namespace jrule::ir {

/// A value or a list of values of one type.
using Evaluated = std::variant<Value, std::vector<Value>>;

/// The function applied to arguments of the types that sema has checked. Defined for all of them: a division by zero, the
/// square root of a negative number and the like follow IEEE 754; the mean, min, max and first of an empty list cannot
/// occur, since an orbit is never empty. Int arithmetic wraps around. Generated C++ calls the same functions of
/// jrule/value.h, so both agree to the last bit.
Evaluated apply(Builtin function, std::span<Evaluated const> arguments);

/// The value of an expression. `leaf` gives those of parameters and lets and of what is read from a map; constants, functions
/// and conditionals are evaluated here. A branch that is not taken is not evaluated. Recursive: the parser bounds the depth.
Evaluated evaluate(Expr const& expr, std::function<Evaluated(Expr const&)> const& leaf);

}  // namespace jrule::ir
