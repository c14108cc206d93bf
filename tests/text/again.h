// What a printed program means: its text parsed and elaborated.
#pragma once

#include <string>

#include "compiler/ir/program.h"

namespace jrule::tests {

struct Again {
  ir::Program program;
  std::string errors;  ///< of the front end, as people see them, without warnings; empty if there are none
};
Again elaborate_again(std::string const& text, std::string const& module);

}  // namespace jrule::tests
