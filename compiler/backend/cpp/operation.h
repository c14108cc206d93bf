// Operations as C++: a function that callers see, and one with what a run has in common, which operations call.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "compiler/backend/cpp/expression.h"
#include "compiler/backend/cpp/function.h"
#include "compiler/ir/program.h"

namespace jrule::cpp {

/// The names that an operation brings into its namespace.
struct OperationPublicNames {
  std::string function;  ///< "house"
  std::string run;       ///< "run_house"
  std::string modeler;   ///< the class that it works on, as it is called here
  std::string class_name;
};

/// The operations of a program, whose rules have these functions, in their order.
struct Operations {
  ir::Program const& program;
  source::Sources const& sources;
  std::vector<Function> const& rules;
  std::vector<OperationPublicNames> const& names;
  Scope const& scope;  ///< of their namespace
};

/// The declaration that callers see, its documentation first.
std::string declare_operation(Operations const& all, std::size_t index);
/// That of the function which operations call: these stand before all definitions.
std::string declare_run(Operations const& all, std::size_t index);
std::string define_operation(Operations const& all, std::size_t index);

/// The rules that some operation applies everywhere in an orbit.
std::set<std::size_t> applied_within(ir::Program const& program);

}  // namespace jrule::cpp
