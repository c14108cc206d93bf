// Editing surfaces: each rule at every place of many shapes, what it adds and takes away, and what it refuses.
#include <array>
#include <numbers>
#include <set>

#include "jrule/typed.h"
#include "tests/reference/plain_map.h"
#include "tests/stdlib/application.h"
#include "tests/stdlib/measure.h"
#include "tests/stdlib/shapes.h"

namespace jrule::test {
namespace {

Module::Rule const& surface_rule(std::string const& name) {
  static Module const module(JRULE_SOURCE_DIR "/stdlib/std/surface.jrule");
  return module.rule(name);
}
Module::Rule const& halfedge_rule(std::string const& name) {
  static Module const module(JRULE_SOURCE_DIR "/stdlib/std/surface_halfedges.jrule");
  return module.rule(name + "_halfedges");
}

using Hooks = std::vector<Dart>;
using Delta = std::array<long long, 3>;  // of vertices, edges, faces

std::vector<Hooks> each_dart(Map const& map) {
  std::vector<Hooks> sites;
  for (Dart const d : map.darts()) sites.push_back({d});
  return sites;
}
/// All pairs with one of two first darts.
std::vector<Hooks> each_pair(Map const& map) {
  std::vector<Hooks> sites;
  for (Dart const d : map.darts()) {
    for (Dart const e : map.darts()) {
      if (d < 2) sites.push_back({d, e});
    }
  }
  return sites;
}

struct Edit {
  std::string name;
  std::vector<Hooks> (*sites)(Map const&);
  Delta (*delta)(Map const&, Hooks const&);
  enum class On { both, surfaces, halfedges } on = On::both;
  /// On generalized and on oriented maps.
  std::vector<Value> arguments = {}, halfedge_arguments = arguments;
  /// May leave two edges between the same vertices, or vertices in one place.
  bool simple = true, apart = true;
};

long long n_of(Map const& map, Hooks const& hooks) { return static_cast<long long>(face_size(map, hooks[0])); }
long long degree_of(Map const& map, Hooks const& hooks) { return static_cast<long long>(vertex_degree(map, hooks[0])); }
#define DELTA(V, E, F)                                                                \
  [](Map const& map, Hooks const& hooks) {                                            \
    [[maybe_unused]] long long const n = n_of(map, hooks), m = degree_of(map, hooks); \
    return Delta{V, E, F};                                                            \
  }

Value const point = Point3{0.3, 0.2, 9}, shift = Vec3{0.3, 0.2, 0.1};

std::vector<Edit> const edits{
    {"insert_vertex", each_dart, DELTA(1, 1, 0), Edit::On::both, {0.25}},
    {"insert_edge", each_pair, DELTA(0, 1, 1), Edit::On::both, {}, {}, false},
    {"remove_edge", each_dart, DELTA(0, -1, -1)},
    {"split_vertex", each_pair, DELTA(1, 1, 0), Edit::On::both, {shift}},
    {"contract_edge", each_dart, DELTA(-1, -1, 0)},
    {"collapse_edge", each_dart, DELTA(-1, -3, -2)},
    {"flip_edge", each_dart, DELTA(0, 0, 0)},
    {"unsew_edge", each_dart, DELTA(0, 1, 0), Edit::On::surfaces, {}, {}, false, false},
    {"triangulate_face", each_dart, DELTA(1, n, n - 1)},
    {"pyramid", each_dart, DELTA(1, n, n - 1), Edit::On::both, {point}},
    {"quadrangulate_face", each_dart, DELTA(n + 1, 2 * n, n - 1)},
    {"extrude_face", each_dart, DELTA(n, 2 * n, n), Edit::On::both, {shift}, {0.5}},
    {"inset_face", each_dart, DELTA(n, 2 * n, n)},
    {"lace_face", each_dart, DELTA(n, 3 * n, 2 * n), Edit::On::surfaces},
    {"move_vertex", each_dart, DELTA(0, 0, 0), Edit::On::both, {point}},
    {"translate", each_dart, DELTA(0, 0, 0), Edit::On::both, {shift}},
    {"rotate", each_dart, DELTA(0, 0, 0), Edit::On::both, {0.5, Vec3{1, 2, 3}, point}},
    {"remove_face", each_dart, DELTA(0, 0, -1), Edit::On::surfaces},
    {"pierce", each_pair, DELTA(0, n, n - 2), Edit::On::both, {}, {}, false},
    {"chamfer_vertex", each_dart, DELTA(m - 1, m, 1), Edit::On::surfaces},
    {"chamfer_edge", each_dart, DELTA(2, 3, 1)},
    {"dissolve_vertex", each_dart, DELTA(-1, -m, 1 - m), Edit::On::surfaces, {}, {}, false},
};

std::vector<Shape> shapes(bool closed) {
  std::vector<Shape> all;
  for (Shape const& shape : closed_surfaces()) {
    if (shape.name != "bunny") all.push_back(shape);
  }
  for (std::size_t const k : {1U, 3U, 5U}) all.push_back(kis(all[k]));
  for (std::size_t const n : {3U, 5U, 6U}) all.push_back(prism(n));
  if (!closed) {
    all.push_back(grid(3, 3));
    all.push_back(moebius(5));
  }
  return all;
}

class Surface : public testing::TestWithParam<std::size_t> {
 protected:
  Edit const& edit() const { return edits[GetParam()]; }

  void applies_everywhere(Module::Rule const& rule, std::vector<Value> const& arguments) const {
    std::set<std::string> applied, refused;
    bool const oriented = rule.scheme.model().is_oriented(1);
    for (Shape const& shape : shapes(oriented)) {
      Map const start = build(*rule.scheme.modeler, shape.polygons);
      Summary const was = summarize(start);
      ASSERT_EQ(degeneracy(start), "");
      for (Hooks const& hooks : edit().sites(start)) {
        SCOPED_TRACE(rule.scheme.name + " on the " + shape.name + " at dart " + std::to_string(hooks.front()) + ", " +
                     std::to_string(hooks.back()));
        if (!refusal(rule, start, hooks, arguments).empty()) {
          refused.insert(shape.name);
          continue;
        }
        applied.insert(shape.name);
        Map map = start;
        apply(rule, map, hooks, arguments);
        Summary const is = summarize(map);
        Delta const delta = edit().delta(start, hooks);
        bool const opens = edit().name == "unsew_edge";  // on a border it splits vertices, in the inside none
        for (std::size_t i = opens ? 1 : 0; i < 3; ++i) {
          ASSERT_EQ(static_cast<long long>(is.cells[i]) - static_cast<long long>(was.cells[i]), delta[i])
              << "of dimension " << i;
        }
        if (edit().simple) {
          ASSERT_EQ(degeneracy(map), "");
        }
        if (edit().apart) {
          ASSERT_EQ(misplaced(map), "");
        }
        if (edit().name != "pierce" && edit().name != "remove_face" && !opens) {
          ASSERT_EQ(is.euler, was.euler);
          ASSERT_EQ(is.orientable, was.orientable);
          ASSERT_EQ(is.boundary_darts > 0, was.boundary_darts > 0);
        }
        ASSERT_EQ(is.components, 1U);
      }
    }
    EXPECT_GE(applied.size(), 5U) << rule.scheme.name;
  }
};

TEST_P(Surface, IsAppliedAnywhere) {
  if (edit().on != Edit::On::halfedges) applies_everywhere(surface_rule(edit().name), edit().arguments);
  if (edit().on != Edit::On::surfaces) applies_everywhere(halfedge_rule(edit().name), edit().halfedge_arguments);
}

INSTANTIATE_TEST_SUITE_P(Edits, Surface, testing::Range(std::size_t{0}, edits.size()),
                         [](auto const& test) { return edits[test.param].name; });

// ---- What one rule does, another undoes ----

/// Are they the same map, whatever its darts are called?
bool same(Map const& a, Map const& b) {
  return reference::isomorphic(reference::plain(a), reference::plain(b), {}, {}, {});
}

/// Both families, as the rule of a name.
using Family = Module::Rule const& (*)(std::string const&);
struct Undo : testing::TestWithParam<std::size_t> {
  Shape shape() const { return shapes(true)[GetParam()]; }
  static std::vector<Family> families() { return {surface_rule, halfedge_rule}; }
};

/// The copies of a node of the right side, by its name.
std::vector<Dart> const& copies(Module::Rule const& rule, std::vector<std::vector<Dart>> const& all,
                                std::string const& name) {
  for (std::size_t id = 0; id < rule.scheme.nodes.size(); ++id) {
    if (rule.scheme.nodes[id].name == name) return all[id];
  }
  throw std::out_of_range("there is no node " + name);
}

TEST_P(Undo, InsertionOfAVertex) {
  for (Family const family : families()) {
    Map const start = build(*family("insert_vertex").scheme.modeler, shape().polygons);
    Map map = start;
    auto const made = apply(family("insert_vertex"), map, {0});
    Dart const vertex = copies(family("insert_vertex"), made, "c").front();
    EXPECT_EQ(vertex_degree(map, vertex), 2U);
    apply(family("remove_vertex"), map, {vertex});
    EXPECT_TRUE(same(map, start));
    EXPECT_EQ(misplaced(map), "");
  }
}

TEST_P(Undo, InsertionOfAnEdge) {
  for (Family const family : families()) {
    Map const start = build(*family("insert_edge").scheme.modeler, shape().polygons);
    int found = 0;
    for (Hooks const& hooks : each_pair(start)) {
      if (!refusal(family("insert_edge"), start, hooks).empty()) continue;
      ++found;
      Map map = start;
      auto const made = apply(family("insert_edge"), map, hooks);
      apply(family("remove_edge"), map, {copies(family("insert_edge"), made, "e").front()});
      EXPECT_TRUE(same(map, start));
    }
    EXPECT_EQ(found > 0, face_size(start, 0) > 3);
  }
}

TEST_P(Undo, SplittingOfAVertex) {
  for (Family const family : families()) {
    Map const start = build(*family("split_vertex").scheme.modeler, shape().polygons);
    for (Hooks const& hooks : each_pair(start)) {
      if (!refusal(family("split_vertex"), start, hooks, {shift}).empty()) continue;
      Map map = start;
      auto const made = apply(family("split_vertex"), map, hooks, {shift});
      Dart const edge = copies(family("split_vertex"), made, "e").front();
      // The ends of the new edge have no neighbour in common, and its faces have grown.
      apply(family("contract_edge"), map, {edge});
      EXPECT_TRUE(same(map, start));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Shapes, Undo, testing::Range(std::size_t{0}, shapes(true).size()));

TEST(FlipEdge, TwiceIsTheOtherWayRound) {
  for (Family const family : Undo::families()) {
    for (std::size_t const solid : {2U, 4U}) {
      Map const start = build(*family("flip_edge").scheme.modeler, platonic_solids()[solid].polygons);
      Map map = start;
      for (int times = 0; times < 2; ++times) {
        Dart const edge = times == 0 ? 0 : map.darts().back();
        ASSERT_EQ(refusal(family("flip_edge"), map, {edge}), "");
        apply(family("flip_edge"), map, {edge});
        EXPECT_EQ(same(map, start), times == 1);
        EXPECT_EQ(misplaced(map), "");
      }
    }
  }
}

TEST(Places, AreThoseAskedFor) {
  for (Family const family : Undo::families()) {
    Map const start = build(*family("scale").scheme.modeler, platonic_solids()[1].polygons);
    auto const at = [](Map const& map, Dart d) { return rewrite::Values<Point3>(map.embedding(0))[d]; };
    Map map = start;
    apply(family("move_vertex"), map, {5}, {point});
    for (Dart const d : map.darts()) {
      bool const moved = number_vertices(map)[d] == number_vertices(map)[5];
      EXPECT_EQ(at(map, d), moved ? std::get<Point3>(point) : at(start, d));
    }
    map = start;
    apply(family("translate"), map, {5}, {shift});
    for (Dart const d : map.darts()) EXPECT_EQ(at(map, d), at(start, d) + std::get<Vec3>(shift));
    map = start;
    apply(family("scale"), map, {5}, {2.0, Point3{0, 0, 1}});
    for (Dart const d : map.darts())
      EXPECT_EQ(at(map, d), Point3{} + (2.0 * (at(start, d) - Point3{}) - Vec3{0, 0, 1}));
    // A quarter turn about a line along the x-axis; the axis may have any length but 0.
    map = start;
    apply(family("rotate"), map, {5}, {std::numbers::pi / 2, Vec3{3, 0, 0}, Point3{7, 1, 2}});
    for (Dart const d : map.darts()) {
      Point3 const p = at(start, d), expected{p.x, 1 - (p.z - 2), 2 + (p.y - 1)};
      EXPECT_LT(distance(at(map, d), expected), 1e-12);
    }
    EXPECT_NE(refusal(family("rotate"), start, {5}, {1.0, Vec3{}, Point3{}}), "");
  }
}

TEST(SewEdges, ClosesWhatUnsewEdgeOpened) {
  Map const start = build(*surface_rule("sew_edges").scheme.modeler, platonic_solids()[1].polygons);
  Map map = start;
  Dart const other = map.target(0, 2);
  apply(surface_rule("unsew_edge"), map, {0});
  EXPECT_EQ(summarize(map).boundary_darts, 4U);
  EXPECT_NE(refusal(surface_rule("sew_edges"), map, {0, 0}), "");
  apply(surface_rule("sew_edges"), map, {0, other});
  EXPECT_TRUE(same(map, start));
  EXPECT_EQ(polygons(map, number_vertices(map)).points, polygons(start, number_vertices(start)).points);
}

TEST(Cone, ClosesAFaceThatStandsByItself) {
  for (std::size_t const n : {3U, 4U, 7U}) {
    Shape const sides = prism(n);
    for (Vertices const& face : sides.polygons.faces) {
      if (face.size() != n) continue;
      Polygons alone{{}, {{}}};
      for (std::size_t const v : face) {
        alone.faces[0].push_back(alone.points.size());
        alone.points.push_back(sides.polygons.points[v]);
      }
      Map map = build(*surface_rule("cone").scheme.modeler, alone);
      apply(surface_rule("cone"), map, {0}, {point});
      EXPECT_EQ(summarize(map).cells, (std::vector<std::size_t>{n + 1, 2 * n, n + 1}));
      EXPECT_EQ(summarize(map).euler, 2);
      EXPECT_EQ(degeneracy(map) + misplaced(map), "");
      EXPECT_NE(refusal(surface_rule("cone"), map, {0}, {point}), "");
      // On an oriented map the face has another at its back.
      alone.faces.emplace_back(alone.faces[0].rbegin(), alone.faces[0].rend());
      Map halfedges = build(*halfedge_rule("cone").scheme.modeler, alone);
      apply(halfedge_rule("cone"), halfedges, {0}, {point});
      EXPECT_EQ(summarize(halfedges).cells, summarize(map).cells);
      EXPECT_EQ(degeneracy(halfedges) + misplaced(halfedges), "");
    }
  }
}

TEST(Prism, ClosesWhatWasAddedFromNothing) {
  Value const p = Point3{0, 0, 0}, q = Point3{2, 0, 0}, r = Point3{2, 2, 0}, s = Point3{0, 2, 0};
  for (Family const family : Undo::families()) {
    for (bool const quad : {false, true}) {
      Module::Rule const& add = family(quad ? "add_quad" : "add_triangle");
      std::size_t const n = quad ? 4 : 3;
      Map map(add.scheme.modeler->model, add.scheme.modeler->embeddings);
      auto const made = apply(add, map, {}, quad ? std::vector{p, q, r, s} : std::vector{p, q, r});
      bool const oriented = map.model().is_oriented(1);
      EXPECT_EQ(summarize(map).cells, (std::vector<std::size_t>{n, n, oriented ? 2U : 1U}));
      auto const at = [&](Dart d) { return Value(rewrite::Values<Point3>(map.embedding(0))[d]); };
      EXPECT_EQ(at(made[0][0]), p);
      EXPECT_EQ(at(other_end(map, made[0][0])), q);
      EXPECT_EQ(misplaced(map), "");
      if (oriented) {  // its front side is a face that can be extruded
        apply(family("extrude_face"), map, {made[0][0]}, {2.0});
      } else {
        apply(family("prism"), map, {made[0][0]}, {Vec3{0, 0, 2}});
      }
      EXPECT_TRUE(same(map, build(*add.scheme.modeler, prism(n).polygons)));
      EXPECT_EQ(misplaced(map), "");
    }
  }
}

TEST(Pierce, MakesATorusOfACube) {
  for (Family const family : Undo::families()) {
    Map const start = build(*family("pierce").scheme.modeler, platonic_solids()[1].polygons);
    int tori = 0, twisted = 0, refused = 0;
    for (Dart const d : start.darts()) {
      if (!refusal(family("pierce"), start, {0, d}).empty()) {
        ++refused;
        continue;
      }
      Map map = start;
      apply(family("pierce"), map, {0, d});
      EXPECT_EQ(summarize(map).euler, 0);
      ++(summarize(map).orientable ? tori : twisted);
    }
    // Only to the face opposite: by each of its darts, of which half would twist the tube of a G-map.
    bool const oriented = start.model().is_oriented(1);
    EXPECT_EQ(tori, 4);
    EXPECT_EQ(twisted, oriented ? 0 : 4);
    EXPECT_EQ(refused, oriented ? 20 : 40);
  }
}

// ---- Refusals ----

TEST(Refused, WhatWouldDegenerate) {
  struct Case {
    char const* rule;
    std::size_t solid;
    Hooks hooks, halfedge_hooks;
    char const* because;  ///< a part of what is said of the G-map
    std::vector<Value> arguments{};
  };
  // The first face of a G-map has the darts 0, 1, 2, … around it, of an O-map the darts 0, 1, ….
  for (Case const& c : std::vector<Case>{
           {"insert_edge", 1, {0, 1}, {0, 1}, "a@0 != b"},              // neighbouring corners
           {"insert_edge", 1, {0, 8}, {0, 4}, "any(x == b"},            // of another face
           {"contract_edge", 0, {0}, {0}, "> 3 for x in <2>(a)"},       // a triangle
           {"collapse_edge", 0, {0}, {0}, "> 3"},                       // a tetrahedron has tips of three edges
           {"flip_edge", 0, {0}, {0}, "not any(any("},                  // the other corners are joined
           {"split_vertex", 1, {0, 1}, {0, 1}, "any(x == b", {shift}},  // darts of two vertices
           {"pierce", 0, {0, 6}, {0, 3}, "not any(any("},               // they have an edge in common
       }) {
    SCOPED_TRACE(c.rule);
    Polygons const& solid = platonic_solids()[c.solid].polygons;
    std::string const on_surface =
        refusal(surface_rule(c.rule), build(*surface_rule(c.rule).scheme.modeler, solid), c.hooks, c.arguments);
    std::string const on_halfedges = refusal(halfedge_rule(c.rule), build(*halfedge_rule(c.rule).scheme.modeler, solid),
                                             c.halfedge_hooks, c.arguments);
    EXPECT_NE(on_surface.find(c.because), std::string::npos) << on_surface;
    EXPECT_NE(on_halfedges, "");
  }
}

TEST(Refused, AVertexOfThreeEdges) {
  for (Family const family : Undo::families()) {
    Map const cube = build(*family("remove_vertex").scheme.modeler, platonic_solids()[1].polygons);
    for (Dart const d : cube.darts()) EXPECT_NE(refusal(family("remove_vertex"), cube, {d}), "");
  }
}

TEST(Refused, AtABorder) {
  Map const square = build(*surface_rule("remove_face").scheme.modeler, grid(1, 1).polygons);
  for (char const* rule :
       {"remove_face", "quadrangulate_face", "chamfer_vertex", "chamfer_edge", "dissolve_vertex", "remove_edge"}) {
    for (Dart const d : square.darts()) EXPECT_NE(refusal(surface_rule(rule), square, {d}), "") << rule;
  }
  // An edge from border to border: contracted, it would leave two parts that touch.
  Map const strip = build(*surface_rule("contract_edge").scheme.modeler, grid(3, 1).polygons);
  int refused = 0;
  for (Dart const d : strip.darts()) {
    if (strip.target(d, 2) == d) continue;
    EXPECT_NE(refusal(surface_rule("contract_edge"), strip, {d}).find("a@2 == a or"), std::string::npos);
    ++refused;
  }
  EXPECT_EQ(refused, 8);
}

}  // namespace
}  // namespace jrule::test
