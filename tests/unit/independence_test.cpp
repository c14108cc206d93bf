// Which rules may be applied at all orbits of their hook at once, and why others may not.
#include <gtest/gtest.h>

#include "compiler/analysis/independence.h"
#include "tests/unit/rule_fixture.h"

namespace jrule {
namespace {

std::string const surface =
    "modeler M on gmap(2) { embedding position : <1,2> -> Point3; embedding color : <0,1> -> Color { default Color(1,1,1); merge mean; } }\n";

/// The reasons, one a line; empty if the rule is independent.
std::string reasons(std::string const& modeler, std::string const& text) {
  ir::RuleScheme const rule = tests::program_of(modeler + text).rules.at(0);
  analysis::Verdict const verdict = analysis::analyze(rule);
  if (!verdict.accepted()) return "not accepted: " + tests::codes(verdict);
  std::string result;
  for (analysis::Dependence const& reason : analysis::analyze_independence(rule, verdict.plan).reasons) {
    EXPECT_FALSE(reason.span.file == source::no_file);
    result += reason.text + '\n';
  }
  return result;
}
std::string on_surface(std::string const& rule) { return reasons(surface, rule); }
std::string on(std::string const& model, std::string const& rule) { return reasons("modeler M on " + model + ";\n", rule); }

TEST(Independence, RulesThatMatchOnlyTheirHooksOrbit) {
  EXPECT_EQ(on_surface("rule triangulate on M { left { hook a <0,1>; } right { a <0,_>; b <_,2>; c <1,2> { position = mean(<0,1>(a).position); }"
                       " a -1- b -0- c; } }"), "");
  EXPECT_EQ(on_surface("rule split_edges on M { left { hook a <0,2>; } right { a <_,2>; b <_,2> { position = mean(<0>(a).position); }"
                       " a -0- b; b -1[0]- b; } }"), "");
  EXPECT_EQ(on_surface("rule cone on M { left { hook a <0,1>; a -2- a; } right { a; b <0,_>; c <_,2>; d <1,2> { position = Point3(0,0,1); }"
                       " a -2- b -1- c -0- d; } }"), "");
  EXPECT_EQ(on_surface("rule unsew on M { left { hook a <0,2>; } right { a <0,_>; a -2- a; } }"), "");
  EXPECT_EQ(on_surface("rule delete on M { left { hook a <0,1>; a -2- a; } right { } }"), "");
}

TEST(Independence, RulesThatMatchWholeComponents) {
  EXPECT_EQ(on_surface("rule quads on M { left { hook a <0,1,2>; } right { a <_,1,2>; b <_,_,2> { position = mean(<0>(a).position); } c <2,_,_>;"
                       " d <2,1,_> { position = mean(<0,1>(a).position); } a -0- b -1- c -0- d; } }"), "");
  // Vertices of an O-map are orbits of a word of two letters, along which a rule may change both arcs.
  EXPECT_EQ(reasons("modeler M on omap(2) { embedding position : vertex -> Point3 { default Point3(0,0,0); } }\n",
                    "rule quads on M { left { hook a <1,2>; } right { a <_,_>; b; c; d; a -1-> c; c -1[~1]-> d; d -1-> b; b -1[1]-> a;"
                    " a -2[2]- b; c -2- d; } }"), "");
}

TEST(Independence, AValueIsGivenByOneApplication) {
  EXPECT_EQ(on_surface("rule paint(c: Color) on M { left { hook a <0,1>; } right { a { color = c; } } }"), "");
  EXPECT_EQ(on_surface("rule smooth on M { left { hook a <1,2>; } right { a { position = mean(<1,2>(a@0).position); } } }"), "");
  EXPECT_EQ(on_surface("rule flatten on M { left { hook a <0,1>; } right { a { position = mean(<0,1>(a).position); } } }"),
            "the vertex of `a` may reach other applications, which give it a value of `position` too: the rule does not match the 2-arcs of `a`\n");
}

TEST(Independence, MergesMayMeet) {
  EXPECT_EQ(reasons("modeler M on gmap(2) { embedding w : <1,2> -> Real { merge mean; } }\n",
                    "rule fold on M { left { hook a <0>; a -2- a; } right { a; a -2[0]- a; } }"), "");
}

TEST(Independence, OneHookAndItsOrbit) {
  EXPECT_EQ(on("gmap(2)", "rule square on M { left { } right { a; a -0- a; a -1- a; a -2- a; } }"),
            "`square` has no hook: there are no orbits to apply it at\n");
  EXPECT_EQ(on("gmap(2)", "rule sew2 on M { left { hook a <0>; hook b <0>; a -2- a; b -2- b; } right { a; b; a -2- b; } }"),
            "`sew2` has 2 hooks: it is applied at darts that are chosen together, not at each orbit\n");
  EXPECT_EQ(on("gmap(2)", "rule double on M { left { hook a <0>; } right { a; b <0>; b -1- b; b -2[2]- b; } }"),
            "the word [2] may lead from one orbit <0> to another, so that applications at both have the same pattern\n");
}

TEST(Independence, SharedDartsAreDeleted) {
  EXPECT_EQ(on("gmap(2)", "rule remove_edge on M { left { hook a <0,2>; b; a -1- b; } right { b; b -1[2]- b; } }"),
            "a dart may be `a` of one application and `b` of another, and `a` is deleted\n");
}

TEST(Independence, SharedArcsAreRemoved) {
  EXPECT_EQ(on("omap(2)", "rule flip on M { left { hook a <2>; b; c; a -1-> b -1-> c -1-> a; }"
                          " right { a; b; c; a -1-> c; c -1[2]-> b; b -1[2]-> a; } }"),
            "a dart may be `a` of one application and `b` of another, and both remove its 1-arc\n"
            "a dart may be `a` of one application and `c` of another, and both remove its 1-arc\n"
            "a dart may be `b` of one application and `c` of another, and both remove its 1-arc\n");
  // Opened from both sides.
  EXPECT_EQ(on("gmap(2)", "rule unsew on M { left { hook a <0>; b <0>; a -2- b; } right { a; b; a -2- a; b -2- b; } }"),
            "a dart may be `a` of one application and `b` of another, and both remove its 2-arc\n");
  // What one application removes, another needs as it is.
  std::string const near =
      on("gmap(2)", "rule near on M { left { hook a <>; b; c; d; a -1- b; a -0- c -1- d; } right { a; b; c; d; a -0- c -1- d; a -1- a; b -1- b; } }");
  EXPECT_EQ(near.substr(0, near.find("a dart may be `a` of one application and `d`")),
            "a dart may be `a` of one application and `b` of another, and both remove its 1-arc\n"
            "a dart may be `a` of one application and `c` of another: both match its 1-arc, and that of `a` is removed\n");
}

TEST(Independence, SharedDartsThatNobodyChangesDoNoHarm) {
  EXPECT_EQ(on("gmap(2)", "rule mark on M { left { hook a <0>; b; a -1- b; } right { a; b; a -1- b; c; c -0- c; c -1- c; c -2- c; } }"), "");
  // The arc that one application removes, the other does not look at.
  EXPECT_EQ(on("gmap(2)", "rule cut on M { left { hook a <0,2>; b; a -1- b; } right { a <_,2>; b; a -1- b; c <_,2>; a -0- c; c -1- c; } }"), "");
  // Every half face takes its colour from the one opposite; none is given two.
  std::string const faces = "modeler M on gmap(3) { embedding color : <0,1> -> Color; }\n";
  EXPECT_EQ(reasons(faces, "rule copy on M { left { hook a <0,1>; b <0,1>; a -3- b; } right { a; b { color = a.color; } a -3- b; } }"), "");
  EXPECT_EQ(reasons(faces, "rule swap on M { left { hook a <0,1>; b <0,1>; a -3- b; } right { a { color = b.color; } b { color = a.color; } a -3- b; } }"),
            "a dart may be `a` of one application and `b` of another, and both give its orbit <0,1> a value of `color`\n");
}

// What the left side asks of its nodes may keep a dart from being matched by two of them.
TEST(Independence, NodesThatDifferShareNothing) {
  // The 2-arc of `a` is a loop, those of `b` and `c` are not.
  EXPECT_EQ(on("gmap(2)", "rule lengthen on M { left { hook a <>; b; c; a -2- a; a -1- b; b -2- c; }"
                          " right { a; b; c; a -2- a; b -2- c; m; n; a -1- m -0- n -1- b; m -2- m; n -2- n; } }"), "");
  EXPECT_EQ(on("gmap(2)", "rule lengthen on M { left { hook a <>; b; c; a -1- b; b -2- c; }"
                          " right { a; b; c; b -2- c; m; n; a -1- m -0- n -1- b; m -2- m; n -2- n; } }"),
            "a dart may be `a` of one application and `b` of another, and both remove its 1-arc\n");
}

TEST(Independence, SubdivisionsOfTheLibrary) {
  source::Sources sources;
  source::Diagnostics diagnostics;
  auto const modules = sema::load(JRULE_SOURCE_DIR "/stdlib/std/subdivision.jrule", {JRULE_SOURCE_DIR "/stdlib", {}}, sources, diagnostics);
  ir::Program const program = sema::elaborate(modules, diagnostics);
  EXPECT_FALSE(diagnostics.has_errors());
  EXPECT_GE(program.rules.size(), 7U);
  for (ir::RuleScheme const& rule : program.rules) {
    EXPECT_TRUE(analysis::analyze_independence(rule, analysis::analyze(rule).plan).independent()) << rule.name;
  }
}

TEST(Independence, ReasonsNameWhatTheyAreAbout) {
  ir::RuleScheme const rule =
      tests::program_of("modeler M on gmap(2);\nrule r on M { left { hook a <0>; b <0>; a -2- b; } right { a; b; a -2- a; b -2- b; } }").rules.at(0);
  auto const independence = analysis::analyze_independence(rule, analysis::analyze(rule).plan);
  ASSERT_EQ(independence.reasons.size(), 1U);
  analysis::Dependence const& reason = independence.reasons[0];
  EXPECT_EQ(reason.kind, analysis::Dependence::Kind::arc);
  EXPECT_EQ(reason.first, 0U);
  EXPECT_EQ(reason.second, 1U);
  EXPECT_EQ(reason.dimension, 2);
  EXPECT_EQ(reason.span, rule.left.arcs.at(2).span);
}

}  // namespace
}  // namespace jrule
