// What the built-in functions compute, on values: used for constants at compile time and by the interpreter.
#pragma once

#include <functional>
#include <span>
#include <utility>
#include <variant>
#include <vector>

#include "compiler/ir/rule_scheme.h"
#include "jrule/map.h"

namespace jrule::ir {

/// A list: a type of its own, since libstdc++ 12 takes a variant of std::vector for one that always has a value, and destroys what
/// a copy without memory never made.
template <class T>
struct List : std::vector<T> {
  using std::vector<T>::vector;
  List(std::vector<T> list) noexcept : std::vector<T>(std::move(list)) {}
};

/// A value or a dart, or a list of them.
using Evaluated = std::variant<Value, List<Value>, Dart, List<Dart>>;

/// The function applied to arguments of the types that sema has checked. Defined for all of them, so that no expression
/// fails: a division by zero, the square root of a negative number and the like follow IEEE 754, Int arithmetic wraps
/// around. The mean, min, max and first of an empty list cannot occur, since an orbit is never empty. Generated C++ calls
/// the same functions of jrule/value.h, so both agree to the last bit.
Evaluated apply(Builtin function, std::span<Evaluated const> arguments);

/// The value of an expression. `leaf` gives those of parameters and lets and of what is read from a map; constants,
/// functions and conditionals are evaluated here. A branch that is not taken is not evaluated, nor the second operand of
/// `and` and `or` where the first decides. Recursive: the parser bounds the depth. Takes no memory
/// unless a list, or `leaf`, does.
Evaluated evaluate(Expr const& expr, std::function<Evaluated(Expr const&)> const& leaf);

/// The same expression with its outermost operation already done, if its parts are constants: to build an expression
/// from its leaves through fold() is to compute all of it that does not depend on the application. By the functions
/// above, so a constant has the value that the expression would have.
ExprPtr fold(Expr expr);

}  // namespace jrule::ir
