// Why a rule is refused: the condition that fails, where, and the words for it.
#pragma once

#include <vector>

#include "compiler/ir/rule_scheme.h"
#include "compiler/source/diagnostic.h"

namespace jrule::analysis {

struct Refusal {
  source::Diagnostic diagnostic;
  ir::NodeId node = 0;  ///< at which the condition fails
  int i = -1;           ///< the dimension
  int j = -1;           ///< the second dimension of a cycle
};
using Refusals = std::vector<Refusal>;

/// Is the rule refused because no map matches its left side? Then there is none that it breaks.
inline bool is_dead_left(Refusal const& refusal) {
  using source::Code;
  Code const code = refusal.diagnostic.code;
  return code == Code::dead_arc || code == Code::dead_cycle || code == Code::dead_clash || code == Code::dead_fixed_dart;
}

}  // namespace jrule::analysis
