// Meshes as plain numbers, in which jrule and its peers are compared.
#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include "jrule/map.h"
#include "jrule/value.h"

namespace jrule::test {

/// Vertex numbers: of a face, in cyclic order; of a set of vertices, ascending.
using Vertices = std::vector<std::size_t>;

struct Polygons {
  std::vector<Point3> points;
  std::vector<Vertices> faces;
};

/// A mesh that a peer has refined once, and what its vertices come from.
struct Refinement {
  Polygons mesh;
  std::vector<std::size_t> of_vertex;       ///< by old vertex
  std::map<Vertices, std::size_t> of_edge;  ///< by the old vertices of the edge, ascending; of each edge that got one
  std::map<Vertices, std::size_t> of_face;  ///< likewise
};

Vertices ascending(Vertices vertices);

/// The faces of a 2-G-map or 2-O-map, `vertex` being the number of each dart's vertex. Faces are in the order of their
/// smallest darts, each from there; those of a mesh that was read turn as in its file.
std::vector<Vertices> faces(Map const& map, std::vector<std::size_t> const& vertex);
/// The vertices, numbered by their smallest darts.
std::vector<std::size_t> number_vertices(Map const& map);
/// With the values of the first embedding as points.
Polygons polygons(Map const& map, std::vector<std::size_t> const& vertex);

}  // namespace jrule::test
