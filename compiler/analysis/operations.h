// Operations after the verdicts on the rules that they call.
#pragma once

#include <vector>

#include "compiler/analysis/analyze.h"
#include "compiler/ir/program.h"

namespace jrule::analysis {

/// What is wrong with an operation because of its rules (`verdicts`, one for each of the program's): calls of rules that are
/// refused (J0512), `apply_all` of rules that are not proved independent (J0513).
std::vector<source::Diagnostic> check_calls(ir::Operation const& operation, ir::Program const& program, std::vector<Verdict> const& verdicts);

/// Transactions. A block that fails leaves the map as it was before. The application of a rule does so by itself; what was done
/// before the statement that fails has to be undone. May a statement of the block fail after another one, or an earlier round of a
/// loop, has changed the map? Only then is the map copied where the block begins. A block with a single call, or one
/// `if` between two, needs none. What may fail: calls, `fail`, rounds of `while` (which may be cancelled), and whatever reads
/// the map or makes a list. What changes the map: calls.
bool may_fail_after_change(ir::Block const& block);

}  // namespace jrule::analysis
