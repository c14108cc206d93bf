#include "compiler/analysis/orbit_count.h"

#include <algorithm>
#include <set>

#include "compiler/analysis/subgroup.h"

namespace jrule::analysis {

using ir::Fraction;

OrbitCounter::OrbitCounter(algebra::Group const& group) : group_(group) {
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    if (auto type = cell_orbit(group.model(), static_cast<int>(i))) {
      auto const finite = order(type->words);
      cells_[i] = Cell{std::move(*type), finite};
    }
  }
}

// A finite subgroup is conjugate to one that commuting letters generate, so it has at most 2^5 elements in G-maps.
std::optional<int> OrbitCounter::order(std::vector<Word> const& generators) const {
  constexpr std::size_t most = 64;
  std::set<Word> seen{Word{}};
  std::vector<Word> open{Word{}};
  while (!open.empty()) {
    Word const at = open.back();
    open.pop_back();
    for (Word const& g : generators) {
      Word next = group_.product(at, g);
      if (seen.insert(next).second) open.push_back(std::move(next));
    }
    if (seen.size() > most) return {};
  }
  return static_cast<int>(seen.size());
}

std::vector<Word> OrbitCounter::conjugators(std::vector<Word> const& generators) const {
  std::vector<Word> words{Word{}};
  for (Word const& g : generators) {
    for (Word const& word : {g, group_.inverse(g)}) {
      for (std::size_t k = 1; k <= word.size(); ++k) words.emplace_back(word.begin(), word.begin() + static_cast<std::ptrdiff_t>(k));
    }
  }
  return words;
}

// u ↦ u·x leads the orbits of a group G onto those of x⁻¹·G·x.
std::vector<Word> OrbitCounter::conjugated(std::vector<Word> const& generators, Word const& by) const {
  std::vector<Word> words;
  for (Word const& g : generators) words.push_back(group_.product(group_.product(group_.inverse(by), g), by));
  return reduced(group_, std::move(words));
}

std::size_t OrbitCounter::total(std::vector<Word> const& words) {
  std::size_t sum = 0;
  for (Word const& word : words) sum += word.size();
  return sum;
}

// Does a conjugate of the group equal that of the cell?
bool OrbitCounter::same_orbits(std::vector<Word> const& generators, OrbitType const& cell) const {
  for (Word const& by : conjugators(generators)) {
    std::vector<Word> const moved = conjugated(generators, by);
    bool const inside = std::all_of(moved.begin(), moved.end(), [&](Word const& g) { return group_.in_orbit(g, cell); });
    if (inside && std::all_of(cell.words.begin(), cell.words.end(), [&](Word const& w) { return generates(group_, moved, w); })) return true;
  }
  return false;
}

OrbitCount OrbitCounter::count(std::vector<Word> const& generators) const {
  auto const& dimensions = group_.model().dimensions;
  bool const all = std::all_of(dimensions.begin(), dimensions.end(), [&](int d) {
    return generates(group_, generators, {Letter{static_cast<std::uint8_t>(d), false}});
  });
  if (all) return {.count = {.constant = {1, 1}}};
  auto const finite = order(generators);
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    if (!cells_[i] || cells_[i]->order != finite || !same_orbits(generators, cells_[i]->type)) continue;
    OrbitCount found;
    found.count.cells[i] = {1, 1};
    return found;
  }
  // Where no element of a finite group but ε fixes a dart, each of its orbits has as many darts as it has elements.
  if (finite) return {.count = {.darts = Fraction{1, *finite}}, .regular_only = *finite > 1};
  return {.others = {OrbitType{shortened(generators, [](Word const&) { return true; })}}};
}

OrbitCount OrbitCounter::add(OrbitCount const& a, OrbitCount const& b) const {
  OrbitCount sum{a.count + b.count, a.regular_only || b.regular_only, a.others};
  sum.others.insert(sum.others.end(), b.others.begin(), b.others.end());
  return sum;
}

ir::Count OrbitCounter::normal(ir::Count count) const {
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    if (!cells_[i] || !cells_[i]->order) continue;
    count.darts = count.darts + count.cells[i] * Fraction{1, *cells_[i]->order};
    count.cells[i] = {};
  }
  return count;
}

ir::Count OrbitCounter::readable(ir::Count const& count) const {
  ir::Count result = normal(count);
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    if (!cells_[i] || !cells_[i]->order) continue;
    Fraction const cells = result.darts * Fraction{*cells_[i]->order, 1};
    if (cells.under != 1 || cells.is_zero()) continue;
    result.cells[i] = cells;
    result.darts = {};
  }
  return result;
}

}  // namespace jrule::analysis
