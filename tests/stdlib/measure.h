// What the tests ask of a 2-G-map or 2-O-map.
#pragma once

#include <string>
#include <vector>

#include "tests/smoothing/polygons.h"

namespace jrule::test {

/// How many orbits of the dimensions `inside` there are in the orbit of d under `dimensions`, which contain them.
std::size_t count_inside(Map const& map, std::vector<int> const& dimensions, std::vector<int> const& inside, Dart d);
/// How many orbits of these dimensions there are.
std::size_t count_orbits(Map const& map, std::vector<int> const& dimensions);

/// Of surfaces: the number of edges of the face of a dart; at a border the darts of a vertex are its edges too.
std::size_t face_size(Map const& map, Dart d);
std::size_t vertex_degree(Map const& map, Dart d);
/// The dart of the same edge and face at the other end.
Dart other_end(Map const& map, Dart d);

/// Is there a face of less than three corners or with a corner twice, an edge from a vertex to itself, or two edges
/// between the same vertices? What it is; empty if all is as in a polyhedron.
std::string degeneracy(Map const& map);
/// Two vertices in one place, or one nowhere? What it is, or empty.
std::string misplaced(Map const& map);

}  // namespace jrule::test
