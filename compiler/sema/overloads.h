// The types of the built-in operators and functions (language reference, section 6).
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "compiler/ir/rule_scheme.h"

namespace jrule::sema {

/// What a function takes and gives, of the one type each.
struct Signature {
  std::vector<ir::ExprType> parameters;
  ir::ExprType result;
};

/// All signatures of a function or operator, those for Int before those for Real.
std::vector<Signature> const& signatures(ir::Builtin function);

/// The first signature that takes these arguments as they are or with some Int as a Real; null if there is none.
Signature const* find_signature(ir::Builtin function, std::span<ir::ExprType const> arguments);

/// The function that is called by that name; none for operators.
std::optional<ir::Builtin> find_function(std::string const& name);
std::vector<std::string> function_names();

/// The component that `.name` reads in a vector, point or colour; none if the type has no such.
std::optional<ir::Builtin> find_component(Type type, std::string const& name);
/// "xyz" of Vec3; empty if values of the type have no components.
std::string component_names(Type type);

}  // namespace jrule::sema
