// The subdivision rules of the library against OpenSubdiv, OpenMesh and their formulas.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <sstream>
#include <stdexcept>

#include "subdivision.h"
#include "tests/integration/both.h"
#include "tests/smoothing/peers.h"

namespace jrule::test {
namespace {

using mesh::HalfedgeMesh;
using mesh::Mesh;

/// What a vertex of the refined mesh comes from, at the copies of one node.
enum class Origin { vertex, edge, face };
struct Column {
  Origin origin;
  std::span<Dart const> copies;
};

/// One rule: its name, its generated function, and the columns of its result of which at least one is at each new
/// vertex. The column `a` is the pattern itself.
template <class Class, class Call, class Columns>
struct Rule {
  using Surface = Class;
  std::string name;
  Call call;
  Columns columns;
};
template <class Class, class Call, class Columns>
Rule<Class, Call, Columns> rule(std::string name, Call call, Columns columns) {
  return {std::move(name), call, columns};
}

#define RULE(CLASS, NAME, ...)                                                       \
  rule<CLASS>(                                                                       \
      #NAME, [](CLASS& m) { return subdivision::NAME(m, m.map().darts().front()); }, \
      []([[maybe_unused]] auto const& c) { return std::vector<Column>{__VA_ARGS__}; })

auto const catmull_clark =
    RULE(Mesh, catmull_clark, {Origin::vertex, c.a}, {Origin::edge, c.b}, {Origin::edge, c.c}, {Origin::face, c.d});
auto const loop =
    RULE(Mesh, loop, {Origin::vertex, c.a}, {Origin::edge, c.b}, {Origin::edge, c.c}, {Origin::edge, c.d});
auto const sqrt3 = RULE(Mesh, sqrt3, {Origin::vertex, c.a}, {Origin::face, c.b}, {Origin::face, c.c});
auto const doo_sabin = RULE(Mesh, doo_sabin, );
auto const quad = RULE(Mesh, quad, );
auto const catmull_clark_halfedges =
    RULE(HalfedgeMesh, catmull_clark_halfedges, {Origin::vertex, c.a}, {Origin::edge, c.b}, {Origin::face, c.d});
auto const loop_halfedges =
    RULE(HalfedgeMesh, loop_halfedges, {Origin::vertex, c.a}, {Origin::edge, c.b}, {Origin::edge, c.c});

std::string path_of(std::string const& file) {
  return std::string(JRULE_SOURCE_DIR) + (file == "bunny.obj" ? "/examples/data/" : "/tests/data/") + file;
}

template <class Class>
Class read(std::string const& file) {
  auto mesh = Class::read(path_of(file));
  if (!mesh) throw std::runtime_error(to_string(mesh.error()));
  return std::move(*mesh);
}

Module const& library() {
  static Module const module(JRULE_SOURCE_DIR "/stdlib/std/subdivision.jrule");
  return module;
}

/// Applies the generated function; the interpreter has to come to the same map, to the last bit. For speed, on
/// maps of up to 50000 darts: of the bunny, at the first level.
template <class Rule>
auto apply(Rule const& rule, typename Rule::Surface& mesh) {
  Map const before = mesh.map();
  auto result = rule.call(mesh);
  if (!result) throw std::runtime_error(to_string(result.error()));
  EXPECT_FALSE(find_violation(mesh.map()));
  if (before.dart_count() <= 50000) {
    Outcome const interpreted = interpret(library().rule(rule.name), before, {before.darts().front()}, {});
    EXPECT_EQ(interpreted.error, "");
    // Not EXPECT_EQ: it would print both maps.
    EXPECT_TRUE(interpreted.map == print_jmap(mesh.map()))
        << rule.name << ": generated code and the interpreter disagree";
  }
  return std::move(result->copies);
}

/// The number that the peer gives to the vertex of each dart, followed from the darts of the map before. Every dart of
/// a vertex has to come to the same number, and every vertex to another one.
std::vector<std::size_t> follow(Map const& before, std::vector<std::size_t> const& old, Map const& after,
                                std::vector<Column> const& columns, Refinement const& peer) {
  auto const old_faces =
      number_orbits(before, before.model().is_oriented(1) ? orbit_of_dimensions({1}) : orbit_of_dimensions({0, 1}));
  std::vector<Vertices> const face_vertices = faces(before, old);
  auto const origin = [&](Origin kind, Dart d) {
    Dart const across = before.target(d, before.model().is_oriented(1) ? 1 : 0);
    switch (kind) {
      case Origin::vertex: return peer.of_vertex.at(old[d]);
      case Origin::edge: return peer.of_edge.at(ascending({old[d], old[across]}));
      case Origin::face: return peer.of_face.at(ascending(face_vertices[old_faces.number[d]]));
    }
    throw std::logic_error("no such origin");
  };
  std::vector<std::size_t> const own = number_vertices(after);
  std::map<std::size_t, std::size_t> peers;  // of our vertices
  for (Column const& column : columns) {
    for (std::size_t k = 0; k < column.copies.size(); ++k) {
      Dart const d = columns.front().copies[k];
      std::size_t const number = origin(column.origin, d);
      auto const [entry, fresh] = peers.try_emplace(own[column.copies[k]], number);
      EXPECT_EQ(entry->second, number);
    }
  }
  std::set<std::size_t> distinct;
  for (auto const& [mine, its] : peers) distinct.insert(its);
  EXPECT_EQ(distinct.size(), peers.size());
  EXPECT_EQ(peers.size(), peer.mesh.points.size());
  EXPECT_EQ(summarize(after).cells[0], peers.size());
  std::vector<std::size_t> result;
  for (std::size_t const mine : own) result.push_back(peers.at(mine));
  return result;
}

std::vector<Vertices> as_sets(std::vector<Vertices> faces) {
  for (Vertices& face : faces) face = ascending(std::move(face));
  std::sort(faces.begin(), faces.end());
  return faces;
}

/// Refines the mesh as often as the peer did: the same faces and points?
template <class Rule, class Peer>
void expect_agreement(Rule const& rule, std::string const& file, std::string const& package, Peer refine) {
  constexpr int levels = 2;
  auto mesh = read<typename Rule::Surface>(file);
  std::vector<std::size_t> vertex = number_vertices(mesh.map());
  std::optional<std::vector<Refinement>> const peer = refine(polygons(mesh.map(), vertex), levels);
  if (!peer) GTEST_SKIP() << "nothing to compare with: install " << package << " and configure again";
  ASSERT_EQ(peer->size(), std::size_t{levels});
  double worst = 0;
  for (Refinement const& level : *peer) {
    Map const before = mesh.map();
    auto const copies = apply(rule, mesh);
    vertex = follow(before, vertex, mesh.map(), rule.columns(copies), level);
    Polygons const refined = polygons(mesh.map(), vertex);
    EXPECT_TRUE(as_sets(refined.faces) == as_sets(level.mesh.faces));
    ASSERT_EQ(refined.points.size(), level.mesh.points.size());
    for (std::size_t v = 0; v < refined.points.size(); ++v) {
      double const deviation = distance(refined.points[v], level.mesh.points[v]);
      ASSERT_LT(deviation, 1e-9) << "vertex " << v;
      worst = std::max(worst, deviation);
    }
    testing::Test::RecordProperty("vertices", static_cast<int>(refined.points.size()));
  }
  std::ostringstream text;
  text << worst;
  testing::Test::RecordProperty("largest_deviation", text.str());
}

template <class Rule>
void against_opensubdiv(Rule const& rule, Scheme scheme, Border border, std::string const& file) {
  expect_agreement(rule, file, "libosd-dev",
                   [&](Polygons const& p, int levels) { return refine_by_opensubdiv(p, scheme, border, levels); });
}
template <class Rule>
void against_openmesh(Rule const& rule, Scheme scheme, std::string const& file) {
  expect_agreement(rule, file, "libopenmesh-dev",
                   [&](Polygons const& p, int levels) { return refine_by_openmesh(p, scheme, levels); });
}

// ---- Peers, each on every mesh that the rule takes ----

// "cube.obj" as "cube_obj".
std::string mesh_name(testing::TestParamInfo<char const*> const& info) {
  std::string name = info.param;
  std::replace(name.begin(), name.end(), '.', '_');
  return name;
}

class Closed : public testing::TestWithParam<char const*> {};

TEST_P(Closed, CatmullClarkIsThatOfOpenSubdiv) {
  against_opensubdiv(catmull_clark, Scheme::catmull_clark, Border::edges_and_corners, GetParam());
}
TEST_P(Closed, CatmullClarkOfHalfedgesIsThatOfOpenSubdiv) {
  against_opensubdiv(catmull_clark_halfedges, Scheme::catmull_clark, Border::edges_and_corners, GetParam());
}
INSTANTIATE_TEST_SUITE_P(Meshes, Closed, testing::Values("cube.obj", "valences.obj", "tetrahedron.off", "bunny.obj"),
                         mesh_name);

class ClosedTriangles : public testing::TestWithParam<char const*> {};

TEST_P(ClosedTriangles, LoopIsThatOfOpenMesh) { against_openmesh(loop, Scheme::loop, GetParam()); }
TEST_P(ClosedTriangles, LoopIsThatOfOpenSubdiv) { against_opensubdiv(loop, Scheme::loop, Border::edges, GetParam()); }
TEST_P(ClosedTriangles, LoopOfHalfedgesIsThatOfOpenMesh) { against_openmesh(loop_halfedges, Scheme::loop, GetParam()); }
TEST_P(ClosedTriangles, Sqrt3IsThatOfOpenMesh) { against_openmesh(sqrt3, Scheme::sqrt3, GetParam()); }
INSTANTIATE_TEST_SUITE_P(Meshes, ClosedTriangles,
                         testing::Values("cube_of_triangles.obj", "valences.obj", "tetrahedron.off", "bunny.obj"),
                         mesh_name);

class Open : public testing::TestWithParam<char const*> {};

TEST_P(Open, CatmullClarkIsThatOfOpenSubdiv) {
  against_opensubdiv(catmull_clark, Scheme::catmull_clark, Border::edges_and_corners, GetParam());
}
INSTANTIATE_TEST_SUITE_P(Meshes, Open, testing::Values("grid.ply", "patch.obj", "patch_of_triangles.obj"), mesh_name);

TEST(OpenTriangles, LoopIsThatOfOpenMesh) { against_openmesh(loop, Scheme::loop, "patch_of_triangles.obj"); }
TEST(OpenTriangles, LoopIsThatOfOpenSubdiv) {
  against_opensubdiv(loop, Scheme::loop, Border::edges, "patch_of_triangles.obj");
}

// ---- Formulas ----

Point3 weighted(std::vector<Point3> const& points, Vertices const& vertices, std::vector<double> const& weights) {
  Vec3 sum;
  for (std::size_t k = 0; k < vertices.size(); ++k) sum = sum + weights[k] * (points[vertices[k]] - Point3{});
  return Point3{} + sum;
}

class DooSabin : public testing::TestWithParam<char const*> {};

// A corner of an n-gon gets 1/2 + 1/4n of itself, 1/8 + 1/4n of both neighbours, and 1/4n of all other corners.
TEST_P(DooSabin, HasItsWeightsAndItsFaces) {
  auto mesh = read<Mesh>(GetParam());
  Map const before = mesh.map();
  std::vector<std::size_t> const vertex = number_vertices(before);
  Polygons const old = polygons(before, vertex);
  Summary const was = summarize(before);
  auto const copies = apply(doo_sabin, mesh);
  for (Dart const d : copies.a) {
    Vertices face;  // from this corner on
    Dart corner = d;
    do {
      face.push_back(vertex[corner]);
      corner = before.walk(corner, {{0, false}, {1, false}});
    } while (corner != d);
    double const n = static_cast<double>(face.size());
    std::vector<double> weights(face.size(), 1 / (4 * n));
    weights[0] += 0.5;
    weights[1] += 0.125;
    weights.back() += 0.125;
    ASSERT_LT(distance(mesh.position(d), weighted(old.points, face, weights)), 1e-12);
  }
  Summary const is = summarize(mesh.map());
  EXPECT_EQ(is.cells,
            (std::vector<std::size_t>{2 * was.cells[1], 4 * was.cells[1], was.cells[0] + was.cells[1] + was.cells[2]}));
  // The new face, edge and vertex faces have as many corners as what they come from has sides.
  std::map<std::size_t, std::size_t> expected, found;
  std::map<std::size_t, std::size_t> valence;
  for (Vertices const& face : old.faces) {
    ++expected[face.size()];
    for (std::size_t const v : face) ++valence[v];
  }
  for (auto const& [v, n] : valence) ++expected[n];
  expected[4] += was.cells[1];
  for (Vertices const& face : faces(mesh.map(), number_vertices(mesh.map()))) ++found[face.size()];
  EXPECT_EQ(found, expected);
}
INSTANTIATE_TEST_SUITE_P(Meshes, DooSabin, testing::Values("cube.obj", "valences.obj", "tetrahedron.off", "bunny.obj"),
                         mesh_name);

TEST(DooSabin, HasTheWeightsOfBSplinesInQuads) {
  auto mesh = read<Mesh>("cube.obj");
  auto const copies = apply(doo_sabin, mesh);
  std::set<std::vector<double>> corners;
  for (Dart const d : copies.a) corners.insert({mesh.position(d).x, mesh.position(d).y, mesh.position(d).z});
  EXPECT_EQ(corners.size(), 24U);
  EXPECT_TRUE(corners.contains({0, 0.25, 0.25}));  // in the side x = 0: (9·0 + 3·1 + 3·0 + 1·1) / 16
}

TEST(Quad, MovesNoVertex) {
  for (char const* file : {"cube.obj", "patch.obj", "moebius.obj"}) {
    auto mesh = read<Mesh>(file);
    Map const before = mesh.map();
    auto const old = read<Mesh>(file);
    auto const copies = apply(quad, mesh);
    for (std::size_t k = 0; k < copies.a.size(); ++k) {
      Dart const d = copies.a[k];
      EXPECT_EQ(mesh.position(d), old.position(d));
      EXPECT_EQ(mesh.position(copies.b[k]), midpoint(old.position(d), old.position(before.target(d, 0))));
    }
    EXPECT_EQ(mesh.map().dart_count(), 4 * before.dart_count());
  }
}

// ---- What the rules do not take ----

TEST(Refused, BordersAndOtherFacesThanTriangles) {
  auto quads = read<Mesh>("cube.obj");
  auto open = read<Mesh>("patch_of_triangles.obj");
  auto halfedges = read<HalfedgeMesh>("cube.obj");
  std::string const before = print_jmap(quads.map()), open_before = print_jmap(open.map());
  EXPECT_FALSE(subdivision::loop(quads, 0));
  EXPECT_FALSE(subdivision::sqrt3(quads, 0));
  EXPECT_FALSE(subdivision::sqrt3(open, 0));
  EXPECT_FALSE(subdivision::doo_sabin(open, 0));
  EXPECT_FALSE(subdivision::loop_halfedges(halfedges, 0));
  EXPECT_EQ(print_jmap(quads.map()), before);
  EXPECT_EQ(print_jmap(open.map()), open_before);
}

// Without an orientation, and with a border: the rules of quads take it.
TEST(Moebius, StaysOne) {
  auto mesh = read<Mesh>("moebius.obj");
  apply(catmull_clark, mesh);
  Summary const summary = summarize(mesh.map());
  EXPECT_FALSE(summary.orientable);
  EXPECT_EQ(summary.euler, 0);
  EXPECT_TRUE(summary.valid);
}

}  // namespace
}  // namespace jrule::test
