#include "tests/stdlib/measure.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "jrule/typed.h"

namespace jrule::test {

namespace {

bool oriented(Map const& map) { return map.model().is_oriented(1); }

}  // namespace

std::size_t count_inside(Map const& map, std::vector<int> const& dimensions, std::vector<int> const& inside, Dart d) {
  std::set<Dart> least;
  for (Dart const e : orbit(map, orbit_of_dimensions(dimensions), d)) {
    auto const part = orbit(map, orbit_of_dimensions(inside), e);
    least.insert(*std::min_element(part.begin(), part.end()));
  }
  return least.size();
}

std::size_t count_orbits(Map const& map, std::vector<int> const& dimensions) {
  return number_orbits(map, orbit_of_dimensions(dimensions)).first.size();
}

std::size_t face_size(Map const& map, Dart d) {
  if (oriented(map)) return orbit(map, orbit_of_dimensions({1}), d).size();
  return count_inside(map, {0, 1}, {0}, d);
}

std::size_t vertex_degree(Map const& map, Dart d) {
  if (oriented(map)) return orbit(map, OrbitType{{{{2, false}, {1, false}}}}, d).size();
  return count_inside(map, {1, 2}, {2}, d);
}

Dart other_end(Map const& map, Dart d) { return map.target(d, oriented(map) ? 2 : 0); }

std::string degeneracy(Map const& map) {
  auto const vertex = number_vertices(map);
  for (Vertices const& face : faces(map, vertex)) {
    if (face.size() < 3) return "a face of " + std::to_string(face.size()) + " corners";
    if (std::set<std::size_t>(face.begin(), face.end()).size() < face.size()) return "a face with a corner twice";
  }
  std::set<Vertices> ends;
  for (Dart const d : cells(map, 1)) {
    Vertices const edge = ascending({vertex[d], vertex[other_end(map, d)]});
    if (edge[0] == edge[1]) return "an edge from a vertex to itself";
    if (!ends.insert(edge).second) return "two edges between two vertices";
  }
  return {};
}

std::string misplaced(Map const& map) {
  std::set<std::vector<long long>> places;
  rewrite::Values<Point3> const positions(map.embedding(0));
  for (Dart const d : cells(map, 0)) {
    Point3 const p = positions[d];
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) return "a vertex nowhere";
    auto const rounded = [](double x) { return std::llround(x * 1e9); };
    if (!places.insert({rounded(p.x), rounded(p.y), rounded(p.z)}).second)
      return "two vertices at " + to_string(Value(p));
  }
  return {};
}

}  // namespace jrule::test
