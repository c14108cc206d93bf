// What a module's page tells, gathered from what was written and from what was proved.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compiler/analysis/analyze.h"
#include "compiler/ir/program.h"
#include "compiler/sema/modules.h"

namespace jrule::docs {

struct Parameter {
  std::string name, type;
  std::string default_value;  ///< as written; empty if there is none
  std::string unit, doc;
};
/// A hook, or a node that is documented.
struct Node {
  std::string name;
  std::string decoration;  ///< as written, "<0,1>"; empty if there is none
  std::string doc;
  bool hook = false;
};
struct Embedding {
  std::string name, orbit, type;
  std::string default_value, merge;  ///< empty if there is none
  std::string doc;
};

struct Section {
  enum class Kind { model, modeler, rule, family, operation, extern_type, extern_function } kind;
  std::string name;
  std::string signature;  ///< "cone(apex: Point3) on Mesh"
  std::string doc;
  std::string source;     ///< in canonical layout
  std::vector<Parameter> parameters{};
  std::vector<Node> nodes{};
  std::vector<Embedding> embeddings{};
  /// Of a rule, itself; of a family, the first of its rules that is found and accepted: on maps of dimension 2, else 3, else 1, in the
  /// greatest dimensions.
  std::optional<ir::RuleScheme> rule{};
  analysis::Plan plan{};                   ///< of `rule`
  std::optional<std::size_t> operation{};  ///< in the program
};

struct Module {
  std::string name;
  std::string doc;  ///< the documentation at the top of the file, where that is not an item's
  struct Import {
    std::string name;  ///< "std.mesh"
    std::string path;  ///< of its file
  };
  std::vector<Import> imports;
  std::vector<Section> sections;  ///< its items in order, but for imports
};

/// Of the root module, which has no errors: `program` is what it was elaborated to, and `verdicts` are those on its rules, all accepted.
Module describe(source::Sources const& sources, sema::Modules const& modules, ir::Program const& program,
                std::vector<analysis::Verdict> const& verdicts);

}  // namespace jrule::docs
