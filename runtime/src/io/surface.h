// A polygon mesh as surface files hold it, and its way to a map and back.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "jrule/map.h"
#include "jrule/result.h"

namespace jrule::io {

struct Surface {
  std::vector<Point3> points;
  std::vector<std::uint32_t> corners;  ///< of face after face: indices into `points`, not yet checked
  std::vector<std::size_t> face_ends;  ///< where the corners of each face end

  // For messages about what was read.
  std::vector<std::size_t> places;  ///< the line of each face; in a binary file, its byte offset
  std::size_t end = 1;              ///< the last line of the file
  bool binary = false;
  std::optional<std::uint32_t> first_index;  ///< the number of the file's first vertex; none if they have no numbers

  std::size_t face_count() const noexcept { return face_ends.size(); }
  std::size_t face_begin(std::size_t face) const noexcept { return face == 0 ? 0 : face_ends[face - 1]; }
  std::span<std::uint32_t const> face(std::size_t f) const noexcept {
    return std::span(corners).subspan(face_begin(f), face_ends[f] - face_begin(f));
  }
  /// Ends the face of the corners added since the last face.
  void end_face(std::size_t place) {
    face_ends.push_back(corners.size());
    places.push_back(place);
  }
};

/// The index of a vertex as a corner; none if no vertex of any file has it.
inline std::optional<std::uint32_t> to_corner(std::int64_t index) noexcept {
  if (index < 0 || index >= std::int64_t{no_dart}) return std::nullopt;
  return static_cast<std::uint32_t>(index);
}

/// The map of a surface, as jrule/io.h says; `file` is for messages.
Result<Map> to_map(Surface const& surface, Model const& model, std::vector<EmbeddingSpec> const& embeddings,
                   std::string const& file);

/// The surface of a map's 2-cells, each once, in the order of their smallest darts and beginning there. Vertices are
/// numbered by smallest dart. Faces that a surface file cannot hold are errors: open ones, those with fewer than three
/// corners, and those that meet a vertex twice, such as the two sides of a wire edge.
Result<Surface> to_surface(Map const& map);

/// Whether both describe the same orbits word by word: neither the order of the words nor their direction matters.
bool same_orbit(Model const& model, OrbitType const& a, OrbitType const& b);

/// A map with these embeddings and `darts` darts. An error if there are more darts than an index can number.
Result<Map> make_map(Model const& model, std::vector<EmbeddingSpec> const& embeddings, std::size_t darts,
                     std::string const& file);

/// Gives all darts the embedding's default value; an error if it has none.
Result<void> set_default(Map& map, std::size_t embedding, std::string const& file);

}  // namespace jrule::io
