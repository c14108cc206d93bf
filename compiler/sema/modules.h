// Modules: a root file and what it imports, parsed, dependencies first.
#pragma once

#include <string>
#include <vector>

#include "compiler/source/diagnostic.h"
#include "compiler/syntax/ast.h"

namespace jrule::sema {

struct SearchPath {
  std::string stdlib;                ///< the folder that holds `std/`; empty if there is none
  std::vector<std::string> folders;  ///< `-I`, in order
};

struct Module {
  std::string name;  ///< the file's stem for the root, "std.surface" for an import
  ast::File ast;
  struct Import {
    std::size_t module;  ///< in Modules::all
    source::Span span;
  };
  std::vector<Import> imports{};  ///< those that were found, in order
};

struct Modules {
  std::vector<Module> all;          ///< dependencies first; the root last. Empty if the root cannot be read
  std::vector<std::string> paths;   ///< of the files read, the root first: for a depfile
};

/// Reads and parses `path` and, once each, the modules that it imports. `std.*` comes from the standard library, any other
/// name is looked up beside the importing file, then along the search path (`a.b` is the file a/b.jrule). Reports J0001,
/// J0004, J0005 and what parsing finds.
Modules load(std::string const& path, SearchPath const& search, source::Sources& sources, source::Diagnostics& diagnostics);

}  // namespace jrule::sema
