#include "compiler/analysis/relations.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <queue>
#include <set>

#include "compiler/analysis/wording.h"

namespace jrule::analysis {

PatternWords::PatternWords(ir::RuleScheme const& rule, algebra::Group const& group, Placement const& placement) : group_(group) {
  using Kind = Generator::Kind;
  auto const generate = [&](Word const& word, Generator generator) {
    bool const known = std::any_of(generators_.begin(), generators_.end(), [&](GeneratorWord const& g) { return g.word == word; });
    if (!word.empty() && !known) generators_.push_back({word, generator});
  };
  for (std::size_t k = 0; k < rule.hook_type.size(); ++k) generate(group.normal_form({rule.hook_type[k]}), {Kind::hook_type, k});
  for (ArcIndex k = 0; k < rule.left.arcs.size(); ++k) generate(rule.left.arcs[k].word, {Kind::left_word, k});
  for (ArcIndex k = 0; k < rule.right.arcs.size(); ++k) generate(rule.right.arcs[k].word, {Kind::right_word, k});
  add_arcs(rule, placement);
  add_cycles(rule);
  add_single_dart(rule);
  close();
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

// Only its own loops say where the copies of a further hook lie (theory: section 2). Without any, that is said of one dart.
void PatternWords::add_single_dart(ir::RuleScheme const& rule) {
  for (std::size_t h = 1; h < rule.hooks.size(); ++h) {
    ir::NodeId const hook = rule.hooks[h];
    bool const walked = std::any_of(rule.left.arcs.begin(), rule.left.arcs.end(),
                                    [&](ir::Arc const& arc) { return arc.source == hook && arc.target == hook && !arc.word.empty(); });
    if (walked) continue;
    for (GeneratorWord const& g : generators_) {
      add(g.word, fmt::format("the hook `{}` has no loop that carries a path, so the left side matches only where the pattern is a single dart", rule.nodes[hook].name),
          *rule.nodes[hook].left_span, {RelationEvidence::Kind::single_dart, {}, h, g.generator});
    }
    return;
  }
}

void PatternWords::close() {
  // The letter stands between letters that stay in the pattern: it is walked from a dart of the pattern, and what follows leads
  // from a dart of the pattern only if it was one.
  auto const only_other = [&](Word const& word) -> std::optional<int> {
    std::optional<int> other;
    for (Letter const letter : word) {
      if (closed_under(letter.dimension)) continue;
      if (other) return {};
      other = letter.dimension;
    }
    return other;
  };
  auto const set = [&](int d, ClosureEvidence evidence) {
    closed_ = static_cast<std::uint16_t>(closed_ | (1U << d));
    evidence.dimension = d;
    closure_.push_back(evidence);
  };
  bool changed = true;
  while (changed) {
    changed = false;
    for (GeneratorWord const& g : generators_) {
      if (auto const d = only_other(g.word)) set(*d, {0, {}, g.generator}), changed = true;
    }
    for (std::size_t r = 0; r < relations_.size(); ++r) {
      if (auto const d = only_other(relations_[r].word)) set(*d, {0, r, {}}), changed = true;
    }
  }
  auto const closed = [&](Letter letter) { return closed_under(letter.dimension); };
  for (GeneratorWord const& g : generators_) {
    for (bool const backwards : {false, true}) {
      Word const word = backwards ? group_.inverse(g.word) : g.word;
      auto const first = std::find_if_not(word.begin(), word.end(), closed);
      if (first == word.end()) break;
      auto const last = std::find_if_not(word.rbegin(), std::make_reverse_iterator(first), closed).base();
      strides_.push_back({{word.begin(), first}, {first, last}, {last, word.end()}, {{}, g.generator, backwards}});
    }
  }
}

// Every relation of Γ has an even number of each letter, so how often each occurs, modulo 2, is a sum of generators' in any product
// of them; and a letter that no generator has occurs in no normal form of one. Cheap, and enough to refuse most words.
bool PatternWords::may_be_walked(Word const& word) const {
  auto const parity = [](Word const& w) {
    unsigned bits = 0;
    for (Letter const letter : w) bits ^= 1U << letter.dimension;
    return bits;
  };
  unsigned letters = closed_;
  std::vector<unsigned> basis;
  auto const reduce = [&](unsigned bits) {
    for (unsigned const b : basis) bits = std::min(bits, bits ^ b);
    return bits;
  };
  auto const extend = [&](unsigned bits) {
    bits = reduce(bits);
    if (bits != 0) basis.push_back(bits);
    std::sort(basis.rbegin(), basis.rend());
  };
  for (int d = 0; d <= max_dimension; ++d) {
    if (closed_under(d)) extend(1U << d);
  }
  for (GeneratorWord const& g : generators_) {
    for (Letter const letter : g.word) letters |= 1U << letter.dimension;
    extend(parity(g.word));
  }
  Word const normal = group_.normal_form(word);
  bool const known = std::all_of(normal.begin(), normal.end(), [&](Letter letter) { return ((letters >> letter.dimension) & 1U) != 0; });
  return known && reduce(parity(normal)) == 0;
}

// Letters under which the pattern is closed, and among them at most one generator as it stands.
std::optional<std::vector<PatternStep>> PatternWords::direct_walk(Word const& word) const {
  auto const closed = [&](Letter letter) { return closed_under(letter.dimension); };
  auto const first = std::find_if_not(word.begin(), word.end(), closed);
  auto const last = std::find_if_not(word.rbegin(), std::make_reverse_iterator(first), closed).base();
  std::vector<PatternStep> steps;
  for (auto letter = word.begin(); letter != first; ++letter) steps.push_back({*letter, {}, false});
  if (first == word.end()) return steps;
  Word const middle(first, last);
  auto const along = std::find_if(strides_.begin(), strides_.end(), [&](Stride const& stride) { return stride.core == middle; });
  if (along == strides_.end()) return {};
  // The generator is before·core·after.
  for (Letter const letter : group_.inverse(along->before)) steps.push_back({letter, {}, false});
  steps.push_back(along->step);
  for (Letter const letter : group_.inverse(along->after)) steps.push_back({letter, {}, false});
  for (auto letter = last; letter != word.end(); ++letter) steps.push_back({*letter, {}, false});
  return steps;
}

std::optional<std::vector<PatternStep>> PatternWords::walk_in_pattern(Word const& word) const {
  if (auto direct = direct_walk(word)) return direct;
  if (strides_.empty() || !may_be_walked(word)) return {};
  std::vector<std::pair<Word, PatternStep>> strides;
  for (Stride const& stride : strides_) strides.push_back({group_.product(group_.product(stride.before, stride.core), stride.after), stride.step});
  for (int const d : group_.model().dimensions) {
    if (!closed_under(d)) continue;
    for (bool const conjugate : {false, true}) {
      Letter const letter{static_cast<std::uint8_t>(d), conjugate};
      if (!conjugate || group_.model().is_oriented(d)) strides.push_back({{letter}, {letter, {}, false}});
    }
  }
  // What is still to be walked, shortest first.
  struct Reached { Word from; std::size_t stride; };
  std::map<Word, Reached> reached;
  auto const longer = [](Word const& a, Word const& b) { return std::pair(a.size(), a) > std::pair(b.size(), b); };
  std::priority_queue<Word, std::vector<Word>, decltype(longer)> open(longer);
  Word const start = group_.normal_form(word);
  std::size_t limit = start.size();
  for (auto const& [along, step] : strides) limit = std::max(limit, start.size() + along.size());
  constexpr std::size_t max_words = 200;  // the words of rules are short
  reached[start] = {};
  open.push(start);
  while (!open.empty() && reached.size() < max_words) {
    Word const at = open.top();
    open.pop();
    for (std::size_t k = 0; k < strides.size(); ++k) {
      Word next = group_.product(group_.inverse(strides[k].first), at);
      if (next.size() > limit || reached.contains(next)) continue;
      reached[next] = {at, k};
      if (next.empty()) {
        std::vector<PatternStep> steps;
        for (Word back = next; back != start; back = reached[back].from) steps.push_back(strides[reached[back].stride].second);
        std::reverse(steps.begin(), steps.end());
        return steps;
      }
      open.push(std::move(next));
    }
  }
  return {};
}

std::optional<Derivation> PatternWords::derive(Word const& word) const {
  return search(word, [](Word const& w) { return w.empty(); });
}

std::optional<Derivation> PatternWords::derive_conjugate_of_letter(Word const& word) const {
  return search(word, [&](Word const& w) { return group_.is_conjugate_to_letter(w); });
}

std::optional<Derivation> PatternWords::search(Word const& word, std::function<bool(Word const&)> const& goal) const {
  Word const start = group_.normal_form(word);
  if (goal(start)) return Derivation{word, {}};
  if (relations_.empty()) return {};

  struct Reached { Word from; Derivation::Step step; };
  std::map<Word, Reached> reached;
  auto const longer = [](Word const& a, Word const& b) { return std::pair(a.size(), a) > std::pair(b.size(), b); };
  std::priority_queue<Word, std::vector<Word>, decltype(longer)> open(longer);
  std::size_t longest = 0;
  for (Relation const& relation : relations_) longest = std::max(longest, relation.word.size());
  std::size_t const limit = start.size() + longest;
  constexpr std::size_t max_words = 400;  // words are short and relations few: what is not found by then hardly exists

  reached[start] = {};
  open.push(start);
  while (!open.empty() && reached.size() < max_words) {
    Word const at = open.top();
    open.pop();
    bool closed = true;
    for (std::size_t cut = 0; cut <= at.size(); ++cut) {
      Word const prefix(at.begin(), at.begin() + static_cast<std::ptrdiff_t>(cut));
      closed = closed && (cut == 0 || closed_under(at[cut - 1].dimension));
      if (!closed && strides_.empty()) break;
      if (!closed && !direct_walk(prefix)) continue;
      Word const rest(at.begin() + static_cast<std::ptrdiff_t>(cut), at.end());
      for (std::size_t r = 0; r < relations_.size(); ++r) {
        for (bool const conjugate : {false, true}) {
          Word const inserted = conjugate ? group_.inverse(relations_[r].word) : relations_[r].word;
          Word next = group_.product(group_.product(prefix, inserted), rest);
          if (next.size() > limit || reached.contains(next)) continue;
          reached[next] = {at, {prefix, r, conjugate, next}};
          if (goal(next)) {
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
