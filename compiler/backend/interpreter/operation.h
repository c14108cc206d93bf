// Operations, run on a map without a C++ compiler.
#pragma once

#include <optional>
#include <vector>

#include "compiler/analysis/analyze.h"
#include "compiler/ir/evaluate.h"
#include "compiler/ir/program.h"
#include "jrule/operation.h"
#include "jrule/rewrite.h"

namespace jrule::interpreter {

/// A program whose rules are all accepted; `verdicts` are theirs, one each.
struct Runnable {
  ir::Program const& program;
  std::vector<analysis::Verdict> const& verdicts;
};

/// Runs `program.operations[operation]` with one argument for each parameter, of its type: a value or a dart. What it returns; nothing
/// if it has no result. If it fails, the map is bit for bit as it was. Nothing that it runs may need C++ from outside
/// (ir::find_extern_use). A block that may fail after it has changed the map costs a copy of the map (analysis/operations.h); all other
/// costs are those of the rules. `workspace` may be used for other maps as well.
/// `applications`, if given, gets the number of applications of rules.
Result<std::optional<ir::Evaluated>> run(Runnable const& runnable, std::size_t operation, Map& map, std::vector<ir::Evaluated> const& arguments,
                                         rewrite::Workspace& workspace, operation::Progress const& progress = {}, std::size_t* applications = nullptr);

}  // namespace jrule::interpreter
