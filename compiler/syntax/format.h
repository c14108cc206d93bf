// The one canonical layout of a source file.
#pragma once

#include <string>
#include <string_view>

#include "compiler/syntax/ast.h"

namespace jrule::syntax {

/// The text in canonical layout: only white space changes; comments, and at most one blank line between things, stay.
/// `text` must parse without errors. format(format(x)) == format(x), and both parse to the same AST.
std::string format(std::string_view text);

/// The AST as an indented tree, for `jrule emit ast` and golden tests.
std::string dump(ast::File const& file);

}  // namespace jrule::syntax
