// Parameters of rules and operations.
#pragma once

#include <vector>

#include "compiler/ir/rule_scheme.h"
#include "compiler/sema/externs.h"
#include "compiler/syntax/ast.h"

namespace jrule::sema {

enum class Darts { refused, allowed };

/// One for each; a name that stands twice (J0208), types and defaults that are none are reported. A Dart has no default (J0206).
std::vector<ir::Parameter> elaborate_parameters(std::vector<ast::Parameter> const& parameters, Darts darts, Externs const& externs,
                                                source::Diagnostics& diagnostics);

}  // namespace jrule::sema
