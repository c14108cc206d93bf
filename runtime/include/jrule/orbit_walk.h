// Orbits as generated code visits them, by their shapes: those whose darts lie on a circle or a path are followed along
// columns of darts, without a set of the darts seen. A column says for each dart where one step leads.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "jrule/map.h"
#include "jrule/rewrite.h"

namespace jrule::rewrite {

// ---- Walks ----
//
// Each calls `visit` with the darts of representatives(map, type, by, d), in their order: one for each ⟨by⟩-orbit inside
// ⟨type⟩(d), or every dart if there is no `by`. O(orbit). Columns must outlive the walk.

/// A type that is empty, or the same as its `by`.
struct DartWalk {
  template <class Visit>
  void operator()(Dart d, Visit visit) const {
    visit(d);
  }
};

/// One dimension that is not oriented: two darts, or one.
class EdgeWalk {
 public:
  explicit EdgeWalk(Dart const* column) : column_(column) {}
  template <class Visit>
  void operator()(Dart d, Visit visit) const {
    visit(d);
    if (Dart const to = column_[d]; to != d) visit(to);
  }

 private:
  Dart const* column_;
};

/// One word, letter by letter.
template <std::size_t length>
class CycleWalk {
 public:
  explicit CycleWalk(std::array<Dart const*, length> columns) : columns_(columns) {}
  template <class Visit>
  void operator()(Dart d, Visit visit) const {
    Dart at = d;
    do {
      visit(at);
      for (Dart const* column : columns_) at = column[at];
    } while (at != d);
  }

 private:
  std::array<Dart const*, length> columns_;
};

enum class By { dart, first, second };  ///< every dart, or one for each orbit of the first or second dimension

/// Two dimensions that are not oriented: the darts lie on a circle, or on a path between two loops, where they take turns.
template <By by>
class DihedralWalk {
 public:
  DihedralWalk(Dart const* first, Dart const* second) : first_(first), second_(second) {}
  template <class Visit>
  void operator()(Dart d, Visit visit) const {
    visit(d);
    if (run<by != By::first, by != By::second>(first_, second_, d, visit)) return;
    (void)run<by != By::second, by != By::first>(second_, first_, d, visit);
  }

 private:
  // From d on, along one, then the other, and so on: has the circle closed? A dart is counted unless its ⟨by⟩-orbit has been:
  // if it was reached by that dimension, or if that leads on to d.
  template <bool one_counts, bool other_counts, class Visit>
  static bool run(Dart const* one, Dart const* other, Dart d, Visit& visit) {
    for (Dart at = d;;) {
      Dart to = one[at];
      if (to == at) return false;
      if (to == d) return true;
      if (one_counts && (other_counts || other[to] != d)) visit(to);
      at = to;
      to = other[at];
      if (to == at) return false;
      if (to == d) return true;
      if (other_counts && (one_counts || one[to] != d)) visit(to);
      at = to;
    }
  }

  Dart const *first_, *second_;
};

/// Any type: with a set, which takes memory.
class OrbitWalk {
 public:
  /// ⟨by⟩ must be a subgroup of ⟨type⟩. Both must outlive it, as the map.
  OrbitWalk(Map const& map, OrbitType const& type, OrbitType const& by) : map_(map), type_(type), by_(by) {}
  template <class Visit>
  void operator()(Dart d, Visit visit) const {
    for (Dart const member : representatives(map_, type_, by_, d)) visit(member);
  }

 private:
  Map const& map_;
  OrbitType const &type_, &by_;
};

// ---- Orbits of the pattern ----
//
// To be filled with what their indices share: fill() gives k's orbit the number, which is not `unset`; until then it is unset
// in the column. O(orbit · columns). A column says for each index of the pattern where one step leads.

// is_first() says whether k is the smallest index of its orbit, or nothing where that takes too many steps: asked at each index, they
// would be the square of a long orbit. may_be_first() is false for most that are not, and tells at once.

/// How far is_first() goes.
inline constexpr int most_steps = 64;

/// What a column holds where nothing is filled in.
inline constexpr Index unset = 0xffffffffU;

/// One column.
class CycleOrbits {
 public:
  explicit CycleOrbits(Index const* column) : column_(column) {}
  void fill(Index* numbers, Index k, Index number) const noexcept {
    // Columns are permutations of a finite set: where they lead, they come back from.
    Index at = k;
    do {
      numbers[at] = number;
      at = column_[at];
    } while (at != k);
  }
  bool may_be_first(Index k) const noexcept { return column_[k] >= k; }
  std::optional<bool> is_first(Index k) const noexcept {
    Index at = column_[k];
    for (int steps = 0; steps < most_steps; ++steps, at = column_[at]) {
      if (at <= k) return at == k;
    }
    return {};
  }

 private:
  Index const* column_;
};

/// Two columns, each its own inverse.
class DihedralOrbits {
 public:
  DihedralOrbits(Index const* first, Index const* second) : first_(first), second_(second) {}
  void fill(Index* numbers, Index k, Index number) const noexcept {
    numbers[k] = number;
    run(first_, second_, numbers, k, number);
    run(second_, first_, numbers, k, number);
  }
  bool may_be_first(Index k) const noexcept { return (first_[k] >= k) & (second_[k] >= k); }
  std::optional<bool> is_first(Index k) const noexcept {
    for (Index const* one : {first_, second_}) {
      Index const* other = one == first_ ? second_ : first_;
      Index at = k;
      for (int steps = 0;; ++steps) {
        Index const to = one[at];
        if (to == at) break;  // the end of a path: there is its other half
        if (to <= k) return to == k;
        if (steps == most_steps) return {};
        at = to;
        std::swap(one, other);
      }
    }
    return true;
  }

 private:
  // A circle is met again, a path ends at a loop.
  static void run(Index const* one, Index const* other, Index* numbers, Index k, Index number) noexcept {
    for (Index at = one[k]; numbers[at] == unset; at = one[at]) {
      numbers[at] = number;
      std::swap(one, other);
    }
  }

  Index const *first_, *second_;
};

/// For each index of a pattern of n darts the smallest one of its orbit, a column of the workspace. May throw std::bad_alloc.
template <class Orbits>
Index const* first_of_orbits(Orbits const& orbits, std::size_t n, Workspace& workspace) {
  Index* const first = workspace.column(n);
  std::fill(first, first + n, unset);
  for (std::size_t k = 0; k < n; ++k) {
    if (first[k] == unset) orbits.fill(first, static_cast<Index>(k), static_cast<Index>(k));
  }
  return first;
}

}  // namespace jrule::rewrite
