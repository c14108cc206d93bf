// The C++ from outside that generated code uses: which headers, and whether the names can be C++ names.
#pragma once

#include <set>
#include <string>

#include "compiler/ir/program.h"
#include "compiler/source/diagnostic.h"

namespace jrule::cpp {

/// Adds the headers of the extern types and functions that a modeler's embeddings, a rule or an operation use. Reports those whose
/// C++ name has a part that C++ cannot use (J0901).
void add_headers(ir::Modeler const& modeler, std::set<std::string>& headers, source::Diagnostics& diagnostics);
void add_headers(ir::RuleScheme const& rule, std::set<std::string>& headers, source::Diagnostics& diagnostics);
void add_headers(ir::Operation const& operation, std::set<std::string>& headers, source::Diagnostics& diagnostics);

}  // namespace jrule::cpp
