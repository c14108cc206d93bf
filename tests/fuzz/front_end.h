// From text to verdicts, as the driver does it, but for files: imports are not looked up.
#pragma once

#include <string_view>
#include <vector>

#include "compiler/analysis/analyze.h"
#include "compiler/ir/program.h"
#include "compiler/sema/modules.h"

namespace jrule::fuzz {

/// Everything that has been said of the text can be shown, to people and as json.
void claim_rendered(source::Sources const& sources, source::Diagnostics const& diagnostics);

struct Checked {
  source::Sources sources;
  source::Diagnostics diagnostics;  ///< also refusals
  sema::Modules modules;
  ir::Program program;
  std::vector<analysis::Verdict> verdicts;  ///< of program.rules, one each
};
/// Claims on the way what ir::verify asks of the front end. `checked` is new.
void check(std::string_view text, Checked& checked);

}  // namespace jrule::fuzz
