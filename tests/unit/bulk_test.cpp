// A rule at all orbits at once: as the rule at each orbit, with values of the map before.
#include <gtest/gtest.h>

#include "compiler/analysis/independence.h"
#include "compiler/backend/interpreter/interpreter.h"
#include "jrule/bulk.h"
#include "jrule/io.h"
#include "tests/unit/polygons.h"
#include "tests/unit/rule_fixture.h"

namespace jrule {
namespace {

struct Bulk {
  ir::RuleScheme rule;
  analysis::Plan plan;
  rewrite::Workspace workspace{};

  explicit Bulk(std::string const& text) : rule(tests::program_of(text).rules.at(0)) {
    analysis::Verdict verdict = analysis::analyze(rule);
    if (!verdict.accepted()) throw std::runtime_error(tests::codes(verdict));
    plan = verdict.plan;
    for (auto const& reason : analysis::analyze_independence(rule, plan).reasons) throw std::runtime_error(reason.text);
  }
  Result<std::size_t> all(Map& map, std::vector<Value> const& values = {}) {
    auto const count = interpreter::apply_all(rule, plan, map, values, workspace);
    auto const violation = find_violation(map);
    EXPECT_FALSE(violation) << violation->text;
    return count;
  }
  Result<interpreter::Applied> at(Map& map, Dart hook) { return interpreter::apply(rule, plan, map, {hook}, {}, workspace); }
  /// Free polygons side by side; the values of each embedding are 0, 1, … by orbit.
  Map polygons(std::vector<std::uint32_t> const& sides) const { return tests::polygons(*rule.modeler, sides); }
};

double real_at(Map const& map, Dart d, std::size_t e = 0) { return std::get<double>(map.embedding(e).value(map.embedding(e).handle(d))); }
Handle handle_at(Map const& map, Dart d) { return map.embedding(0).handle(d); }

std::string const weights = "modeler S on gmap(2) { embedding w : <1,2> -> Real { merge mean; } }\n";
std::string const split = weights + "rule split on S { left { hook a <0,2>; } right { a <_,2>; b <_,2> { w = mean(<0>(a).w); } a -0- b; b -1[0]- b; } }";
std::string const cone = weights + "rule cone on S { left { hook a <0,1>; a -2- a; }"
                                   " right { a; b <0,_>; c <_,2>; d <1,2> { w = mean(<0,1>(a).w); } a -2- b -1- c -0- d; } }";

TEST(Bulk, EveryEdgeGetsItsMiddle) {
  Bulk rule(split);
  Map map = rule.polygons({3, 4});
  auto const count = rule.all(map);
  ASSERT_TRUE(count) << to_string(count.error());
  EXPECT_EQ(*count, 7U);
  EXPECT_EQ(map.dart_count(), 28U);
  EXPECT_EQ(summarize(map).cells, (std::vector<std::size_t>{14, 14, 2}));
  // The new darts are numbered as the old ones: 14 + d is beside d. Corners of the triangle are 0, 1, 2.
  for (Dart d = 0; d < 14; ++d) EXPECT_EQ(map.target(d, 0), 14 + d);
  EXPECT_EQ(real_at(map, 14), 0.5);
  EXPECT_EQ(real_at(map, 16), 1.5);
  EXPECT_EQ(handle_at(map, 14), handle_at(map, 15));
  EXPECT_EQ(real_at(map, 0), 0);
}

TEST(Bulk, ErasedDartsAreNoPartOfIt) {
  Bulk erase(weights + "rule erase on S { left { hook a <0,1>; a -2- a; } right { } }");
  Bulk rule(split);
  Map map = rule.polygons({5, 3, 4});
  ASSERT_TRUE(erase.at(map, 0));
  auto const count = rule.all(map);
  ASSERT_TRUE(count);
  EXPECT_EQ(*count, 7U);
  EXPECT_EQ(map.dart_count(), 28U);
  EXPECT_EQ(real_at(map, map.target(10, 0)), 5.5);
  // All of them erased: the map is empty, and there is nothing to do.
  EXPECT_EQ(*erase.all(map), 2U);
  EXPECT_EQ(map.dart_count(), 0U);
  EXPECT_EQ(*erase.all(map), 0U);
}

TEST(Bulk, OrbitsWhereTheRuleDoesNotApplyAreLeftOut) {
  Bulk rule(cone);
  Bulk sew2(weights + "rule close on S { left { hook a <0>; a -2- a; } right { a; a -2[0]- a; } }");
  Map map = rule.polygons({3, 4, 5});
  ASSERT_TRUE(sew2.at(map, 6));  // an edge of the square is no longer free
  auto const count = rule.all(map);
  ASSERT_TRUE(count);
  EXPECT_EQ(*count, 2U);
  EXPECT_EQ(map.dart_count(), 24U + 3 * 16);
  EXPECT_EQ(real_at(map, map.target(map.target(map.target(0, 2), 1), 0)), 1);   // of 0, 1, 2
  EXPECT_EQ(real_at(map, map.target(map.target(map.target(14, 2), 1), 0)), 9);  // of 7 … 11
  EXPECT_EQ(map.target(8, 2), 8U);
}

TEST(Bulk, TheFirstRefusalIfItAppliesNowhere) {
  Bulk rule(cone);
  Bulk close(weights + "rule close on S { left { hook a <0>; a -2- a; } right { a; a -2[0]- a; } }");
  Map map = rule.polygons({3, 4});
  ASSERT_EQ(*close.all(map), 7U);
  std::string const before = print_jmap(map);
  auto const count = rule.all(map);
  ASSERT_FALSE(count);
  EXPECT_EQ(count.error().kind, Error::Kind::not_applicable);
  EXPECT_EQ(count.error().message, rule.at(map, 0).error().message);
  EXPECT_EQ(print_jmap(map), before);
}

TEST(Bulk, ExpressionsSeeTheMapBefore) {
  Bulk smooth(weights + "rule smooth on S { left { hook a <1,2>; } right { a { w = mean(v@0.w for v in <1,2>(a)); } } }");
  Map map = smooth.polygons({3});
  EXPECT_EQ(*smooth.all(map), 3U);
  EXPECT_EQ(real_at(map, 0), 1.5);
  EXPECT_EQ(real_at(map, 2), 1);
  EXPECT_EQ(real_at(map, 4), 0.5);
}

TEST(Bulk, LetsAndRequirementsAreOfEachApplication) {
  Bulk rule("modeler S on gmap(2) { embedding w : <0,1> -> Real; }\n"
            "rule r(limit: Real) on S { left { hook a <0,1>; let n = count(<0,1>(a) by <0>); let t = n + a.w; require a.w < limit; require n > 3; }"
            " right { a { w = t; } } }");
  Map map = rule.polygons({4, 3, 5, 6});  // values 0, 1, 2, 3
  auto const count = rule.all(map, {2.5});
  ASSERT_TRUE(count);
  EXPECT_EQ(*count, 2U);
  EXPECT_EQ(real_at(map, 0), 4);
  EXPECT_EQ(real_at(map, 8), 1);
  EXPECT_EQ(real_at(map, 14), 7);
  EXPECT_EQ(real_at(map, 24), 3);
  EXPECT_EQ(rule.all(map, {0.0}).error().message, "`r` is not applicable: `a.w < limit` does not hold where the hook `a` is dart 0");
}

// What several applications merge into one orbit is merged once.
TEST(Bulk, MergedOrbitsGetTheMeanOfAllTheirValues) {
  Bulk fold(weights + "rule fold on S { left { hook a <0>; a -2- a; } right { a; a -2[0]- a; } }");
  Map map = fold.polygons({3, 4});
  EXPECT_EQ(*fold.all(map), 7U);
  for (Dart d = 0; d < 6; ++d) EXPECT_EQ(real_at(map, d), 1);
  for (Dart d = 6; d < 14; ++d) EXPECT_EQ(real_at(map, d), 4.5);
}

TEST(Bulk, SplitOrbitsKeepTheirValue) {
  Bulk open(weights + "rule open on S { left { hook a <0,2>; } right { a <0,_>; a -2- a; } }");
  Map map = open.polygons({3});
  map.link(0, 2, 2);  // so all corners are one
  map.link(1, 2, 3);
  Bulk set(weights + "rule set on S { left { hook a <1,2>; } right { a { w = 7.0; } } }");
  EXPECT_EQ(*set.all(map), 1U);
  EXPECT_EQ(*open.all(map), 2U);
  for (Dart d = 0; d < 6; ++d) EXPECT_EQ(real_at(map, d), 7);
}

// Darts that two applications match: each of the copies is told which darts are twice in it alone.
TEST(Bulk, ADartOfTwoApplicationsIsMatchedTwiceByNone) {
  Bulk mark("modeler S on gmap(2);\nrule mark on S { left { hook a <0>; b; a -1- b; } right { a; b; a -1- b; c; c -0- c; c -1- c; c -2- c; } }");
  Map map = mark.polygons({3, 1});  // the edge of the loop is its own neighbour
  auto const count = mark.all(map);
  ASSERT_TRUE(count);
  EXPECT_EQ(*count, 3U);
  EXPECT_EQ(map.dart_count(), 14U);
}

TEST(Bulk, PatternsOfAllApplications) {
  Bulk any(split);
  Map map = any.polygons({2, 1});
  rewrite::Workspace workspace;
  OrbitType const edge = orbit_of_dimensions({0, 2});
  auto all = rewrite::all_applications(map, edge);
  EXPECT_EQ(all.pattern, (std::vector<Dart>{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(all.number, (rewrite::Column{0, 0, 1, 1, 2, 2}));
  EXPECT_EQ(all.first, (std::vector<rewrite::Index>{0, 2, 4}));
  auto const kept = rewrite::without(all, {false, true, false});
  EXPECT_EQ(kept.pattern, (std::vector<Dart>{0, 1, 4, 5}));
  EXPECT_EQ(kept.number, (rewrite::Column{0, 0, 1, 1}));
  EXPECT_EQ(kept.first, (std::vector<rewrite::Index>{0, 2}));
  EXPECT_EQ(rewrite::without(all, {false, true, false}, std::vector<Dart>{5, 4, 3, 2, 1, 0}), (std::vector<Dart>{5, 4, 1, 0}));
  rewrite::mark_pattern(map, kept.pattern, workspace);
  EXPECT_EQ(rewrite::bulk_column(map, kept.pattern, {{0, false}}, workspace), (rewrite::Column{1, 0, 3, 2}));
  EXPECT_EQ(rewrite::bulk_column(map, all.pattern, {{0, false}, {1, false}}, workspace), (rewrite::Column{2, 3, 0, 1, 4, 5}));
  EXPECT_EQ(rewrite::bulk_column(map, all.pattern, {}, workspace), (rewrite::Column{0, 1, 2, 3, 4, 5}));
  for (Dart const d : {0U, 1U}) map.erase(d);
  all = rewrite::all_applications(map, edge);
  EXPECT_EQ(all.pattern, (std::vector<Dart>{2, 3, 4, 5}));
  EXPECT_EQ(all.number, (rewrite::Column{0, 0, 1, 1}));
  EXPECT_EQ(all.first, (std::vector<rewrite::Index>{0, 2}));
}

TEST(Bulk, OnlyWithOneHookAndOnMapsOfItsModeler) {
  Bulk rule(split);
  Map other(gmap(2));
  other.add_darts(1);
  EXPECT_EQ(rule.all(other).error().kind, Error::Kind::bad_input);
  Map map = rule.polygons({3});
  EXPECT_EQ(rule.all(map, {1.0}).error().kind, Error::Kind::bad_input);
}

}  // namespace
}  // namespace jrule
