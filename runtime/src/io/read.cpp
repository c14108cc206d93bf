#include <array>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <new>
#include <stdexcept>
#include <system_error>

#include "formats.h"
#include "jrule/io.h"

namespace jrule {
namespace {

Result<std::string> read_file(std::string const& path) {
  auto const error = [&](int code) {
    return fail(Error::Kind::io, "cannot read the file: " + std::generic_category().message(code), path);
  };
  auto const close = [](std::FILE* f) { std::fclose(f); };
  std::unique_ptr<std::FILE, decltype(close)> const in(std::fopen(path.c_str(), "rb"), close);
  if (!in) return error(errno);
  std::string bytes;
  std::array<char, 65536> block;
  for (;;) {
    std::size_t const got = std::fread(block.data(), 1, block.size(), in.get());
    if (std::ferror(in.get()) != 0) return error(errno);
    bytes.append(block.data(), got);
    if (got < block.size()) return bytes;
  }
}

/// Runs `read`, with the errors of the allocator as results.
template <class Read>
Result<Map> guarded(std::string const& path, Read read) {
  auto const error = [&] { return fail(Error::Kind::no_memory, "the map does not fit into memory", path); };
  try {
    return read();
  } catch (std::bad_alloc const&) {
    return error();
  } catch (std::length_error const&) {
    return error();
  }
}

}  // namespace

namespace io {

std::string suffix_of(std::string const& path) {
  std::string suffix = std::filesystem::path(path).extension().string();
  for (char& c : suffix) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return suffix;
}

SurfaceFormat const* find_format(std::string_view suffix) {
  static constexpr SurfaceFormat formats[] = {{".obj", parse_obj, print_obj},
                                              {".off", parse_off, print_off},
                                              {".ply", parse_ply, print_ply},
                                              {".stl", parse_stl, print_stl}};
  for (SurfaceFormat const& format : formats) {
    if (format.suffix == suffix) return &format;
  }
  return nullptr;
}

tl::unexpected<Error> unknown_format(std::string const& path) {
  std::string const suffix = suffix_of(path);
  return fail(Error::Kind::bad_input,
              (suffix.empty() ? "a file without a suffix has no format" : "no format has the suffix '" + suffix + "'") +
                  "; the formats are .obj .off .ply .stl .jmap",
              path);
}

}  // namespace io

Result<Map> read_map(std::string const& path, Model const& model, std::vector<EmbeddingSpec> const& embeddings) {
  std::string const suffix = io::suffix_of(path);
  io::SurfaceFormat const* const format = io::find_format(suffix);
  if (format == nullptr && suffix != ".jmap") return io::unknown_format(path);
  return guarded(path, [&]() -> Result<Map> {
    auto const bytes = read_file(path);
    if (!bytes) return tl::unexpected(bytes.error());
    if (format == nullptr) return io::parse_jmap_as(*bytes, path, model, embeddings);
    auto const surface = format->parse(*bytes, path);
    if (!surface) return tl::unexpected(surface.error());
    return io::to_map(*surface, model, embeddings, path);
  });
}

Result<Map> map_of_polygons(std::vector<Point3> const& points, std::vector<std::vector<std::uint32_t>> const& faces, Model const& model,
                            std::vector<EmbeddingSpec> const& embeddings) {
  std::string const name = "polygons";
  return guarded(name, [&]() -> Result<Map> {
    io::Surface surface;
    surface.points = points;
    for (std::size_t f = 0; f < faces.size(); ++f) {
      surface.corners.insert(surface.corners.end(), faces[f].begin(), faces[f].end());
      surface.end_face(f + 1);
    }
    surface.end = faces.size() + 1;
    surface.first_index = 0;
    return io::to_map(surface, model, embeddings, name);
  });
}

Result<Map> read_jmap(std::string const& path) {
  return guarded(path, [&]() -> Result<Map> {
    auto const text = read_file(path);
    if (!text) return tl::unexpected(text.error());
    return parse_jmap(*text, path);
  });
}

}  // namespace jrule
