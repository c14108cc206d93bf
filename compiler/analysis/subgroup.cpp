#include "compiler/analysis/subgroup.h"

#include <algorithm>
#include <queue>
#include <set>

namespace jrule::analysis {

namespace {

void sort_out(algebra::Group const& group, std::vector<Word>& words) {
  for (Word& word : words) word = std::min(group.normal_form(word), group.inverse(word));
  std::sort(words.begin(), words.end());
  words.erase(std::unique(words.begin(), words.end()), words.end());
  std::erase(words, Word{});
}

// Letters, or the words of a cell: then Group::in_orbit decides.
bool is_decided(algebra::Group const& group, std::vector<Word> const& generators) {
  if (std::all_of(generators.begin(), generators.end(), [](Word const& g) { return g.size() == 1; })) return true;
  for (int i = 0; i <= group.model().dimension; ++i) {
    auto cell = cell_orbit(group.model(), i);
    if (!cell) continue;
    sort_out(group, cell->words);
    if (cell->words == generators) return true;
  }
  return false;
}

}  // namespace

std::vector<Word> reduced(algebra::Group const& group, std::vector<Word> generators) {
  sort_out(group, generators);
  // Each round makes the words shorter altogether.
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t i = 0; i < generators.size() && !changed; ++i) {
      for (std::size_t j = 0; j < generators.size() && !changed; ++j) {
        if (i == j) continue;
        for (Word const& by : {generators[j], group.inverse(generators[j])}) {
          for (Word const& other : {group.product(generators[i], by), group.product(by, generators[i])}) {
            if (changed || other.size() >= generators[i].size()) continue;
            generators[i] = other;
            changed = true;
          }
        }
      }
    }
    if (changed) sort_out(group, generators);
  }
  return generators;
}

bool generates(algebra::Group const& group, std::vector<Word> const& generators, Word const& word) {
  std::vector<Word> const by = reduced(group, generators);
  if (is_decided(group, by)) return group.in_orbit(word, OrbitType{by});
  constexpr std::size_t most = 100;
  auto const longer = [](Word const& a, Word const& b) { return std::pair(a.size(), a) > std::pair(b.size(), b); };
  std::priority_queue<Word, std::vector<Word>, decltype(longer)> open(longer);
  Word const start = group.normal_form(word);
  std::set<Word> seen{start};
  open.push(start);
  std::size_t longest = start.size();
  for (Word const& g : by) longest = std::max(longest, g.size());
  while (!open.empty() && seen.size() < most) {
    Word const at = open.top();
    open.pop();
    if (at.empty()) return true;
    for (Word const& g : by) {
      for (Word const& step : {g, group.inverse(g)}) {
        Word next = group.product(at, step);
        if (next.size() <= longest + 2 && seen.insert(next).second) open.push(std::move(next));
      }
    }
  }
  return seen.contains(Word{});
}

}  // namespace jrule::analysis
