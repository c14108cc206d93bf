// Where the nodes of a rule are drawn.
#pragma once

#include <cstddef>
#include <vector>

namespace jrule::draw {

/// The sides of a rule that something stands on, as bits.
using Sides = unsigned;
inline constexpr Sides left_side = 1, right_side = 2;

struct GridNode {
  Sides sides = 0;
  Sides loops = 0;  ///< where it has loops, which need room
};
struct GridLink {
  std::size_t from = 0, to = 0;  ///< two nodes
  Sides sides = 0;
};
struct Cell {
  int column = 0, row = 0;
  bool operator==(Cell const&) const = default;
};

/// Puts the nodes on the cells of a grid, so that straight links are short, cross each other seldom and pass no other node, and the
/// nodes are read from left to right. A node on both sides has the same cell on both; nodes of different sides may share
/// one, since they are never seen together. By a search of bounded cost that knows no chance and no rounding: equal input,
/// equal layout, on every machine.
std::vector<Cell> grid_layout(std::vector<GridNode> const& nodes, std::vector<GridLink> const& links);

}  // namespace jrule::draw
