#include "tests/reference/plain_map.h"

#include <fmt/format.h>

#include <algorithm>

namespace jrule::reference {

PlainMap plain(Map const& map) {
  PlainMap result{map.model().dimensions, {}};
  for (Dart const d : map.darts()) {
    for (int const i : result.dimensions) result.targets[d][i] = {map.target(d, i)};
  }
  return result;
}

std::optional<std::string> violation(PlainMap const& map, Model const& model) {
  auto const& t = map.targets;
  for (int const i : model.dimensions) {
    std::map<Dart, int> incoming;
    for (auto const& [d, arcs] : t) {
      if (arcs.at(i).size() != 1) return fmt::format("dart {} has {} outgoing {}-arcs", d, arcs.at(i).size(), i);
      ++incoming[arcs.at(i)[0]];
    }
    for (auto const& [d, count] : incoming) {
      if (count != 1) return fmt::format("dart {} has {} incoming {}-arcs", d, count, i);
    }
  }
  auto const next = [&](Dart d, int i) { return t.at(d).at(i)[0]; };
  for (auto const& [d, arcs] : t) {
    for (int const i : model.dimensions) {
      if (!model.is_oriented(i) && next(next(d, i), i) != d)
        return fmt::format("the {}-arc of dart {} has no reverse", i, d);
      if (model.closed && next(d, i) == d) return fmt::format("the {}-arc of dart {} is a loop", i, d);
    }
    for (auto const& [i, j] : model.exchange) {
      if (next(next(next(next(d, i), j), i), j) != d)
        return fmt::format("the path {}{}{}{} from dart {} does not return", i, j, i, j, d);
    }
  }
  return {};
}

namespace {

using Renaming = std::map<Dart, Dart>;

/// Follows equal labels from the renamed darts on; false where that is not possible. For graphs with at most one d-arc out of a
/// dart: their connected components, walked forwards only, are permutations' orbits or the answer is no anyway.
bool follow(PlainMap const& a, PlainMap const& b, Renaming& renamed, Renaming& used, std::vector<Dart> open) {
  while (!open.empty()) {
    Dart const x = open.back();
    open.pop_back();
    for (int const i : a.dimensions) {
      auto const& from = a.targets.at(x).at(i);
      auto const& to = b.targets.at(renamed.at(x)).at(i);
      if (from.size() != 1 || to.size() != 1) return false;
      auto const [known, is_new] = renamed.emplace(from[0], to[0]);
      if (!is_new) {
        if (known->second != to[0]) return false;
        continue;
      }
      if (!used.emplace(to[0], from[0]).second) return false;
      open.push_back(from[0]);
    }
  }
  return true;
}

}  // namespace

bool isomorphic(PlainMap const& a, PlainMap const& b, std::map<Dart, Dart> const& fixed,
                std::map<Dart, unsigned> const& colour_a, std::map<Dart, unsigned> const& colour_b) {
  if (a.dimensions != b.dimensions || a.targets.size() != b.targets.size()) return false;
  Renaming renamed, used;
  std::vector<Dart> open;
  for (auto const& [x, y] : fixed) {
    if (!a.targets.contains(x) || !b.targets.contains(y) || !used.emplace(y, x).second) return false;
    renamed.emplace(x, y);
    open.push_back(x);
  }
  if (!follow(a, b, renamed, used, open)) return false;
  auto const colour = [](std::map<Dart, unsigned> const& colours, Dart d) {
    auto const found = colours.find(d);
    return found == colours.end() ? std::optional<unsigned>() : found->second;
  };
  auto const colours_agree = [&](Renaming const& r) {
    return std::all_of(r.begin(), r.end(),
                       [&](auto const& pair) { return colour(colour_a, pair.first) == colour(colour_b, pair.second); });
  };
  if (!colours_agree(renamed)) return false;
  // A component without a fixed dart: isomorphic components are interchangeable, so the first partner that fits will do.
  for (auto const& [x, arcs_x] : a.targets) {
    if (renamed.contains(x)) continue;
    bool found = false;
    for (auto const& [y, arcs_y] : b.targets) {
      if (used.contains(y)) continue;
      Renaming more = renamed, more_used = used;
      more[x] = y;
      more_used[y] = x;
      if (!follow(a, b, more, more_used, {x}) || !colours_agree(more)) continue;
      renamed = std::move(more);
      used = std::move(more_used);
      found = true;
      break;
    }
    if (!found) return false;
  }
  return true;
}

}  // namespace jrule::reference
