// Any bytes as a surface of each format, in each model: what is read is a map, and what is written of it reads as a map of as many cells.
#include <cstddef>
#include <cstdint>

#include "formats.h"
#include "jrule/io.h"
#include "tests/fuzz/claim.h"

namespace jrule::fuzz {

namespace {

void write_again(Map const& map, io::SurfaceFormat const& format) {
  auto const surface = io::to_surface(map);
  if (!surface) return;  // a vertex twice on a face
  auto const bytes = format.print(*surface);
  if (!bytes) return;  // .stl: beyond float
  auto const read = format.parse(*bytes, "again");
  claim(read.has_value(), "what is written reads" + (read ? "" : ": " + read.error().message));
  // .stl knows vertices by their places, and cuts faces.
  if (format.suffix == ".stl") return;
  claim(read->points.size() == surface->points.size() && read->corners == surface->corners && read->face_ends == surface->face_ends,
        "what is written reads as the same");
  for (std::size_t i = 0; i < read->points.size(); ++i) claim(read->points[i] == surface->points[i], "numbers read as the same");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
  std::string_view const bytes(reinterpret_cast<char const*>(data), size);
  for (std::string_view const suffix : {".obj", ".off", ".ply", ".stl"}) {
    io::SurfaceFormat const& format = *io::find_format(suffix);
    auto const surface = format.parse(bytes, "fuzz");
    if (!surface) {
      claim(!surface.error().message.empty(), "an error has words");
      continue;
    }
    for (Model const& model : {gmap(2), closed_gmap(2), omap(2), dual_omap(2), gmap(3)}) {
      std::vector<EmbeddingSpec> const embeddings{{"position", *cell_orbit(model, 0), Type::Point3, std::nullopt, MergePolicy::none}};
      auto const map = io::to_map(*surface, model, embeddings, "fuzz");
      if (!map) continue;
      auto const violation = find_violation(*map);
      claim(!violation, "what is read is a map" + (violation ? ": " + violation->text : ""));
      write_again(*map, format);
    }
  }
  return 0;
}

}  // namespace jrule::fuzz
