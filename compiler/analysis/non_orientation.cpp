#include "compiler/analysis/non_orientation.h"

#include <fmt/format.h>

#include "compiler/analysis/wording.h"

namespace jrule::analysis {

using source::Code;

namespace {

void check_side(ir::RuleScheme const& rule, algebra::Group const& group, PatternWords const& words, bool added, Refusals& refusals) {
  ir::Side const& side = added ? rule.right : rule.left;
  ir::Side const& other = added ? rule.left : rule.right;
  ir::Table const table(rule.nodes.size(), side);
  for (ir::Arc const& arc : side.arcs) {
    int const d = arc.dimension;
    if (rule.model().is_oriented(d) || ir::find_same(other, arc)) continue;
    std::string const verb = added ? "adds" : "deletes";
    std::string const note = fmt::format("in a {} dimension {} is not oriented: every {}-arc has its reverse, which the rule has to {} with it "
                                         "(non-orientation; paper, Def. 24)", map_name(rule.model()), d, d, added ? "add" : "delete");
    ir::Arc const* const back = table.out(arc.target, d);
    if (!back || back->target != arc.source) {
      source::Diagnostic diagnostic{.code = added ? Code::single_added_arc : Code::single_deleted_arc, .span = arc.span,
                                    .message = fmt::format("the rule {} {} without its reverse", verb, describe(rule, arc)), .notes = {note}};
      if (back) diagnostic.labels.push_back({back->span, fmt::format("from `{}` there is {}", rule.nodes[arc.target].name, describe(rule, *back))});
      if (!back && arc.source != arc.target) {
        diagnostic.notes.push_back(fmt::format("write {} for both directions", both_directions(rule, arc)));
      }
      refusals.push_back({std::move(diagnostic), arc.source, d, -1});
      continue;
    }
    if (back < &arc) continue;  // judged with that one
    Word const expected = group.inverse(arc.word);
    if (words.equal(back->word, expected)) continue;
    if (&arc == back) {
      refusals.push_back({{.code = Code::words_not_conjugate, .span = arc.span,
                           .message = fmt::format("the rule {} {}, which is not its own reverse: that carries {}", verb, describe(rule, arc), describe(expected)),
                           .notes = {note}},
                          arc.source, d, -1});
    } else {  // of a pair with wrong words, the arc that is written first is reported
      source::Diagnostic diagnostic{
          .code = Code::words_not_conjugate, .span = back->span,
          .message = fmt::format("the {}-arc from `{}` to `{}` carries {}, but the reverse of the arc from `{}` carries {}", d,
                                 rule.nodes[back->source].name, rule.nodes[back->target].name, describe(back->word), rule.nodes[arc.source].name,
                                 describe(expected)),
          .labels = {{arc.span, describe(rule, arc)}}, .notes = {note}};
      refusals.push_back({std::move(diagnostic), arc.source, d, -1});
    }
  }
}

}  // namespace

Refusals check_non_orientation(ir::RuleScheme const& rule, algebra::Group const& group, PatternWords const& words) {
  Refusals refusals;
  check_side(rule, group, words, false, refusals);
  check_side(rule, group, words, true, refusals);
  return refusals;
}

}  // namespace jrule::analysis
