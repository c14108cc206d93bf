#include "tests/bench/peers/meshes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <stdexcept>

#include "jrule/io.h"
#include "tests/smoothing/polygons.h"

namespace jrule::bench {

namespace {

/// Fills `next` and `opposite` from `first` and `vertex`.
Surface joined(Surface s) {
  constexpr std::uint32_t none = 0xffffffffU;
  s.next.resize(s.corner_count());
  s.opposite.resize(s.corner_count(), none);
  // The corners at each vertex, in a chain.
  std::vector<std::uint32_t> last(s.points.size(), none), before(s.corner_count());
  for (std::size_t f = 0; f < s.face_count(); ++f) {
    for (std::uint32_t c = s.first[f]; c < s.first[f + 1]; ++c) {
      s.next[c] = c + 1 < s.first[f + 1] ? c + 1 : s.first[f];
      before[c] = last[s.vertex[c]];
      last[s.vertex[c]] = c;
    }
  }
  for (std::uint32_t c = 0; c < s.corner_count(); ++c) {
    for (std::uint32_t other = last[s.vertex[s.next[c]]]; other != none; other = before[other]) {
      if (s.vertex[s.next[other]] != s.vertex[c]) continue;
      if (s.opposite[c] != none) throw std::runtime_error(s.name + ": two faces have the same side");
      s.opposite[c] = other;
    }
    if (s.opposite[c] == none) throw std::runtime_error(s.name + " is not closed");
  }
  return s;
}

}  // namespace

Surface torus(std::uint32_t n) {
  Surface s;
  s.name = "torus " + std::to_string(n) + "²";
  double const step = 2 * std::numbers::pi / n;
  for (std::uint32_t y = 0; y < n; ++y) {
    for (std::uint32_t x = 0; x < n; ++x) {
      double const r = 2 + std::cos(y * step);
      s.points.push_back({r * std::cos(x * step), r * std::sin(x * step), std::sin(y * step)});
      std::uint32_t const right = (x + 1) % n, up = (y + 1) % n;
      s.first.push_back(static_cast<std::uint32_t>(s.vertex.size()));
      for (std::uint32_t const v : {y * n + x, y * n + right, up * n + right, up * n + x}) s.vertex.push_back(v);
    }
  }
  s.first.push_back(static_cast<std::uint32_t>(s.vertex.size()));
  return joined(std::move(s));
}

Surface read_surface(std::string const& name, std::string const& path) {
  Result<Map> const map = read_map(path, gmap(2), {{"position", orbit_of_dimensions({1, 2}), Type::Point3}});
  if (!map) throw std::runtime_error(to_string(map.error()));
  test::Polygons const polygons = test::polygons(*map, test::number_vertices(*map));
  Surface s;
  s.name = name;
  s.points = polygons.points;
  for (test::Vertices const& face : polygons.faces) {
    s.first.push_back(static_cast<std::uint32_t>(s.vertex.size()));
    for (std::size_t const v : face) s.vertex.push_back(static_cast<std::uint32_t>(v));
  }
  s.first.push_back(static_cast<std::uint32_t>(s.vertex.size()));
  return joined(std::move(s));
}

std::vector<std::uint32_t> sample_faces(Surface const& surface, std::size_t count) {
  std::vector<std::uint32_t> faces(surface.face_count());
  std::iota(faces.begin(), faces.end(), 0U);
  std::mt19937 random(1);
  // Not std::shuffle, whose order is the library's choice.
  count = std::min(count, faces.size());
  for (std::size_t k = 0; k < count; ++k) std::swap(faces[k], faces[k + random() % (faces.size() - k)]);
  faces.resize(count);
  return faces;
}

Map map_of(Surface const& s, Model const& model, std::vector<EmbeddingSpec> const& embeddings) {
  Map map(model, embeddings);
  bool const halfedges = model.is_oriented(1);
  map.add_darts((halfedges ? 1 : 2) * s.corner_count());
  for (Dart c = 0; c < s.corner_count(); ++c) {
    if (halfedges) {
      map.set_target(c, 1, s.next[c]);
      map.set_target(c, 2, s.opposite[c]);
    } else {
      map.link(2 * c, 0, 2 * c + 1);
      map.link(2 * c + 1, 1, 2 * s.next[c]);
      map.link(2 * c, 2, 2 * s.opposite[c] + 1);
    }
  }
  for (std::size_t e = 0; e < map.embedding_count(); ++e) {
    Embedding& embedding = map.embedding(e);
    embedding.reserve_values(s.points.size());
    for (Point3 const& p : s.points) embedding.add(Value(p));
    for (Dart c = 0; c < s.corner_count(); ++c) {
      if (halfedges) {
        embedding.set_handle(c, s.vertex[c]);
      } else {
        embedding.set_handle(2 * c, s.vertex[c]);
        embedding.set_handle(2 * c + 1, s.vertex[s.next[c]]);
      }
    }
  }
  return map;
}

}  // namespace jrule::bench
