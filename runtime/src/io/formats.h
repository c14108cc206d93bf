// The file formats: for each surface format, the bytes of a file to a surface and back; and .jmap.
#pragma once

#include <string>
#include <string_view>

#include "surface.h"

namespace jrule::io {

/// Each reads a whole file; `file` is its path, for messages. What only concerns the syntax of the format is checked
/// here, what concerns the surface by to_map().
Result<Surface> parse_obj(std::string_view text, std::string const& file);
Result<Surface> parse_off(std::string_view text, std::string const& file);
Result<Surface> parse_ply(std::string_view bytes, std::string const& file);
Result<Surface> parse_stl(std::string_view bytes, std::string const& file);

Result<std::string> print_obj(Surface const& surface);
Result<std::string> print_off(Surface const& surface);
/// Ascii, the coordinates as doubles.
Result<std::string> print_ply(Surface const& surface);
/// Binary. An error where a coordinate or a triangle does not survive as float.
Result<std::string> print_stl(Surface const& surface);

struct SurfaceFormat {
  std::string_view suffix;
  Result<Surface> (*parse)(std::string_view bytes, std::string const& file);
  Result<std::string> (*print)(Surface const& surface);
};

/// ".obj" of "dir/Cube.OBJ": the suffix in lower case.
std::string suffix_of(std::string const& path);
/// The surface format of that suffix; null if there is none.
SurfaceFormat const* find_format(std::string_view suffix);
/// The error for a file of any other suffix than those known.
tl::unexpected<Error> unknown_format(std::string const& path);

/// A .jmap as a map of this model with these embeddings.
Result<Map> parse_jmap_as(std::string_view text, std::string const& file, Model const& model,
                          std::vector<EmbeddingSpec> const& embeddings);
/// print_jmap(), but an error where a dart lacks a value or a value is not finite: such a file could not be read.
Result<std::string> print_checked_jmap(Map const& map);

}  // namespace jrule::io
