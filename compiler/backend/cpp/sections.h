// The three parts of a rule's function, in the order in which they stand.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "compiler/backend/cpp/function.h"
#include "compiler/backend/cpp/writer.h"

namespace jrule::cpp {

/// The pattern, the match columns and the tests of the left side, of one application. Like interpreter.cpp's find_match().
void write_match(Writer& out, Function const& f);
/// The same of all applications, which `find` gives; those that are refused are left out. Like find_all_matches(). `text` follows, and
/// what it mentions is declared.
void write_all_matches(Writer& out, Function const& f, std::string const& find, std::string const& text);
/// Without columns: refuses, by returning false, if a test fails anywhere. Nothing if there is no test.
void write_dense_checks(Writer& out, Function const& f);
/// Lets and requirements, from the map before.
void write_conditions(Writer& out, Function const& f);
/// The values of touched orbits, all from the map before. Like evaluate_clauses().
void write_values(Writer& out, Function const& f);
/// What may still fail; then darts, arcs and values. Like reserve() and commit().
void write_commit(Writer& out, Function const& f);
/// "return ConeResult{match_a[0], …};"
void write_result(Writer& out, Function const& f);

/// A declaration that stands before a text, if that or another declaration mentions its name.
struct Local {
  std::string name;
  std::string line;
};
/// Writes those that are needed, in their order, then the text, whose lines are indented already.
void write_with_locals(Writer& out, std::vector<Local> const& locals, std::string const& text);
/// Does the text mention the name?
bool mentions(std::string_view text, std::string_view name);
/// The map, the workspace, the embeddings.
std::vector<Local> map_locals(Function const& f);
/// What expressions read the map with, and the orbits of the pattern.
std::vector<Local> view_locals(Function const& f);

}  // namespace jrule::cpp
