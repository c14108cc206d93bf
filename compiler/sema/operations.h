// Operations: from statements as written to those of the intermediate representation (language reference, section 7).
#pragma once

#include <memory>
#include <optional>

#include "compiler/ir/program.h"
#include "compiler/sema/callees.h"

namespace jrule::sema {

/// All of the operation but its body. None if something was reported.
std::optional<ir::Operation> declare_operation(ast::Operation const& operation, std::string const& name, std::string const& module,
                                               std::shared_ptr<ir::Modeler const> modeler, Externs const& externs, source::Diagnostics& diagnostics);

/// The body of `callees.operations()[index]`, as Program::operations[index] has it then; that program may get further rules and
/// operations, which calls in the body mean. False if something was reported.
bool elaborate_body(std::size_t index, ir::Program& program, Callees& callees, Externs const& externs, source::Diagnostics& diagnostics);

}  // namespace jrule::sema
