// The verdicts where the printed algorithms err, and the plans of accepted rules.
#include <gtest/gtest.h>

#include "compiler/analysis/certify.h"
#include "compiler/analysis/counterexample/counterexample.h"
#include "tests/bench/stars.h"
#include "tests/certificate/checker.h"
#include "tests/unit/rule_fixture.h"

namespace jrule {
namespace {

using tests::codes;
using tests::program_of;
using Kind = analysis::OrbitComponent::Kind;

/// Accepted rules must have a certificate that the independent checker accepts.
analysis::Verdict verdict_on(ir::RuleScheme const& rule) {
  analysis::Verdict verdict = analysis::analyze(rule);
  if (verdict.accepted()) {
    EXPECT_EQ(certificate::fault(analysis::certify(rule), rule), std::nullopt);
  }
  return verdict;
}

std::string verdict_on(std::string const& modeler, std::string const& rule) {
  return codes(verdict_on(program_of("modeler M on " + modeler + ";\n" + rule).rules.at(0)));
}

// Erratum 1: of a cycle of length 2 the four-step word must be trivial, not the two-step one.
TEST(Errata, LoopsZeroAndTwoOnOneNodeCloseTheCycle0202) {
  EXPECT_EQ(verdict_on("gmap(2)", "rule r on M { left { hook a <0,1,2>; } right { a <0,1,2>; b <0,1,2>; } }"), "");
  EXPECT_EQ(verdict_on("gmap(2)", "rule r on M { left { hook a <0,1,2>; } right { a <0,1,2>; b <1,0,2>; } }"), "J0321");
}

// Erratum 2: a preserved node without a left i-arc has no i-arc to look for.
TEST(Errata, APreservedNodeWithoutLeftArcIsNotRefusedForIt) {
  // The 2-arcs of `a` are not matched; its 0-arc is replaced along a path that leads where the old one led.
  EXPECT_EQ(verdict_on("gmap(2)", "rule r on M { left { hook a <1>; } right { a <1>; } }"), "");
  EXPECT_EQ(verdict_on("gmap(2)", "rule r on M { left { hook a <1>; a -0- a; } right { a <1>; b; c; a -0- b; b -1- b; b -2- b; c -0- c; c -1- c; c -2- c; } }"), "J0324 J0323");
}

// Erratum 3: cycles of the left side are facts about any match, not obligations.
TEST(Errata, ALeftCycleWithAWordIsNoObligation) {
  // The left 0202-cycle from `a` has the word [1,1] = ε only for the loops given; deleting both nodes needs nothing on the right.
  EXPECT_EQ(verdict_on("gmap(2)", "rule r on M { left { hook a <0,1>; a -2- a; } right { } }"), "");
  EXPECT_EQ(verdict_on("gmap(2)", "rule r on M { left { hook a <1>; b <1>; a -0- b; a -2[1]- a; b -2- b; } right { } }"), "");
}

// Words that are equal in Γ are equal, however they are spelled.
TEST(Errata, WordsAreComparedInTheGroup) {
  EXPECT_EQ(verdict_on("gmap(2)", "rule r on M { left { hook a <0,1,2>; } right { a <0,1,2>; b <0,1,2>; c <0,1,2>; } }"), "");
  // 0·2 and 2·0 are one word: the reverse of an arc with [0,2] may be spelled [0,2] too.
  EXPECT_EQ(verdict_on("gmap(2)",
                       "rule r on M { left { hook a <0,1,2>; } right { a <0,1,2>; b <0,1,_>; c <0,1,_>; b -2[0,2]-> c; c -2[0,2]-> b; } }"),
            "");
  EXPECT_EQ(verdict_on("gmap(2)",
                       "rule r on M { left { hook a <0,1,2>; } right { a <0,1,2>; b <0,1,_>; c <0,1,_>; b -2[0,1]-> c; c -2[0,1]-> b; } }"),
            "J0313");
}

// What the benchmark measures is what it says: accepted rules of 20 nodes in dimension 4, and refused ones.
TEST(LargeRules, AreAcceptedAndWithAMistakeRefuted) {
  ir::Program const right = program_of(bench::stars()), wrong = program_of(bench::wrong_stars());
  ASSERT_EQ(right.rules.size(), 2U);
  EXPECT_EQ(right.rules[0].model(), gmap(4));
  EXPECT_EQ(right.rules[1].model(), omap(4));
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(right.rules[i].nodes.size(), 20U);
    EXPECT_EQ(codes(verdict_on(right.rules[i])), "");
    EXPECT_EQ(codes(verdict_on(wrong.rules[i])), i == 0 ? "J0321 J0321 J0321 J0321 J0321" : "J0321");
    EXPECT_TRUE(analysis::find_counterexample(wrong.rules[i]));
    EXPECT_FALSE(analysis::find_counterexample(right.rules[i], 200));
  }
}

TEST(IncidentArcs, AtMostOneArcOfADimension) {
  EXPECT_EQ(verdict_on("gmap(2)", "rule r on M { left { hook a <0,1,2>; } right { a <0,1,2>; a -1- a; } }"), "J0301");
}

TEST(NonOrientation, SingleArcsStandOnlyIfPreserved) {
  EXPECT_EQ(verdict_on("omap(2)", "rule r on M { left { hook a <1>; a -2-> a; } right { a; a -2-> a; } }"), "");
  EXPECT_EQ(verdict_on("omap(2)", "rule r on M { left { hook a <1,2>; } right { a <1,_>; b <~1,_>; a -2-> b; b -2[1]-> a; } }"), "J0313");
}

TEST(Cycles, CompletionUsesTheLeftSideOnly) {
  // a -0- b, a -2- c, b -2- d on the left imply c -0- d.
  EXPECT_EQ(verdict_on("gmap(2)",
                       "rule r on M { left { hook a <>; b; c; d; a -0- b; a -2- c; b -2- d; } right { a; b; c; d; a -0- b; a -2- c; b -2- d; } }"),
            "");
  // Unsewing the edge whole is sound; unsewing one end of it is not.
  EXPECT_EQ(verdict_on("gmap(2)",
                       "rule r on M { left { hook a <>; b; c; d; a -0- b; a -2- c; b -2- d; } right { a; b; c; d; a -0- b; a -2- a; b -2- b; c -2- c; d -2- d; } }"),
            "");
  EXPECT_EQ(verdict_on("gmap(2)", "rule r on M { left { hook a <>; c; a -2- c; } right { a; c; a -2- a; c -2- c; } }"), "J0324 J0323 J0323");
}

TEST(DeadLeft, ContradictionsAreErrors) {
  EXPECT_EQ(verdict_on("gmap(2)", "rule r on M { left { hook a <>; b; c; a -0-> b; b -0-> c; c -0-> a; } right { a; b; c; a -0-> b; b -0-> c; c -0-> a; } }"), "J0331");
  EXPECT_EQ(verdict_on("gmap(2)",
                       "rule r on M { left { hook a <>; b; c; d; e; a -0- b; a -2- c; b -2- d; c -0- e; } right { a; b; c; d; e; a -0- b; a -2- c; b -2- d; c -0- e; } }"),
            "J0332");
}

TEST(DeadLeft, TwoNodesAtOneDart) {
  EXPECT_EQ(verdict_on("gmap(2)", "rule r on M { left { hook a <0>; b <_>; a -1- b; } right { a; b; a -1- b; } }"), "");
  // The dart of `b` that the 1-arc of (u, a) leads to is that of u·1 in the pattern, so it is (u·1, a).
  EXPECT_EQ(verdict_on("gmap(2)", "rule r on M { left { hook a <>; b; a -1[1]- b; } right { a; b; a -1[1]- b; } }"), "J0334");
  EXPECT_EQ(verdict_on("gmap(2)", "rule r on M { left { hook a <1>; b; c; a -0- b; b -0[1]-> c; } right { a; b; c; a -0- b; b -0[1]-> c; } }"), "J0301");
  EXPECT_EQ(verdict_on("gmap(2)", "rule r on M { left { hook a <1>; b; a -0- b; c; b -1- c; d; c -0- d; } right { a; b; c; d; a -0- b; b -1- c; c -0- d; } }"), "");
  EXPECT_EQ(verdict_on("closed_gmap(2)", "rule r on M { left { hook a <0,1>; a -2- a; } right { a; a -2- a; } }"), "J0335");
}

// The left side says that 2 leads nowhere on the pattern, so [0,2] is [0] there.
TEST(ForcedRelations, ALoopOnTheHook) {
  std::string const left = "rule r on M { left { hook a <0,1>; a -2- a; } right { a; a -2- b; ";
  EXPECT_EQ(verdict_on("gmap(2)", left + "b <0,1>; } }"), "");
  EXPECT_EQ(verdict_on("gmap(2)", left + "b <_,1>; b -0[0,2]- b; } }"), "");
  EXPECT_EQ(verdict_on("gmap(2)", left + "b <_,1>; b -0[0,1,0]- b; } }"), "J0321");
}

// The pattern's darts are matched by the second hook along 0 and 2, which commute, so 0 and 1 commute on the pattern.
TEST(ForcedRelations, AFurtherHookWhoseDimensionsCommute) {
  std::string const first = "rule r on M { left { hook a <0,1>; ";
  EXPECT_EQ(verdict_on("gmap(2)", first + "hook b <0,2>; } " + "right { a; b; c <0,2>; c -1- c; } }"), "");
  EXPECT_EQ(verdict_on("gmap(2)", first + "hook b <0,1>; } " + "right { a; b; c <0,2>; c -1- c; } }"), "J0321");
}

// The left side says that 0 is ε on the pattern, the word [2,0] that the pattern is closed under 2 then: so y has a 2-arc in the
// pattern, which C(0,2) needs.
TEST(ForcedRelations, WordsCloseThePatternUnderTheirLetters) {
  EXPECT_EQ(verdict_on("gmap(2)", "rule r on M { left { hook y <>; y -0- y; } right { y; n; y -0- n; n -1- n; n -2[2,0]- n; } }"), "");
  EXPECT_EQ(verdict_on("gmap(2)", "rule r on M { left { hook y <>; y -0- y; } right { y; n; y -0- n; n -1- n; n -2[1,0,1]- n; } }"), "J0324 J0323");
}

// 1·3 leads from the pattern into the pattern, though neither 1 nor 3 does.
TEST(ForcedRelations, AWordAsAWhole) {
  EXPECT_EQ(verdict_on("omap(3)", "rule r on M { left { hook a <>; b; a -1-> b; } right { a; b; a -1[1,3]-> b; } }"), "");
  EXPECT_EQ(verdict_on("omap(3)", "rule r on M { left { hook a <>; b; a -1-> b; } right { a; b; a -1[1,2]-> b; } }"), "J0324 J0323");
}

// The copies of b are reached from one of them along its loops: it has none, so the pattern is one dart.
TEST(ForcedRelations, AFurtherHookWithoutLoops) {
  EXPECT_EQ(verdict_on("omap(2)", "rule r on M { left { hook a <>; hook b <>; a -2- a; } right { a; b; a -2[1]-> a; } }"), "");
  EXPECT_EQ(verdict_on("omap(2)", "rule r on M { left { hook a <>; a -2- a; } right { a; a -2[1]-> a; } }"), "J0313");
}

TEST(Closed, AMatchedArcMovesEveryDart) {
  std::string const right = "right { n; n -0[0,2]- n; n -1[0]- n; n -2[2]- n; } }";
  EXPECT_EQ(verdict_on("closed_gmap(2)", "rule r on M { left { hook a <0,2>; a -1[0,2]- a; } " + right), "");
  EXPECT_EQ(verdict_on("closed_gmap(2)", "rule r on M { left { hook a <0,2>; a -1[0]- a; } " + right), "J0341");
}

TEST(Closed, NoLoopIsMatched) {
  EXPECT_EQ(verdict_on("closed_gmap(2)", "rule r on M { left { hook a <0>; hook b <0>; a -2[0]- a; b -2- b; } right { a; b; a -2[0]- a; b -2[0]- b; } }"), "J0335");
}

TEST(Closed, LoopsAreRefusedUnlessTheWordMovesEveryDart) {
  EXPECT_EQ(verdict_on("closed_gmap(2)", "rule r on M { left { hook a <0,1,2>; } right { a <0,1,2>; b <0,1,_>; b -2- b; } }"), "J0333");
  EXPECT_EQ(verdict_on("closed_gmap(2)", "rule r on M { left { hook a <0,1,2>; } right { a <0,1,2>; b <0,1,2>; } }"), "");
  EXPECT_EQ(verdict_on("closed_gmap(2)", "rule r on M { left { hook a <0,1,2>; } right { a <0,1,2>; b <0,_,2>; b -1[0,2]- b; } }"), "J0341");
}

// ---- Plans ----

analysis::Verdict analyse(std::string const& text) { return verdict_on(program_of(text).rules.at(0)); }

TEST(Plan, QuadSubdivision) {
  auto const verdict = analyse(
      "modeler S on gmap(2) { embedding position : <1,2> -> Point3; embedding color : <0,1> -> Color; }\n"
      "rule q on S { left { hook a <0,1,2>; } right { a <_,1,2>; b <_,_,2> { position = mean(<0>(a).position); } c <2,_,_>; "
      "d <2,1,_> { position = mean(<0,1>(a).position); } a -0- b -1- c -0- d; } }");
  ASSERT_EQ(codes(verdict), "");
  auto const& plan = verdict.plan;
  EXPECT_TRUE(plan.checks.empty());
  EXPECT_FALSE(plan.test_injectivity);
  EXPECT_EQ(plan.added, (std::vector<ir::NodeId>{1, 2, 3}));
  ASSERT_EQ(plan.orbits.size(), 3U);
  // A new vertex for each edge of the pattern, one for each face; the quads keep the colour of their face.
  EXPECT_EQ(plan.orbits[0].kind, Kind::fresh);
  EXPECT_EQ(plan.orbits[0].members.size(), 2U);
  EXPECT_EQ(plan.orbits[0].generators, (std::vector<Word>{{{2, false}}, {{0, false}}}));
  EXPECT_EQ(plan.orbits[1].kind, Kind::fresh);
  EXPECT_EQ(plan.orbits[1].members.size(), 1U);
  EXPECT_EQ(plan.orbits[2].embedding, 1U);
  EXPECT_EQ(plan.orbits[2].kind, Kind::inherit);
  EXPECT_EQ(plan.orbits[2].sources.size(), 3U);
}

TEST(Plan, LeftArcsThatHoldEverywhereAreNotTested) {
  auto const verdict = analyse(
      "modeler S on gmap(2);\n"
      "rule r on S { left { hook a <0>; b <0>; a -2- b; } right { a <0>; b <0>; a -2- b; } }");
  ASSERT_EQ(codes(verdict), "");
  EXPECT_EQ(verdict.plan.steps.size(), 1U);
  EXPECT_TRUE(verdict.plan.checks.empty());  // b's 0-loop holds since 0 and 2 commute
  EXPECT_TRUE(verdict.plan.test_injectivity);
}

TEST(Plan, FoldingAnEdgeMergesItsVertices) {
  std::string const rule = "rule fold on S { left { hook a <0>; a -2- a; } right { a; a -2[0]- a; } }";
  EXPECT_EQ(codes(analyse("modeler S on gmap(2) { embedding position : <1,2> -> Point3; }\n" + rule)), "J0402");
  auto const verdict = analyse("modeler S on gmap(2) { embedding position : <1,2> -> Point3 { merge mean; } }\n" + rule);
  ASSERT_EQ(codes(verdict), "");
  ASSERT_EQ(verdict.plan.orbits.size(), 1U);
  EXPECT_EQ(verdict.plan.orbits[0].kind, Kind::merge);
}

TEST(Plan, SplitOrbitsNeedNothing) {
  auto const verdict = analyse(
      "modeler S on gmap(2) { embedding position : <1,2> -> Point3; }\n"
      "rule unsew on S { left { hook a <0>; b <0>; a -2- b; } right { a; b; a -2- a; b -2- b; } }");
  ASSERT_EQ(codes(verdict), "");
  EXPECT_TRUE(verdict.plan.orbits.empty());
}

}  // namespace
}  // namespace jrule
