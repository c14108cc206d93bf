// Walks over orbits as generated code has them: the darts of orbit() and representatives(), in their order, without a set of
// those seen, where the shape of the orbit tells which they are.
#pragma once

#include "jrule/map.h"
#include "jrule/rewrite.h"

namespace jrule::rewrite {

/// One dart for each ⟨by⟩-orbit inside an orbit of a type; without `by`, each dart. Made once for each place that walks.
class OrbitWalk {
 public:
  /// ⟨by⟩ must be a subgroup of ⟨type⟩.
  OrbitWalk(Model const& model, OrbitType type, OrbitType by);

  /// Calls `visit` with the darts of representatives(), in their order. O(orbit · words); allocates only where the orbit is
  /// neither that of one word nor of two non-oriented dimensions.
  template <class Visit>
  void operator()(Map const& map, Dart d, Visit visit) const {
    switch (shape_) {
      case Shape::dart: return visit(d);
      case Shape::cycle: return cycle(map, d, visit);
      case Shape::dihedral: return dihedral(map, d, visit);
      case Shape::other:
        for (Dart const member : representatives(map, type_, by_words_, d)) visit(member);
    }
  }

 private:
  enum class Shape : std::uint8_t { dart, cycle, dihedral, other };

  template <class Visit>
  void cycle(Map const& map, Dart d, Visit visit) const {
    Word const& word = type_.words.front();
    Dart at = d;
    do {
      visit(at);
      at = map.walk(at, word);
    } while (at != d);
  }

  // The darts lie on a circle, or on a path between two loops; the two dimensions take turns.
  template <class Visit>
  void dihedral(Map const& map, Dart d, Visit visit) const {
    std::span<Dart const> const one = map.targets(one_), two = map.targets(two_);
    visit(d);
    if (run(one, two, d, by_ != one_, by_ != two_, visit)) return;
    (void)run(two, one, d, by_ != two_, by_ != one_, visit);
  }
  // From d on, along `first`, then `second`, and so on: has the circle closed? A dart is counted unless its ⟨by⟩-orbit has been:
  // if it was reached by that dimension, or if that leads on to d.
  template <class Visit>
  bool run(std::span<Dart const> first, std::span<Dart const> second, Dart d, bool first_counts, bool second_counts, Visit& visit) const {
    for (Dart at = d;;) {
      Dart to = first[at];
      if (to == at) return false;
      if (to == d) return true;
      if (first_counts && (second_counts || second[to] != d)) visit(to);
      at = to;
      to = second[at];
      if (to == at) return false;
      if (to == d) return true;
      if (second_counts && (first_counts || first[to] != d)) visit(to);
      at = to;
    }
  }

  OrbitType type_, by_words_;
  Shape shape_ = Shape::other;
  int one_ = -1, two_ = -1;  // dihedral: the dimensions
  int by_ = -1;              // dihedral: the one whose orbits are counted once
};

}  // namespace jrule::rewrite
