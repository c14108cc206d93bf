#include "surface.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include <fmt/format.h>

#include "text.h"

namespace jrule::io {
namespace {

/// A face's k-th edge, seen from that face, has the index of its k-th corner in Surface::corners.
using HalfEdge = std::uint32_t;
constexpr HalfEdge no_half_edge = no_dart;

enum class Shape { gmap, omap, dual_omap };

/// Which of the known shapes a model has, whatever its name.
std::optional<Shape> shape_of(Model const& model) {
  int const n = model.dimension;
  if (n < 1 || n > max_dimension) return std::nullopt;
  auto const is = [&](Model known) {
    known.name = model.name;
    return known == model;
  };
  if (is(gmap(n)) || is(closed_gmap(n))) return Shape::gmap;
  if (is(omap(n))) return Shape::omap;
  if (is(dual_omap(n))) return Shape::dual_omap;
  return std::nullopt;
}

/// The embedding that holds the positions: the first of type Point3 on vertices.
std::optional<std::size_t> find_positions(Model const& model, std::vector<EmbeddingSpec> const& embeddings) {
  auto const vertex = cell_orbit(model, 0);
  if (!vertex) return std::nullopt;
  for (std::size_t i = 0; i < embeddings.size(); ++i) {
    if (embeddings[i].type == Type::Point3 && same_orbit(model, embeddings[i].orbit, *vertex)) return i;
  }
  return std::nullopt;
}

/// A surface with what its checks find out about it.
class Checked {
 public:
  Checked(Surface const& surface, std::string const& file) : surface_(surface), file_(file) {}

  /// Every face has three corners or more, all different, all in the file.
  Result<void> check_faces();
  /// Finds the half-edges of each edge; no edge has more than two.
  Result<void> pair_half_edges();
  /// No half-edge is alone.
  Result<void> check_closed(std::string const& model) const;
  /// Decides which faces to turn so that the faces of each component are oriented as its first one.
  Result<void> orient(std::string const& model);

  std::size_t half_edge_count() const noexcept { return surface_.corners.size(); }
  HalfEdge mate(HalfEdge h) const noexcept { return mates_[h]; }
  HalfEdge next(HalfEdge h) const noexcept {
    std::size_t const f = faces_[h];
    return h + 1 == surface_.face_ends[f] ? static_cast<HalfEdge>(surface_.face_begin(f)) : h + 1;
  }
  HalfEdge previous(HalfEdge h) const noexcept {
    std::size_t const f = faces_[h];
    return static_cast<HalfEdge>((h == surface_.face_begin(f) ? surface_.face_ends[f] : h) - 1);
  }
  std::uint32_t begin_vertex(HalfEdge h) const noexcept { return surface_.corners[h]; }
  std::uint32_t end_vertex(HalfEdge h) const noexcept { return surface_.corners[next(h)]; }
  bool is_turned(HalfEdge h) const noexcept { return turned_[faces_[h]]; }

 private:
  std::string name(std::uint32_t vertex) const {
    Point3 const& p = surface_.points[vertex];
    if (!surface_.first_index) return fmt::format("({}, {}, {})", p.x, p.y, p.z);
    return fmt::format("{}", std::uint64_t{vertex} + *surface_.first_index);
  }
  std::string edge_name(HalfEdge h) const {
    return fmt::format("the edge between vertices {} and {}", name(begin_vertex(h)), name(end_vertex(h)));
  }
  tl::unexpected<Error> bad_face(std::size_t face, std::string message) const {
    if (!surface_.binary) return bad_input(std::move(message), file_, surface_.places[face]);
    return bad_input(fmt::format("{} (face at byte {})", message, surface_.places[face]), file_, 0);
  }

  Surface const& surface_;
  std::string const& file_;
  std::vector<std::uint32_t> faces_;  // of each half-edge
  std::vector<HalfEdge> mates_;       // the other half-edge of the same edge
  std::vector<bool> turned_;          // for each face
};

Result<void> Checked::check_faces() {
  if (surface_.face_count() == 0) {
    return bad_input("the file has no faces", file_, surface_.binary ? 0 : surface_.end);
  }
  faces_.resize(surface_.corners.size());
  std::vector<std::size_t> last_face(surface_.points.size(), surface_.face_count());
  for (std::size_t f = 0; f < surface_.face_count(); ++f) {
    auto const face = surface_.face(f);
    if (face.size() < 3) return bad_face(f, fmt::format("a face needs 3 corners or more, found {}", face.size()));
    std::fill_n(faces_.begin() + static_cast<std::ptrdiff_t>(surface_.face_begin(f)), face.size(),
                static_cast<std::uint32_t>(f));
    for (std::uint32_t corner : face) {
      if (corner >= surface_.points.size()) {
        return bad_face(f,
                        fmt::format("there is no vertex {}: the file has {}",
                                    std::uint64_t{corner} + surface_.first_index.value_or(0), surface_.points.size()));
      }
      if (last_face[corner] == f) return bad_face(f, fmt::format("the face has vertex {} twice", name(corner)));
      last_face[corner] = f;
    }
  }
  return {};
}

Result<void> Checked::pair_half_edges() {
  struct Use {
    std::uint32_t low, high;
    HalfEdge half_edge;
    auto operator<=>(Use const&) const = default;
  };
  std::vector<Use> uses(half_edge_count());
  for (HalfEdge h = 0; h < uses.size(); ++h) {
    auto const [low, high] = std::minmax({begin_vertex(h), end_vertex(h)});
    uses[h] = {low, high, h};
  }
  std::sort(uses.begin(), uses.end());

  mates_.assign(uses.size(), no_half_edge);
  HalfEdge third = no_half_edge;  // the first in the file that has two before it
  for (std::size_t i = 0; i < uses.size();) {
    std::size_t end = i + 1;
    while (end < uses.size() && uses[end].low == uses[i].low && uses[end].high == uses[i].high) ++end;
    if (end - i > 2) third = std::min(third, uses[i + 2].half_edge);
    if (end - i == 2) {
      mates_[uses[i].half_edge] = uses[i + 1].half_edge;
      mates_[uses[i + 1].half_edge] = uses[i].half_edge;
    }
    i = end;
  }
  if (third != no_half_edge) return bad_face(faces_[third], edge_name(third) + " belongs to more than two faces");
  return {};
}

Result<void> Checked::check_closed(std::string const& model) const {
  for (HalfEdge h = 0; h < mates_.size(); ++h) {
    if (mates_[h] != no_half_edge) continue;
    return bad_face(faces_[h],
                    fmt::format("{} belongs to one face only, but {} allows no boundary", edge_name(h), model));
  }
  return {};
}

Result<void> Checked::orient(std::string const& model) {
  turned_.assign(surface_.face_count(), false);
  std::vector<bool> reached(surface_.face_count(), false);
  std::vector<std::uint32_t> queue;
  for (std::uint32_t first = 0; first < surface_.face_count(); ++first) {
    if (reached[first]) continue;
    reached[first] = true;
    queue.assign(1, first);
    for (std::size_t i = 0; i < queue.size(); ++i) {
      std::uint32_t const f = queue[i];
      for (std::size_t h = surface_.face_begin(f); h < surface_.face_ends[f]; ++h) {
        HalfEdge const other = mates_[h];
        if (other == no_half_edge) continue;
        std::uint32_t const g = faces_[other];
        // Alike means: the two faces run along their edge in opposite directions.
        bool const same_direction = begin_vertex(static_cast<HalfEdge>(h)) == begin_vertex(other);
        bool const turn = turned_[f] != same_direction;
        if (!reached[g]) {
          reached[g] = true;
          turned_[g] = turn;
          queue.push_back(g);
        } else if (turned_[g] != turn) {
          return bad_face(std::max(f, g),
                          fmt::format("the surface is not orientable, as {} demands: the faces at {} cannot "
                                      "be turned alike",
                                      model, edge_name(other)));
        }
      }
    }
  }
  return {};
}

/// Links the darts of a G-map; returns the vertex of each.
std::vector<std::uint32_t> link_gmap(Map& map, Checked const& surface) {
  std::vector<std::uint32_t> vertices(2 * surface.half_edge_count());
  for (HalfEdge h = 0; h < surface.half_edge_count(); ++h) {
    Dart const begin = 2 * h;
    Dart const end = begin + 1;
    vertices[begin] = surface.begin_vertex(h);
    vertices[end] = surface.end_vertex(h);
    map.link(begin, 0, end);
    map.link(end, 1, 2 * surface.next(h));
    if (HalfEdge const other = surface.mate(h); other != no_half_edge) {
      bool const same_direction = surface.begin_vertex(other) == surface.begin_vertex(h);
      map.link(begin, 2, same_direction ? 2 * other : 2 * other + 1);
      map.link(end, 2, same_direction ? 2 * other + 1 : 2 * other);
    }
  }
  return vertices;
}

/// An oriented surface without boundary: the file's faces and the outer faces that fill its holes.
struct Oriented {
  std::vector<Dart> next;             // in the face
  std::vector<Dart> opposite;         // in the face across the edge
  std::vector<std::uint32_t> origin;  // the vertex where the dart starts
};

Oriented fill_holes(Checked const& surface) {
  std::size_t const count = surface.half_edge_count();
  Oriented all{std::vector<Dart>(count), std::vector<Dart>(count), std::vector<std::uint32_t>(count)};
  auto const previous = [&](HalfEdge h) { return surface.is_turned(h) ? surface.next(h) : surface.previous(h); };
  for (HalfEdge h = 0; h < count; ++h) {
    all.next[h] = surface.is_turned(h) ? surface.previous(h) : surface.next(h);
    all.origin[h] = surface.is_turned(h) ? surface.end_vertex(h) : surface.begin_vertex(h);
    all.opposite[h] = surface.mate(h);
  }
  for (HalfEdge first = 0; first < count; ++first) {
    if (all.opposite[first] != no_dart) continue;
    Dart const face = static_cast<Dart>(all.next.size());
    HalfEdge h = first;
    do {
      all.opposite[h] = static_cast<Dart>(all.next.size());
      all.origin.push_back(all.origin[all.next[h]]);
      all.opposite.push_back(h);
      all.next.push_back(static_cast<Dart>(all.next.size() + 1));
      // The next border is found by turning around the vertex where h starts, through the faces there. A vertex where
      // several fans of faces meet so becomes one vertex for each fan.
      h = previous(h);
      while (surface.mate(h) != no_half_edge) h = previous(surface.mate(h));
    } while (h != first);
    all.next.back() = face;
  }
  return all;
}

void link_oriented(Map& map, Shape shape, Oriented const& surface) {
  for (Dart d = 0; d < map.dart_limit(); ++d) {
    if (shape == Shape::omap) {
      map.set_target(d, 1, surface.next[d]);
      map.set_target(d, 2, surface.opposite[d]);
    } else {  // 1 leads across the edge and 2 around the vertex, so that the word 12 leads around the face
      map.set_target(d, 1, surface.opposite[d]);
      map.set_target(d, 2, surface.next[surface.opposite[d]]);
    }
  }
}

}  // namespace

bool same_orbit(Model const& model, OrbitType const& a, OrbitType const& b) {
  auto const canonical = [&](OrbitType const& type) {
    std::vector<Word> words;
    for (Word const& word : type.words) {
      Word inverse(word.rbegin(), word.rend());
      for (Letter& letter : inverse) letter.conjugate = letter.conjugate != model.is_oriented(letter.dimension);
      words.push_back(std::min(word, inverse));
    }
    std::sort(words.begin(), words.end());
    words.erase(std::unique(words.begin(), words.end()), words.end());
    return words;
  };
  return canonical(a) == canonical(b);
}

Result<Map> make_map(Model const& model, std::vector<EmbeddingSpec> const& embeddings, std::size_t darts,
                     std::string const& file) {
  if (darts >= no_dart) {
    return fail(Error::Kind::no_memory, fmt::format("{} darts are more than a map holds", darts), file);
  }
  Map map(model, embeddings);
  map.add_darts(darts);
  return map;
}

Result<void> set_default(Map& map, std::size_t embedding, std::string const& file) {
  Embedding& e = map.embedding(embedding);
  auto const handle = e.add_default();
  if (!handle) {
    return fail(Error::Kind::bad_input,
                fmt::format("the file has no values of embedding '{}', which has no default", e.spec().name), file);
  }
  for (Dart d = 0; d < map.dart_limit(); ++d) e.set_handle(d, *handle);
  return {};
}

Result<Map> to_map(Surface const& surface, Model const& model, std::vector<EmbeddingSpec> const& embeddings,
                   std::string const& file) {
  auto const shape = shape_of(model);
  std::string const model_name = fmt::format("{}({})", model.name, model.dimension);
  if (!shape || model.dimension < 2) {
    return fail(Error::Kind::bad_input,
                fmt::format("a surface cannot be read as {}: only G-maps and O-maps of dimension 2 "
                            "or more, and their closed and dual kinds",
                            model_name),
                file);
  }
  // There a loop breaks the model: an arc of dimension 3 must lead to another volume.
  if ((*shape != Shape::gmap || model.closed) && model.dimension > 2) {
    return fail(Error::Kind::bad_input,
                fmt::format("a surface cannot be read as {}: its arcs above 2 cannot be loops", model_name), file);
  }

  Checked checked(surface, file);
  if (auto ok = checked.check_faces(); !ok) return tl::unexpected(ok.error());
  if (2 * surface.corners.size() >= no_dart) {
    return fail(Error::Kind::no_memory, fmt::format("{} corners are more than a map holds", surface.corners.size()),
                file);
  }
  if (auto ok = checked.pair_half_edges(); !ok) return tl::unexpected(ok.error());
  if (model.closed) {
    if (auto ok = checked.check_closed(model_name); !ok) return tl::unexpected(ok.error());
  }

  std::optional<Oriented> oriented;
  if (*shape != Shape::gmap) {
    if (auto ok = checked.orient(model_name); !ok) return tl::unexpected(ok.error());
    oriented = fill_holes(checked);
  }
  Result<Map> map = make_map(model, embeddings, oriented ? oriented->next.size() : 2 * surface.corners.size(), file);
  if (!map) return map;
  if (oriented) link_oriented(*map, *shape, *oriented);
  std::vector<std::uint32_t> const vertices = oriented ? std::move(oriented->origin) : link_gmap(*map, checked);

  auto const positions = find_positions(model, embeddings);
  for (std::size_t i = 0; i < embeddings.size(); ++i) {
    if (i != positions) {
      if (auto ok = set_default(*map, i, file); !ok) return tl::unexpected(ok.error());
      continue;
    }
    Embedding& e = map->embedding(i);
    std::vector<Handle> handles(surface.points.size(), no_handle);
    for (Dart d = 0; d < map->dart_limit(); ++d) {
      Handle& handle = handles[vertices[d]];
      if (handle == no_handle) handle = e.add(surface.points[vertices[d]]);
      e.set_handle(d, handle);
    }
  }
  return map;
}

Result<Surface> to_surface(Map const& map) {
  Model const& model = map.model();
  auto const shape = shape_of(model);
  auto const error = [](std::string message) {
    return fail(Error::Kind::bad_input, message + "; a surface file cannot hold that, write a .jmap");
  };
  if (!shape || model.dimension < 2) {
    return error(fmt::format("a map of {}({}) has no faces known here", model.name, model.dimension));
  }
  std::vector<EmbeddingSpec> specs;
  for (std::size_t i = 0; i < map.embedding_count(); ++i) specs.push_back(map.embedding(i).spec());
  auto const positions = find_positions(model, specs);
  if (!positions) return error("the map has no embedding of type Point3 on vertices");
  if (map.dart_count() == 0) return error("the map has no faces");

  Surface surface;
  Embedding const& e = map.embedding(*positions);
  OrbitNumbers const vertices = number_orbits(map, e.spec().orbit);
  for (Dart d : vertices.first) {
    if (e.handle(d) == no_handle) return error(fmt::format("dart {} has no value of '{}'", d, e.spec().name));
    Point3 const p = e.values<Point3>()[e.handle(d)];
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) {
      return error(fmt::format("dart {} has a '{}' that is not finite", d, e.spec().name));
    }
    surface.points.push_back(p);
  }

  // The word that leads from a corner of a face to the next.
  std::vector<int> const steps = *shape == Shape::gmap   ? std::vector{0, 1}
                                 : *shape == Shape::omap ? std::vector{1}
                                                         : std::vector{1, 2};
  std::vector<Dart> last_face(vertices.first.size(), no_dart);
  auto const face_orbit = cell_orbit(model, 2);
  assert(face_orbit);
  for (Dart first : number_orbits(map, *face_orbit).first) {
    std::size_t corners = 0;
    Dart d = first;
    do {
      std::uint32_t const vertex = vertices.number[d];
      if (last_face[vertex] == first) {
        return error(fmt::format("the face of dart {} meets the vertex of dart {} twice", first, d));
      }
      last_face[vertex] = first;
      surface.corners.push_back(vertex);
      ++corners;
      for (int i : steps) {
        Dart const to = map.target(d, i);
        if (to == d && *shape == Shape::gmap) {
          return error(fmt::format("the face of dart {} is open: the {}-arc of dart {} is a loop", first, i, d));
        }
        d = to;
      }
    } while (d != first);
    if (corners < 3) return error(fmt::format("the face of dart {} has only {} corners", first, corners));
    surface.end_face(first);
  }
  return surface;
}

}  // namespace jrule::io
