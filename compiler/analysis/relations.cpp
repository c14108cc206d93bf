#include "compiler/analysis/relations.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <queue>
#include <set>

#include "compiler/analysis/wording.h"

namespace jrule::analysis {

PatternWords::PatternWords(ir::RuleScheme const& rule, algebra::Group const& group, Placement const& placement) : group_(group) {
  add_arcs(rule, placement);
  add_cycles(rule);
  close(rule);
}

void PatternWords::add(Word word, std::string reason, source::Span span, RelationEvidence evidence) {
  if (word.empty()) return;
  Word const inverse = group_.inverse(word);
  for (Relation const& known : relations_) {
    if (known.word == word || known.word == inverse) return;
  }
  relations_.push_back({std::move(word), std::move(reason), span, std::move(evidence)});
}

// In the first hook's component m(u, s) = u·x_s, so a left arc (w, d) from s to t says u·x_s·d = u·w·x_t.
// In any component, an arc and its reverse with words w and w' lead from (u, s) to (u·w·w', s), and back to the same dart.
void PatternWords::add_arcs(ir::RuleScheme const& rule, Placement const& placement) {
  ir::Table const left(rule.nodes.size(), rule.left);
  auto const index_of = [&](ir::Arc const& arc) { return static_cast<ArcIndex>(&arc - rule.left.arcs.data()); };
  for (ir::Arc const& arc : rule.left.arcs) {
    std::string const reason = fmt::format("the left side matches {}", describe(rule, arc));
    auto const& from = placement.offset(arc.source);
    auto const& to = placement.offset(arc.target);
    if (placement.hook(arc.source) == 0 && from && to) {
      Word const there = group_.product(*from, {Letter{static_cast<std::uint8_t>(arc.dimension), false}});
      add(group_.product(there, group_.inverse(group_.product(arc.word, *to))), reason, arc.span,
          {RelationEvidence::Kind::arc, {index_of(arc)}});
    }
    if (rule.model().is_oriented(arc.dimension)) continue;
    ir::Arc const* const back = left.out(arc.target, arc.dimension);
    if (back && back->target == arc.source) {
      add(group_.product(arc.word, back->word), fmt::format("{}, and its reverse", reason), arc.span,
          {RelationEvidence::Kind::arc_and_reverse, {index_of(arc), index_of(*back)}});
    }
  }
}

// An ijij-cycle of the left side with the word w leads from (u, s) to (u·w, s), and in the map back to the same dart. (So do two
// exchangeable loops on a further hook: the letters that they stand for commute on the pattern.)
void PatternWords::add_cycles(ir::RuleScheme const& rule) {
  ir::Table const left(rule.nodes.size(), rule.left);
  for (auto const& [i, j] : rule.model().exchange) {
    for (ir::NodeId start = 0; start < rule.nodes.size(); ++start) {
      ir::NodeId at = start;
      Word word;
      std::vector<ArcIndex> arcs;
      ir::Arc const* arc = nullptr;
      for (int const d : {i, j, i, j}) {
        arc = left.out(at, d);
        if (!arc) break;
        word = group_.product(word, arc->word);
        arcs.push_back(static_cast<ArcIndex>(arc - rule.left.arcs.data()));
        at = arc->target;
      }
      if (arc && at == start) {
        add(word, fmt::format("the left side matches the cycle {}{}{}{} of `{}`", i, j, i, j, rule.nodes[start].name), arc->span,
            {RelationEvidence::Kind::cycle, std::move(arcs)});
      }
    }
  }
}

void PatternWords::close(ir::RuleScheme const& rule) {
  using Kind = ClosureEvidence::Kind;
  auto const set = [&](int d, Kind kind, std::size_t index) {
    if (closed_under(d)) return;
    closed_ = static_cast<std::uint16_t>(closed_ | (1U << d));
    closure_.push_back({d, kind, index});
  };
  for (std::size_t k = 0; k < rule.hook_type.size(); ++k) set(rule.hook_type[k].dimension, Kind::hook_type, k);
  for (auto const& [side, kind] : {std::pair{&rule.left, Kind::left_word}, std::pair{&rule.right, Kind::right_word}}) {
    for (ArcIndex k = 0; k < side->arcs.size(); ++k) {
      if (side->arcs[k].word.size() == 1) set(side->arcs[k].word.front().dimension, kind, k);
    }
  }
  // A relation d·w = ε with w in the pattern says that d leads where w̄ does.
  bool changed = true;
  while (changed) {
    changed = false;
    for (std::size_t r = 0; r < relations_.size(); ++r) {
      std::optional<int> other;
      int others = 0;
      for (Letter const letter : relations_[r].word) {
        if (closed_under(letter.dimension)) continue;
        other = letter.dimension;
        ++others;
      }
      // It must stand first or last: between other letters, it is walked from a dart of the pattern all the same, since all
      // letters before it stay there.
      if (others == 1) {
        set(*other, Kind::relation, r);
        changed = true;
      }
    }
  }
}

bool PatternWords::stays_in_pattern(Word const& word) const {
  return std::all_of(word.begin(), word.end(), [&](Letter letter) { return closed_under(letter.dimension); });
}

std::optional<Derivation> PatternWords::derive(Word const& word) const {
  Word const start = group_.normal_form(word);
  if (start.empty()) return Derivation{word, {}};
  if (relations_.empty()) return {};

  struct Reached { Word from; Derivation::Step step; };
  std::map<Word, Reached> reached;
  auto const longer = [](Word const& a, Word const& b) { return std::pair(a.size(), a) > std::pair(b.size(), b); };
  std::priority_queue<Word, std::vector<Word>, decltype(longer)> open(longer);
  std::size_t longest = 0;
  for (Relation const& relation : relations_) longest = std::max(longest, relation.word.size());
  std::size_t const limit = start.size() + longest;
  constexpr std::size_t max_words = 2000;  // words are short and relations few: what is not found by then hardly exists

  reached[start] = {};
  open.push(start);
  while (!open.empty() && reached.size() < max_words) {
    Word const at = open.top();
    open.pop();
    for (std::size_t cut = 0; cut <= at.size(); ++cut) {
      Word const prefix(at.begin(), at.begin() + static_cast<std::ptrdiff_t>(cut));
      if (!stays_in_pattern(prefix)) break;
      Word const rest(at.begin() + static_cast<std::ptrdiff_t>(cut), at.end());
      for (std::size_t r = 0; r < relations_.size(); ++r) {
        for (bool const conjugate : {false, true}) {
          Word const inserted = conjugate ? group_.inverse(relations_[r].word) : relations_[r].word;
          Word next = group_.product(group_.product(prefix, inserted), rest);
          if (next.size() > limit || reached.contains(next)) continue;
          reached[next] = {at, {prefix, r, conjugate, next}};
          if (next.empty()) {
            Derivation derivation{word, {}};
            for (Word back = next; back != start; back = reached[back].from) derivation.steps.push_back(reached[back].step);
            std::reverse(derivation.steps.begin(), derivation.steps.end());
            return derivation;
          }
          open.push(std::move(next));
        }
      }
    }
  }
  return {};
}

}  // namespace jrule::analysis
