// `jrule run`: operations, as the command line gives them what they take.
#include "tests/cli/fixture.h"

namespace jrule::tests {
namespace {

bool contains(std::string const& text, std::string const& part) { return text.find(part) != std::string::npos; }

class Run : public CommandLine {
 protected:
  Run() {
    file("solid.jrule", R"(
modeler Solid on gmap(2) { embedding position : vertex -> Point3; }

rule square(side: Real = 1) on Solid {
  left { }
  right {
    a { position = Point3(0, 0, 0); } b { position = Point3(side, 0, 0); } c; d { position = Point3(side, side, 0); }
    e; f { position = Point3(0, side, 0); } g; h;
    a -0- b -1- c -0- d -1- e -0- f -1- g -0- h -1- a;
    a -2- a; b -2- b; c -2- c; d -2- d; e -2- e; f -2- f; g -2- g; h -2- h;
  }
}
rule cone(apex: Point3) on Solid {
  left  { hook a <0,1>;  a -2- a; }
  right { a; b <0,_>; c <_,2>; d <1,2> { position = apex; } a -2- b -1- c -0- d; }
}
operation house(side: Real = 1.0) on Solid -> Dart {
  let base = square(side);
  let top = cone(base.a, apex: Point3(0, 0, side));
  return top.d;
}
operation roofs(first: Dart, height: Real, second: Dart) on Solid {
  cone(first, Point3(0, 0, height));
  cone(second, Point3(0, 0, height));
}
operation size(d: Dart) on Solid -> Int { return count(<0,1>(d) by <0>); }
)");
  }
};

TEST_F(Run, BeginsWithAnEmptyMap) {
  Outcome const made = jrule({"run", "solid.jrule:house", "side=2", "--out", "house.jmap", "--picture", "house.svg"});
  EXPECT_EQ(made.exit_status, 0);
  EXPECT_TRUE(made.output.starts_with("house: 2 rules applied, gives dart 24\n5 vertices, 8 edges, 5 faces, 32 darts, valid\n")) << made.output;
  EXPECT_TRUE(contains(content("house.jmap"), "0 0 2\n"));
  EXPECT_TRUE(contains(content("house.svg"), "<svg"));
  Outcome const stats = jrule({"run", "solid.jrule:house", "--out", "house.off", "--stats", "json"});
  EXPECT_TRUE(contains(stats.output, R"("darts":32,"cells":[5,8,5])")) << stats.output;
}

TEST_F(Run, TakesDartsOfAMesh) {
  std::string const square = demo("square.off");
  Outcome const size = jrule({"run", "solid.jrule:size", "--in", square, "--at", "face:0", "--out", "same.off"});
  EXPECT_EQ(size.exit_status, 0);
  EXPECT_TRUE(size.output.starts_with("size: 0 rules applied, gives 4\n")) << size.output;
  Outcome const none = jrule({"run", "solid.jrule:size", "--in", square, "--out", "x.off"});
  EXPECT_EQ(none.exit_status, 2);
  EXPECT_EQ(none.output, "jrule: error: `size` takes darts for `d`, but `--at` selects 0 darts: write `--at dart:0`\n");
  Outcome const empty = jrule({"run", "solid.jrule:size", "--at", "dart:0", "--out", "x.off"});
  EXPECT_EQ(empty.output, "jrule: error: `size` takes darts of a mesh: give one with `--in`\n");
  Outcome const more = jrule({"run", "solid.jrule:house", "--in", square, "--at", "dart:0", "--out", "x.off"});
  EXPECT_EQ(more.output, "jrule: error: `house` has no parameter that is a dart, but `--at` selects 1 dart\n");
}

TEST_F(Run, FailsAndWritesNothing) {
  Outcome const failed = jrule({"run", "solid.jrule:roofs", "--in", demo("square.off"), "--at", "dart:0,dart:2", "height=1", "--out", "out.off"});
  EXPECT_EQ(failed.exit_status, 1);
  EXPECT_EQ(failed.output, "jrule: error: `cone` is not applicable: the 2-arc of `a` has to be a loop, but from dart 2 it leads to dart 11\n");
  EXPECT_EQ(files(), std::vector<std::string>{"solid.jrule"});
  // Nor the picture, if the mesh cannot be written.
  for (char const* const out : {"none/house.jmap", "house.xyz", "."}) {
    Outcome const unwritten = jrule({"run", "solid.jrule:house", "--out", out, "--picture", "house.svg"});
    EXPECT_EQ(unwritten.exit_status, 2) << unwritten.output;
    EXPECT_EQ(files(), std::vector<std::string>{"solid.jrule"}) << out;
  }
}

TEST_F(Run, ArgumentsAreChecked) {
  auto const output = [&](std::vector<std::string> words) {
    words.insert(words.end(), {"--out", "x.off"});
    Outcome const outcome = jrule(words);
    EXPECT_EQ(outcome.exit_status, 2);
    return outcome.output;
  };
  EXPECT_EQ(output({"run", "solid.jrule"}), "jrule: error: `solid.jrule` is not of the form FILE:OPERATION\n");
  EXPECT_EQ(output({"run", "solid.jrule:cone"}), "jrule: error: `cone` is a rule: `jrule apply` applies it\n");
  EXPECT_EQ(output({"run", "solid.jrule:tower"}), "jrule: error: `solid.jrule` has no operation `tower`; it has `house`, `roofs`, `size`\n");
  EXPECT_EQ(output({"run", "solid.jrule:house", "side=wide"}), "jrule: error: `wide` is not a Real: write `side=0.5`\n");
  EXPECT_EQ(output({"run", "solid.jrule:house", "width=1"}), "jrule: error: `house` has no parameter `width`; it has `side`\n");
  EXPECT_EQ(output({"run", "solid.jrule:roofs", "--in", demo("square.off"), "--at", "dart:0,dart:2"}),
            "jrule: error: the parameter `height` of `roofs` is missing: write `height=0.5`\n");
  EXPECT_EQ(output({"run", "missing.jrule:house"}), "jrule: error: cannot read `missing.jrule`: No such file or directory [J0001]\n");
}

TEST_F(Run, CppFromOutsideCannotBeRun) {
  file("land.jrule",
       "extern fn low() -> Real in \"soil.hpp\" as \"geo::low\";\n"
       "modeler Land on gmap(2);\n"
       "operation inner() on Land -> Real { return low(); }\n"
       "operation outer() on Land -> Real { let x = inner(); return x; }\n");
  Outcome const outcome = jrule({"run", "land.jrule:outer", "--out", "x.jmap"});
  EXPECT_EQ(outcome.exit_status, 1);
  EXPECT_TRUE(contains(outcome.output, "land.jrule:3:44: error: `outer` cannot be run here: a statement calls the extern function `low` [J0903]\n")) << outcome.output;
}

TEST_F(Run, OtherCommandsTakeFilesWithOperations) {
  EXPECT_EQ(jrule({"check", "solid.jrule"}).output, "solid.jrule: 2 rules accepted, 3 operations\n");
  EXPECT_TRUE(contains(jrule({"emit", "ir", "solid.jrule"}).output, "operation house on Solid -> Dart\n"));
  EXPECT_TRUE(contains(jrule({"emit", "jrule", "solid.jrule"}).output, "let top = cone(base.a, Point3(0.0, 0.0, side));\n"));
  for (char const* const stage : {"ast", "dot", "certificate", "cpp", "plugin"}) EXPECT_EQ(jrule({"emit", stage, "solid.jrule"}).exit_status, 0) << stage;
  EXPECT_FALSE(contains(jrule({"emit", "jrule", "solid.jrule:cone"}).output, "operation"));
  EXPECT_EQ(jrule({"fmt", "solid.jrule"}).exit_status, 0);
  EXPECT_EQ(jrule({"check", "solid.jrule"}).exit_status, 0);
}

}  // namespace
}  // namespace jrule::tests
