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
# round, 1 to ~1, where it passes or is passed
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
            "certificate of the rule quad_subdivision on Surface, for a 2-G-map  surface.jrule:2\n" + legend + R"(@QUAD)");
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
            "certificate of the rule cone on Surface, for a 2-G-map  surface.jrule:2\n" + legend + R"(@CONE)");
}

// What the left side says: a placed node, a relation, an implied arc, letters that turn round.
TEST(Printed, WhatTheLeftSideSays) {
  EXPECT_EQ(printed(R"(modeler M on gmap(2);
rule r on M { left { hook a <0,1>; a -2- a; b; a -1[0]- b; } right { a; a -2- c; b; a -1[0]- b; c <0,1>; } }
)"),
            "@LEFT");
}

}  // namespace
}  // namespace jrule::certificate
