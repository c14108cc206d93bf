// Reading and writing maps. The format is chosen by the suffix: .obj .off .ply .stl (surfaces) and .jmap (any map).
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "jrule/map.h"
#include "jrule/result.h"

namespace jrule {

/// Reads a map of `model` with these embeddings.
///
/// Surfaces (.obj .off .ply .stl) need a model of dimension 2 or more that is a G-map, closed G-map, O-map or dual O-map,
/// and become darts whose arcs above 2 are loops. Positions go to the first embedding of type Point3 on vertices, if any;
/// other embeddings take their defaults, and one without a default is an error. In a model without arcs that stay free
/// (O-maps), a hole becomes an outer face; a closed G-map refuses a surface with a boundary. Faces are oriented alike for
/// O-maps; a non-orientable surface is then an error. Errors name the file and line: a number that is not finite, an index
/// out of range, a face with fewer than three or with two equal vertices, an edge of more than two faces.
/// Darts are numbered in the order of the file: of face f with n corners, darts first + 2k and first + 2k + 1 (G-maps) are
/// the two ends of its k-th edge; first + k (O-maps) is its k-th edge. So equal files give equal maps.
///
/// .jmap must name the same model and dimension; embeddings are taken by name, missing ones get their defaults. It cannot
/// hold values of Type::Extern: a file that has them by the embedding's name is an error.
///
/// A default that is computed by C++ is computed once; what it throws is passed on.
Result<Map> read_map(std::string const& path, Model const& model, std::vector<EmbeddingSpec> const& embeddings);

/// The map of polygons, each given by its corners as indices into `points`: what read_map() makes of a file with these faces, with the
/// same numbers of darts. Errors count the faces from 1 as lines of "polygons".
Result<Map> map_of_polygons(std::vector<Point3> const& points, std::vector<std::vector<std::uint32_t>> const& faces, Model const& model,
                            std::vector<EmbeddingSpec> const& embeddings);

/// Reads a .jmap with the model and the embeddings that it names itself. Its orbit types follow each embedding's type.
Result<Map> read_jmap(std::string const& path);
/// The same from text; `path` is for messages only.
Result<Map> parse_jmap(std::string_view text, std::string const& path);
/// The canonical .jmap text: live darts renumbered 0.. in index order, values in the order of the first dart that has them.
/// Throws std::invalid_argument if the map has an embedding of Type::Extern.
std::string print_jmap(Map const& map);

/// Writes by suffix; the file appears whole or not at all (a temporary file beside it is renamed). Surface formats write
/// every 2-cell once (in O-maps, outer faces are faces like all others) and need an embedding of type Point3 on vertices; .stl cuts n-gons into
/// triangles. .jmap refuses a map with an embedding of Type::Extern, the others leave it out. Numbers are written so that they read back exactly (.stl: as float).
Result<void> write_map(Map const& map, std::string const& path);

/// What write_map() writes to a file of that name.
Result<std::string> map_text(Map const& map, std::string const& path);

/// Writes a file that appears whole or not at all: a temporary file beside it is renamed.
Result<void> write_whole_file(std::string const& path, std::string const& bytes);
/// The same with several: where one cannot be written, none appears.
struct FileText {
  std::string path, bytes;
};
Result<void> write_whole_files(std::span<FileText const> files);

}  // namespace jrule
