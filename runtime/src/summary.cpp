#include "jrule/map.h"

namespace jrule {

namespace {

/// Can the darts be told apart in two kinds such that every arc joins one of each? A loop (a boundary) says nothing.
bool two_colourable(Map const& map) {
  std::vector<std::uint8_t> colour(map.dart_limit(), 0);  // 0: none yet; else 1 or 2
  std::vector<Dart> open;
  for (Dart start = 0; start < map.dart_limit(); ++start) {
    if (!map.contains(start) || colour[start] != 0) continue;
    colour[start] = 1;
    open.push_back(start);
    while (!open.empty()) {
      Dart const from = open.back();
      open.pop_back();
      for (int d : map.model().dimensions) {
        Dart const to = map.target(from, d);
        if (to == from) continue;
        if (colour[to] == colour[from]) return false;
        if (colour[to] != 0) continue;
        colour[to] = static_cast<std::uint8_t>(3 - colour[from]);
        open.push_back(to);
      }
    }
  }
  return true;
}

}  // namespace

Summary summarize(Map const& map) {
  Model const& model = map.model();
  int const n = model.dimension;
  Summary summary;
  summary.model = model.name;
  summary.dimension = n;
  summary.darts = map.dart_count();
  summary.cells.assign(static_cast<std::size_t>(n) + 1, 0);
  auto const violation = find_violation(map);
  summary.valid = !violation;
  if (model.has(n) && !model.is_oriented(n)) {
    for (Dart d = 0; d < map.dart_limit(); ++d) {
      if (map.contains(d) && map.target(d, n) == d) ++summary.boundary_darts;
    }
  }
  // Without whole arcs there are no orbits to count.
  if (violation && violation->kind == Violation::Kind::incident_arcs) return summary;

  for (int i = 0; i <= n; ++i) {
    auto const type = cell_orbit(model, i);
    if (!type) continue;
    std::size_t const count = number_orbits(map, *type).first.size();
    summary.cells[static_cast<std::size_t>(i)] = count;
    auto const signed_count = static_cast<long long>(count);
    summary.euler += i % 2 == 0 ? signed_count : -signed_count;
  }
  summary.components = number_orbits(map, component_orbit(model)).first.size();
  // An oriented dimension gives every cell of the map one orientation.
  summary.orientable = model.oriented != 0 || two_colourable(map);
  return summary;
}

}  // namespace jrule
