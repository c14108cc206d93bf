// Operators and functions applied to typed operands: the fitting signature, or what is wrong with the operands.
#pragma once

#include <string>
#include <vector>

#include "compiler/ir/rule_scheme.h"
#include "compiler/source/diagnostic.h"

namespace jrule::sema {

/// The function of the arguments, none of which is null and of which there are as many as some signature has; `name` is
/// where the function is written. Null, reported, if it does not take them (J0240, J0241).
ir::ExprPtr apply(ir::Builtin function, source::Span name, std::vector<ir::ExprPtr> arguments, source::Span span,
                  source::Diagnostics& diagnostics);

/// The value, not null, as that type: an Int becomes a Real, anything else is J0240.
ir::ExprPtr convert(ir::ExprPtr value, ir::ExprType expected, source::Diagnostics& diagnostics);

/// Is an argument of that type taken where the other is expected: the same, or an Int for a Real?
bool is_taken_as(ir::ExprType const& argument, ir::ExprType const& expected);

/// Has some signature so many parameters? Reported (J0242) if not.
bool check_argument_count(ir::Builtin function, source::Span name, std::size_t count, source::Diagnostics& diagnostics);

/// Reports a list (J0240) where `user`, such as `+` or `.x`, needs one value. Gives null.
ir::ExprPtr report_list(std::string const& user, ir::Expr const& argument, source::Diagnostics& diagnostics);

/// The note that says how one value is made of such a list.
std::string aggregate_it(ir::ExprType const& list);

/// "a `Real`", "an `Int`", "a list `[Real]`".
std::string described(ir::ExprType const& type);

/// The type of each operand, told where it is written.
std::vector<source::Label> type_labels(std::vector<ir::ExprPtr> const& operands);

}  // namespace jrule::sema
