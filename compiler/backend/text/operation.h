// Operations as text.
#pragma once

#include <string>
#include <vector>

#include "compiler/backend/text/print_jrule.h"

namespace jrule::text {

/// The names that a program's rules and operations have in its text, in their order.
struct ItemNames {
  std::vector<std::string> rules, operations;
};

/// The item `operation NAME(…) on MODELER { … }` of `program.operations[index]`, its modeler as given.
Spelled<std::string> spell_operation(ir::Program const& program, std::size_t index, ItemNames const& names, std::string const& modeler);

}  // namespace jrule::text
