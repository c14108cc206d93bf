// Expressions and constants as text.
#pragma once

#include <optional>
#include <string>

#include "compiler/algebra/group.h"
#include "compiler/backend/text/print_jrule.h"

namespace jrule::text {

/// `<0,[2,~1]>`
std::string spell(OrbitType const& orbit);
/// `[2,~1]`, `[]`
std::string spell_word(Word const& word);
/// `2`, `~1`
std::string spell(Letter letter);

/// A constant expression with that value: any number, also negative, infinite or NaN.
std::string spell_constant(Value const& value);

/// The expression with the fewest parentheses. Where `expected` is given, it stands where a value of that type is expected, so
/// that an Int is converted. The first `lets` lets of the rule are declared already.
Spelled<std::string> spell(ir::Expr const& expr, ir::RuleScheme const& rule, algebra::Group const& group, std::size_t lets,
                           std::optional<ir::ExprType> expected);

}  // namespace jrule::text
