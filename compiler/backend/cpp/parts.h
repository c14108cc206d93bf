// What the functions of rules and operations have in common.
#pragma once

#include <string>
#include <vector>

#include "compiler/backend/cpp/writer.h"
#include "compiler/ir/rule_scheme.h"

namespace jrule::cpp {

/// ": what it is", the first line of a documentation comment, to stand behind a few words; empty if there is none.
std::string remark(std::string const& doc);
/// "/// @param height  Real in m, by default 1: how far up".
std::string document_parameter(ir::Parameter const& parameter, std::string const& name);
std::string default_of(ir::Parameter const& parameter);

/// "name(a, b)" with what follows, each parameter on a line of its own if they do not fit on one. `opens`: a block follows.
void open_call(Writer& out, std::string const& start, std::vector<std::string> const& list, std::string const& end, bool opens);

/// Functions are `try` blocks as a whole: whatever they allocate, running out of memory leaves the map as it was.
void close_function(Writer& out, std::string const& name);

}  // namespace jrule::cpp
