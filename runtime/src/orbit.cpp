// Orbits. A word acts on the darts of a map as a permutation of a finite set, so its conjugate is one of its powers:
// the walks below follow the words forwards only and still reach what the words and their conjugates reach.
#include <algorithm>
#include <cassert>

#include "jrule/map.h"
#include "jrule/rewrite.h"

namespace jrule {

namespace {

/// A set of darts whose cost is that of its members, not of the map: open addressing, at most half full.
class DartSet {
 public:
  bool contains(Dart d) const { return !slots_.empty() && slots_[find(d)] == d; }
  /// False if the dart is a member already.
  bool insert(Dart d) {
    if (2 * (size_ + 1) > slots_.size()) grow();
    if (!place(d)) return false;
    ++size_;
    return true;
  }

 private:
  /// The slot of the dart, or the free one where it would be.
  std::size_t find(Dart d) const {
    std::size_t const mask = slots_.size() - 1;
    // Multiplicative hashing (2^32 / golden ratio); the high bits are folded in, since the mask looks at the low ones.
    std::uint32_t const hash = d * 2654435769U;
    std::size_t at = (hash ^ (hash >> 15)) & mask;
    while (slots_[at] != no_dart && slots_[at] != d) at = (at + 1) & mask;
    return at;
  }
  bool place(Dart d) {
    std::size_t const at = find(d);
    if (slots_[at] == d) return false;
    slots_[at] = d;
    return true;
  }
  void grow() {
    std::vector<Dart> const old = std::move(slots_);
    slots_.assign(std::max<std::size_t>(32, 2 * old.size()), no_dart);
    for (Dart const d : old) {
      if (d != no_dart) place(d);
    }
  }

  std::vector<Dart> slots_;
  std::size_t size_ = 0;
};

/// Calls `visit` with the darts of the orbit that are not `seen`, in the order of orbit(); then they are.
template <class Visit>
void walk_orbit(Map const& map, OrbitType const& type, Dart d, DartSet& seen, Visit visit) {
  struct Step { Dart dart; std::size_t next_word; };
  if (!seen.insert(d)) return;
  visit(d);
  std::vector<Step> path{{d, 0}};
  while (!path.empty()) {
    Step& step = path.back();
    if (step.next_word == type.words.size()) {
      path.pop_back();
      continue;
    }
    Dart const to = map.walk(step.dart, type.words[step.next_word++]);
    if (!seen.insert(to)) continue;
    visit(to);
    path.push_back({to, 0});
  }
}

}  // namespace

std::vector<Dart> orbit(Map const& map, OrbitType const& type, Dart d) {
  assert(map.contains(d));
  std::vector<Dart> found;
  DartSet seen;
  walk_orbit(map, type, d, seen, [&](Dart member) { found.push_back(member); });
  return found;
}

std::vector<Dart> rewrite::representatives(Map const& map, OrbitType const& type, OrbitType const& by, Dart d) {
  std::vector<Dart> const members = orbit(map, type, d);
  if (by.words.empty()) return members;
  std::vector<Dart> result;
  DartSet seen;
  for (Dart const member : members) {
    if (seen.contains(member)) continue;
    result.push_back(member);
    walk_orbit(map, by, member, seen, [](Dart) {});
  }
  return result;
}

OrbitNumbers number_orbits(Map const& map, OrbitType const& type) {
  OrbitNumbers orbits;
  orbits.number.resize(map.dart_limit(), no_orbit);
  std::vector<Dart> open;
  for (Dart start = 0; start < map.dart_limit(); ++start) {
    if (!map.contains(start) || orbits.number[start] != no_orbit) continue;
    auto const number = static_cast<std::uint32_t>(orbits.first.size());
    orbits.first.push_back(start);
    orbits.number[start] = number;
    open.push_back(start);
    while (!open.empty()) {
      Dart const from = open.back();
      open.pop_back();
      for (Word const& word : type.words) {
        Dart const to = map.walk(from, word);
        if (orbits.number[to] != no_orbit) continue;
        orbits.number[to] = number;
        open.push_back(to);
      }
    }
  }
  return orbits;
}

std::vector<Dart> cells(Map const& map, int dimension) {
  std::optional<OrbitType> const type = cell_orbit(map.model(), dimension);
  return type ? number_orbits(map, *type).first : std::vector<Dart>{};
}

}  // namespace jrule
