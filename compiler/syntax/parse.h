// Text -> AST. The only place that knows ANTLR.
#pragma once

#include "compiler/source/diagnostic.h"
#include "compiler/syntax/ast.h"

namespace jrule::syntax {

/// The items of a file. Every item with an error is reported (J00xx, J01xx) and left out; the others are returned whole.
/// Never throws for bad text. Cost: linear, about 1 µs a token once warm.
ast::File parse(source::Sources const& sources, source::FileId file, source::Diagnostics& diagnostics);

}  // namespace jrule::syntax
