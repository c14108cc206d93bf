#include "compiler/analysis/dead_left.h"

#include <fmt/format.h>

#include <algorithm>

#include "compiler/analysis/wording.h"

namespace jrule::analysis {

using source::Code;

namespace {

// In the first hook's component m(u, s) = u·x_s. If x_s·x̄_t leads from the pattern into the pattern, to u·p, then
// m(u·p, t) = u·p·x_t = u·x_s = m(u, s): a dart matched twice.
void check_clashes(ir::RuleScheme const& rule, algebra::Group const& group, Placement const& placement, PatternWords const& words,
                   Refusals& refusals) {
  for (ir::NodeId s = 0; s < rule.nodes.size(); ++s) {
    for (ir::NodeId t = s + 1; t < rule.nodes.size(); ++t) {
      if (rule.nodes[s].added() || rule.nodes[t].added() || placement.hook(s) != 0 || placement.hook(t) != 0) continue;
      if (!placement.offset(s) || !placement.offset(t)) continue;
      Word const between = group.product(*placement.offset(s), group.inverse(*placement.offset(t)));
      if (!words.stays_in_pattern(between)) continue;
      source::Diagnostic diagnostic{
          .code = Code::dead_clash, .span = *rule.nodes[t].left_span,
          .message = fmt::format("no map matches the left side: `{}` and `{}` would be the same darts", rule.nodes[s].name, rule.nodes[t].name),
          .labels = {{*rule.nodes[s].left_span, fmt::format("every dart of `{}` is one of `{}` too", rule.nodes[t].name, rule.nodes[s].name)}},
          .notes = {between.empty() ? fmt::format("at each dart of the pattern `{}` and `{}` stand for the same dart", rule.nodes[s].name, rule.nodes[t].name)
                                    : fmt::format("`{}` at a dart of the pattern and `{}` at the one where {} leads from it stand for the same dart",
                                                  rule.nodes[s].name, rule.nodes[t].name, describe(between)),
                    "a match takes each dart once (paper, section 6.3)"}};
      refusals.push_back({std::move(diagnostic), t, -1, -1});
      return;
    }
  }
}

}  // namespace

Refusals check_dead_left(ir::RuleScheme const& rule, algebra::Group const& group, Placement const& placement, PatternWords const& words) {
  Refusals refusals;
  check_clashes(rule, group, placement, words, refusals);
  if (!rule.model().closed) return refusals;
  for (ir::Arc const& arc : rule.left.arcs) {
    if (arc.source != arc.target || !words.trivial(arc.word)) continue;
    refusals.push_back({{.code = Code::dead_fixed_dart, .span = arc.span,
                         .message = fmt::format("no map matches the left side: {} is a loop", describe(rule, arc)),
                         .notes = {fmt::format("in a {} no arc leads from a dart to itself", map_name(rule.model()))}},
                        arc.source, arc.dimension, -1});
    return refusals;
  }
  // ε leads where a conjugate of a letter does.
  auto const fixed = words.derive_conjugate_of_letter({});
  if (!fixed) return refusals;
  Relation const& first = words.relations()[fixed->steps.front().relation];
  source::Diagnostic diagnostic{.code = Code::dead_fixed_dart, .span = first.span,
                                .message = fmt::format("no map matches the left side: {} would lead a dart back to itself", describe(fixed->steps.back().result))};
  for (Derivation::Step const& step : fixed->steps) {
    std::string const& reason = words.relations()[step.relation].reason;
    if (std::find(diagnostic.notes.begin(), diagnostic.notes.end(), reason) == diagnostic.notes.end()) diagnostic.notes.push_back(reason);
  }
  diagnostic.notes.push_back(fmt::format("in a {} no arc leads from a dart to itself, so that path leads to another dart", map_name(rule.model())));
  refusals.push_back({std::move(diagnostic), 0, -1, -1});
  return refusals;
}

}  // namespace jrule::analysis
