// The oracle itself, on cases worked out by hand.
#include <gtest/gtest.h>

#include "tests/property/rule_builder.h"
#include "tests/reference/engine.h"
#include "tests/reference/values.h"

namespace jrule::reference {

namespace {

using property::On;
using property::RuleBuilder;
using property::word;

std::shared_ptr<ir::Modeler const> on(Model const& model) {
  auto modeler = std::make_shared<ir::Modeler>();
  modeler->model = model;
  return modeler;
}

/// A directed cycle of an O-map's 1-arcs; 2-arcs are loops.
PlainMap ring(Dart size) {
  PlainMap map{{1, 2}, {}};
  for (Dart d = 0; d < size; ++d) map.targets[d] = {{1, {(d + 1) % size}}, {2, {d}}};
  return map;
}

/// Every 1-arc gets a dart of its own in the middle, joined in a ring of their own: u -1-> a new dart, and 2-arcs.
ir::RuleScheme doubling() {
  RuleBuilder rule(on(omap(2)), "doubling", {1});
  ir::NodeId const a = rule.rewired_hook(), b = rule.node(On::right);
  rule.arc(On::right, a, 1, b).arc(On::right, b, 1, a, word(1)).arc(On::right, b, 2, b);
  return rule.build();
}

}  // namespace

TEST(ReferenceEngine, InstantiatesWordsAlongThePattern) {
  auto const derivation = derive(doubling(), ring(3), {1});
  ASSERT_TRUE(derivation);
  // Copies in the order of the darts: the new dart after u is 3 + u, and leads to u + 1.
  for (Dart u = 0; u < 3; ++u) {
    EXPECT_EQ(derivation->copies.at({u, 1}), 3 + u);
    EXPECT_EQ(derivation->result.targets.at(u).at(1), std::vector<Dart>{3 + u});
    EXPECT_EQ(derivation->result.targets.at(3 + u).at(1), std::vector<Dart>{(u + 1) % 3});
    EXPECT_EQ(derivation->result.targets.at(u).at(2), std::vector<Dart>{u});
  }
  EXPECT_FALSE(violation(derivation->result, omap(2)));
}

TEST(ReferenceEngine, ThePatternIsTheHooksOrbitOnly) {
  PlainMap map = ring(2);
  map.targets[7] = {{1, {7}}, {2, {7}}};
  auto const derivation = derive(doubling(), map, {7});
  ASSERT_TRUE(derivation);
  EXPECT_EQ(derivation->result.targets.size(), 4U);
  EXPECT_EQ(derivation->result.targets.at(0), map.targets.at(0));
}

TEST(ReferenceEngine, MatchesWithoutIdentifyingDarts) {
  RuleBuilder rule(on(omap(2)), "skip", {});
  ir::NodeId const a = rule.hook(On::both), b = rule.node(On::both);
  rule.arc(On::both, a, 1, b);
  EXPECT_TRUE(derive(rule.build(), ring(2), {0}));
  EXPECT_FALSE(derive(rule.build(), ring(1), {0}));
}

TEST(ReferenceEngine, LeavesNoArcDangling) {
  RuleBuilder whole(on(omap(1)), "whole", {}), part(on(omap(1)), "part", {});
  whole.arc(On::left, whole.hook(On::left), 1, 0);
  part.hook(On::left);
  PlainMap map{{1}, {}};
  map.targets[0] = {{1, {0}}};
  ASSERT_TRUE(derive(whole.build(), map, {0}));
  EXPECT_TRUE(derive(whole.build(), map, {0})->result.targets.empty());
  EXPECT_FALSE(derive(part.build(), map, {0}));
}

TEST(ReferenceEngine, WalksFurtherHooksInStep) {
  RuleBuilder rule(on(omap(2)), "opposite", {1});
  rule.hook(On::both);
  rule.hook(On::both, {property::letter(1, true)});
  PlainMap map = ring(3);
  for (Dart d = 0; d < 4; ++d) map.targets[10 + d] = {{1, {10 + (d + 1) % 4}}, {2, {10 + d}}};
  for (Dart d = 0; d < 3; ++d) map.targets[20 + d] = {{1, {20 + (d + 1) % 3}}, {2, {20 + d}}};
  auto const derivation = derive(rule.build(), map, {0, 21});
  ASSERT_TRUE(derivation);
  EXPECT_EQ(derivation->copies.at({0, 1}), 21U);
  EXPECT_EQ(derivation->copies.at({1, 1}), 20U);
  EXPECT_EQ(derivation->copies.at({2, 1}), 22U);
  EXPECT_FALSE(derive(rule.build(), map, {0, 10}));  // three darts against four
  EXPECT_FALSE(derive(rule.build(), map, {0, 1}));   // the same darts
}

TEST(ReferenceEngine, ShowsWhatAnUnsoundRuleDoes) {
  RuleBuilder rule(on(gmap(2)), "half", {});
  ir::NodeId const a = rule.hook(On::both), b = rule.node(On::both);
  rule.arc(On::left, a, 2, b).loops(On::right, a, {2}).loops(On::right, b, {2});
  // An edge of two faces: 0 -0- 1, 0 -2- 2, 1 -2- 3, 2 -0- 3; cutting one of its two 2-arcs.
  PlainMap map{{0, 1, 2}, {}};
  for (Dart d = 0; d < 4; ++d) map.targets[d] = {{0, {d ^ 1U}}, {1, {d}}, {2, {d ^ 2U}}};
  ASSERT_FALSE(violation(map, gmap(2)));
  auto const derivation = derive(rule.build(), map, {0});
  ASSERT_TRUE(derivation);
  EXPECT_EQ(violation(derivation->result, gmap(2)), "the path 0202 from dart 0 does not return");
}

/// Sews a dart of an O-map to the next one, and adds a dart whose face gets its value from a clause.
TEST(ReferenceValues, OfKeptMergedAndNewOrbitsAndOfClauses) {
  auto modeler = std::make_shared<ir::Modeler>();
  modeler->model = omap(2);
  modeler->embeddings = {{"edge", orbit_of_dimensions({2}), Type::Real, Value(-1.0), MergePolicy::mean},
                         {"face", orbit_of_dimensions({1}), Type::Int, Value(std::int64_t{-1}), MergePolicy::first}};
  RuleBuilder rule(modeler, "sew_and_more", {});
  ir::NodeId const a = rule.hook(On::both), b = rule.node(On::both), c = rule.node(On::right);
  rule.arc(On::both, a, 1, b).loops(On::left, a, {2}).loops(On::left, b, {2}).arc(On::right, a, 2, b);
  rule.loops(On::right, c, {1, 2});
  ir::RuleScheme scheme = rule.build();
  // The value of the face behind b, plus one.
  auto const expr = [](auto node, ir::ExprType type) {
    return std::make_shared<ir::Expr const>(ir::Expr{type, std::move(node), {}});
  };
  ir::ExprType const integer{Type::Int, false, false};
  auto const next = expr(ir::Walk{expr(ir::NodeDart{b}, ir::dart_type), word(1)}, ir::dart_type);
  scheme.clauses.push_back(
      {c, 1,
       expr(ir::Apply{ir::Builtin::add, {expr(ir::ValueAt{1, next}, integer), expr(ir::Constant{std::int64_t{1}}, integer)}},
            integer),
       {}});
  PlainMap const map = ring(3);
  PlainValues const values{{{0, 10.0}, {1, 20.0}, {2, 60.0}},
                           {{0, std::int64_t{5}}, {1, std::int64_t{5}}, {2, std::int64_t{5}}}};
  auto const derivation = derive(scheme, map, {0});
  ASSERT_TRUE(derivation);
  auto const orbits = orbit_values(scheme, map, values, *derivation);
  ASSERT_EQ(orbits.size(), 5U);
  using Source = OrbitValues::Source;
  auto const expect = [&](std::size_t o, Source source, std::vector<Dart> const& darts, Value const& value) {
    EXPECT_EQ(orbits[o].source, source);
    EXPECT_EQ(orbits[o].darts, darts);
    EXPECT_EQ(orbits[o].allowed, std::vector<Value>{value});
  };
  expect(0, Source::merged, {0, 1}, 15.0);
  expect(1, Source::kept, {2}, 60.0);
  expect(2, Source::fresh, {3}, -1.0);
  expect(3, Source::kept, {0, 1, 2}, std::int64_t{5});
  expect(4, Source::clause, {3}, std::int64_t{6});
}

TEST(PlainMap, ViolationsOfEveryKind) {
  PlainMap map{{1, 2}, {}};
  map.targets[0] = {{1, {1}}, {2, {0}}};
  map.targets[1] = {{1, {0}}, {2, {}}};
  EXPECT_EQ(violation(map, omap(2)), "dart 1 has 0 outgoing 2-arcs");
  map.targets[1][2] = {0};
  EXPECT_EQ(violation(map, omap(2)), "dart 0 has 2 incoming 2-arcs");
  map.targets[1][2] = {1};
  EXPECT_FALSE(violation(map, omap(2)));
  PlainMap triangle{{1}, {}};
  for (Dart d = 0; d < 3; ++d) triangle.targets[d] = {{1, {(d + 1) % 3}}};
  Model model = omap(1);
  EXPECT_FALSE(violation(triangle, model));
  model.oriented = 0;
  EXPECT_EQ(violation(triangle, model), "the 1-arc of dart 0 has no reverse");
  PlainMap point{{0}, {}};
  point.targets[0] = {{0, {0}}};
  EXPECT_FALSE(violation(point, gmap(0)));
  EXPECT_EQ(violation(point, closed_gmap(0)), "the 0-arc of dart 0 is a loop");
}

TEST(PlainMap, IsomorphismKeepsFixedDartsAndColours) {
  PlainMap const a = ring(3);
  PlainMap b{{1, 2}, {}};
  for (Dart d = 0; d < 3; ++d) b.targets[10 * d] = {{1, {10 * ((d + 1) % 3)}}, {2, {10 * d}}};
  EXPECT_TRUE(isomorphic(a, b, {}, {}, {}));
  EXPECT_TRUE(isomorphic(a, b, {{0, 10}, {1, 20}}, {}, {}));
  EXPECT_FALSE(isomorphic(a, b, {{0, 10}, {1, 0}}, {}, {}));
  EXPECT_TRUE(isomorphic(a, b, {}, {{0, 5}}, {{20, 5}}));
  EXPECT_FALSE(isomorphic(a, b, {}, {{0, 5}}, {{20, 6}}));
  EXPECT_FALSE(isomorphic(a, b, {}, {{0, 5}}, {}));
  EXPECT_FALSE(isomorphic(a, ring(4), {}, {}, {}));
  PlainMap other = a;
  other.targets[0][2] = {1};
  other.targets[1][2] = {0};
  EXPECT_FALSE(isomorphic(a, other, {}, {}, {}));
}

}  // namespace jrule::reference
