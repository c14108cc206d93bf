// One-line texts of small parts of the AST.
#pragma once

#include <string>

#include "compiler/syntax/ast.h"

namespace jrule::syntax {

/// In the spelling of the language: `i-2`, `[2,~1]`, `<0,1>`, `cell(i)`, `[Point3]`, `gmap(2)`.
std::string text_of(ast::Dimension const& dimension);
std::string text_of(ast::Word const& word);
std::string text_of(ast::OrbitElement const& element);
std::string text_of(std::vector<ast::OrbitElement> const& elements);
std::string text_of(ast::OrbitType const& type);
std::string text_of(ast::TypeName const& type);
std::string text_of(ast::ModelRef const& model);
std::string quoted(std::string const& text);

/// Fully bracketed, so that the shape of the tree shows: `(add (member (name a) x) (int 1))`.
std::string text_of(ast::Expr const& expr);
std::string text_of(ast::Call const& call);

}  // namespace jrule::syntax
