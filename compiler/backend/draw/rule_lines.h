// What of a rule is drawn: each arc once, joined with its reverse, and the relabellings that nodes wear.
#pragma once

#include <string>
#include <vector>

#include "compiler/algebra/group.h"
#include "compiler/ir/rule_scheme.h"

namespace jrule::draw {

struct RuleLine {
  ir::Arc const* arc;
  bool both_ways;   ///< the arc and its reverse
  bool palindrome;  ///< the word is its own conjugate
  bool preserved;   ///< it stands on the other side, too
};

/// The lines of a side in the order of writing: each arc alone or with its reverse, once. An arc is joined only with a
/// reverse that is preserved as it is. They point into `side`.
std::vector<RuleLine> rule_lines(algebra::Group const& group, ir::Side const& side, ir::Side const& other_side);

/// "2", "2[0,~1]".
std::string arc_label(ir::Arc const& arc);

/// The decorations of the nodes of a side, and the lines that these do not say.
struct DecoratedSide {
  std::vector<std::string> decorations;  ///< by node, "<0,_,2>": as long as the hook's type; empty if that is
  std::vector<RuleLine> lines;
};
DecoratedSide decorated_side(ir::RuleScheme const& rule, algebra::Group const& group, bool left);

}  // namespace jrule::draw
