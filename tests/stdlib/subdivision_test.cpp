// Subdivision: the rules on oriented maps against those on generalized ones, and those without a peer in
// tests/smoothing against their formulas.
#include <algorithm>
#include <map>

#include "tests/stdlib/application.h"
#include "tests/stdlib/measure.h"
#include "tests/stdlib/shapes.h"

namespace jrule::test {
namespace {

Module::Rule const& rule(std::string const& name) {
  static Module const module(JRULE_SOURCE_DIR "/stdlib/std/subdivision.jrule");
  return module.rule(name);
}

std::vector<Point3> points_of(Map const& map) { return polygons(map, number_vertices(map)).points; }

/// Has each point of `some` one of `all` at its place?
void expect_among(std::vector<Point3> const& some, std::vector<Point3> const& all) {
  for (Point3 const& p : some) {
    double nearest = 1;
    for (Point3 const& q : all) nearest = std::min(nearest, distance(p, q));
    ASSERT_LT(nearest, 1e-12) << to_string(Value(p));
  }
}

class Subdivision : public testing::TestWithParam<std::string> {};

TEST_P(Subdivision, OfHalfedgesIsThatOfMeshes) {
  Module::Rule const& mesh = rule(GetParam());
  Module::Rule const& halfedges = rule(GetParam() + "_halfedges");
  std::size_t applied = 0;
  for (Shape const& shape : closed_surfaces()) {
    if (shape.name == "bunny") continue;
    SCOPED_TRACE(shape.name);
    Map one = build(*mesh.scheme.modeler, shape.polygons), other = build(*halfedges.scheme.modeler, shape.polygons);
    bool const applicable = refusal(mesh, one, {0}).empty();
    ASSERT_EQ(refusal(halfedges, other, {0}).empty(), applicable);
    if (!applicable) continue;
    ++applied;
    long long const euler = summarize(one).euler;
    for (int level = 0; level < 2; ++level) {
      apply(mesh, one, {one.darts().front()});
      apply(halfedges, other, {other.darts().front()});
    }
    EXPECT_EQ(summarize(one).cells, summarize(other).cells);
    EXPECT_EQ(summarize(other).euler, euler);
    EXPECT_EQ(degeneracy(other), "");
    EXPECT_EQ(points_of(one).size(), points_of(other).size());
    expect_among(points_of(one), points_of(other));
  }
  bool const of_triangles = GetParam() == "loop" || GetParam() == "butterfly" || GetParam() == "sqrt3";
  EXPECT_EQ(applied, of_triangles ? 3U : 6U);
}

INSTANTIATE_TEST_SUITE_P(Rules, Subdivision,
                         testing::Values("quad", "catmull_clark", "loop", "butterfly", "doo_sabin", "midedge", "sqrt3"),
                         [](auto const& test) { return test.param; });

TEST(Butterfly, HasItsWeights) {
  for (Shape const& shape : closed_surfaces()) {
    if (shape.polygons.faces.front().size() != 3) continue;
    std::vector<Point3> const& at = shape.polygons.points;
    // Of each edge, as it turns in its face, the third corner.
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> tip;
    for (Vertices const& face : shape.polygons.faces) {
      for (std::size_t k = 0; k < 3; ++k) tip[{face[k], face[(k + 1) % 3]}] = face[(k + 2) % 3];
    }
    for (double const w : {1.0 / 16, 0.0, 0.1}) {
      std::vector<Point3> expected = at;
      for (auto const& [edge, r] : tip) {
        auto const [p, q] = edge;
        std::size_t const s = tip.at({q, p});
        Vec3 sum{};
        auto const add = [&](std::size_t v, double weight) { sum = sum + weight * (at[v] - Point3{}); };
        for (std::size_t const v : {p, q}) add(v, 0.5);
        for (std::size_t const v : {r, s}) add(v, 2 * w);
        for (std::size_t const v : {tip.at({p, r}), tip.at({r, q}), tip.at({q, s}), tip.at({s, p})}) add(v, -w);
        if (p < q) expected.push_back(Point3{} + sum);
      }
      Map map = build(*rule("butterfly").scheme.modeler, shape.polygons);
      apply(rule("butterfly"), map, {0}, {w});
      ASSERT_EQ(points_of(map).size(), expected.size());
      expect_among(expected, points_of(map));
    }
  }
}

TEST(Midedge, KeepsTheMiddlesOfEdges) {
  Map map = build(*rule("midedge").scheme.modeler, platonic_solids()[1].polygons);
  apply(rule("midedge"), map, {0});
  for (Point3 const& p : points_of(map)) EXPECT_EQ(p.x * p.x + p.y * p.y + p.z * p.z, 2);
}

}  // namespace
}  // namespace jrule::test
