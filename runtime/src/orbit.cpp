// Orbits. A word acts on the darts of a map as a permutation of a finite set, so its conjugate is one of its powers:
// the walks below follow the words forwards only and still reach what the words and their conjugates reach. This also
// brings the darts of an O-map's face or vertex in their cyclic order.
#include <algorithm>
#include <cassert>

#include "jrule/map.h"

namespace jrule {

namespace {

/// The marks of one walk. The bytes outlive it, all zero again, so that a walk costs its orbit and not the map.
class Marks {
 public:
  Marks(std::size_t darts, std::vector<Dart> const& marked) : marked_(marked) {
    if (bytes_.size() < darts) bytes_.resize(darts);
  }
  Marks(Marks const&) = delete;
  Marks& operator=(Marks const&) = delete;
  ~Marks() {
    for (Dart d : marked_) bytes_[d] = 0;
  }
  bool has(Dart d) const { return bytes_[d] != 0; }
  void set(Dart d) { bytes_[d] = 1; }

 private:
  std::vector<Dart> const& marked_;
  static thread_local std::vector<std::uint8_t> bytes_;
};

thread_local std::vector<std::uint8_t> Marks::bytes_;

}  // namespace

std::vector<Dart> orbit(Map const& map, OrbitType const& type, Dart d) {
  assert(map.contains(d));
  std::vector<Dart> found;
  {  // the marks must be gone before `found` may be moved from
    Marks marks(map.dart_limit(), found);
    auto const meet = [&](Dart dart) {
      if (marks.has(dart)) return;
      found.push_back(dart);  // before the mark, which is cleared through it should this throw
      marks.set(dart);
    };
    meet(d);
    for (std::size_t k = 0; k < found.size(); ++k) {
      Dart const from = found[k];
      for (Word const& word : type.words) meet(map.walk(from, word));
    }
  }
  return found;
}

OrbitNumbers number_orbits(Map const& map, OrbitType const& type) {
  OrbitNumbers orbits;
  orbits.number.assign(map.dart_limit(), no_orbit);
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

}  // namespace jrule
