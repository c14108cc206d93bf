#include "tests/reference/examination.h"

#include <algorithm>
#include <functional>
#include <set>

namespace jrule::reference {

namespace {

using analysis::CellClass;
using analysis::CellEffects;
using analysis::OrbitCount;

Dart step(PlainMap const& map, Dart d, Letter letter) {
  if (!letter.conjugate) return map.targets.at(d).at(letter.dimension).at(0);
  Dart at = d;  // the dimension permutes the darts: once around
  for (Dart next = step(map, d, {letter.dimension, false}); next != d;
       next = step(map, next, {letter.dimension, false}))
    at = next;
  return at;
}

Dart walk(PlainMap const& map, Dart d, Word const& word) {
  for (Letter const letter : word) d = step(map, d, letter);
  return d;
}

/// Of each of the darts, the number of its orbit. They must be closed under the words.
std::map<Dart, std::size_t> orbits(PlainMap const& map, std::set<Dart> const& darts, OrbitType const& type) {
  std::map<Dart, Dart> parent;
  for (Dart const d : darts) parent[d] = d;
  std::function<Dart(Dart)> const find = [&](Dart d) { return parent.at(d) == d ? d : parent[d] = find(parent.at(d)); };
  for (Dart const d : darts) {
    for (Word const& word : type.words) parent[find(d)] = find(walk(map, d, word));
  }
  std::map<Dart, std::size_t> numbers, found;
  for (Dart const d : darts) found[d] = numbers.emplace(find(d), numbers.size()).first->second;
  return found;
}

std::size_t count(std::map<Dart, std::size_t> const& numbers) {
  std::set<std::size_t> different;
  for (auto const& [d, number] : numbers) different.insert(number);
  return different.size();
}

std::set<Dart> darts_of(PlainMap const& map) {
  std::set<Dart> darts;
  for (auto const& [d, arcs] : map.targets) darts.insert(d);
  return darts;
}

/// Does no path of finite order return to its dart at once? Those are conjugate to words of letters that commute with
/// each other, each at most once.
bool is_regular(PlainMap const& map, Model const& model) {
  auto const commute = [&](std::vector<int> const& letters) {
    for (std::size_t b = 1; b < letters.size(); ++b) {
      for (std::size_t a = 0; a < b; ++a) {
        if (!model.exchanges(letters[a], letters[b])) return false;
      }
    }
    return true;
  };
  for (unsigned subset = 1; subset < 1U << model.dimensions.size(); ++subset) {
    std::vector<int> letters;
    for (std::size_t k = 0; k < model.dimensions.size(); ++k) {
      if ((subset >> k & 1U) != 0) letters.push_back(model.dimensions[k]);
    }
    if (!commute(letters) || (letters.size() == 1 && model.is_oriented(letters[0]))) continue;
    Word word;
    for (int const i : letters) word.push_back({static_cast<std::uint8_t>(i), false});
    for (auto const& [d, arcs] : map.targets) {
      if (walk(map, d, word) == d) return false;
    }
  }
  return true;
}

/// One application, held against what is said of the rule.
struct Examination {
  ir::RuleScheme const& rule;
  analysis::Effects const& effects;
  PlainMap const& before;
  Derivation const& derivation;
  Tally& tally;
  PlainMap const& after = derivation.result;
  std::set<Dart> pattern = find_pattern();

  std::set<Dart> find_pattern() const {
    std::set<Dart> darts;
    for (auto const& [copy, dart] : derivation.copies) darts.insert(copy.first);
    for (auto const& [copy, dart] : derivation.match) darts.insert(copy.first);
    return darts;
  }

  std::size_t number(CellClass const& cells) const {
    if (rule.hooks.empty()) return 1;  // the pattern is no dart of the map
    std::size_t const orbits_there = count(orbits(before, pattern, cells.per));
    if (cells.single && orbits_there > 1)
      throw std::logic_error("the pattern is more than one orbit " + to_string(cells.per));
    return orbits_there;
  }
  std::size_t number(std::vector<CellClass> const& classes) const {
    std::size_t sum = 0;
    for (CellClass const& c : classes) sum += number(c);
    return sum;
  }

  /// Cells with a copy of a node of these classes.
  std::set<std::size_t> touched(std::map<Dart, std::size_t> const& cells, std::vector<CellClass> const& classes,
                                bool left) const {
    std::set<std::size_t> found;
    for (auto const& [copy, dart] : left ? derivation.match : derivation.copies) {
      for (CellClass const& c : classes) {
        if (std::find(c.nodes.begin(), c.nodes.end(), copy.second) != c.nodes.end()) found.insert(cells.at(dart));
      }
    }
    return found;
  }

  std::optional<std::string> cells(CellEffects const& told) const {
    auto const was = orbits(before, darts_of(before), told.orbit), is = orbits(after, darts_of(after), told.orbit);
    std::map<std::size_t, std::set<std::size_t>> parts,
        sources;  // of a cell before, those that it is in; of one afterwards, the reverse
    std::set<std::size_t> deleted, created;
    for (auto const& [d, cell] : was) {
      deleted.insert(cell);
      if (is.contains(d)) parts[cell].insert(is.at(d)), sources[is.at(d)].insert(cell);
    }
    for (auto const& [d, cell] : is) created.insert(cell);
    for (auto const& [cell, found] : parts) deleted.erase(cell);
    for (auto const& [cell, found] : sources) created.erase(cell);
    if (created != touched(is, told.created, false) || created.size() != number(told.created))
      return "other cells are new";
    if (deleted != touched(was, told.deleted, true) || deleted.size() != number(told.deleted))
      return "other cells are deleted";
    tally.created += static_cast<int>(created.size());
    tally.deleted += static_cast<int>(deleted.size());
    auto const may_split = touched(was, told.split, true), may_merge = touched(is, told.merged, false);
    for (auto const& [cell, found] : parts) {
      if (found.size() > 1 && !may_split.contains(cell)) return "a cell is split";
    }
    for (auto const& [cell, found] : sources) {
      if (found.size() > 1 && !may_merge.contains(cell)) return "cells merge";
    }
    if (told.split.empty()) ++tally.never_split;
    if (told.merged.empty()) ++tally.never_merged;
    for (CellClass const& c : told.kept) {
      auto const found = touched(was, {c}, true);
      if (c.reaches_out ? found.size() > number(c) : found.size() != number(c))
        return "another number of cells is kept";
      ++tally.kept;
    }
    if (told.count) {
      if (auto fault = counted(*told.count, told.dimension)) return fault;
    }
    return {};
  }

  /// What the count speaks of: of rules on whole components, the component; else the map.
  std::set<Dart> counted_before() const {
    if (!effects.whole) return darts_of(before);
    return rule.hooks.empty() ? std::set<Dart>{} : pattern;
  }
  std::set<Dart> counted_after() const {
    if (!effects.whole) return darts_of(after);
    std::set<Dart> darts;
    for (auto const& [copy, dart] : derivation.copies) darts.insert(dart);
    return darts;
  }

  PlainMap part(PlainMap const& map, std::set<Dart> const& darts) const {
    PlainMap found{map.dimensions, {}};
    for (Dart const d : darts) found.targets[d] = map.targets.at(d);
    return found;
  }

  std::optional<std::string> counted(OrbitCount const& told, std::optional<int> dimension) const {
    PlainMap const old = part(before, counted_before());
    if (told.regular_only && !is_regular(old, rule.model())) return {};
    auto const cells_in = [&](PlainMap const& map, int i) {
      return count(orbits(map, darts_of(map), *cell_orbit(rule.model(), i)));
    };
    ir::Fraction sum =
        told.count.constant + told.count.darts * ir::Fraction{static_cast<std::int64_t>(old.targets.size()), 1};
    for (int i = 0; i < static_cast<int>(ir::Count::named_cells); ++i) {
      ir::Fraction const factor = told.count.cells[static_cast<std::size_t>(i)];
      if (!factor.is_zero()) sum = sum + factor * ir::Fraction{static_cast<std::int64_t>(cells_in(old, i)), 1};
    }
    for (OrbitType const& other : told.others)
      sum = sum + ir::Fraction{static_cast<std::int64_t>(count(orbits(old, darts_of(old), other))), 1};
    PlainMap const now = part(after, counted_after());
    std::size_t const found = dimension ? cells_in(now, *dimension) : now.targets.size();
    if (sum != ir::Fraction{static_cast<std::int64_t>(found), 1}) {
      return "there are " + std::to_string(found) + " and not " + to_string(told.count);
    }
    ++(told.regular_only ? tally.regular_counts : effects.whole ? tally.counts : tally.local_counts);
    return {};
  }

  std::optional<std::string> run() const {
    for (CellEffects const& told : effects.cells) {
      if (auto fault = cells(told)) return std::to_string(told.dimension) + "-cells: " + *fault;
    }
    if (effects.darts) {
      if (auto fault = counted(*effects.darts, {})) return "darts: " + *fault;
    }
    return {};
  }
};

}  // namespace

std::optional<std::string> examine(ir::RuleScheme const& rule, analysis::Effects const& effects, PlainMap const& before,
                                   Derivation const& derivation, Tally& tally) {
  return Examination{rule, effects, before, derivation, tally}.run();
}

}  // namespace jrule::reference
