// `expect V' = V + E + F;`: from expressions to sums over numbers of cells.
#pragma once

#include <optional>

#include "compiler/ir/count.h"
#include "compiler/source/diagnostic.h"
#include "compiler/syntax/ast.h"
#include "jrule/model.h"

namespace jrule::sema {

/// None, reported, if it is no sum of multiples of V, E, F, C, D and numbers (J0226), or of cells that the model lacks (J0227).
std::optional<ir::Expectation> elaborate_expectation(ast::Expectation const& expectation, Model const& model, source::Diagnostics& diagnostics);

}  // namespace jrule::sema
