// Imported rules and operations: which ones a file sees, and how what is wrong with them is told to it (language reference, section 3).
#pragma once

#include <string>
#include <vector>

#include "compiler/sema/modules.h"

namespace jrule::sema {

/// A rule of a module that the root imports.
struct ImportedRule {
  ast::Rule const* rule;
  std::string module;   ///< that declares it
  source::Span import;  ///< in the root
};

/// The rules of the modules that the root itself imports, in the order of its imports; not those whose name stands for
/// another rule in the root.
std::vector<ImportedRule> imported_rules(Modules const& modules);

struct ImportedOperation {
  ast::Operation const* operation;
  Module const* module;  ///< that declares it
  source::Span import;   ///< in the root
};
/// The same of operations.
std::vector<ImportedOperation> imported_operations(Modules const& modules);

/// What was found in an imported rule or operation on a modeler of the root, told at the import: the rule itself may be right, and its file
/// is seldom the user's to change.
source::Diagnostic told_at_import(source::Diagnostic found, source::Span import, std::string const& rule, std::string const& module,
                                  std::string const& modeler);

}  // namespace jrule::sema
