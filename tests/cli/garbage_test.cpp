// Bad input gets a clear error, never a crash and never a part of an output.
#include <algorithm>

#include "tests/cli/fixture.h"

namespace jrule::tests {
namespace {

class Garbage : public CommandLine {
 protected:
  // Everything that reads sources says the same, and nothing crashes.
  void expect_source_error(std::string const& text, std::string const& code) const {
    file("bad.jrule", text);
    for (std::vector<std::string> const& command :
         {std::vector<std::string>{"check", "bad.jrule"}, {"emit", "cpp", "bad.jrule", "-o", "out"}, {"fmt", "--check", "bad.jrule"}}) {
      Outcome const outcome = jrule(command);
      EXPECT_EQ(outcome.exit_status, 1) << command[0] << ": " << outcome.output.substr(0, 500);
      EXPECT_NE(outcome.output.find("[" + code + "]"), std::string::npos) << command[0] << ": " << outcome.output.substr(0, 500);
    }
    EXPECT_EQ(files(), std::vector<std::string>{"bad.jrule"});
  }

  void expect_mesh_error(std::string const& name, std::string const& text, std::string const& message) const {
    file(name, text);
    Outcome const info = jrule({"info", name});
    EXPECT_EQ(info.exit_status, 1) << info.output;
    EXPECT_NE(info.output.find(message), std::string::npos) << info.output;
    Outcome const apply = jrule({"apply", demo("surface.jrule") + ":quad_subdivision", "--in", name, "--out", "out.obj"});
    EXPECT_EQ(apply.exit_status, 2) << apply.output;
    EXPECT_NE(apply.output.find(message), std::string::npos) << apply.output;
    EXPECT_EQ(files(), std::vector<std::string>{name});
  }
};

TEST_F(Garbage, EmptyFile) { expect_source_error("", "J0003"); }
TEST_F(Garbage, OnlyComments) { expect_source_error("// nothing\n/* at all */\n", "J0003"); }
TEST_F(Garbage, BinaryFile) { expect_source_error(std::string("\x7f" "ELF\x02\x01\x01\x00\x00\xff\xfe", 11), "J0002"); }
TEST_F(Garbage, UnterminatedComment) { expect_source_error("modeler M on gmap(2);\n/* for ever", "J0102"); }
TEST_F(Garbage, TenMegabytesOfBrackets) { expect_source_error(std::string(10'000'000, '('), "J0101"); }
TEST_F(Garbage, DeepNesting) {
  expect_source_error("modeler M on gmap(2) { embedding x : <0> -> Real { default " + std::string(5000, '(') + "1" + std::string(5000, ')') + "; } }", "J0103");
}
TEST_F(Garbage, DeepNestingWithoutBrackets) {
  std::string minus;
  for (int i = 0; i < 5000; ++i) minus += "- ";
  expect_source_error("modeler M on gmap(2) { embedding x : <0> -> Real { default " + minus + "1; } }", "J0103");
}

TEST_F(Garbage, MissingFilesAreUsageErrors) {
  EXPECT_EQ(jrule({"check", "none.jrule"}).exit_status, 2);
  EXPECT_EQ(jrule({"check", "."}).exit_status, 2);
  EXPECT_EQ(jrule({"info", "none.obj"}).exit_status, 2);
  EXPECT_EQ(jrule({"fmt", "none.jrule"}).exit_status, 2);
  EXPECT_EQ(jrule({"info", demo("surface.jrule")}).exit_status, 1);
  EXPECT_EQ(files(), std::vector<std::string>{});
}

TEST_F(Garbage, ObjWithNan) { expect_mesh_error("a.obj", "v 0 0 0\nv 1 nan 0\nv 0 1 0\nf 1 2 3\n", "a.obj:2: error: "); }
TEST_F(Garbage, ObjWithMissingVertices) { expect_mesh_error("a.obj", "v 0 0 0\nv 1 0 0\nf 1 2 3\n", "a.obj:3: error: "); }
TEST_F(Garbage, ObjWithNegativeIndicesOutOfRange) { expect_mesh_error("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -1 -2 -9\n", "a.obj:4: error: "); }
TEST_F(Garbage, ObjWithIndexZero) { expect_mesh_error("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 1 2\n", "a.obj:4: error: "); }
TEST_F(Garbage, ObjWithTwoEqualVertices) { expect_mesh_error("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 2 3\n", "a.obj:4: error: "); }
TEST_F(Garbage, ObjWithNonManifoldEdge) {
  expect_mesh_error("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 -1 0\nf 1 2 3\nf 1 2 4\nf 1 2 5\n", "a.obj:8: error: ");
}
TEST_F(Garbage, EmptyObj) { expect_mesh_error("a.obj", "", "a.obj"); }
TEST_F(Garbage, BinaryObj) { expect_mesh_error("a.obj", std::string("f \x00\x01\xff\n", 6), "a.obj:1: error: "); }
TEST_F(Garbage, PlyThatPromisesTooMuch) {
  expect_mesh_error("a.ply",
                    "ply\nformat ascii 1.0\nelement vertex 1000000000000\nproperty float x\nproperty float y\nproperty float z\n"
                    "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n",
                    "a.ply");
}
TEST_F(Garbage, JmapThatIsNoMap) { expect_mesh_error("a.jmap", "jmap 1\nmodel gmap 2\ndarts 2\n1 0 0\n1 1 1\n", "a.jmap"); }

// The relative indices of the OBJ format are no garbage.
TEST_F(Garbage, ObjWithRelativeIndicesIsRead) {
  file("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\n");
  Outcome const outcome = jrule({"info", "a.obj"});
  EXPECT_EQ(outcome.exit_status, 0) << outcome.output;
  EXPECT_NE(outcome.output.find("3 vertices, 3 edges, 1 face, 6 darts, valid"), std::string::npos) << outcome.output;
}

TEST_F(Garbage, OutputThatCannotBeWritten) {
  Outcome const outcome = jrule({"apply", demo("surface.jrule") + ":quad_subdivision", "--in", demo("square.off"), "--out", "no/such/folder/out.obj"});
  EXPECT_EQ(outcome.exit_status, 2) << outcome.output;
  EXPECT_EQ(files(), std::vector<std::string>{});
}

TEST_F(Garbage, OutputOfUnknownFormat) {
  Outcome const outcome = jrule({"apply", demo("surface.jrule") + ":quad_subdivision", "--in", demo("square.off"), "--out", "out.xyz"});
  EXPECT_EQ(outcome.exit_status, 2) << outcome.output;
  EXPECT_EQ(files(), std::vector<std::string>{});
}

// Every prefix of a good file is either good or refused with a place.
TEST_F(Garbage, PrefixesOfAGoodFile) {
  std::string const text = read(demo("surface.jrule"));
  for (std::size_t length = 1; length < text.size(); length += 41) {
    file("bad.jrule", text.substr(0, length));
    Outcome const outcome = jrule({"check", "bad.jrule"});
    EXPECT_TRUE(outcome.exit_status == 0 || outcome.exit_status == 1) << length << ": " << outcome.output;
    if (outcome.exit_status == 1) {
      EXPECT_NE(outcome.output.find("bad.jrule:"), std::string::npos) << length << ": " << outcome.output;
    }
  }
}

}  // namespace
}  // namespace jrule::tests
