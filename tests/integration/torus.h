// A torus of n × n squares, of 8 n² darts, for tests that need a map of some size.
#pragma once

#include <cstdint>

#include <gtest/gtest.h>

#include "jrule/map.h"
#include "tests/integration/both.h"

namespace jrule::test {

/// The dart at the k-th place (of 8, in cyclic order) of a square.
inline Dart torus_dart(std::uint32_t n, std::uint32_t x, std::uint32_t y, std::uint32_t k) {
  return 8 * ((y % n) * n + x % n) + k % 8;
}

/// Every orbit has a value of its own. Class is a generated modeler on gmap(2).
template <class Class>
Class torus(std::uint32_t n) {
  Map map(Class::model(), Class::embeddings());
  map.add_darts(std::size_t{8} * n * n);
  for (std::uint32_t y = 0; y < n; ++y) {
    for (std::uint32_t x = 0; x < n; ++x) {
      auto const dart = [&](std::uint32_t k) { return torus_dart(n, x, y, k); };
      for (std::uint32_t k = 0; k < 8; k += 2) {
        map.link(dart(k), 0, dart(k + 1));
        map.link(dart(k + 1), 1, dart(k + 2));
      }
      map.link(dart(2), 2, torus_dart(n, x + 1, y, 7));
      map.link(dart(3), 2, torus_dart(n, x + 1, y, 6));
      map.link(dart(4), 2, torus_dart(n, x, y + 1, 1));
      map.link(dart(5), 2, torus_dart(n, x, y + 1, 0));
    }
  }
  number_values(map);
  auto modeler = Class::from_map(std::move(map));
  EXPECT_TRUE(modeler);
  return std::move(*modeler);
}

}  // namespace jrule::test
