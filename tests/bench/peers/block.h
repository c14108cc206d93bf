// The cubes of the block, and where they touch.
#pragma once

#include "tests/bench/peers/contest.h"

namespace jrule::bench {

/// Calls with the least corner of each cube, of side 1; cubes are numbered in this order.
template <class Call>
void for_each_cube(Call call) {
  for (std::size_t z = 0; z < block_side; ++z) {
    for (std::size_t y = 0; y < block_side; ++y) {
      for (std::size_t x = 0; x < block_side; ++x)
        call(static_cast<double>(x), static_cast<double>(y), static_cast<double>(z));
    }
  }
}

/// Calls with each cube, its next neighbour along an axis, and the axis.
template <class Call>
void for_each_contact(Call call) {
  constexpr std::size_t n = block_side;
  for (std::size_t cube = 0; cube < n * n * n; ++cube) {
    if (cube % n + 1 < n) call(cube, cube + 1, std::size_t{0});
    if (cube / n % n + 1 < n) call(cube, cube + n, std::size_t{1});
    if (cube / n / n + 1 < n) call(cube, cube + n * n, std::size_t{2});
  }
}

}  // namespace jrule::bench
