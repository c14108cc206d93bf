// What a refusal for topology shows: a counterexample, in the notes of its message and as files.
#pragma once

#include <string>
#include <vector>

#include "compiler/analysis/analyze.h"
#include "jrule/io.h"

namespace jrule::driver {

/// Where counterexamples are to be written, and what: collected while rules are judged.
struct CounterexampleFiles {
  std::string directory;
  std::vector<FileText> files{};
};

/// Searches a counterexample for a rule that is refused for topology, unless its left side is known to match nothing,
/// and adds it to the notes of the first such refusal: the map, the hooks and the violation, or that there is none.
/// With `files`, adds the map before and the graph after to them, and a picture.
void refute(ir::RuleScheme const& rule, analysis::Verdict& verdict, CounterexampleFiles* files);

}  // namespace jrule::driver
