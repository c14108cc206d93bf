#include "compiler/backend/draw/grid_layout.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <utility>

namespace jrule::draw {

namespace {

// What is ugly, in one unit. Two nodes of a side never share a cell; a link through a node that it does not belong to would be read
// wrongly; a crossing is only untidy.
constexpr long through_node = 200, crossing = 45, longer = 14, slanted = 7, column_used = 2, row_used = 5, backwards = 3, upwards = 1,
               crowded_loop = 4, begins_late = 2;

struct Vector {
  long x, y;
};
long cross(Vector a, Vector b) { return a.x * b.y - a.y * b.x; }
long dot(Vector a, Vector b) { return a.x * b.x + a.y * b.y; }
Vector between(Cell a, Cell b) { return {b.column - a.column, b.row - a.row}; }

/// Does the straight line from a to b pass the middle of c closer than a third of a cell?
bool passes(Cell a, Cell b, Cell c) {
  Vector const along = between(a, b), to = between(a, c);
  long const square = dot(along, along), forward = dot(along, to), aside = cross(along, to);
  return forward > 0 && forward < square && 9 * aside * aside < square;
}

bool cross_each_other(Cell a, Cell b, Cell c, Cell d) {
  auto const beside = [](int p, int q, int r, int s) { return std::max(p, q) <= std::min(r, s) || std::max(r, s) <= std::min(p, q); };
  if (a.column != b.column && c.column != d.column && beside(a.column, b.column, c.column, d.column)) return false;
  if (a.row != b.row && c.row != d.row && beside(a.row, b.row, c.row, d.row)) return false;
  auto const apart = [](Cell p, Cell q, Cell r, Cell s) {
    long const one = cross(between(p, q), between(p, r)), other = cross(between(p, q), between(p, s));
    return (one > 0 && other < 0) || (one < 0 && other > 0);
  };
  return apart(a, b, c, d) && apart(c, d, a, b);
}

/// Numbers for moves to try, the same everywhere: a linear congruential sequence (Knuth's MMIX).
class Sequence {
 public:
  std::size_t below(std::size_t limit) {
    state_ = state_ * 6364136223846793005U + 1442695040888963407U;
    return static_cast<std::size_t>(state_ >> 33U) % limit;
  }

 private:
  std::uint64_t state_ = 88172645463325252U;
};

class Search {
 public:
  Search(std::vector<GridNode> const& nodes, std::vector<GridLink> const& links) : nodes_(nodes), links_(links) {
    while (side_ * side_ < static_cast<int>(nodes.size())) ++side_;
    side_ += 2;
    linked_.resize(nodes.size() * nodes.size(), false);
    for (GridLink const& link : links) linked_[link.from * nodes.size() + link.to] = linked_[link.to * nodes.size() + link.from] = true;
  }

  std::vector<Cell> best() {
    std::vector<Cell> const start = in_rows();
    std::vector<Cell> found = start;
    long least = cost(start);
    std::size_t const evaluation = 1 + links_.size() * (links_.size() + nodes_.size());
    std::size_t const steps = std::min(3000 * nodes_.size(), 150'000'000 / (evaluation * rounds));
    for (std::size_t round = 0; round < rounds && steps > 0; ++round) {
      std::vector<Cell> at = round % 2 == 0 ? start : found;
      long now = cost(at);
      for (std::size_t step = 0; step < steps; ++step) {
        // Steps for the worse are taken, too, but ever smaller ones.
        long const allowed = 60 * static_cast<long>(steps - step) / static_cast<long>(steps);
        std::vector<Cell> const before = at;
        if (!move(at)) continue;
        long const then = cost(at, now + allowed);
        if (then > now + allowed) {
          at = before;
          continue;
        }
        now = then;
        if (now < least) {
          least = now;
          found = at;
        }
      }
    }
    return found;
  }

 private:
  static constexpr std::size_t rounds = 6;

  bool is_free(std::vector<Cell> const& at, std::size_t node, Cell cell) const {
    for (std::size_t other = 0; other < nodes_.size(); ++other) {
      if (other != node && at[other] == cell && (nodes_[other].sides & nodes_[node].sides) != 0) return false;
    }
    return true;
  }

  /// In the order in which links reach them, row after row.
  std::vector<Cell> in_rows() const {
    std::vector<std::size_t> order;
    std::vector<bool> seen(nodes_.size(), false);
    for (std::size_t first = 0; first < nodes_.size(); ++first) {
      if (seen[first]) continue;
      seen[first] = true;
      order.push_back(first);
      for (std::size_t next = order.size() - 1; next < order.size(); ++next) {
        for (GridLink const& link : links_) {
          for (auto const& [from, to] : {std::pair(link.from, link.to), std::pair(link.to, link.from)}) {
            if (from != order[next] || seen[to]) continue;
            seen[to] = true;
            order.push_back(to);
          }
        }
      }
    }
    std::vector<Cell> at(nodes_.size());
    int const width = side_ - 2;
    for (std::size_t k = 0; k < order.size(); ++k) at[order[k]] = {static_cast<int>(k) % width, static_cast<int>(k) / width};
    return at;
  }

  /// A node to a free cell, or two nodes to each other's.
  bool move(std::vector<Cell>& at) {
    std::size_t const node = sequence_.below(nodes_.size());
    if (sequence_.below(3) == 0) {
      std::size_t const other = sequence_.below(nodes_.size());
      std::swap(at[node], at[other]);
      if (node != other && is_free(at, node, at[node]) && is_free(at, other, at[other])) return true;
      std::swap(at[node], at[other]);
      return false;
    }
    auto const place = [&] { return static_cast<int>(sequence_.below(static_cast<std::size_t>(side_))); };
    Cell const cell{place(), place()};
    if (cell == at[node] || !is_free(at, node, cell)) return false;
    at[node] = cell;
    return true;
  }

  /// Of what is uglier than `limit`, some number above that: no part is below zero, so the rest is not looked at.
  long cost(std::vector<Cell> const& at, long limit = std::numeric_limits<long>::max()) const {
    long sum = size_cost(at) + loop_cost(at);
    for (GridLink const& link : links_) sum += length_cost(at[link.from], at[link.to]);
    for (std::size_t i = 0; i < links_.size() && sum <= limit; ++i) sum += link_cost(at, i);
    return sum;
  }

  /// What the link passes, and which links after it it crosses.
  long link_cost(std::vector<Cell> const& at, std::size_t i) const {
    GridLink const& link = links_[i];
    Cell const a = at[link.from], b = at[link.to];
    long sum = 0;
    bool const to_neighbour = std::abs(b.column - a.column) <= 1 && std::abs(b.row - a.row) <= 1;  // nothing is in between
    for (std::size_t node = 0; node < nodes_.size() && !to_neighbour; ++node) {
      if (node == link.from || node == link.to || (nodes_[node].sides & link.sides) == 0) continue;
      if (passes(a, b, at[node])) sum += through_node;
    }
    for (std::size_t j = i + 1; j < links_.size(); ++j) {
      GridLink const& other = links_[j];
      if ((link.sides & other.sides) != 0 && cross_each_other(a, b, at[other.from], at[other.to])) sum += crossing;
    }
    return sum;
  }

  /// A loop beside a node that it has nothing to do with is read as an arc to that.
  long loop_cost(std::vector<Cell> const& at) const {
    long sum = 0;
    for (std::size_t node = 0; node < nodes_.size(); ++node) {
      if (nodes_[node].loops == 0) continue;
      for (std::size_t other = 0; other < nodes_.size(); ++other) {
        if (other == node || (nodes_[node].loops & nodes_[other].sides) == 0) continue;
        Vector const apart = between(at[node], at[other]);
        if (dot(apart, apart) == 1 && !linked_[node * nodes_.size() + other]) sum += crowded_loop;
      }
    }
    return sum;
  }

  static long length_cost(Cell a, Cell b) {
    long const across = std::abs(b.column - a.column), down = std::abs(b.row - a.row);
    long cost = longer * (std::max(across, down) - 1) + slanted * std::min(across, down);
    // Nodes are linked in the order of writing.
    if (b.column < a.column) cost += backwards;
    if (b.row < a.row) cost += upwards;
    return cost;
  }

  long size_cost(std::vector<Cell> const& at) const {
    long sum = 0;
    for (Sides const side : {left_side, right_side}) {
      Cell low{side_, side_}, high{-1, -1};
      for (std::size_t node = 0; node < nodes_.size(); ++node) {
        if ((nodes_[node].sides & side) == 0) continue;
        low = {std::min(low.column, at[node].column), std::min(low.row, at[node].row)};
        high = {std::max(high.column, at[node].column), std::max(high.row, at[node].row)};
      }
      // The first node of all is where reading begins.
      if ((nodes_[0].sides & side) != 0) sum += begins_late * (at[0].column - low.column + at[0].row - low.row);
      if (high.column >= 0) sum += column_used * (high.column - low.column) + row_used * (high.row - low.row);
    }
    return sum;
  }

  std::vector<GridNode> const& nodes_;
  std::vector<GridLink> const& links_;
  int side_ = 1;
  std::vector<bool> linked_;  // by two nodes
  Sequence sequence_;
};

}  // namespace

std::vector<Cell> grid_layout(std::vector<GridNode> const& nodes, std::vector<GridLink> const& links) {
  if (nodes.empty()) return {};
  return Search(nodes, links).best();
}

}  // namespace jrule::draw
