// A modeler as a C++ class: a map, its embeddings by name and type, reading and writing.
#pragma once

#include <string>

#include "compiler/ir/rule_scheme.h"
#include "compiler/source/diagnostic.h"

namespace jrule::cpp {

/// The definition of the class. Reports embeddings whose name a member function cannot have (J0901).
std::string modeler_class(ir::Modeler const& modeler, std::string const& class_name, source::Diagnostics& diagnostics);

}  // namespace jrule::cpp
