// How many orbits a group of words has on a whole component, in numbers of cells and darts.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "compiler/algebra/group.h"
#include "compiler/ir/count.h"

namespace jrule::analysis {

/// A sum of such numbers.
struct OrbitCount {
  ir::Count count{};
  /// It holds only for a regular component: a path that returns to its dart when it is followed often enough in every map, such as
  /// 2 or 0·2 of a 2-G-map, never returns at once. So there is no border, and no edge is folded: an edge of a
  /// surface has four darts, of an O-map two.
  bool regular_only = false;
  /// Besides, so many as there are orbits of these types, which no cells or darts say.
  std::vector<OrbitType> others{};
};

class OrbitCounter {
 public:
  explicit OrbitCounter(algebra::Group const& group);

  /// The number of orbits of the generated group.
  OrbitCount count(std::vector<Word> const& generators) const;
  OrbitCount add(OrbitCount const& a, OrbitCount const& b) const;

  /// The same number for regular components, in a form that is the same for all sums that are equal for every one of them: cells
  /// of a fixed number of darts are given by the number of darts.
  ir::Count normal(ir::Count count) const;
  /// The same, written with as few fractions as can be.
  ir::Count readable(ir::Count const& count) const;

  /// The generators, conjugated by one word so that they are as short as can be, in order: as many orbits. `may` says which words.
  template <class May>
  std::vector<Word> shortened(std::vector<Word> const& generators, May may) const {
    std::vector<Word> best = conjugated(generators, {});
    for (Word const& by : conjugators(generators)) {
      if (std::vector<Word> other = conjugated(generators, by); total(other) < total(best) && may(by)) best = std::move(other);
    }
    return best;
  }

 private:
  struct Cell {
    OrbitType type;
    std::optional<int> order;  ///< of the group that its words generate, if it is finite
  };

  std::optional<int> order(std::vector<Word> const& generators) const;
  bool same_orbits(std::vector<Word> const& generators, OrbitType const& cell) const;
  std::vector<Word> conjugators(std::vector<Word> const& generators) const;
  std::vector<Word> conjugated(std::vector<Word> const& generators, Word const& by) const;
  static std::size_t total(std::vector<Word> const& words);

  algebra::Group const& group_;
  std::array<std::optional<Cell>, ir::Count::named_cells> cells_;
};

}  // namespace jrule::analysis
