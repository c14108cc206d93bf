// What `jrule emit certificate` prints, to the letter.
#include <gtest/gtest.h>

#include "compiler/analysis/certify.h"
#include "compiler/sema/elaborate.h"
#include "compiler/syntax/parse.h"

namespace jrule::certificate {
namespace {

std::string printed(std::string const& text) {
  source::Sources sources;
  source::Diagnostics diagnostics;
  sema::Modules modules;
  modules.all.push_back({"surface", syntax::parse(sources, sources.add("surface.jrule", text), diagnostics)});
  ir::Program const program = sema::elaborate(modules, diagnostics);
  EXPECT_FALSE(diagnostics.has_errors());
  return analysis::print(analysis::certify(program.rules.at(0)), program.rules.at(0), sources);
}

std::string const legend = R"(# L1, R1, I1: an arc of the left side, of the right side, one that the left side implies and that is on both sides
# (p,q) between two words: letter q moves to letter p, past exchangeable ones, and both cancel; an oriented letter turns
# round, 1 to ~1, where it passes or is passed. That two words are equal is shown by the first times the conjugate of the second
)";

TEST(Printed, QuadSubdivision) {
  EXPECT_EQ(printed(R"(modeler Surface on gmap(2);
rule quad_subdivision on Surface {
  left  { hook a <0,1,2>; }
  right {
    a <_,1,2>;
    b <_,_,2>;
    c <2,_,_>;
    d <2,1,_>;
    a -0- b -1- c -0- d;
  }
}
)"),
            "certificate of the rule quad_subdivision on Surface, for a 2-G-map  surface.jrule:2\n" + legend + R"(left side
  L1  a -0[0]-> a  surface.jrule:3
  L2  a -1[1]-> a  surface.jrule:3
  L3  a -2[2]-> a  surface.jrule:3
right side
  R1  a -1[1]-> a  surface.jrule:5
  R2  a -2[2]-> a  surface.jrule:5
  R3  b -2[2]-> b  surface.jrule:6
  R4  c -2[0]-> c  surface.jrule:7
  R5  d -2[0]-> d  surface.jrule:8
  R6  d -1[1]-> d  surface.jrule:8
  R7  a -0-> b  surface.jrule:9
  R8  b -0-> a  surface.jrule:9
  R9  b -1-> c  surface.jrule:9
  R10  c -1-> b  surface.jrule:9
  R11  c -0-> d  surface.jrule:9
  R12  d -0-> c  surface.jrule:9
incident arcs (paper, Def. 22)
  preserved node a, dimension 0: out L1 before and R7 after; in L1 before and R8 after
  preserved node a, dimension 1: out L2 before and R1 after; in L2 before and R1 after
  preserved node a, dimension 2: out L3 before and R2 after; in L3 before and R2 after
  added node b, dimension 0: out R8; in R7
  added node b, dimension 1: out R9; in R10
  added node b, dimension 2: out R3; in R3
  added node c, dimension 0: out R11; in R12
  added node c, dimension 1: out R10; in R9
  added node c, dimension 2: out R4; in R4
  added node d, dimension 0: out R12; in R11
  added node d, dimension 1: out R6; in R6
  added node d, dimension 2: out R5; in R5
reverses of added and deleted arcs (paper, Def. 24)
  L1 reverses itself: [0,0] (1,2) ε
  R3 reverses itself: [2,2] (1,2) ε
  R4 reverses itself: [0,0] (1,2) ε
  R5 reverses itself: [0,0] (1,2) ε
  R6 reverses itself: [1,1] (1,2) ε
  R8 reverses R7: ε
  R10 reverses R9: ε
  R12 reverses R11: ε
cycles through added and deleted arcs (paper, Def. 27)
  left cycle 0202 from a: L1 L3 L1 L3
  added cycle 2020 from b: R3 R8 R2 R7: [2,2] (1,2) ε
  added cycle 2020 from c: R4 R11 R5 R12: [0,0] (1,2) ε
)");
}

TEST(Printed, Cone) {
  EXPECT_EQ(printed(R"(modeler Surface on gmap(2);
rule cone on Surface {
  left  { hook a <0,1>; a -2- a; }
  right {
    a; b <0,_>; c <_,2>; d <1,2>;
    a -2- b -1- c -0- d;
  }
}
)"),
            "certificate of the rule cone on Surface, for a 2-G-map  surface.jrule:2\n" + legend + R"(left side
  L1  a -0[0]-> a  surface.jrule:3
  L2  a -1[1]-> a  surface.jrule:3
  L3  a -2-> a  surface.jrule:3
right side
  R1  a -0[0]-> a  surface.jrule:5
  R2  a -1[1]-> a  surface.jrule:5
  R3  b -0[0]-> b  surface.jrule:5
  R4  c -2[1]-> c  surface.jrule:5
  R5  d -1[0]-> d  surface.jrule:5
  R6  d -2[1]-> d  surface.jrule:5
  R7  a -2-> b  surface.jrule:6
  R8  b -2-> a  surface.jrule:6
  R9  b -1-> c  surface.jrule:6
  R10  c -1-> b  surface.jrule:6
  R11  c -0-> d  surface.jrule:6
  R12  d -0-> c  surface.jrule:6
incident arcs (paper, Def. 22)
  preserved node a, dimension 0: out L1 before and R1 after; in L1 before and R1 after
  preserved node a, dimension 1: out L2 before and R2 after; in L2 before and R2 after
  preserved node a, dimension 2: out L3 before and R7 after; in L3 before and R8 after
  added node b, dimension 0: out R3; in R3
  added node b, dimension 1: out R9; in R10
  added node b, dimension 2: out R8; in R7
  added node c, dimension 0: out R11; in R12
  added node c, dimension 1: out R10; in R9
  added node c, dimension 2: out R4; in R4
  added node d, dimension 0: out R12; in R11
  added node d, dimension 1: out R5; in R5
  added node d, dimension 2: out R6; in R6
reverses of added and deleted arcs (paper, Def. 24)
  L3 reverses itself: ε
  R3 reverses itself: [0,0] (1,2) ε
  R4 reverses itself: [1,1] (1,2) ε
  R5 reverses itself: [0,0] (1,2) ε
  R6 reverses itself: [1,1] (1,2) ε
  R8 reverses R7: ε
  R10 reverses R9: ε
  R12 reverses R11: ε
cycles through added and deleted arcs (paper, Def. 27)
  left cycle 2020 from a: L3 L1 L3 L1
  added cycle 0202 from b: R3 R8 R1 R7: [0,0] (1,2) ε
  added cycle 2020 from c: R4 R11 R6 R12: [1,1] (1,2) ε
)");
}

void expect_lines(std::string const& text, std::string const& lines) {
  EXPECT_NE(text.find(lines), std::string::npos) << "missing:\n" << lines << "in:\n" << text;
}

TEST(Printed, ARelationThatTheLeftSideForces) {
  std::string const text = printed(R"(modeler M on gmap(2);
rule r on M {
  left  { hook a <0,1>; a -2- a; }
  right { a; a -2- b; b <_,1>; b -0[0,2]- b; }
}
)");
  expect_lines(text, R"(words that the left side makes ε on the pattern
  F1  2, from the arc L3: [2,2] (1,2) ε
)");
  expect_lines(text, R"(  added cycle 2020 from a: R4 R6 R5 R1: [0,2,0] is ε on the pattern
    [0,2,0] is ε, by F1: [2,0,2,0] (1,3) [0,0] (1,2) ε
)");
}

TEST(Printed, PlacedNodesAndImpliedArcs) {
  expect_lines(printed(R"(modeler M on gmap(2);
rule unsew_edge on M {
  left  { hook a <>; b; c; d; a -0- b; a -2- c; b -2- d; }
  right { a; b; c; d; a -0- b; a -2- a; b -2- b; c -2- c; d -2- d; }
}
)"),
               R"(where the darts of left nodes lie from those of a
  c at 2, from L3: [2,2] (1,2) ε
  b at 0, from L1: [0,0] (1,2) ε
  d at [0,2], from L5: [0,2,2,0] (2,3) [0,0] (1,2) ε
arcs that the left side implies
  I1  c -0-> d, there in every map: [2,0,2,0] (1,3) [0,0] (1,2) ε
  I2  d -0-> c, the reverse of I1: ε
)");
}

TEST(Printed, LettersThatTurnRound) {
  expect_lines(printed(R"(modeler M on omap(3);
rule separate_copy on M {
  left  { hook a <1,2,3>; }
  right { a; b <1,2,3>; }
}
)"),
               R"(cycles through added and deleted arcs (paper, Def. 27)
  added cycle 1313 from b: R4 R6 R4 R6: [1,3,1,3] (1,3) [3,3] (1,2) ε
)");
}

}  // namespace
}  // namespace jrule::certificate
