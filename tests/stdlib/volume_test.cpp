// Volumes: each rule at every place of many solids, and what it adds and takes away.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>

#include "jrule/typed.h"
#include "tests/reference/plain_map.h"
#include "tests/stdlib/application.h"
#include "tests/stdlib/measure.h"
#include "tests/stdlib/shapes.h"

namespace jrule::test {
namespace {

Module::Rule const& rule(std::string const& name) {
  static Module const module(JRULE_SOURCE_DIR "/stdlib/std/volume.jrule");
  return module.rule(name);
}

using Cells = std::array<long long, 4>;
Cells cells_of(Map const& map) {
  Cells cells{};
  Summary const summary = summarize(map);
  std::copy(summary.cells.begin(), summary.cells.end(), cells.begin());
  return cells;
}

bool same(Map const& a, Map const& b) {
  return reference::isomorphic(reference::plain(a), reference::plain(b), {}, {}, {});
}

/// The parts of a cell at a dart: count(map, {0, 1}, {0}) edges of its face on one side.
struct At {
  Map const& map;
  Dart dart;
  long long count(std::vector<int> const& cell, std::vector<int> const& inside) const {
    return static_cast<long long>(count_inside(map, cell, inside, dart));
  }
  long long sides() const { return count({0, 1}, {0}); }
};

struct Edit {
  std::string name;
  Cells (*delta)(At const&);
  std::vector<Value> arguments = {};
};
Value const point = Point3{0.3, 0.2, 9}, shift = Vec3{0.3, 0.2, 9};

std::vector<Edit> const edits{
    {"unsew_volumes", nullptr},  // vertices and edges may be opened too
    {"insert_vertex_solid",
     [](At const&) {
       return Cells{1, 1, 0, 0};
     }},
    {"triangulate_face_solid",
     [](At const& a) {
       return Cells{1, a.sides(), a.sides() - 1, 0};
     }},
    {"remove_face_solid",
     [](At const&) {
       return Cells{0, 0, -1, -1};
     }},
    {"extrude_face_solid",
     [](At const& a) {
       return Cells{a.sides(), 2 * a.sides(), a.sides() + 1, 1};
     },
     {shift}},
    {"pyramid_solid",
     [](At const& a) {
       return Cells{1, a.sides(), a.sides(), 1};
     },
     {point}},
    {"cone_volume",
     [](At const& a) {
       return Cells{1, a.count({0, 1, 2}, {1, 2}), a.count({0, 1, 2}, {0, 2}), a.count({0, 1, 2}, {0, 1}) - 1};
     }},
    {"remove_volume",
     [](At const&) {
       return Cells{0, 0, 0, -1};
     }},
    {"chamfer_vertex_solid",
     [](At const& a) {
       return Cells{a.count({1, 2, 3}, {2, 3}) - 1, a.count({1, 2, 3}, {1, 3}), a.count({1, 2, 3}, {1, 2}), 1};
     }},
};

class Volume : public testing::TestWithParam<std::size_t> {};

TEST_P(Volume, IsAppliedAnywhere) {
  Edit const& edit = edits[GetParam()];
  std::set<std::string> applied;
  for (Solid const& solid : solids()) {
    Map const start = build(*rule(edit.name).scheme.modeler, solid);
    ASSERT_TRUE(summarize(start).valid);
    for (Dart const d : start.darts()) {
      if (d % (start.dart_count() / 50 + 1) != 0) continue;  // at about fifty darts
      if (!refusal(rule(edit.name), start, {d}, edit.arguments).empty()) continue;
      SCOPED_TRACE(edit.name + " on the " + solid.name + " at dart " + std::to_string(d));
      applied.insert(solid.name);
      Map map = start;
      apply(rule(edit.name), map, {d}, edit.arguments);
      if (!edit.delta) continue;
      Cells const was = cells_of(start), is = cells_of(map), delta = edit.delta({start, d});
      for (std::size_t i = 0; i < 4; ++i) ASSERT_EQ(is[i] - was[i], delta[i]) << "of dimension " << i;
      ASSERT_EQ(misplaced(map), "");
    }
  }
  EXPECT_GE(applied.size(), 5U);
}

INSTANTIATE_TEST_SUITE_P(Edits, Volume, testing::Range(std::size_t{0}, edits.size()),
                         [](auto const& test) { return edits[test.param].name; });

// ---- Refinements of all ----

struct Refinement {
  std::string name;
  /// From the numbers of orbits: of ⟨1,2⟩ there is one for each vertex of each volume.
  Cells (*cells)(Cells const&, Map const&);
};
long long count(Map const& map, std::vector<int> const& dimensions) {
  return static_cast<long long>(count_orbits(map, dimensions));
}
std::vector<Refinement> const refinements{
    {"tetrahedra",
     [](Cells const& c, Map const& m) {
       return Cells{c[0] + c[2] + c[3], c[1] + count(m, {1, 3}) + count(m, {1, 2}) + count(m, {0, 1}),
                    count(m, {0, 3}) + count(m, {0, 2}) + count(m, {1}), count(m, {0})};
     }},
    {"hexahedra",
     [](Cells const& c, Map const& m) {
       return Cells{c[0] + c[1] + c[2] + c[3], 2 * c[1] + count(m, {0, 3}) + count(m, {0, 1}),
                    count(m, {0, 3}) + count(m, {0, 2}), count(m, {1, 2})};
     }},
    {"dual_solid",
     [](Cells const& c, Map const&) {
       return Cells{c[3], c[2], c[1], c[0]};
     }},
};

TEST(Refinement, OfAllVolumes) {
  for (Refinement const& refinement : refinements) {
    Module::Rule const& r = rule(refinement.name);
    std::size_t applied = 0;
    for (Solid const& solid : solids()) {
      SCOPED_TRACE(refinement.name + " of the " + solid.name);
      Map map = build(*r.scheme.modeler, solid);
      if (!refusal(r, map, {0}).empty()) continue;
      ++applied;
      Map const start = map;
      apply(r, map, {0});
      EXPECT_EQ(cells_of(map), refinement.cells(cells_of(start), start));
      EXPECT_EQ(summarize(map).euler, summarize(start).euler);
      EXPECT_EQ(map.dart_count() % start.dart_count(), 0U);
      if (refinement.name == "dual_solid") {
        apply(r, map, {0});
        EXPECT_TRUE(same(map, start));
      } else {
        if (summarize(map).boundary_darts > 0) {  // an outside has its centre inside
          EXPECT_EQ(misplaced(map), "");
        }
        // Of a tetrahedron there are 24 darts, of a hexahedron 48.
        for (Dart const d : cells(map, 3)) {
          EXPECT_EQ(orbit(map, orbit_of_dimensions({0, 1, 2}), d).size(), refinement.name == "tetrahedra" ? 24U : 48U);
        }
      }
    }
    // The octahedron and the icosahedron have no corners of three edges; a dual needs an outside.
    EXPECT_EQ(applied, refinement.name == "tetrahedra" ? 14U : refinement.name == "hexahedra" ? 10U : 5U);
  }
}

/// The points of the vertices, scaled and rounded to whole numbers.
std::set<std::array<long long, 3>> places(Map const& map, double scale) {
  rewrite::Values<Point3> const positions(map.embedding(0));
  std::set<std::array<long long, 3>> all;
  for (Dart const d : cells(map, 0)) {
    Point3 const p = positions[d];
    all.insert({std::llround(scale * p.x), std::llround(scale * p.y), std::llround(scale * p.z)});
  }
  return all;
}

TEST(Menger, TakesSevenPartsOfTwentySeven) {
  for (auto const& [n, m, k] :
       std::vector<std::array<std::size_t, 3>>{{1, 1, 1}, {2, 1, 1}, {1, 3, 1}, {2, 2, 1}, {2, 2, 2}}) {
    Solid const solid = block(n, m, k);
    SCOPED_TRACE(solid.name);
    Map map = build(*rule("menger").scheme.modeler, solid);
    Cells const was = cells_of(map);
    apply(rule("menger"), map, {0});
    Map const fine = build(*rule("menger").scheme.modeler, block(3 * n, 3 * m, 3 * k));
    Cells const all = cells_of(fine);
    // Of all the parts every edge belongs to one that stays; not the middle of a face, nor the faces of the part
    // inside.
    EXPECT_EQ(cells_of(map), (Cells{all[0], all[1], all[2] - was[2] - 6 * was[3], 20 * was[3]}));
    EXPECT_EQ(misplaced(map), "");
    EXPECT_EQ(places(map, 3), places(fine, 1));
    EXPECT_EQ(refusal(rule("menger"), map, {0}), "");
  }
  EXPECT_NE(refusal(rule("menger"), build(*rule("menger").scheme.modeler, solids()[0]), {0}), "");
  Map sponge = build(*rule("menger").scheme.modeler, block(1, 1, 1));
  apply(rule("menger"), sponge, {0});
  EXPECT_EQ(summarize(sponge).euler, 1 - 5);  // it has five holes
}

// ---- Two hooks, and the way back ----

TEST(SewVolumes, ClosesWhatUnsewVolumesOpened) {
  for (Solid const& solid : solids()) {
    Map const start = build(*rule("sew_volumes").scheme.modeler, solid);
    for (Dart const d : cells(start, 2)) {
      Dart const across = start.target(d, 3);
      if (across == d) continue;
      Map map = start;
      apply(rule("unsew_volumes"), map, {d});
      EXPECT_EQ(cells_of(map)[2], cells_of(start)[2] + 1);
      apply(rule("sew_volumes"), map, {d, across});
      EXPECT_TRUE(same(map, start)) << solid.name;
    }
  }
}

TEST(InsertEdge, CutsFacesOnBothSides) {
  std::set<std::string> applied;
  for (Solid const& solid : solids()) {
    Map const start = build(*rule("insert_edge_solid").scheme.modeler, solid);
    for (Dart const d : start.darts()) {
      if (!refusal(rule("insert_edge_solid"), start, {0, d}).empty()) continue;
      Map map = start;
      apply(rule("insert_edge_solid"), map, {0, d});
      Cells const was = cells_of(start);
      EXPECT_EQ(cells_of(map), (Cells{was[0], was[1] + 1, was[2] + 1, was[3]}));
      applied.insert(solid.name);
    }
  }
  EXPECT_GE(applied.size(), 5U);
}

TEST(RemoveFace, JoinsAPyramidToItsVolume) {
  // A free face gets a pyramid, and the two volumes become one.
  for (Solid const& solid : solids()) {
    Map map = build(*rule("pyramid_solid").scheme.modeler, solid);
    if (map.target(0, 3) != 0) continue;
    Cells const was = cells_of(map);
    long long const n = At{map, 0}.sides();
    apply(rule("pyramid_solid"), map, {0}, {point});
    apply(rule("remove_face_solid"), map, {0});
    EXPECT_EQ(cells_of(map), (Cells{was[0] + 1, was[1] + n, was[2] + n - 1, was[3]}));
  }
}

TEST(RemoveFace, NeedsTwoVolumes) {
  // Four cubes around an edge: when three of the four faces between them are gone, one volume is on both sides of the
  // last.
  Map map = build(*rule("remove_face_solid").scheme.modeler, block(2, 2, 1));
  for (int left = 4; left > 0; --left) {
    std::vector<Dart> const faces = cells(map, 2);
    auto const inside = std::find_if(faces.begin(), faces.end(), [&](Dart d) { return map.target(d, 3) != d; });
    ASSERT_NE(inside, faces.end());
    if (left == 1) {
      EXPECT_NE(refusal(rule("remove_face_solid"), map, {*inside}), "");
    } else {
      apply(rule("remove_face_solid"), map, {*inside});
    }
  }
}

// ---- From nothing ----

TEST(Prisms, AndConesOfFacesThatStandByThemselves) {
  Value const p = Point3{0, 0, 0}, q = Point3{2, 0, 0}, r = Point3{2, 2, 0}, s = Point3{0, 2, 0};
  for (bool const quad : {false, true}) {
    Module::Rule const& add = rule(quad ? "add_quad_solid" : "add_triangle_solid");
    std::vector<Value> const corners = quad ? std::vector{p, q, r, s} : std::vector{p, q, r};
    long long const n = quad ? 4 : 3;
    Map face(add.scheme.modeler->model, add.scheme.modeler->embeddings);
    auto const made = apply(add, face, {}, corners);
    EXPECT_EQ(cells_of(face), (Cells{n, n, 1, 1}));
    rewrite::Values<Point3> const positions(face.embedding(0));
    EXPECT_EQ(Value(positions[made[0][0]]), p);
    EXPECT_EQ(Value(positions[face.target(made[0][0], 0)]), q);
    Map prism = face, cone = face;
    apply(rule("prism_solid"), prism, {made[0][0]}, {shift});
    EXPECT_EQ(cells_of(prism), (Cells{2 * n, 3 * n, n + 2, 1}));
    apply(rule("cone_solid"), cone, {made[0][0]}, {point});
    EXPECT_EQ(cells_of(cone), (Cells{n + 1, 2 * n, n + 1, 1}));
    for (Map const* solid : {&prism, &cone}) {
      EXPECT_EQ(misplaced(*solid), "");
      EXPECT_EQ(summarize(*solid).euler, 1);
      EXPECT_NE(refusal(rule("prism_solid"), *solid, {made[0][0]}, {shift}), "");
    }
  }
}

// ---- Oriented maps ----

Module::Rule const& halfedge_rule(std::string const& name) {
  static Module const module(JRULE_SOURCE_DIR "/stdlib/std/volume_halfedges.jrule");
  return module.rule(name + "_halfedges");
}

struct HalfedgeEdit {
  std::string name;
  /// Of a face of n edges; of a volume of so many vertices, edges and faces.
  Cells (*delta)(long long n, Cells const& volume);
  std::vector<Value> arguments = {};
};
std::vector<HalfedgeEdit> const halfedge_edits{
    {"insert_vertex_solid",
     [](long long, Cells const&) {
       return Cells{1, 1, 0, 0};
     }},
    {"triangulate_face_solid",
     [](long long n, Cells const&) {
       return Cells{1, n, n - 1, 0};
     }},
    {"remove_face_solid",
     [](long long, Cells const&) {
       return Cells{0, 0, -1, -1};
     }},
    {"extrude_face_solid",
     [](long long n, Cells const&) {
       return Cells{n, 2 * n, n + 1, 1};
     },
     {0.75}},
    {"cone_volume",
     [](long long, Cells const& c) {
       return Cells{1, c[0], c[1], c[2] - 1};
     }},
};

TEST(VolumesOfHalfedges, AreEditedAnywhere) {
  for (HalfedgeEdit const& edit : halfedge_edits) {
    Module::Rule const& r = halfedge_rule(edit.name);
    std::set<std::string> applied;
    for (Solid const& solid : solids()) {
      Map const start = build(*r.scheme.modeler, with_outside(solid));
      ASSERT_TRUE(summarize(start).valid);
      for (Dart const d : start.darts()) {
        if (d % (start.dart_count() / 30 + 1) != 0 || !refusal(r, start, {d}, edit.arguments).empty()) continue;
        SCOPED_TRACE(edit.name + " on the " + solid.name + " at dart " + std::to_string(d));
        applied.insert(solid.name);
        Map map = start;
        apply(r, map, {d}, edit.arguments);
        auto const count = [&](OrbitType const& type) { return static_cast<long long>(orbit(start, type, d).size()); };
        long long const edges = count(orbit_of_dimensions({1, 2})) / 2;
        auto const faces = static_cast<long long>(count_inside(start, {1, 2}, {1}, d));
        Cells const volume{2 + edges - faces, edges, faces, 1};  // all of them are spheres
        Cells const was = cells_of(start), is = cells_of(map),
                    delta = edit.delta(count(orbit_of_dimensions({1})), volume);
        for (std::size_t i = 0; i < 4; ++i) ASSERT_EQ(is[i] - was[i], delta[i]) << "of dimension " << i;
      }
    }
    EXPECT_GE(applied.size(), 5U) << edit.name;
  }
}

TEST(VolumesOfHalfedges, AreRefinedAsThoseOfGeneralizedMaps) {
  for (char const* name : {"tetrahedra", "hexahedra", "dual_solid"}) {
    std::size_t applied = 0;
    for (Solid const& solid : solids()) {
      if (solid.points.size() > 40) continue;
      SCOPED_TRACE(std::string(name) + " of the " + solid.name);
      Map map = build(*rule(name).scheme.modeler, with_outside(solid));
      Map halfedges = build(*halfedge_rule(name).scheme.modeler, with_outside(solid));
      EXPECT_EQ(cells_of(map), cells_of(halfedges));
      bool const applicable = refusal(rule(name), map, {0}).empty();
      EXPECT_EQ(refusal(halfedge_rule(name), halfedges, {0}).empty(), applicable);
      if (!applicable) continue;
      ++applied;
      apply(rule(name), map, {0});
      apply(halfedge_rule(name), halfedges, {0});
      EXPECT_EQ(cells_of(map), cells_of(halfedges));
      EXPECT_EQ(places(map, 1e6), places(halfedges, 1e6));
      EXPECT_EQ(map.dart_count(), 2 * halfedges.dart_count());
    }
    EXPECT_GE(applied, 5U) << name;
  }
}

TEST(VolumesOfHalfedges, AreExtrudedOutwards) {
  Module::Rule const& extrude = halfedge_rule("extrude_face_solid");
  Map map = build(*extrude.scheme.modeler, with_outside(block(1, 1, 1)));
  apply(extrude, map, {0}, {2.0});  // the face x = 0
  for (long long const z : {0, 1}) {
    for (long long const y : {0, 1}) EXPECT_TRUE(places(map, 1).contains({-2, y, z}));
  }
}

// ---- Places ----

TEST(PlacesOfSolids, AreThoseAskedFor) {
  for (bool const halfedges : {false, true}) {
    auto const named = [&](std::string const& name) -> Module::Rule const& {
      return halfedges ? halfedge_rule(name + "_solid") : rule(name + "_solid");
    };
    Solid const cubes = block(2, 1, 1);
    Map const start = build(*named("scale").scheme.modeler, halfedges ? with_outside(cubes) : cubes);
    auto const at = [](Map const& map, Dart d) { return rewrite::Values<Point3>(map.embedding(0))[d]; };
    auto const moves = [&](std::string const& name, std::vector<Value> const& arguments, auto const& expected) {
      SCOPED_TRACE(name);
      Map map = start;
      apply(named(name), map, {5}, arguments);
      for (Dart const d : map.darts()) EXPECT_LT(distance(at(map, d), expected(d)), 1e-12);
      EXPECT_FALSE(find_violation(map));
    };
    OrbitType const& vertex = start.embedding(0).spec().orbit;
    std::vector<Dart> const moved = orbit(start, vertex, 5);
    moves("move_vertex", {Point3{9, 8, 7}}, [&](Dart d) {
      return std::find(moved.begin(), moved.end(), d) != moved.end() ? Point3{9, 8, 7} : at(start, d);
    });
    moves("translate", {Vec3{0.5, 2, -1}}, [&](Dart d) { return at(start, d) + Vec3{0.5, 2, -1}; });
    moves("scale", {3.0, Point3{1, 0, 0}}, [&](Dart d) { return Point3{1, 0, 0} + 3.0 * (at(start, d) - Point3{1, 0, 0}); });
    moves("rotate", {std::numbers::pi, Vec3{0, 0.1, 0}, Point3{1, 5, 1}}, [&](Dart d) {
      Point3 const p = at(start, d);
      return Point3{2 - p.x, p.y, 2 - p.z};
    });
    EXPECT_NE(refusal(named("rotate"), start, {5}, {1.0, Vec3{}, Point3{}}), "");
  }
}

}  // namespace
}  // namespace jrule::test
