#include "tests/smoothing/polygons.h"

#include <algorithm>

#include "jrule/typed.h"

namespace jrule::test {

namespace {

bool has_halfedges(Map const& map) { return map.model().is_oriented(1); }

OrbitType vertex_orbit(Map const& map) {
  return has_halfedges(map) ? OrbitType{{{{2, false}, {1, false}}}} : orbit_of_dimensions({1, 2});
}

}  // namespace

Vertices ascending(Vertices vertices) {
  std::sort(vertices.begin(), vertices.end());
  return vertices;
}

std::vector<Vertices> faces(Map const& map, std::vector<std::size_t> const& vertex) {
  std::vector<Vertices> result;
  for (Dart const first : cells(map, 2)) {
    Vertices& face = result.emplace_back();
    Dart d = first;
    do {
      face.push_back(vertex[d]);
      d = map.target(has_halfedges(map) ? d : map.target(d, 0), 1);
    } while (d != first);
  }
  return result;
}

std::vector<std::size_t> number_vertices(Map const& map) {
  auto const numbers = number_orbits(map, vertex_orbit(map)).number;
  return {numbers.begin(), numbers.end()};
}

Polygons polygons(Map const& map, std::vector<std::size_t> const& vertex) {
  Polygons result{std::vector<Point3>(*std::max_element(vertex.begin(), vertex.end()) + 1), faces(map, vertex)};
  rewrite::Values<Point3> const positions(map.embedding(0));
  for (Dart const d : map.darts()) result.points[vertex[d]] = positions[d];
  return result;
}

}  // namespace jrule::test
