// The operators of Conway's notation: their published counts, the cells that they make, how they compose.
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "compiler/analysis/independence.h"
#include "compiler/backend/interpreter/interpreter.h"
#include "jrule/typed.h"
#include "tests/reference/plain_map.h"
#include "tests/stdlib/application.h"
#include "tests/stdlib/shapes.h"

namespace jrule::test {
namespace {

Module const& surfaces() {
  static Module const module(JRULE_SOURCE_DIR "/stdlib/std/conway.jrule");
  return module;
}
Module const& halfedges() {
  static Module const module(JRULE_SOURCE_DIR "/stdlib/std/conway_halfedges.jrule");
  return module;
}

/// How many cells have how many sides; of vertices, edges.
using Sides = std::map<std::size_t, std::size_t>;

/// What an operator makes of v vertices, e edges and f faces.
struct Operator {
  std::string name;
  bool chiral;
  /// As published: V' = V[0] v + V[1] e + V[2] f, E' = E e, F' likewise.
  std::size_t V[3], E, F[3];
  /// A vertex (face) of n edges becomes a vertex of so many times n edges; 0: it becomes none.
  std::size_t vertex_of_vertex, vertex_of_face;
  Sides new_vertices;  ///< those with a fixed number of edges: how many for each old edge
  std::size_t face_of_vertex, face_of_face;
  Sides new_faces;
};

std::vector<Operator> const operators{
    {"dual", false, {0, 0, 1}, 1, {1, 0, 0}, 0, 1, {}, 1, 0, {}},
    {"join", false, {1, 0, 1}, 2, {0, 1, 0}, 1, 1, {}, 0, 0, {{4, 1}}},
    {"ambo", false, {0, 1, 0}, 2, {1, 0, 1}, 0, 0, {{4, 1}}, 1, 1, {}},
    {"kis", false, {1, 0, 1}, 3, {0, 2, 0}, 2, 1, {}, 0, 0, {{3, 2}}},
    {"needle", false, {1, 0, 1}, 3, {0, 2, 0}, 1, 2, {}, 0, 0, {{3, 2}}},
    {"truncate", false, {0, 2, 0}, 3, {1, 0, 1}, 0, 0, {{3, 2}}, 1, 2, {}},
    {"zip", false, {0, 2, 0}, 3, {1, 0, 1}, 0, 0, {{3, 2}}, 2, 1, {}},
    {"ortho", false, {1, 1, 1}, 4, {0, 2, 0}, 1, 1, {{4, 1}}, 0, 0, {{4, 2}}},
    {"expand", false, {0, 2, 0}, 4, {1, 1, 1}, 0, 0, {{4, 2}}, 1, 1, {{4, 1}}},
    {"meta", false, {1, 1, 1}, 6, {0, 4, 0}, 2, 2, {{4, 1}}, 0, 0, {{3, 4}}},
    {"bevel", false, {0, 4, 0}, 6, {1, 1, 1}, 0, 0, {{3, 4}}, 2, 2, {{4, 1}}},
    {"chamfer", false, {1, 2, 0}, 4, {0, 1, 1}, 1, 0, {{3, 2}}, 0, 1, {{6, 1}}},
    {"subdivide", false, {1, 1, 0}, 4, {0, 2, 1}, 1, 0, {{6, 1}}, 0, 1, {{3, 2}}},
    {"loft", false, {1, 2, 0}, 5, {0, 2, 1}, 2, 0, {{3, 2}}, 0, 1, {{4, 2}}},
    {"quinto", false, {1, 3, 0}, 6, {0, 2, 1}, 1, 0, {{3, 2}, {4, 1}}, 0, 1, {{5, 2}}},
    {"joined_lace", false, {1, 2, 0}, 6, {0, 3, 1}, 2, 0, {{4, 2}}, 0, 1, {{3, 2}, {4, 1}}},
    {"lace", false, {1, 2, 0}, 7, {0, 4, 1}, 3, 0, {{4, 2}}, 0, 1, {{3, 4}}},
    {"stake", false, {1, 2, 1}, 7, {0, 4, 0}, 3, 1, {{3, 2}}, 0, 0, {{3, 2}, {4, 2}}},
    {"join_kis_kis", false, {1, 2, 1}, 8, {0, 5, 0}, 3, 2, {{3, 2}}, 0, 0, {{3, 4}, {4, 1}}},
    {"ethel", false, {1, 4, 0}, 8, {0, 3, 1}, 1, 0, {{3, 2}, {4, 2}}, 0, 1, {{4, 2}, {6, 1}}},
    {"waffle", false, {1, 4, 1}, 9, {0, 4, 0}, 1, 1, {{3, 2}, {4, 2}}, 0, 0, {{4, 2}, {5, 2}}},
    {"cross", false, {1, 3, 1}, 10, {0, 6, 0}, 2, 1, {{4, 2}, {6, 1}}, 0, 0, {{3, 4}, {4, 2}}},
    {"gyro", true, {1, 2, 1}, 5, {0, 2, 0}, 1, 1, {{3, 2}}, 0, 0, {{5, 2}}},
    {"snub", true, {0, 2, 0}, 5, {1, 2, 1}, 0, 0, {{5, 2}}, 1, 1, {{3, 2}}},
    {"propeller", true, {1, 2, 0}, 5, {0, 2, 1}, 1, 0, {{4, 2}}, 0, 1, {{4, 2}}},
    {"whirl", true, {1, 4, 0}, 7, {0, 2, 1}, 1, 0, {{3, 4}}, 0, 1, {{6, 2}}},
    {"bowtie", true, {1, 5, 1}, 10, {0, 4, 0}, 1, 1, {{3, 4}, {4, 1}}, 0, 0, {{3, 2}, {7, 2}}},
};

Module::Rule const& surface_rule(std::string const& name) { return surfaces().rule(name); }
Module::Rule const& halfedge_rule(std::string const& name) {
  for (Operator const& op : operators) {
    if (op.name == name && op.chiral) return halfedges().rule(name);
  }
  return halfedges().rule(name + "_halfedges");
}

/// The numbers of edges of the vertices, and of sides of the faces.
struct Cells {
  Sides vertices, faces;
  bool operator==(Cells const&) const = default;
};
Cells cells_of(Map const& map) {
  std::vector<std::size_t> const vertex = number_vertices(map);
  std::map<std::size_t, std::size_t> edges_of;
  Cells cells;
  for (Vertices const& face : faces(map, vertex)) {
    ++cells.faces[face.size()];
    for (std::size_t const v : face) ++edges_of[v];
  }
  for (auto const& [v, n] : edges_of) ++cells.vertices[n];
  return cells;
}

Cells expected(Operator const& op, Cells const& old, std::size_t edges) {
  Cells cells;
  for (auto const& [n, count] : old.vertices) {
    if (op.vertex_of_vertex != 0) cells.vertices[op.vertex_of_vertex * n] += count;
    if (op.face_of_vertex != 0) cells.faces[op.face_of_vertex * n] += count;
  }
  for (auto const& [n, count] : old.faces) {
    if (op.vertex_of_face != 0) cells.vertices[op.vertex_of_face * n] += count;
    if (op.face_of_face != 0) cells.faces[op.face_of_face * n] += count;
  }
  for (auto const& [n, count] : op.new_vertices) cells.vertices[n] += count * edges;
  for (auto const& [n, count] : op.new_faces) cells.faces[n] += count * edges;
  return cells;
}

/// All points finite, no two alike; on a solid around the origin, every face with an area.
void expect_a_shape(Map const& map, bool solid) {
  Polygons const shape = polygons(map, number_vertices(map));
  std::map<std::vector<long long>, std::size_t> seen;
  for (Point3 const& p : shape.points) {
    ASSERT_TRUE(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
    auto const rounded = [](double x) { return std::llround(x * 1e9); };
    std::vector<long long> const place{rounded(p.x), rounded(p.y), rounded(p.z)};
    EXPECT_EQ(seen[place]++, 0U) << "two vertices at " << to_string(Value(p));
  }
  if (!solid) return;
  for (Vertices const& face : shape.faces) {
    std::vector<Point3> corners;
    for (std::size_t const v : face) corners.push_back(shape.points[v]);
    EXPECT_GT(norm(area_vector(corners)), 1e-3);
  }
}

Map applied(Module::Rule const& rule, Map map) {
  apply(rule, map, {map.darts().front()});
  return map;
}

class Conway : public testing::TestWithParam<std::size_t> {
 protected:
  Operator const& op() const { return operators[GetParam()]; }
  std::vector<Module::Rule const*> rules() const {
    std::vector<Module::Rule const*> both{&halfedge_rule(op().name)};
    if (!op().chiral) both.push_back(&surface_rule(op().name));
    return both;
  }
};

TEST_P(Conway, MakesTheCellsThatItShould) {
  for (Shape const& shape : closed_surfaces()) {
    SCOPED_TRACE(shape.name);
    for (Module::Rule const* rule : rules()) {
      SCOPED_TRACE(rule->scheme.name);
      Map map = build(*rule->scheme.modeler, shape.polygons);
      Summary const was = summarize(map);
      ASSERT_TRUE(was.valid);
      Cells const old = cells_of(map);
      ASSERT_EQ(apply(*rule, map, {map.darts().front()}).empty(), false);
      Summary const is = summarize(map);
      auto const total = [&](std::size_t const(&c)[3]) {
        return c[0] * was.cells[0] + c[1] * was.cells[1] + c[2] * was.cells[2];
      };
      EXPECT_EQ(is.cells, (std::vector<std::size_t>{total(op().V), op().E * was.cells[1], total(op().F)}));
      EXPECT_EQ(is.darts, op().E * was.darts);
      EXPECT_EQ(is.euler, was.euler);
      EXPECT_EQ(is.boundary_darts, 0U);
      EXPECT_EQ(is.components, 1U);
      EXPECT_TRUE(is.orientable);
      EXPECT_EQ(cells_of(map), expected(op(), old, was.cells[1]));
      expect_a_shape(map, was.euler == 2 && shape.name != "bunny");
    }
  }
}

TEST_P(Conway, IsAppliedToAllComponentsAtOnce) {
  Polygons two = platonic_solids()[0].polygons;
  std::size_t const first = two.points.size();
  Polygons const& cube = platonic_solids()[1].polygons;
  two.points.insert(two.points.end(), cube.points.begin(), cube.points.end());
  for (Vertices face : cube.faces) {
    for (std::size_t& v : face) v += first;
    two.faces.push_back(face);
  }
  for (Module::Rule const* rule : rules()) {
    EXPECT_TRUE(analysis::analyze_independence(rule->scheme, rule->plan).independent()) << rule->scheme.name;
    Map map = build(*rule->scheme.modeler, two);
    std::size_t const darts = map.dart_count();
    rewrite::Workspace workspace;
    auto const count = interpreter::apply_all(rule->scheme, rule->plan, map, defaults(rule->scheme), workspace);
    ASSERT_TRUE(count);
    EXPECT_EQ(*count, 2U);
    EXPECT_EQ(map.dart_count(), op().E * darts);
    EXPECT_TRUE(summarize(map).valid);
  }
}

// The two rules of an operator make the same points, whatever they call them.
TEST_P(Conway, PutsVerticesWhereItsOtherRuleDoes) {
  if (op().chiral) return;
  for (Shape const& shape : platonic_solids()) {
    std::vector<std::vector<Point3>> points;
    for (Module::Rule const* rule : rules()) {
      Map const map = applied(*rule, build(*rule->scheme.modeler, shape.polygons));
      points.push_back(polygons(map, number_vertices(map)).points);
    }
    ASSERT_EQ(points[0].size(), points[1].size());
    for (Point3 const& p : points[0]) {
      double nearest = 1;
      for (Point3 const& q : points[1]) nearest = std::min(nearest, distance(p, q));
      EXPECT_LT(nearest, 1e-12) << op().name << " of the " << shape.name << ": " << to_string(Value(p));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Operators, Conway, testing::Range(std::size_t{0}, operators.size()),
                         [](auto const& test) { return operators[test.param].name; });

TEST(ConwayModules, HaveNoOtherRules) {
  std::size_t const chiral = static_cast<std::size_t>(
      std::count_if(operators.begin(), operators.end(), [](Operator const& op) { return op.chiral; }));
  EXPECT_EQ(surfaces().size(), operators.size() - chiral);
  EXPECT_EQ(halfedges().size(), operators.size());
}

// ---- Composition ----

/// "d k d": from the right to the left.
Map composed(std::string const& names, Map map, Module::Rule const& (*rule)(std::string const&)) {
  static std::map<char, std::string> const letters{
      {'d', "dual"},      {'j', "join"},  {'a', "ambo"},   {'k', "kis"},      {'n', "needle"}, {'t', "truncate"},
      {'z', "zip"},       {'o', "ortho"}, {'e', "expand"}, {'m', "meta"},     {'b', "bevel"},  {'c', "chamfer"},
      {'u', "subdivide"}, {'g', "gyro"},  {'s', "snub"},   {'p', "propeller"}};
  for (auto letter = names.rbegin(); letter != names.rend(); ++letter)
    map = applied(rule(letters.at(*letter)), std::move(map));
  return map;
}

struct Equation {
  char const* left;
  char const* right;
  bool chiral = false;
};
// Those of the rules' comments, and some that follow.
Equation const equations[] = {{"dd", ""},  {"j", "da"},  {"jd", "j"},       {"a", "dj"},       {"ad", "a"},
                              {"k", "dz"}, {"k", "dtd"}, {"n", "kd"},       {"t", "dkd"},      {"z", "dk"},
                              {"z", "td"}, {"o", "jj"},  {"e", "do"},       {"e", "aa"},       {"m", "kj"},
                              {"md", "m"}, {"b", "dm"},  {"b", "ta"},       {"c", "dud"},      {"u", "dcd"},
                              {"od", "o"}, {"ed", "e"},  {"g", "ds", true}, {"s", "dg", true}, {"p", "dpd", true}};

void expect_equal(Equation const& equation, Map const& start, Module::Rule const& (*rule)(std::string const&)) {
  Map const left = composed(equation.left, start, rule), right = composed(equation.right, start, rule);
  EXPECT_TRUE(reference::isomorphic(reference::plain(left), reference::plain(right), {}, {}, {}))
      << equation.left << " = " << equation.right;
}

TEST(Composition, IsAsDefined) {
  for (std::size_t const solid : {0U, 1U}) {
    Polygons const& polygons = platonic_solids()[solid].polygons;
    SCOPED_TRACE(platonic_solids()[solid].name);
    for (Equation const& equation : equations) {
      expect_equal(equation, build(*halfedge_rule("dual").scheme.modeler, polygons), halfedge_rule);
      if (!equation.chiral) expect_equal(equation, build(*surface_rule("dual").scheme.modeler, polygons), surface_rule);
    }
  }
}

// ---- Borders ----

// Operators that leave the old edges where they are leave a border a border; the others refuse one.
TEST(Border, StaysOneOrIsRefused) {
  std::set<std::string> const keep{"kis", "ortho", "meta", "subdivide", "loft", "quinto", "lace", "stake", "cross"};
  for (Operator const& op : operators) {
    if (op.chiral) continue;
    SCOPED_TRACE(op.name);
    Module::Rule const& rule = surface_rule(op.name);
    for (Shape const& shape : {grid(2, 3), moebius(5)}) {
      Map map = build(*rule.scheme.modeler, shape.polygons);
      Summary const was = summarize(map);
      ASSERT_GT(was.boundary_darts, 0U);
      EXPECT_EQ(refusal(rule, map, {0}).empty(), keep.contains(op.name));
      if (!keep.contains(op.name)) continue;
      apply(rule, map, {0});
      Summary const is = summarize(map);
      EXPECT_EQ(is.euler, was.euler);
      EXPECT_EQ(is.orientable, was.orientable);
      EXPECT_EQ(is.boundary_darts % was.boundary_darts, 0U);
      EXPECT_GT(is.boundary_darts, 0U);
      expect_a_shape(map, false);
    }
  }
}

// ---- Parameters ----

TEST(Parameters, PlaceNewVertices) {
  Module::Rule const& truncate = surface_rule("truncate");
  Map map = build(*truncate.scheme.modeler, platonic_solids()[1].polygons);
  apply(truncate, map, {0}, {0.25});
  for (Point3 const& p : polygons(map, number_vertices(map)).points) {
    std::vector<double> c{std::abs(p.x), std::abs(p.y), std::abs(p.z)};
    std::sort(c.begin(), c.end());
    EXPECT_EQ(c, (std::vector<double>{0.5, 1, 1}));
  }
  // Faces turn to the left seen from outside, so that their normals point there.
  Module::Rule const& kis = halfedge_rule("kis");
  map = build(*kis.scheme.modeler, platonic_solids()[1].polygons);
  apply(kis, map, {0}, {2.0});
  std::size_t tips = 0;
  for (Point3 const& p : polygons(map, number_vertices(map)).points) tips += norm(p - Point3{}) == 3.0 ? 1 : 0;
  EXPECT_EQ(tips, 6U);
}

}  // namespace
}  // namespace jrule::test
