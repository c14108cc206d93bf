// All that a source file means, after sema.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "compiler/ir/operation.h"
#include "compiler/ir/rule_scheme.h"

namespace jrule::ir {

/// What a module's files mean: the root file's modelers, its rules and operations, and those imported that its modelers take.
struct Program {
  std::string module;  ///< the root file's stem
  std::vector<std::shared_ptr<Modeler const>> modelers;
  std::vector<RuleScheme> rules;  ///< also those that only operations use: `sew[2]`
  std::vector<Operation> operations{};
};

/// What the stages rely on: variables are declared where they are read and of the types that they are used as, calls have the
/// arguments of what they call, which is on the operation's modeler, a result type is met by every `return`. None if all holds;
/// else what does not, which is a fault of the compiler.
std::optional<std::string> verify(Operation const& operation, Program const& program);

/// Leaves out the operations that are not good (one flag for each), and those that call one that is left out.
void keep_operations(Program& program, std::vector<bool> good);

/// The textual form, for `jrule emit ir`.
std::string print(Operation const& operation, Program const& program);

}  // namespace jrule::ir
