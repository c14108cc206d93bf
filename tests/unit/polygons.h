// Small maps for tests of application.
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/ir/rule_scheme.h"
#include "jrule/map.h"

namespace jrule::tests {

/// Free polygons side by side; the values of each embedding, which are reals, are 0, 1, … by orbit.
inline Map polygons(ir::Modeler const& modeler, std::vector<std::uint32_t> const& sides) {
  Map map(modeler.model, modeler.embeddings);
  for (std::uint32_t const n : sides) {
    std::vector<Dart> const d = map.add_darts(2 * n);
    for (std::uint32_t k = 0; k < n; ++k) {
      map.link(d[2 * k], 0, d[2 * k + 1]);
      map.link(d[2 * k + 1], 1, d[(2 * k + 2) % (2 * n)]);
    }
  }
  for (std::size_t e = 0; e < map.embedding_count(); ++e) {
    OrbitNumbers const orbits = number_orbits(map, map.embedding(e).spec().orbit);
    for (std::size_t i = 0; i < orbits.first.size(); ++i) map.embedding(e).add(static_cast<double>(i));
    for (Dart const d : map.darts()) map.embedding(e).set_handle(d, orbits.number[d]);
  }
  return map;
}

}  // namespace jrule::tests
