#include "tests/stdlib/subjects.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "tests/reference/plain_map.h"
#include "tests/stdlib/application.h"

namespace jrule::test {

namespace {

Shape polygon(std::size_t n) {
  Shape shape{"polygon of " + std::to_string(n), {{}, {{}}}};
  for (std::size_t k = 0; k < n; ++k) {
    double const angle = 2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(n);
    shape.polygons.points.push_back({std::cos(angle), std::sin(angle), 0});
    shape.polygons.faces[0].push_back(k);
  }
  return shape;
}

/// n × m quads, joined round one way, and round the other way with a turn: two sides in one.
Shape klein_bottle(std::size_t n, std::size_t m) {
  Shape shape{"Klein bottle", {}};
  auto const at = [&](std::size_t i, std::size_t j) { return (j < m ? i % n : (2 * n - i) % n) * m + j % m; };
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < m; ++j) {
      shape.polygons.points.push_back({static_cast<double>(i), static_cast<double>(j), static_cast<double>(i * j)});
      shape.polygons.faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return shape;
}

/// An icosahedron whose opposite points are one: closed, with one side.
Shape projective_plane() {
  Shape shape{"projective plane", {{}, {}}};
  for (std::size_t v = 0; v < 6; ++v) {
    double const x = static_cast<double>(v);
    shape.polygons.points.push_back({x, x * x, x * x * x});
  }
  for (std::size_t k = 0; k < 5; ++k) {
    auto const at = [&](std::size_t i) { return 1 + (k + i) % 5; };
    shape.polygons.faces.push_back({0, at(0), at(1)});
    shape.polygons.faces.push_back({at(0), at(1), at(3)});
  }
  return shape;
}

/// With a corner in the middle of each edge.
Shape with_middles(Shape shape) {
  shape.name += " with middles of edges";
  std::map<Vertices, std::size_t> middle;
  for (Vertices& face : shape.polygons.faces) {
    Vertices finer;
    for (std::size_t k = 0; k < face.size(); ++k) {
      std::size_t const a = face[k], b = face[(k + 1) % face.size()];
      auto const [found, is_new] = middle.emplace(ascending({a, b}), shape.polygons.points.size());
      if (is_new) shape.polygons.points.push_back(midpoint(shape.polygons.points[a], shape.polygons.points[b]));
      finer.insert(finer.end(), {a, found->second});
    }
    face = std::move(finer);
  }
  return shape;
}

std::vector<Shape> const& surfaces() {
  static std::vector<Shape> const all = [] {
    std::vector<Shape> made;
    for (Shape const& shape : closed_surfaces()) {
      if (shape.name != "bunny") made.push_back(shape);
    }
    for (std::size_t const n : {3U, 5U, 6U}) made.push_back(prism(n));
    for (std::size_t const k : {1U, 3U, 5U, 7U}) made.push_back(kis(made[k]));
    for (std::size_t const solid : {0U, 1U, 2U}) made.push_back(with_middles(platonic_solids()[solid]));
    made.insert(made.end(), {klein_bottle(4, 3), projective_plane(), grid(3, 2), moebius(5)});
    for (std::size_t const n : {3U, 4U, 5U, 6U, 7U}) made.push_back(polygon(n));
    return made;
  }();
  return all;
}

/// With a face for each hole; none if there is one side only. Each vertex must be on one hole at most.
std::optional<Polygons> without_holes(Polygons polygons) {
  std::set<std::pair<std::size_t, std::size_t>> edges;
  for (Vertices const& face : polygons.faces) {
    for (std::size_t k = 0; k < face.size(); ++k) {
      if (!edges.emplace(face[k], face[(k + 1) % face.size()]).second) return {};
    }
  }
  std::map<std::size_t, std::size_t> next;
  for (auto const& [a, b] : edges) {
    if (!edges.contains({b, a})) next[b] = a;
  }
  while (!next.empty()) {
    Vertices hole;
    for (auto at = next.begin(); at != next.end(); at = next.find(hole.back())) {
      hole.push_back(at->second);
      next.erase(at);
    }
    polygons.faces.push_back(std::move(hole));
  }
  return polygons;
}

bool has_border(Map const& map) { return summarize(map).boundary_darts > 0; }

std::vector<Subject> surfaces_of(ir::Modeler const& modeler) {
  std::vector<Subject> found;
  for (Shape const& shape : surfaces()) {
    auto const filled = without_holes(shape.polygons);
    bool const closed = !filled || filled->faces.size() == shape.polygons.faces.size();
    if (!modeler.model.is_oriented(1)) {
      Map map = build(modeler, shape.polygons);
      bool const open = has_border(map);
      found.push_back({shape.name, shape.name, std::move(map), !open});
    } else if (filled) {
      found.push_back({shape.name, shape.name, build(modeler, *filled), closed});
    }
  }
  return found;
}

/// A face that stands by itself in space.
Map lone_face(ir::Modeler const& modeler, std::size_t n) {
  static Module const module(JRULE_SOURCE_DIR "/stdlib/std/volume.jrule");
  Map map(modeler.model, modeler.embeddings);
  apply(module.rule("add_triangle_solid"), map, {}, {Point3{0, 0, 0}, Point3{2, 0, 0}, Point3{0, 2, 0}});
  for (std::size_t k = 3; k < n; ++k) apply(module.rule("insert_vertex_solid"), map, {0});
  return map;
}

std::vector<Subject> solids_of(ir::Modeler const& modeler) {
  bool const oriented = modeler.model.is_oriented(1);
  std::vector<Solid> all = solids();
  all.pop_back();  // 3 × 3 × 3 cubes
  for (std::size_t const n : {3U, 6U}) {
    Shape const sides = prism(n);
    all.push_back({sides.name, sides.polygons.points, {sides.polygons.faces}});
    all.push_back(with_outside(all.back()));
  }
  all.insert(all.end(), {block(1, 3, 1), block(2, 2, 1), with_outside(block(2, 1, 1))});
  std::vector<Subject> found;
  for (Solid const& solid : all) {
    Solid const filled = with_outside(solid);
    bool const closed = filled.volumes.size() == solid.volumes.size();
    Solid const& shape = oriented ? filled : solid;
    found.push_back({solid.name, shape.name, build(modeler, shape), closed});
  }
  for (std::size_t n = 3; n < 8 && !oriented; ++n) {
    std::string const name = "face of " + std::to_string(n);
    found.push_back({name, name, lone_face(modeler, n), false});
  }
  return found;
}

/// With the i-arcs opened at some place: a corner where an edge or a face ends.
std::vector<Subject> opened(std::vector<Subject> const& all, int i, int n) {
  constexpr std::size_t most = 10;
  Module::Rule const open = instance("unsew", {i}, n);
  std::vector<Subject> found;
  for (Subject const& subject : all) {
    Map map = subject.map;
    std::vector<Dart> const darts = map.darts();
    auto const at = std::find_if(darts.begin(), darts.end(), [&](Dart d) { return refusal(open, map, {d}).empty(); });
    if (at == darts.end() || found.size() == most) continue;
    apply(open, map, {*at});
    std::string const name = subject.name + " opened in dimension " + std::to_string(i);
    found.push_back({name, name, std::move(map), false});
  }
  return found;
}

/// Edges of triangles drawn together: faces of two corners.
std::vector<Subject> with_digons(std::vector<Subject> const& solids) {
  Module::Rule const contract = instance("contract_cell", {1}, 3);
  std::vector<Subject> found;
  for (Subject const& solid : solids) {
    Map map = solid.map;
    if (orbit(map, orbit_of_dimensions({0, 1}), 0).size() != 6 || !refusal(contract, map, {0}).empty()) continue;
    apply(contract, map, {0});
    std::string const name = solid.name + " with an edge drawn together";
    found.push_back({name, name, std::move(map), solid.closed});
  }
  return found;
}

}  // namespace

std::vector<Subject> subjects(ir::Modeler const& modeler) {
  return modeler.model.dimension == 2 ? surfaces_of(modeler) : solids_of(modeler);
}

std::vector<Subject> unfinished_subjects(ir::Modeler const& modeler) {
  static Module const module(JRULE_SOURCE_DIR "/stdlib/std/holes.jrule");
  std::vector<Subject> found;
  if (modeler.model.dimension != 2 || modeler.model.is_oriented(1)) return found;
  for (Subject& subject : surfaces_of(modeler)) {
    if (subject.closed) continue;
    for (int sides = 0; sides < 2; ++sides) {
      std::vector<Dart> const darts = subject.map.darts();
      auto const free = std::find_if(darts.begin(), darts.end(), [&](Dart d) { return subject.map.target(d, 2) == d; });
      apply(module.rule("add_side"), subject.map, {*free});
    }
    subject.name = subject.shape = subject.name + " with two open sides";
    found.push_back(std::move(subject));
  }
  return found;
}

namespace {

std::vector<Subject> paths() {
  std::vector<Subject> found;
  for (Dart const k : {1U, 2U, 3U, 4U, 5U, 8U}) {
    for (bool const round : {false, true}) {
      std::string const name = (round ? "ring of " : "path of ") + std::to_string(k);
      found.push_back({name, name, path(k, round), round});
    }
  }
  return found;
}

std::vector<Subject> bare_surfaces_or_solids(int n) {
  static Module const surface(JRULE_SOURCE_DIR "/stdlib/std/surface.jrule"),
      volume(JRULE_SOURCE_DIR "/stdlib/std/volume.jrule");
  std::vector<Subject> all;
  for (Subject& subject : subjects(*(n == 2 ? surface.rules() : volume.rules()).front().scheme.modeler)) {
    all.push_back({subject.name, subject.shape, bare(subject.map), subject.closed});
  }
  return all;
}

}  // namespace

std::vector<Subject> bare_subjects(int n) {
  std::vector<Subject> const whole = n == 1 ? paths() : bare_surfaces_or_solids(n);
  std::vector<Subject> found = whole;
  auto const add = [&](std::vector<Subject> more) {
    for (Subject& subject : more) {
      bool const known = std::any_of(found.begin(), found.end(), [&](Subject const& other) {
        return reference::isomorphic(reference::plain(subject.map), reference::plain(other.map), {}, {}, {});
      });
      if (!known) found.push_back(std::move(subject));
    }
  };
  for (int i = 0; i < n; ++i) add(opened(whole, i, n));
  if (n == 3) add(with_digons(whole));
  return found;
}

std::vector<std::size_t> closed_cells(Map const& map) {
  int const n = map.model().dimension;
  std::vector<std::size_t> cells = summarize(map).cells;
  std::set<Dart> free;  // of holes that are not yet known
  for (Dart const d : map.darts()) {
    if (!map.model().is_oriented(1) && map.target(d, n) == d) free.insert(d);
  }
  // Across the side, then around it through the map to the next free dart.
  auto const across = [&](Dart d) {
    Dart at = map.target(d, n - 1);
    while (map.target(at, n) != at) at = map.target(map.target(at, n), n - 1);
    return at;
  };
  while (!free.empty()) {
    ++cells.back();
    std::vector<Dart> open{*free.begin()};
    free.erase(open.front());
    while (!open.empty()) {
      Dart const d = open.back();
      open.pop_back();
      for (int i = 0; i < n; ++i) {
        Dart const next = i + 1 == n ? across(d) : map.target(d, i);
        if (free.erase(next) > 0) open.push_back(next);
      }
    }
  }
  return cells;
}

Map bare(Map const& map) {
  Map copy(map.model());
  copy.add_darts(map.dart_count());
  for (Dart const d : map.darts()) {
    for (int const i : map.model().dimensions) copy.set_target(d, i, map.target(d, i));
  }
  return copy;
}

Map path(Dart n, bool round) {
  Map map(gmap(1));
  map.add_darts(2 * n);
  for (Dart k = 0; k < n; ++k) {
    map.link(2 * k, 0, 2 * k + 1);
    if (round || k + 1 < n) map.link(2 * k + 1, 1, (2 * k + 2) % (2 * n));
  }
  return map;
}

}  // namespace jrule::test
