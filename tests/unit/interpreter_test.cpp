// Applications: values survive splits and merges, also beyond the matched part; a refusal leaves the map as it was.
#include <gtest/gtest.h>

#include "compiler/backend/interpreter/interpreter.h"
#include "jrule/io.h"
#include "tests/unit/rule_fixture.h"

namespace jrule {
namespace {

struct Applier {
  ir::RuleScheme rule;
  analysis::Plan plan;
  rewrite::Workspace workspace{};

  explicit Applier(std::string const& text) : rule(tests::program_of(text).rules.at(0)) {
    analysis::Verdict verdict = analysis::analyze(rule);
    if (!verdict.accepted()) throw std::runtime_error(tests::codes(verdict));
    plan = verdict.plan;
  }
  Result<interpreter::Applied> at(Map& map, std::vector<Dart> const& hooks, std::vector<Value> const& values = {}) {
    return interpreter::apply(rule, plan, map, hooks, values, workspace);
  }
  // Polygons side by side, free, with a position and a number at each corner's orbit.
  Map polygons(std::vector<std::uint32_t> const& sides) const {
    Map map(rule.model(), rule.modeler->embeddings);
    for (std::uint32_t const n : sides) {
      std::vector<Dart> const d = map.add_darts(2 * n);
      for (std::uint32_t k = 0; k < n; ++k) {
        map.link(d[2 * k], 0, d[2 * k + 1]);
        map.link(d[2 * k + 1], 1, d[(2 * k + 2) % (2 * n)]);
      }
    }
    for (std::size_t e = 0; e < map.embedding_count(); ++e) {
      OrbitNumbers const orbits = number_orbits(map, map.embedding(e).spec().orbit);
      for (std::size_t i = 0; i < orbits.first.size(); ++i) map.embedding(e).add(static_cast<double>(i));
      for (Dart const d : map.darts()) map.embedding(e).set_handle(d, orbits.number[d]);
    }
    return map;
  }
};

double real_at(Map const& map, Dart d) { return std::get<double>(map.embedding(0).value(map.embedding(0).handle(d))); }

std::string const vertex_weight = "modeler S on gmap(2) { embedding w : <1,2> -> Real { merge mean; } }\n";

TEST(Interpreter, MergedOrbitsGetTheirMean) {
  Applier sew(vertex_weight + "rule sew on S { left { hook a <0>; hook b <0>; a -2- a; b -2- b; } right { a; b; a -2- b; } }");
  Map map = sew.polygons({3, 3});
  ASSERT_TRUE(sew.at(map, {0, 6}));
  EXPECT_FALSE(find_violation(map));
  // Vertices 0 and 3 of the triangles became one, and 1 and 4; the whole vertex has the new value, unmatched darts too.
  EXPECT_EQ(real_at(map, 0), 1.5);
  EXPECT_EQ(real_at(map, 5), 1.5);
  EXPECT_EQ(real_at(map, 1), 2.5);
  EXPECT_EQ(real_at(map, 8), 2.5);
  EXPECT_EQ(real_at(map, 3), 2);
}

TEST(Interpreter, SplitOrbitsKeepTheirValue) {
  Applier sew(vertex_weight + "rule sew on S { left { hook a <0>; hook b <0>; a -2- a; b -2- b; } right { a; b; a -2- b; } }");
  Applier unsew(vertex_weight + "rule unsew on S { left { hook a <0>; b <0>; a -2- b; } right { a; b; a -2- a; b -2- b; } }");
  Map map = sew.polygons({3, 3});
  ASSERT_TRUE(sew.at(map, {0, 6}));
  ASSERT_TRUE(unsew.at(map, {0}));
  EXPECT_FALSE(find_violation(map));
  EXPECT_EQ(real_at(map, 5), 1.5);
  EXPECT_EQ(real_at(map, 11), 1.5);
}

TEST(Interpreter, AClauseReachesBeyondTheMatchedPart) {
  Applier set(vertex_weight + "rule set(x: Real) on S { left { hook a <>; } right { a { w = x + a.w; } } }");
  Map map = set.polygons({4});
  ASSERT_TRUE(set.at(map, {1}, {10.0}));
  EXPECT_EQ(real_at(map, 1), 11);
  EXPECT_EQ(real_at(map, 2), 11);  // the other dart of that corner
  EXPECT_EQ(real_at(map, 0), 0);
  EXPECT_FALSE(find_violation(map));
}

TEST(Interpreter, ExpressionsSeeTheMapBefore) {
  // The two ends of an edge exchange their values.
  Applier swap(vertex_weight + "rule swap on S { left { hook a <>; b; a -0- b; } right { a { w = b.w; } b { w = a.w; } a -0- b; } }");
  Map map = swap.polygons({3});
  ASSERT_TRUE(swap.at(map, {0}));
  EXPECT_EQ(real_at(map, 0), 1);
  EXPECT_EQ(real_at(map, 1), 0);
}

TEST(Interpreter, OneValueForEachNewOrbit) {
  Applier split(vertex_weight + "rule split on S { left { hook a <0,2>; } right { a <_,2>; b <_,2> { w = mean(<0>(a).w); } a -0- b; b -1[0]- b; } }");
  Map map = split.polygons({3});
  std::size_t const values = map.embedding(0).value_count();
  auto const applied = split.at(map, {0});
  ASSERT_TRUE(applied) << applied.error().message;
  EXPECT_FALSE(find_violation(map));
  EXPECT_EQ(map.dart_count(), 8U);
  EXPECT_EQ(map.embedding(0).value_count(), values + 1);
  EXPECT_EQ(real_at(map, applied->copies[1][0]), 0.5);
}

TEST(Interpreter, RequirementsAndLets) {
  Applier rule(vertex_weight +
               "rule r(limit: Real) on S { left { hook a <0,1>; let total = sum(<0,1>(a).w); require total < limit; } right { a { w = total; } } }");
  Map map = rule.polygons({3});
  std::string const before = print_jmap(map);
  auto const refused = rule.at(map, {0}, {3.0});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().kind, Error::Kind::not_applicable);
  EXPECT_EQ(refused.error().message, "`r` is not applicable: it requires (< total limit)");
  EXPECT_EQ(print_jmap(map), before);
  ASSERT_TRUE(rule.at(map, {0}, {3.5}));
  EXPECT_EQ(real_at(map, 0), 3);
}

TEST(Interpreter, ARefusalLeavesTheMapAsItWas) {
  Applier cone(vertex_weight +
               "rule cone on S { left { hook a <0,1>; a -2- a; } right { a; b <0,_>; c <_,2>; d <1,2> { w = mean(<0,1>(a).w); } a -2- b -1- c -0- d; } }");
  Applier sew(vertex_weight +
              "rule sew on S { left { hook a <0>; hook b <0>; a -2- a; b -2- b; } right { a; b; a -2- b; } }");
  Map map = cone.polygons({3, 4});
  ASSERT_TRUE(sew.at(map, {0, 6}));
  std::string const before = print_jmap(map);
  auto const refused = cone.at(map, {6});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().message, "`cone` is not applicable: the 2-arc of `a` has to be a loop, but from dart 6 it leads to dart 0");
  auto const twice = sew.at(map, {2, 3});
  ASSERT_FALSE(twice);
  EXPECT_EQ(twice.error().message, "`sew` is not applicable: dart 3 would be matched twice");
  EXPECT_FALSE(cone.at(map, {99}));
  EXPECT_EQ(print_jmap(map), before);
}

TEST(Interpreter, TheMapMustBeOfTheRulesModeler) {
  Applier rule("modeler S on gmap(2);\nrule r on S { left { hook a <>; } right { a; } }");
  Map other(gmap(3));
  other.add_darts(1);
  auto const refused = rule.at(other, {0});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().kind, Error::Kind::bad_input);
}

TEST(Interpreter, DeletedDartsAreReused) {
  Applier erase("modeler S on gmap(2);\nrule erase on S { left { hook a <0,1>; a -2- a; } right { } }");
  Map map = erase.polygons({3, 4});
  ASSERT_TRUE(erase.at(map, {0}));
  EXPECT_EQ(map.dart_count(), 8U);
  EXPECT_FALSE(map.contains(0));
  EXPECT_FALSE(find_violation(map));
  EXPECT_EQ(map.add_darts(1), std::vector<Dart>{0});
}

}  // namespace
}  // namespace jrule
