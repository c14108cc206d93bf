#include "compiler/analysis/closedness.h"

#include <fmt/format.h>

#include "compiler/analysis/wording.h"

namespace jrule::analysis {

using source::Code;

Refusals check_closedness(ir::RuleScheme const& rule, PatternWords const& words) {
  Refusals refusals;
  if (!rule.model().closed) return refusals;
  std::string const note = fmt::format("in a {} no arc leads from a dart to itself", map_name(rule.model()));
  for (ir::Arc const& arc : rule.right.arcs) {
    if (arc.source != arc.target || ir::find_same(rule.left, arc)) continue;
    if (arc.word.empty()) {
      refusals.push_back({{.code = Code::added_loop, .span = arc.span, .message = fmt::format("the rule adds {}: a loop", describe(rule, arc)), .notes = {note}},
                          arc.source, arc.dimension, -1});
    } else if (!words.derive_conjugate_of_letter(arc.word)) {
      refusals.push_back({{.code = Code::unproved_no_loop, .span = arc.span,
                           .message = fmt::format("the rule adds {}, which is a loop where that path returns to its dart", describe(rule, arc)),
                           .notes = {note, "only a path conjugate to a single dimension, or one that the left side shows to lead where such a path does, is known to move every dart of a closed map"}},
                          arc.source, arc.dimension, -1});
    }
  }
  return refusals;
}

}  // namespace jrule::analysis
