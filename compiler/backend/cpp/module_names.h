// The names that a module's modelers and rules have in C++.
#pragma once

#include <string>
#include <vector>

#include "compiler/backend/cpp/emit.h"
#include "compiler/backend/cpp/function.h"
#include "compiler/backend/cpp/operation.h"

namespace jrule::cpp {

struct Class {
  ir::Modeler const* modeler;
  std::string name_space;
  std::string name;
};

struct ModuleNames {
  std::string name_space;
  std::vector<Class> classes;      ///< the program's modelers, then those of other modules that its rules work on
  std::vector<PublicNames> rules;  ///< one for each rule
  std::vector<OperationPublicNames> operations;  ///< one for each of the program's
  std::vector<std::string> taken;  ///< of the namespace

  Class const& class_of(ir::Modeler const& modeler) const;
};

/// Names that C++ cannot use, or that are taken twice, are reported (J0901).
ModuleNames name_module(ir::Program const& program, std::vector<Rule> const& rules, Options const& options,
                        source::Diagnostics& diagnostics);

}  // namespace jrule::cpp
