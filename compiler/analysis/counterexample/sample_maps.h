// Small maps of any model: all connected ones of few darts, and random completions of a map that has some arcs
// already.
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/analysis/counterexample/partial_map.h"

namespace jrule::analysis {

/// The choices of a search: the same each time, on every machine (a linear congruential generator, its high bits).
class Choices {
 public:
  /// 0 … count-1.
  std::size_t below(std::size_t count) {
    state_ = state_ * 6364136223846793005U + 1442695040888963407U;
    return static_cast<std::size_t>((state_ >> 33U) % count);
  }
  bool percent(std::size_t share) { return below(100) < share; }

 private:
  std::uint64_t state_ = 0x9e3779b97f4a7c15U;
};

/// Every connected map with exactly that many darts, up to renaming the darts but dart 0: Γ's transitive actions with
/// a base point, its subgroups of that index. Stops after `most` of them.
std::vector<PartialMap> connected_maps(Model const& model, Dart darts, std::size_t most);

/// How missing arcs are drawn, in percent; otherwise an arc leads to some dart that has none coming in.
struct Manner {
  std::size_t loops;  ///< the arc is a loop
  std::size_t fresh;  ///< it leads to a new dart
  bool by_dimension;  ///< all arcs of one dimension before those of the next
};
Manner draw_manner(Choices& choices);

/// Draws the missing arcs, with new darts up to `limit` in all. False, and the map as it was, if within some steps no
/// map was found.
bool complete(PartialMap& map, Dart limit, Manner manner, Choices& choices);

}  // namespace jrule::analysis
