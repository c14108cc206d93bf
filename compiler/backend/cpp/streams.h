// Arcs and handles that a commit writes in columns, one after the other.
#pragma once

#include <string>

#include "compiler/backend/cpp/function.h"
#include "compiler/backend/cpp/writer.h"

namespace jrule::cpp {

/// All of them, in an order in which each is read before it is written; in parts, where threads may be taken.
void write_streams(Writer& out, Function const& f);
/// Has the application to walk the component's orbits, to find which darts get the value? Then no stream writes their handles.
bool is_walked(Function const& f, analysis::OrbitComponent const& component);
/// "surface.jrule:12: a -0-> b".
std::string arc_comment(Function const& f, ir::Arc const& arc);

}  // namespace jrule::cpp
