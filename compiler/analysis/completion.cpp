#include "compiler/analysis/completion.h"

#include <fmt/format.h>

#include "compiler/analysis/wording.h"

namespace jrule::analysis {

using source::Code;

namespace {

struct Completion {
  algebra::Group const& group;
  Placement const& placement;
  PatternWords const& words;
  Completed result;

  std::string name(ir::NodeId id) const { return result.rule.nodes[id].name; }

  ArcIndex index_of(ir::Arc const& arc) const { return static_cast<ArcIndex>(&arc - result.rule.left.arcs.data()); }

  void add_to_both(ir::Arc arc, ImpliedEvidence evidence) {
    result.implied.push_back(std::move(evidence));
    result.rule.left.arcs.push_back(arc);
    result.rule.right.arcs.push_back(std::move(arc));
  }

  // Every arc of a non-oriented dimension has its reverse; darts of distinct nodes are distinct.
  bool complete_reverse() {
    ir::Table const table(result.rule.nodes.size(), result.rule.left);
    for (ir::Arc const& arc : result.rule.left.arcs) {
      int const d = arc.dimension;
      if (result.rule.model().is_oriented(d)) continue;
      ir::Arc const* const back = table.out(arc.target, d);
      ir::Arc const* const into = table.in(arc.source, d);
      ir::Arc const* const clash = back && back->target != arc.source ? back : into && into->source != arc.target ? into : nullptr;
      if (clash) {
        result.dead.push_back({{.code = Code::dead_arc, .span = clash->span,
                                .message = fmt::format("no map matches the left side: {} cannot stand beside {}", describe(result.rule, *clash), describe(result.rule, arc)),
                                .labels = {{arc.span, fmt::format("its reverse would lead from `{}` to `{}`", name(arc.target), name(arc.source))}},
                                .notes = {fmt::format("in a {} the reverse of a {}-arc is the {}-arc of its target (non-orientation; paper, Def. 9)",
                                                      map_name(result.rule.model()), d, d)}},
                               arc.source, d, -1});
        return false;
      }
      if (!back) {
        add_to_both({arc.target, d, group.inverse(arc.word), arc.source, arc.span}, {ImpliedEvidence::Kind::reverse, {index_of(arc)}});
        return true;
      }
    }
    return false;
  }

  bool complete_cycle(int i, int j) {
    ir::RuleScheme& rule = result.rule;
    ir::Table const table(rule.nodes.size(), rule.left);
    for (ir::NodeId start = 0; start < rule.nodes.size(); ++start) {
      ir::Arc const* const first = table.out(start, i);
      ir::Arc const* const second = first ? table.out(first->target, j) : nullptr;
      ir::Arc const* const third = second ? table.out(second->target, i) : nullptr;
      if (!third) continue;
      ir::NodeId const end = third->target;
      ir::Arc const* const fourth = table.out(end, j);
      ir::Arc const* const into = table.in(start, j);
      if (fourth && fourth->target == start) continue;
      if (fourth || into) {
        ir::Arc const* const clash = fourth ? fourth : into;
        rule_out(start, i, j, *first, *second, *third, *clash);
        return false;
      }
      Word const word = group.product(group.product(first->word, second->word), third->word);
      ir::Arc const arc{end, j, group.inverse(word), start, second->span};
      ArcIndex const added = rule.left.arcs.size();
      add_to_both(arc, {ImpliedEvidence::Kind::cycle, {index_of(*first), index_of(*second), index_of(*third)}});
      // From a node to itself it is its own reverse, or the left side matches only where it is.
      if (!rule.model().is_oriented(j) && start != end) add_to_both({start, j, word, end, arc.span}, {ImpliedEvidence::Kind::reverse, {added}});
      return true;
    }
    return false;
  }

  // m(u, s)·d = u·x_s·d = u·w·x_t = m(u·w, t) in every map, although the left side does not say so.
  bool complete_within() {
    ir::RuleScheme& rule = result.rule;
    ir::Table const table(rule.nodes.size(), rule.left);
    auto const in_first = [&](ir::NodeId id) { return rule.nodes[id].preserved() && placement.hook(id) == 0 && placement.offset(id); };
    for (ir::NodeId s = 0; s < rule.nodes.size(); ++s) {
      for (int const d : rule.model().dimensions) {
        if (!in_first(s) || table.out(s, d)) continue;
        Word const there = group.product(*placement.offset(s), {Letter{static_cast<std::uint8_t>(d), false}});
        for (ir::NodeId t = 0; t < rule.nodes.size(); ++t) {
          if (!in_first(t) || table.in(t, d)) continue;
          Word const word = group.product(there, group.inverse(*placement.offset(t)));
          if (!words.stays_in_pattern(word)) continue;
          add_to_both({s, d, word, t, rule.nodes[s].span()}, {ImpliedEvidence::Kind::placement, {}});
          return true;
        }
      }
    }
    return false;
  }

  void rule_out(ir::NodeId start, int i, int j, ir::Arc const& first, ir::Arc const& second, ir::Arc const& third, ir::Arc const& clash) {
    result.dead.push_back(
        {{.code = Code::dead_cycle, .span = clash.span,
          .message = fmt::format("no map matches the left side: the path {}{}{} leads from `{}` to `{}`, so the {}-arc of `{}` has to lead to `{}`", i, j, i,
                                 name(start), name(third.target), j, name(third.target), name(start)),
          .labels = {{first.span, fmt::format("{}-arc to `{}`", i, name(first.target))},
                     {second.span, fmt::format("then the {}-arc to `{}`", j, name(second.target))},
                     {third.span, fmt::format("then the {}-arc to `{}`", i, name(third.target))}},
          .notes = {fmt::format("in a {} the path {}{}{}{} returns to every dart (cycles; paper, Def. 9)", map_name(result.rule.model()), i, j, i, j)}},
         start, i, j});
  }
};

}  // namespace

Completed complete(ir::RuleScheme const& rule, algebra::Group const& group, Placement const& placement, PatternWords const& words) {
  Completion completion{group, placement, words, {rule, {}, {}}};
  // Each step adds an arc to a node that had none, so this ends.
  bool changed = true;
  while (changed && completion.result.dead.empty()) {
    changed = completion.complete_reverse();
    if (!changed && completion.result.dead.empty()) changed = completion.complete_within();
    for (auto const& [i, j] : rule.model().exchange) {
      if (!changed && completion.result.dead.empty()) changed = completion.complete_cycle(i, j) || (completion.result.dead.empty() && completion.complete_cycle(j, i));
    }
  }
  return std::move(completion.result);
}

}  // namespace jrule::analysis
