#include "tests/stdlib/shapes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <stdexcept>

#include "jrule/io.h"

namespace jrule::test {

namespace {

/// The faces of the convex hull of points around the origin: each plane through three of them with no point outside.
Polygons hull(std::vector<Point3> const& points) {
  constexpr double epsilon = 1e-9;
  Polygons result{points, {}};
  std::set<Vertices> seen;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = 0; j < points.size(); ++j) {
      for (std::size_t k = 0; k < points.size(); ++k) {
        Vec3 const normal = cross(points[j] - points[i], points[k] - points[i]);
        auto const height = [&](std::size_t v) { return dot(normal, points[v] - points[i]); };
        if (i == j || norm(normal) < epsilon || dot(normal, points[i] - Point3{}) <= 0) continue;
        Vertices face;
        bool supports = true;
        for (std::size_t v = 0; v < points.size(); ++v) {
          if (height(v) > epsilon) supports = false;
          if (std::abs(height(v)) <= epsilon) face.push_back(v);
        }
        if (!supports || !seen.insert(face).second) continue;
        Vec3 center{};
        for (std::size_t const v : face) center = center + (points[v] - Point3{}) / static_cast<double>(face.size());
        Vec3 const x = points[face[0]] - Point3{} - center, y = cross(normalize(normal), x);
        auto const angle = [&](std::size_t v) {
          Vec3 const at = points[v] - Point3{} - center;
          return std::atan2(dot(at, y), dot(at, x));
        };
        std::sort(face.begin(), face.end(), [&](std::size_t a, std::size_t b) { return angle(a) < angle(b); });
        result.faces.push_back(std::move(face));
      }
    }
  }
  return result;
}

constexpr double phi = std::numbers::phi;

/// The points (±x, ±y, ±z) and, if asked for, those with their coordinates turned round.
std::vector<Point3> with_signs(Point3 p, bool cyclic) {
  std::set<std::vector<double>> all;
  for (double const sx : {1.0, -1.0}) {
    for (double const sy : {1.0, -1.0}) {
      for (double const sz : {1.0, -1.0}) {
        double const x = sx * p.x + 0.0, y = sy * p.y + 0.0, z = sz * p.z + 0.0;  // no negative zero
        all.insert({x, y, z});
        if (cyclic) all.insert({{y, z, x}, {z, x, y}});
      }
    }
  }
  std::vector<Point3> points;
  for (std::vector<double> const& c : all) points.push_back({c[0], c[1], c[2]});
  return points;
}

std::vector<Point3> both(std::vector<Point3> points, std::vector<Point3> const& others) {
  points.insert(points.end(), others.begin(), others.end());
  return points;
}

Polygons torus(std::size_t n) {
  Polygons result;
  double const step = 2 * std::numbers::pi / static_cast<double>(n);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      double const u = step * static_cast<double>(i), v = step * static_cast<double>(j);
      result.points.push_back({(3 + std::cos(v)) * std::cos(u), (3 + std::cos(v)) * std::sin(u), std::sin(v)});
      auto const at = [&](std::size_t a, std::size_t b) { return a % n * n + b % n; };
      result.faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return result;
}

/// The embeddings after the first.
void give_defaults(Map& map) {
  for (std::size_t e = 1; e < map.embedding_count(); ++e) {
    OrbitNumbers const orbits = number_orbits(map, map.embedding(e).spec().orbit);
    std::vector<Handle> handles;
    for (std::size_t i = 0; i < orbits.first.size(); ++i) handles.push_back(map.embedding(e).add_default().value());
    for (Dart const d : map.darts()) map.embedding(e).set_handle(d, handles[orbits.number[d]]);
  }
}

Polygons bunny() {
  Model const model = gmap(2);
  auto const map = read_map(JRULE_SOURCE_DIR "/examples/data/bunny.obj", model,
                            {{"position", orbit_of_dimensions({1, 2}), Type::Point3}});
  if (!map) throw std::runtime_error(to_string(map.error()));
  return polygons(*map, number_vertices(*map));
}

}  // namespace

std::vector<Shape> const& platonic_solids() {
  static std::vector<Shape> const solids{
      {"tetrahedron", hull({{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}})},
      {"cube", hull(with_signs({1, 1, 1}, false))},
      {"octahedron", hull(with_signs({1, 0, 0}, true))},
      {"dodecahedron", hull(both(with_signs({1, 1, 1}, false), with_signs({0, phi, 1 / phi}, true)))},
      {"icosahedron", hull(with_signs({0, 1, phi}, true))},
  };
  return solids;
}

std::vector<Shape> const& closed_surfaces() {
  static std::vector<Shape> const surfaces = [] {
    std::vector<Shape> all = platonic_solids();
    all.push_back({"torus", torus(4)});
    all.push_back({"bunny", bunny()});
    return all;
  }();
  return surfaces;
}

Shape prism(std::size_t n) {
  std::vector<Point3> points;
  for (std::size_t k = 0; k < n; ++k) {
    double const angle = 2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(n);
    for (double const z : {-1.0, 1.0}) points.push_back({2 * std::cos(angle), 2 * std::sin(angle), z});
  }
  return {"prism of " + std::to_string(n), hull(points)};
}

Shape grid(std::size_t n, std::size_t m) {
  Shape result{"grid", {}};
  for (std::size_t i = 0; i <= n; ++i) {
    for (std::size_t j = 0; j <= m; ++j) {
      result.polygons.points.push_back({static_cast<double>(i), static_cast<double>(j), 0});
      std::size_t const at = i * (m + 1) + j;
      if (i < n && j < m) result.polygons.faces.push_back({at, at + m + 1, at + m + 2, at + 1});
    }
  }
  return result;
}

Shape moebius(std::size_t n) {
  Shape result{"moebius", {}};
  double const step = std::numbers::pi / static_cast<double>(n);
  for (std::size_t i = 0; i < n; ++i) {
    double const half = step * static_cast<double>(i);
    for (double const s : {-1.0, 1.0}) {
      double const r = 3 + s * std::cos(half);
      result.polygons.points.push_back({r * std::cos(2 * half), r * std::sin(2 * half), s * std::sin(half)});
    }
    bool const last = i + 1 == n;
    result.polygons.faces.push_back({2 * i, last ? 1 : 2 * i + 2, last ? 0 : 2 * i + 3, 2 * i + 1});
  }
  return result;
}

Shape kis(Shape shape) {
  shape.name = "kis of the " + shape.name;
  std::vector<Vertices> triangles;
  for (Vertices const& face : shape.polygons.faces) {
    Vec3 center{};
    for (std::size_t const v : face)
      center = center + (shape.polygons.points[v] - Point3{}) / static_cast<double>(face.size());
    for (std::size_t k = 0; k < face.size(); ++k) {
      triangles.push_back({face[k], face[(k + 1) % face.size()], shape.polygons.points.size()});
    }
    shape.polygons.points.push_back(Point3{} + 1.1 * center);
  }
  shape.polygons.faces = std::move(triangles);
  return shape;
}

Map build(ir::Modeler const& modeler, Polygons const& polygons) {
  Map map(modeler.model, modeler.embeddings);
  bool const oriented = modeler.model.is_oriented(1);
  std::map<Vertices, std::vector<Dart>> of_edge;  // its darts, by its ends ascending
  std::vector<Handle> handles;
  for (Point3 const& p : polygons.points) handles.push_back(map.embedding(0).add(p));
  for (Vertices const& face : polygons.faces) {
    std::size_t const n = face.size();
    std::vector<Dart> const d = map.add_darts(oriented ? n : 2 * n);
    for (std::size_t k = 0; k < n; ++k) {
      std::size_t const a = face[k], b = face[(k + 1) % n];
      std::vector<Dart>& edge = of_edge[ascending({a, b})];
      if (oriented) {
        map.link(d[k], 1, d[(k + 1) % n]);
        map.embedding(0).set_handle(d[k], handles[a]);
        edge.push_back(d[k]);
      } else {
        map.link(d[2 * k], 0, d[2 * k + 1]);
        map.link(d[2 * k + 1], 1, d[(2 * k + 2) % (2 * n)]);
        map.embedding(0).set_handle(d[2 * k], handles[a]);
        map.embedding(0).set_handle(d[2 * k + 1], handles[b]);
        edge.push_back(a < b ? d[2 * k] : d[2 * k + 1]);
      }
    }
  }
  for (auto const& [ends, darts] : of_edge) {
    if (darts.size() == 1 && !oriented) continue;
    if (darts.size() != 2) throw std::runtime_error("an edge of " + std::to_string(darts.size()) + " faces");
    map.link(darts[0], 2, darts[1]);
    if (!oriented) map.link(map.target(darts[0], 0), 2, map.target(darts[1], 0));
  }
  give_defaults(map);
  return map;
}

Solid block(std::size_t n, std::size_t m, std::size_t k) {
  Solid result{"block of " + std::to_string(n) + " x " + std::to_string(m) + " x " + std::to_string(k), {}, {}};
  auto const at = [&](std::size_t x, std::size_t y, std::size_t z) { return (x * (m + 1) + y) * (k + 1) + z; };
  for (std::size_t x = 0; x <= n; ++x) {
    for (std::size_t y = 0; y <= m; ++y) {
      for (std::size_t z = 0; z <= k; ++z) {
        result.points.push_back({static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)});
        if (x == n || y == m || z == k) continue;
        std::size_t const p[2][2][2] = {
            {{at(x, y, z), at(x, y, z + 1)}, {at(x, y + 1, z), at(x, y + 1, z + 1)}},
            {{at(x + 1, y, z), at(x + 1, y, z + 1)}, {at(x + 1, y + 1, z), at(x + 1, y + 1, z + 1)}}};
        result.volumes.push_back({{p[0][0][0], p[0][0][1], p[0][1][1], p[0][1][0]},
                                  {p[1][0][0], p[1][1][0], p[1][1][1], p[1][0][1]},
                                  {p[0][0][0], p[1][0][0], p[1][0][1], p[0][0][1]},
                                  {p[0][1][0], p[0][1][1], p[1][1][1], p[1][1][0]},
                                  {p[0][0][0], p[0][1][0], p[1][1][0], p[1][0][0]},
                                  {p[0][0][1], p[1][0][1], p[1][1][1], p[0][1][1]}});
      }
    }
  }
  return result;
}

std::vector<Solid> const& solids() {
  static std::vector<Solid> const all = [] {
    std::vector<Solid> made;
    for (Shape const& shape : platonic_solids())
      made.push_back({shape.name, shape.polygons.points, {shape.polygons.faces}});
    for (std::size_t k = 0; k < 5; ++k) {
      made.push_back(with_outside(made[k]));
    }
    Shape const sides = prism(5);
    made.push_back({sides.name, sides.polygons.points, {sides.polygons.faces}});
    made.push_back(block(2, 1, 1));
    made.push_back(block(2, 2, 2));
    made.push_back(block(3, 3, 3));
    return made;
  }();
  return all;
}

Solid with_outside(Solid solid) {
  std::map<Vertices, std::vector<Vertices>> by_vertices;
  for (auto const& faces : solid.volumes) {
    for (Vertices const& face : faces) by_vertices[ascending(face)].push_back(face);
  }
  std::vector<Vertices> outside;
  for (auto const& [vertices, sides] : by_vertices) {
    if (sides.size() == 1) outside.emplace_back(sides[0].rbegin(), sides[0].rend());
  }
  if (outside.empty()) return solid;
  solid.volumes.push_back(std::move(outside));
  solid.name += " and its outside";
  return solid;
}

Map build(ir::Modeler const& modeler, Solid const& solid) {
  Map map(modeler.model, modeler.embeddings);
  bool const oriented = modeler.model.is_oriented(1);
  std::vector<Handle> handles;
  for (Point3 const& p : solid.points) handles.push_back(map.embedding(0).add(p));
  // The darts of an edge of a face, of its volumes: by the face's vertices and the edge's; in G-maps that at the lesser
  // end.
  std::map<std::vector<Vertices>, std::vector<Dart>> of_side;
  auto const join = [&](std::vector<Dart> const& darts, int dimension) {
    if (darts.size() != 2) throw std::runtime_error("an edge of " + std::to_string(darts.size()) + " faces");
    map.link(darts[0], dimension, darts[1]);
    if (!oriented) map.link(map.target(darts[0], 0), dimension, map.target(darts[1], 0));
  };
  for (std::vector<Vertices> const& faces : solid.volumes) {
    std::map<Vertices, std::vector<Dart>> of_edge;  // of this volume
    for (Vertices const& face : faces) {
      std::size_t const n = face.size();
      std::vector<Dart> const d = map.add_darts(oriented ? n : 2 * n);
      for (std::size_t k = 0; k < n; ++k) {
        std::size_t const a = face[k], b = face[(k + 1) % n];
        Dart dart = oriented ? d[k] : d[2 * k];
        map.embedding(0).set_handle(dart, handles[a]);
        if (oriented) {
          map.link(dart, 1, d[(k + 1) % n]);
        } else {
          Dart const end = d[2 * k + 1];
          map.embedding(0).set_handle(end, handles[b]);
          map.link(dart, 0, end);
          map.link(end, 1, d[(2 * k + 2) % (2 * n)]);
          if (b < a) dart = end;
        }
        of_edge[ascending({a, b})].push_back(dart);
        of_side[{ascending(face), ascending({a, b})}].push_back(dart);
      }
    }
    for (auto const& [ends, darts] : of_edge) join(darts, 2);
  }
  for (auto const& [side, darts] : of_side) {
    if (darts.size() > 1 || oriented) join(darts, 3);
  }
  give_defaults(map);
  return map;
}

}  // namespace jrule::test
