#include "compiler/analysis/cycles.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "compiler/analysis/alternating_paths.h"
#include "compiler/analysis/wording.h"

namespace jrule::analysis {

using source::Code;

namespace {

struct CycleCheck {
  ir::RuleScheme const& rule;
  algebra::Group const& group;
  PatternWords const& words;
  SideView left{rule.nodes.size(), rule.left, rule.right};
  SideView right{rule.nodes.size(), rule.right, rule.left};
  Refusals refusals{};
  std::set<std::tuple<int, int, ir::NodeId>> reported{};  // the nodes of failing cycles
  std::set<ir::Arc const*> proved{};                      // the arcs in closed cycles of the pair

  std::string name(ir::NodeId id) const { return rule.nodes[id].name; }

  Word word_of(AlternatingPath const& path) const {
    Word word;
    for (ir::Arc const* arc : path) word = group.product(word, arc->word);
    return word;
  }

  std::string model_note(int i, int j) const {
    return fmt::format("in a {} the path {}{}{}{} returns to every dart (cycles; paper, Def. 9 and 27)", map_name(rule.model()), i, j, i, j);
  }

  void label_steps(source::Diagnostic& diagnostic, AlternatingPath const& path) const {
    for (std::size_t k = 0; k < path.size(); ++k) {
      ir::Arc const& arc = *path[k];
      std::string text = fmt::format("step {}: the {}-arc from `{}` to `{}`", k + 1, arc.dimension, name(arc.source), name(arc.target));
      if (!arc.word.empty()) text += ", with " + describe(arc.word);
      diagnostic.notes.push_back(std::move(text));
    }
  }

  // Of a failing cycle, the changed arc that carries a word and is written last: there the words usually go wrong.
  ir::Arc const* culprit(SideView const& view, AlternatingPath const& path) const {
    ir::Arc const* best = nullptr;
    auto const rank = [&](ir::Arc const* arc) { return std::tuple(view.changed(*arc), !arc->word.empty(), arc->span); };
    for (ir::Arc const* arc : path) {
      if (!best || rank(best) < rank(arc)) best = arc;
    }
    return best;
  }

  // A failing cycle is reported once, not from each of its nodes.
  bool first_report(AlternatingPath const& path, int i, int j) {
    auto const key = [&](ir::NodeId node) { return std::tuple(std::min(i, j), std::max(i, j), node); };
    bool const known = std::any_of(path.begin(), path.end(), [&](ir::Arc const* arc) { return reported.contains(key(arc->source)); });
    for (ir::Arc const* arc : path) reported.insert({key(arc->source), key(arc->target)});
    return !known;
  }

  void refuse_cycle(AlternatingPath const& path, int i, int j) {
    ir::NodeId const start = path.front()->source, end = path.back()->target;
    if (!first_report(path, i, j)) return;
    ir::Arc const* const at = culprit(right, path);
    source::Diagnostic diagnostic{.code = Code::open_cycle, .span = at->span, .message = {}};
    diagnostic.message =
        start != end ? fmt::format("the path {}{}{}{} from `{}` leads to `{}` and not back", i, j, i, j, name(start), name(end))
                     : fmt::format("the path {}{}{}{} from a dart of `{}` does not return to it: it ends where {} leads in the pattern", i, j, i, j, name(start),
                                   describe(word_of(path)));
    std::set<source::Span> labelled{at->span};
    for (ir::Arc const* arc : path) {
      if (labelled.insert(arc->span).second) diagnostic.labels.push_back({arc->span, describe(rule, *arc)});
    }
    diagnostic.notes.push_back(model_note(i, j));
    label_steps(diagnostic, path);
    refusals.push_back({std::move(diagnostic), start, i, j});
  }

  void refuse_path(AlternatingPath const& path, AlternatingPath const& partner, bool added, int i, int j) {
    ir::NodeId const start = path.front()->source, end = path.back()->target;
    std::string labels;
    for (ir::Arc const* arc : path) labels += static_cast<char>('0' + arc->dimension);
    std::string along = path.size() == 1 ? describe(rule, *path.front()) : fmt::format("the path {} from `{}` to `{}`", labels, name(start), name(end));
    if (path.size() > 1 && !word_of(path).empty()) along += " with " + describe(word_of(path));
    source::Diagnostic diagnostic{.code = added ? Code::incoherent_added_path : Code::incoherent_deleted_path, .span = path.front()->span, .message = {}};
    diagnostic.message = added ? fmt::format("the rule adds {}, which replaces no deleted path and closes no cycle {}{}{}{}", along, i, j, i, j)
                               : fmt::format("the rule deletes {} without replacing it, which opens a cycle {}{}{}{}", along, i, j, i, j);
    std::set<source::Span> labelled{path.front()->span};
    for (ir::Arc const* arc : path) {
      if (labelled.insert(arc->span).second) diagnostic.labels.push_back({arc->span, describe(rule, *arc)});
    }
    diagnostic.notes.push_back(model_note(i, j));
    diagnostic.notes.push_back(added ? "the rest of that cycle is not matched and stays as it is, so the added path has to lead where a deleted one led, "
                                       "with the same labels and an equal word (coherence; paper, Def. 15 and 26)"
                                     : "the rest of that cycle is not matched and stays as it is, so the right side has to lead there again, with the same "
                                       "labels and an equal word (coherence; paper, Def. 15 and 26)");
    if (!partner.empty()) {
      diagnostic.notes.push_back(fmt::format("the path on the other side has these ends and labels, but {} instead of {}", describe(word_of(partner)), describe(word_of(path))));
    }
    refusals.push_back({std::move(diagnostic), start, i, j});
  }

  void check(CycleObligation const& obligation, int i, int j) {
    AlternatingPath const& path = obligation.path;
    if (obligation.four_steps()) {
      // On the left a closed walk is a fact, and completion has refused the others.
      if (!obligation.added || proved.contains(path.front())) return;
      if (closes(path) && words.trivial(word_of(path))) {
        // It acts as ε from each of its nodes then, for its arcs lead from pattern darts to pattern darts.
        for (ir::Arc const* arc : right.arcs_of(path, rule.model())) proved.insert(arc);
        return;
      }
      // Named by the smaller dimension first where that reads the same.
      ir::Arc const& first = *path.front();
      AlternatingPath const usual = right.walk(first.source, i, j);
      bool const same = usual.size() == 4 && (!closes(usual) || !words.trivial(word_of(usual)));
      same ? refuse_cycle(usual, i, j) : refuse_cycle(path, first.dimension, first.dimension == i ? j : i);
    } else {
      // The left path first, as the certificate has it: the search is bounded, and may find only one of a word and its conjugate.
      AlternatingPath const& before = obligation.added ? obligation.partner : path;
      AlternatingPath const& after = obligation.added ? path : obligation.partner;
      bool const replaced = !obligation.partner.empty() && words.equal(word_of(before), word_of(after));
      if (!replaced) refuse_path(path, obligation.partner, obligation.added, i, j);
    }
  }
};

}  // namespace

Refusals check_cycles(ir::RuleScheme const& completed, algebra::Group const& group, PatternWords const& words) {
  CycleCheck check{completed, group, words};
  for (auto const& [i, j] : completed.model().exchange) {
    check.proved.clear();
    for (CycleObligation const& obligation : cycle_obligations(check.left, check.right, completed.model(), i, j)) check.check(obligation, i, j);
  }
  return std::move(check.refusals);
}

}  // namespace jrule::analysis
