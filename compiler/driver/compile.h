// A source file through all stages up to the verdicts.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "compiler/analysis/analyze.h"
#include "compiler/driver/commands.h"
#include "compiler/driver/reference.h"
#include "compiler/driver/refutation.h"
#include "compiler/sema/elaborate.h"

namespace jrule::driver {

struct Compilation {
  source::Sources sources;
  source::Diagnostics diagnostics;
  sema::Modules modules;
  ir::Program program;
  std::vector<analysis::Verdict> verdicts;  ///< of program.rules, one each

  bool read() const { return !modules.all.empty(); }
};

/// Everything is in the diagnostics, refusals with their counterexamples too; those are added to `files`, if given.
std::unique_ptr<Compilation> compile(std::string const& path, Common const& common, CounterexampleFiles* files = nullptr);

/// The verdict on one more rule, its refusals added to the diagnostics.
analysis::Verdict judge(ir::RuleScheme const& rule, source::Diagnostics& diagnostics, CounterexampleFiles* files = nullptr);

/// Leaves only that rule in the program, with its verdict; an instance if it has dimensions, `n` being that of its model. False,
/// reported, if it is not there.
bool keep_only(RuleReference const& reference, std::optional<int> n, Compilation& compilation);

/// Where imports are looked up: `std` in the folder that the environment's JRULE_STDLIB names, else in the one installed with
/// this executable, else in the sources that it was built from.
sema::SearchPath search_path(Common const& common);

}  // namespace jrule::driver
