// The three parts of a rule's function, in the order in which they stand.
#pragma once

#include "compiler/backend/cpp/function.h"
#include "compiler/backend/cpp/writer.h"

namespace jrule::cpp {

/// The pattern, the match columns and the tests of the left side. Like interpreter.cpp's find_match().
void write_match(Writer& out, Function const& f);
/// Lets, requirements and the values of touched orbits, all from the map before. Like evaluate_expressions().
void write_values(Writer& out, Function const& f);
/// What may still fail; then darts, arcs and values. Like reserve() and commit().
void write_commit(Writer& out, Function const& f);

}  // namespace jrule::cpp
