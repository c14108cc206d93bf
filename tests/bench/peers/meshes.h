// The surfaces of the benchmark, as plain numbers from which every contender builds its own mesh.
#pragma once

#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "jrule/map.h"
#include "jrule/value.h"

namespace jrule::bench {

/// A closed oriented surface. Corner c of a face begins the side that leads to corner next[c]; opposite[c] begins the
/// same side in the neighbouring face, the other way round.
struct Surface {
  std::string name;
  std::vector<Point3> points;           ///< by vertex
  std::vector<std::uint32_t> first;     ///< the first corner of each face, and the number of corners
  std::vector<std::uint32_t> vertex;    ///< by corner
  std::vector<std::uint32_t> next;      ///< by corner
  std::vector<std::uint32_t> opposite;  ///< by corner

  std::size_t corner_count() const { return vertex.size(); }
  std::size_t face_count() const { return first.size() - 1; }
};

/// The torus of n × n quads.
Surface torus(std::uint32_t n);
/// A mesh in a file; it must be closed. Throws std::runtime_error.
Surface read_surface(std::string const& name, std::string const& path);

/// So many faces, no two alike, in an order that depends on the seed only.
std::vector<std::uint32_t> sample_faces(Surface const& surface, std::size_t count);

/// The surface as a 2-G-map (darts 2c and 2c + 1 at both ends of the side of c) or a 2-O-map (dart c), with a value for
/// each vertex if there is an embedding.
Map map_of(Surface const& surface, Model const& model, std::vector<EmbeddingSpec> const& embeddings);

}  // namespace jrule::bench
