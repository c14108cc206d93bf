// What a program uses of C++ from outside, as text.
#pragma once

#include <memory>
#include <vector>

#include "compiler/backend/text/print_jrule.h"

namespace jrule::text {

/// Each once, in the order in which they are met.
struct Externs {
  std::vector<ir::ExternTypePtr> types;
  std::vector<ir::ExternFunctionPtr> functions;
};

/// The extern types and functions that the modelers, and the program's rules and operations name.
Externs externs_of(std::vector<std::shared_ptr<ir::Modeler const>> const& modelers, ir::Program const& program);

/// The items `extern …;`.
Spelled<std::string> spell(ir::ExternType const& type);
Spelled<std::string> spell(ir::ExternFunction const& function);

}  // namespace jrule::text
