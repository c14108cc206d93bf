// What of a rule is C++ from outside: only generated code can run such a rule.
#pragma once

#include <optional>
#include <string>

#include "compiler/ir/program.h"

namespace jrule::ir {

/// The first call of an extern function in the expression; null if there is none.
Expr const* find_call(Expr const& expr);

struct ExternUse {
  Span span;
  std::string what;  ///< "it calls the extern function `hardness`"
  Span declaration;  ///< of the extern type or function
};
/// The first thing for which running the rule takes C++ from outside: in its modeler, then in the rule. None if the
/// interpreter can run it.
std::optional<ExternUse> find_extern_use(RuleScheme const& rule);
/// The same of an operation, and of all that it calls.
std::optional<ExternUse> find_extern_use(Operation const& operation, Program const& program);

}  // namespace jrule::ir
