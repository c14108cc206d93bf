// Applications: values survive splits and merges, also beyond the matched part; a refusal leaves the map as it was.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "compiler/backend/interpreter/interpreter.h"
#include "jrule/io.h"
#include "tests/unit/polygons.h"
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
  Map polygons(std::vector<std::uint32_t> const& sides) const { return tests::polygons(*rule.modeler, sides); }
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

std::string const first_weight = "modeler S on gmap(2) { embedding w : vertex -> Real { merge first; } }\n";

TEST(Interpreter, TheFirstOfMergedValuesIsThatOfTheNodeThatComesFirst) {
  std::string const arcs = "hook a <0>; hook b <0>; a -2- a; b -2- b;";
  Applier sew(first_weight + "rule sew on S { left { " + arcs + " } right { a; b; a -2- b; } }");
  Map map = sew.polygons({3, 3, 3});
  ASSERT_TRUE(sew.at(map, {0, 6}));
  ASSERT_TRUE(sew.at(map, {8, 12}));
  EXPECT_FALSE(find_violation(map));
  for (Dart const d : {0U, 5U, 6U, 11U}) EXPECT_EQ(real_at(map, d), 0);
  for (Dart const d : {1U, 2U, 7U, 8U, 12U, 17U}) EXPECT_EQ(real_at(map, d), 1);
  for (Dart const d : {9U, 10U, 13U, 14U}) EXPECT_EQ(real_at(map, d), 5);
  EXPECT_EQ(map.embedding(0).value_count(), 9U) << "no value is new";
}

// The edges of polygons are glued at random: the ends of an edge may be one vertex already, or become one by way of others.
TEST(Interpreter, MergedOrbitsHaveOneValueHoweverTheyMeet) {
  std::string const rule = "rule sew on S { left { hook a <0>; hook b <0>; a -2- a; b -2- b; } right { a; b; a -2- b; } }";
  Applier first(first_weight + rule), mean(vertex_weight + rule);
  std::mt19937 random(7);
  int met = 0;
  for (int round = 0; round < 600; ++round) {
    bool const by_first = round % 2 == 0;
    Applier& sew = by_first ? first : mean;
    Map map = sew.polygons({2 + static_cast<std::uint32_t>(random() % 3), 3, 1 + static_cast<std::uint32_t>(random() % 4)});
    for (int step = 0; step < 12; ++step) {
      Dart const a = static_cast<Dart>(random() % map.dart_limit()), b = static_cast<Dart>(random() % map.dart_limit());
      double const kept = real_at(map, a), other = real_at(map, b);
      if (!sew.at(map, {a, b})) continue;
      ASSERT_FALSE(find_violation(map));
      std::vector<Dart> const vertex = orbit(map, map.embedding(0).spec().orbit, a);
      bool const both_ends = std::find(vertex.begin(), vertex.end(), map.target(a, 0)) != vertex.end();
      met += both_ends;
      if (!both_ends) {
        ASSERT_EQ(real_at(map, a), by_first ? kept : (kept + other) / 2);
      }
    }
  }
  EXPECT_GT(met, 20);
}

TEST(Interpreter, SplitOrbitsKeepTheirValue) {
  Applier sew(vertex_weight + "rule sew on S { left { hook a <0>; hook b <0>; a -2- a; b -2- b; } right { a; b; a -2- b; } }");
  Applier unsew(vertex_weight + "rule unsew on S { left { hook a <0>; b <0>; a -2- b; } right { a; b; a -2- a; b -2- b; } }");
  Map map = sew.polygons({3, 3});
  ASSERT_TRUE(sew.at(map, {0, 6}));
  ASSERT_TRUE(unsew.at(map, {0}));
  EXPECT_FALSE(find_violation(map));
  for (Dart const d : {0U, 5U, 6U, 11U}) EXPECT_EQ(real_at(map, d), 1.5);
  for (Dart const d : {1U, 2U, 7U, 8U}) EXPECT_EQ(real_at(map, d), 2.5);
}

TEST(Interpreter, AClauseReachesBeyondTheMatchedPart) {
  Applier set(vertex_weight + "rule set(x: Real) on S { left { hook a <>; } right { a { w = x + a.w; } } }");
  Map map = set.polygons({4});
  ASSERT_TRUE(set.at(map, {1}, {10.0}));
  EXPECT_EQ(real_at(map, 1), 11);
  EXPECT_EQ(real_at(map, 2), 11);  // the other dart of that corner
  EXPECT_EQ(real_at(map, 0), 0);
  EXPECT_FALSE(find_violation(map));

  // The vertex of two sewn triangles lies in a face of which the rule matches no dart.
  Applier sew(vertex_weight + "rule sew on S { left { hook a <0>; hook b <0>; a -2- a; b -2- b; } right { a; b; a -2- b; } }");
  Map sewn = sew.polygons({3, 3});
  ASSERT_TRUE(sew.at(sewn, {0, 6}));
  ASSERT_TRUE(set.at(sewn, {0}, {10.0}));
  for (Dart const d : {0U, 5U, 6U, 11U}) EXPECT_EQ(real_at(sewn, d), 11.5);
  EXPECT_FALSE(find_violation(sewn));
}

TEST(Interpreter, AListReachesBeyondTheMatchedPartAndIsReadBefore) {
  // The surface of two triangles has the vertices 1.5, 2.5, 2 and 5 before it is cut; after that neither part has them all.
  Applier sew(vertex_weight + "rule sew on S { left { hook a <0>; hook b <0>; a -2- a; b -2- b; } right { a; b; a -2- b; } }");
  Applier cut(vertex_weight +
              "rule cut on S { left { hook a <0>; b <0>; a -2- b; } right { a { w = sum(<0,1,2>(a).w); } b; a -2- a; b -2- b; } }");
  Map map = sew.polygons({3, 3});
  ASSERT_TRUE(sew.at(map, {0, 6}));
  ASSERT_TRUE(cut.at(map, {0}));
  for (Dart const d : {0U, 5U, 1U, 2U}) EXPECT_EQ(real_at(map, d), 11);
  for (Dart const d : {6U, 11U}) EXPECT_EQ(real_at(map, d), 1.5);
  for (Dart const d : {7U, 8U}) EXPECT_EQ(real_at(map, d), 2.5);
  EXPECT_FALSE(find_violation(map));
}

TEST(Interpreter, ALongSeriesKeepsThePoolSmall) {
  Applier set(vertex_weight + "rule set(x: Real) on S { left { hook a <>; require x < 1000; } right { a { w = x + a.w; } } }");
  Map map = set.polygons({4});
  std::size_t drops = 0;
  for (int i = 1; i <= 100; ++i) {
    std::size_t const before = map.embedding(0).value_count();
    ASSERT_FALSE(set.at(map, {1}, {1000.0}));
    ASSERT_EQ(map.embedding(0).value_count(), before) << "nothing is dropped when nothing is applied";
    ASSERT_TRUE(set.at(map, {1}, {1.0}));
    ASSERT_LE(map.embedding(0).value_count(), 9U) << "two for each corner, and the new one";
    if (map.embedding(0).value_count() <= before) ++drops;
    ASSERT_EQ(real_at(map, 2), 1 + i);
  }
  EXPECT_GT(drops, 0U);
  EXPECT_LT(drops, 50U);
  for (Dart const d : {0U, 3U, 4U}) EXPECT_EQ(real_at(map, d), d == 0 ? 0 : 2);
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
  EXPECT_EQ(refused.error().message, "`r` is not applicable: `total < limit` does not hold where the hook `a` is dart 0");
  EXPECT_EQ(print_jmap(map), before);
  ASSERT_TRUE(rule.at(map, {0}, {3.5}));
  EXPECT_EQ(real_at(map, 0), 3);
}

TEST(Interpreter, ARequirementIsToldAsItIsWrittenAndWhere) {
  auto const refusal = [](std::string const& text, std::vector<Dart> const& hooks, std::vector<Value> const& values = {}) {
    Applier rule(vertex_weight + text);
    Map map = rule.polygons({3, 4});
    auto const refused = rule.at(map, hooks, values);
    return refused ? "applied" : refused.error().message;
  };
  EXPECT_EQ(refusal("rule r on S { left { hook a <0,1>; require count( face(a) by <0> ) ==  /* a quad */\n"
                    "      pi / pi + 3  // in numbers\n  ; } right { a; } }", {2}),
            "`r` is not applicable: `count( face(a) by <0> ) == pi / pi + 3` does not hold where the hook `a` is dart 2");
  std::string const two = "left { hook a <0>; hook b <0>; hook c <0>; a -2- a; b -2- b; c -2- c; require ";
  std::string const unchanged = "; } right { a; b; c; a -2- a; b -2- b; c -2- c; } }";
  EXPECT_EQ(refusal("rule r on S { " + two + "b.w < a.w" + unchanged, {0, 2, 6}),
            "`r` is not applicable: `b.w < a.w` does not hold where the hook `a` is dart 0, the hook `b` is dart 2 and the hook `c` is dart 6");
  // The same everywhere, also by way of a `let`: no dart is named.
  std::string const parameter = "rule r(h: Real) on S { left { hook a <0,1>; let twice = 2 * h; let here = a.w; ";
  EXPECT_EQ(refusal(parameter + "require twice > 0 and h > 0; } right { a; } }", {0}, {-1.0}), "`r` is not applicable: `twice > 0 and h > 0` does not hold");
  EXPECT_EQ(refusal(parameter + "require twice > here; } right { a; } }", {0}, {-1.0}),
            "`r` is not applicable: `twice > here` does not hold where the hook `a` is dart 0");
  EXPECT_EQ(refusal("rule r(h: Real) on S { left { require h > 0; } right { } }", {}, {-1.0}), "`r` is not applicable: `h > 0` does not hold");
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
