// What of a rule is C++ from outside, as the stages behind sema see it.
#include "compiler/ir/extern_use.h"

#include <gtest/gtest.h>

#include "tests/unit/rule_fixture.h"

namespace jrule::ir {
namespace {

std::string const declarations = R"(
extern type Soil in "soil.hpp" as "geo::Soil";
extern fn grass() -> Soil in "soil.hpp" as "geo::grass";
extern fn mix(a: Soil, b: Soil) -> Soil in "soil.hpp" as "geo::mix";
extern fn hard(soil: Soil) -> Real in "soil.hpp" as "geo::hard";
extern fn low(heights: [Real]) -> Real in "soil.hpp" as "geo::low";
)";

std::string use(std::string const& modeler, std::string const& rule) {
  Program const program = tests::program_of(declarations + "modeler M on gmap(2) { " + modeler + " }\n" + rule);
  EXPECT_FALSE(verify(program.rules.at(0)));
  auto const found = find_extern_use(program.rules.at(0));
  return found ? found->what : "nothing";
}

TEST(ExternUse, IsFoundWhereverItIs) {
  std::string const height = "embedding h : vertex -> Real { default 1; merge mean; }";
  std::string const plain = "rule r on M { left { hook a <0,1>; } right { a; } }";
  EXPECT_EQ(use(height, plain), "nothing");
  EXPECT_EQ(use("embedding s : face -> Soil;", plain), "the embedding `s` has the extern type `Soil`");
  EXPECT_EQ(use("embedding h : face -> Real { default 1 + 2 * hard(grass()); }", plain),
            "the default of `h` calls the extern function `hard`");
  EXPECT_EQ(use(height + "embedding l : face -> Real { merge low; }", plain),
            "the embedding `l` is merged by the extern function `low`");
  auto const in = [&](std::string const& parameters, std::string const& left, std::string const& right) {
    return use(height,
               "rule r(" + parameters + ") on M { left { hook a <0,1>; " + left + " } right { a { " + right + " } } }");
  };
  EXPECT_EQ(in("s: Soil", "", ""), "the parameter `s` has the extern type `Soil`");
  EXPECT_EQ(in("x: Real = hard(grass())", "", ""), "the default of `x` calls the extern function `hard`");
  EXPECT_EQ(in("", "let y = grass();", ""), "`y` calls the extern function `grass`");
  EXPECT_EQ(in("", "require low(<0,1>(a).h) < 1;", ""), "a requirement calls the extern function `low`");
  EXPECT_EQ(in("", "let y = mean(hard(grass()) for e in <0,1>(a));", ""), "`y` calls the extern function `hard`");
  EXPECT_EQ(in("", "let y = low(e.h for e in <0,1>(a));", ""), "`y` calls the extern function `low`");
  std::string const dart = "(if hard(grass()) < 1 then a else a@0)";
  EXPECT_EQ(in("", "let y = " + dart + ".h;", ""), "`y` calls the extern function `hard`");
  EXPECT_EQ(in("", "let y = " + dart + "@1;", ""), "`y` calls the extern function `hard`");
  EXPECT_EQ(in("", "let y = mean(<0,1>(" + dart + ").h);", ""), "`y` calls the extern function `hard`");
  EXPECT_EQ(in("", "let y = count(<0,1>(" + dart + ") by <0>);", ""), "`y` calls the extern function `hard`");
  EXPECT_EQ(in("", "let y = mean(e.h for e in <0,1>(" + dart + "));", ""), "`y` calls the extern function `hard`");
  EXPECT_EQ(in("", "", "h = 1 + low(<0,1>(a).h);"), "`h` of `a` calls the extern function `low`");
}

TEST(ExternUse, IsPrinted) {
  Program const program = tests::program_of(declarations + R"(
modeler M on gmap(2) {
  embedding s : face -> Soil { default grass(); merge mix; }
  embedding h : vertex -> Real { default hard(grass()); merge low; }
}
rule r(s: Soil = mix(grass(), grass()), x: Real = 1) on M {
  left  { hook a <0,1>; let y = first(<0,1>(a).s); require hard(y) < x; }
  right { a { s = mix(s, y); } }
}
)");
  EXPECT_EQ(print(*program.modelers.at(0)),
            "modeler M on gmap(2)\n  dimensions 0 1 2\n  exchange (0,2)\n"
            "  embedding s : <0,1> -> Soil default (grass) merge mix\n"
            "  embedding h : <1,2> -> Real default (hard (grass)) merge low\n");
  std::string const text = print(program.rules.at(0));
  for (char const* line :
       {"  parameter s: Soil = (mix (grass) (grass))\n", "  parameter x: Real = 1\n",
        "  let y = (first <0,1>(a by <0,1>).s)\n", "  require (< (hard y) x)\n", "  a.s = (mix s y)\n"}) {
    EXPECT_NE(text.find(line), std::string::npos) << line << text;
  }
}

// The analysis of topology and embeddings does not mind what a type is.
TEST(ExternUse, IsAnalysedLikeTheRest) {
  std::string const rules = R"(
rule unite on M { left { hook a <0,2>; b; a -1- b; } right { b; b -1[2]- b; } }
rule dot on M { left { } right { a; a -0- a; a -1- a; a -2- a; } }
)";
  auto const judged = [&](std::string const& policies) {
    Program const program = tests::program_of(declarations + "modeler M on gmap(2) { embedding s : face -> Soil { " +
                                              policies + " } }" + rules);
    return tests::codes(analysis::analyze(program.rules.at(0))) + "," +
           tests::codes(analysis::analyze(program.rules.at(1)));
  };
  EXPECT_EQ(judged(""), "J0402,J0401");
  EXPECT_EQ(judged("merge mix;"), ",J0401");
  EXPECT_EQ(judged("merge first; default grass();"), ",");
}

TEST(ExternUse, DocumentationOfParametersIsKept) {
  Program const program = tests::program_of(R"(
modeler M on gmap(2);
rule r(
    /// in metres
    /// above the sea
    height: Real = 2, other: Real) on M { left { hook a <>; } right { a; } }
)");
  ASSERT_EQ(program.rules.at(0).parameters.size(), 2U);
  EXPECT_EQ(program.rules[0].parameters[0].doc, "in metres\nabove the sea");
  EXPECT_EQ(program.rules[0].parameters[1].doc, "");
}

}  // namespace
}  // namespace jrule::ir
