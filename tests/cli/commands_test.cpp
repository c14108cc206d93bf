// The commands as the language reference documents them (section 9): what they print, what they write, their exit statuses.
#include <algorithm>

#include "tests/cli/fixture.h"

namespace jrule::tests {
namespace {

class Commands : public CommandLine {};

bool contains(std::string const& text, std::string const& part) { return text.find(part) != std::string::npos; }

TEST_F(Commands, CheckAcceptsTheDemo) {
  Outcome const outcome = jrule({"check", demo("surface.jrule"), demo("halfedges.jrule")});
  EXPECT_EQ(outcome.exit_status, 0);
  EXPECT_TRUE(contains(outcome.output, "surface.jrule: 3 rules accepted\n")) << outcome.output;
  EXPECT_TRUE(contains(outcome.output, "halfedges.jrule: 2 rules accepted\n")) << outcome.output;
}

TEST_F(Commands, CheckPrintsOneJsonObjectALine) {
  file("bad.jrule", "modeler M on gmap(2);\nrule r on M { left { hook a <0>; } right { a <0>; b <1>; } }\n");
  Outcome const outcome = jrule({"check", "--message-format", "json", "bad.jrule"});
  EXPECT_EQ(outcome.exit_status, 1);
  EXPECT_TRUE(outcome.output.starts_with(R"({"schema":1,"code":"J0302","severity":"error","message":")")) << outcome.output;
  EXPECT_TRUE(contains(outcome.output, R"("file":"bad.jrule","line":2,"column":51)")) << outcome.output;
  EXPECT_EQ(std::count(outcome.output.begin(), outcome.output.end(), '\n'), 2) << outcome.output;  // b lacks 0 and 2
}

TEST_F(Commands, WarningsAreErrorsIfTheUserSaysSo) {
  file("split.jrule",
       "modeler M on gmap(2) { embedding position : vertex -> Point3; }\n"
       "rule split on M { left { hook a <0,2>; } right { a <_,2>; b <1,2> { position = a.position; } a -0- b; } }\n");
  Outcome const warned = jrule({"check", "split.jrule"});
  EXPECT_EQ(warned.exit_status, 0);
  EXPECT_TRUE(warned.output.find("split.jrule:2:80: warning: ") != std::string::npos) << warned.output;
  EXPECT_TRUE(contains(warned.output, "[J0411]\n")) << warned.output;
  EXPECT_TRUE(contains(warned.output, "split.jrule: 1 rule accepted, 1 warning\n")) << warned.output;
  Outcome const refused = jrule({"check", "-Werror", "split.jrule"});
  EXPECT_EQ(refused.exit_status, 1);
  EXPECT_TRUE(contains(refused.output, "split.jrule:2:80: error: ")) << refused.output;
  EXPECT_TRUE(contains(refused.output, "split.jrule: 1 rule accepted, 1 error\n")) << refused.output;
  Outcome const as_json = jrule({"check", "-Werror", "--message-format", "json", "split.jrule"});
  EXPECT_TRUE(contains(as_json.output, R"("code":"J0411","severity":"error")")) << as_json.output;
  EXPECT_EQ(jrule({"emit", "cpp", "-Werror", "split.jrule", "-o", "out"}).exit_status, 1);
  EXPECT_EQ(files(), std::vector<std::string>{"split.jrule"});
  EXPECT_EQ(jrule({"check", "-Wall", "split.jrule"}).exit_status, 2);
}

TEST_F(Commands, QuadSubdivisionOfTheBunny) {
  Outcome const outcome = jrule({"apply", demo("surface.jrule") + ":quad_subdivision", "--in", bunny(), "--out", "quads.obj", "--stats", "json"});
  EXPECT_EQ(outcome.exit_status, 0) << outcome.output;
  EXPECT_EQ(outcome.output,
            R"({"model":"gmap","dimension":2,"darts":88176,"cells":[11024,22044,11022],"components":1,"euler":2,"orientable":true,"boundary_darts":0,"valid":true})"
            "\n");
  Outcome const again = jrule({"info", "quads.obj"});
  EXPECT_EQ(again.exit_status, 0);
  EXPECT_TRUE(contains(again.output, "11 024 vertices, 22 044 edges, 11 022 faces, 88 176 darts, valid\n")) << again.output;
}

TEST_F(Commands, QuadSubdivisionOfTheBunnyAsOMap) {
  Outcome const outcome = jrule({"apply", demo("halfedges.jrule") + ":quad_subdivision", "--in", bunny(), "--out", "quads.ply"});
  EXPECT_EQ(outcome.exit_status, 0) << outcome.output;
  EXPECT_TRUE(contains(outcome.output, "11 024 vertices, 22 044 edges, 11 022 faces, 44 088 darts, valid\n")) << outcome.output;
}

TEST_F(Commands, ThreadsDoNotChangeTheResult) {
  auto const subdivide = [&](std::string const& out, std::string const& threads) {
    std::vector<std::string> words{"apply", demo("surface.jrule") + ":quad_subdivision", "--in", bunny(), "--out", out};
    if (!threads.empty()) words.insert(words.end(), {"--threads", threads});
    return jrule(words).exit_status;
  };
  EXPECT_EQ(subdivide("one.jmap", "1"), 0);
  EXPECT_EQ(subdivide("three.jmap", "3"), 0);
  EXPECT_EQ(subdivide("all.jmap", ""), 0);
  EXPECT_EQ(content("one.jmap"), content("three.jmap"));
  EXPECT_EQ(content("one.jmap"), content("all.jmap"));
  EXPECT_EQ(subdivide("none.jmap", "0"), 2);
}

TEST_F(Commands, ConeIsNotApplicableToTheBunny) {
  Outcome const outcome = jrule({"apply", demo("surface.jrule") + ":cone", "--in", bunny(), "--out", "cone.obj", "--at", "face:0", "apex=0,0,1"});
  EXPECT_EQ(outcome.exit_status, 1);
  EXPECT_TRUE(contains(outcome.output, "`cone` is not applicable: the 2-arc of `a` has to be a loop")) << outcome.output;
  EXPECT_EQ(files(), std::vector<std::string>{});
}

TEST_F(Commands, ConeOnASquare) {
  Outcome const outcome = jrule({"apply", demo("surface.jrule") + ":cone", "--in", demo("square.off"), "--out", "p.off", "--at", "face:0", "apex=Point3(0.5,0.5,1)"});
  EXPECT_EQ(outcome.exit_status, 0) << outcome.output;
  EXPECT_TRUE(contains(outcome.output, "5 vertices, 8 edges, 5 faces, 32 darts, valid\n")) << outcome.output;
  EXPECT_TRUE(contains(content("p.off"), "0.5 0.5 1\n"));
}

TEST_F(Commands, SewingTwoSquares) {
  file("two.off", "OFF\n8 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 0\n4 0 0\n4 1 0\n3 1 0\n4 0 1 2 3\n4 4 5 6 7\n");
  // Dart 3 is at (1,1), dart 15 at (3,0)... of the edges x = 1 and x = 3, the ends that meet are darts 2 (1,0) and 15 (3,0).
  Outcome const sewn = jrule({"apply", demo("surface.jrule") + ":sew2", "--in", "two.off", "--out", "sewn.obj", "--at", "dart:2,dart:15"});
  EXPECT_EQ(sewn.exit_status, 0) << sewn.output;
  EXPECT_TRUE(contains(sewn.output, "6 vertices, 7 edges, 2 faces, 16 darts, valid\n")) << sewn.output;
  EXPECT_TRUE(contains(content("sewn.obj"), "v 2 0 0\n"));
  EXPECT_TRUE(contains(content("sewn.obj"), "v 2 1 0\n"));
  // An edge cannot be sewn to itself, and not without a dart for each hook.
  EXPECT_EQ(jrule({"apply", demo("surface.jrule") + ":sew2", "--in", "two.off", "--out", "x.obj", "--at", "dart:2,dart:2"}).exit_status, 1);
  EXPECT_EQ(jrule({"apply", demo("surface.jrule") + ":sew2", "--in", "two.off", "--out", "x.obj", "--at", "dart:2"}).exit_status, 2);
  EXPECT_EQ(jrule({"apply", demo("surface.jrule") + ":sew2", "--in", "two.off", "--out", "x.obj"}).exit_status, 2);
  EXPECT_EQ(files(), (std::vector<std::string>{"sewn.obj", "two.off"}));
}

TEST_F(Commands, RulesOfTheLibraryTakeTheirDimension) {
  std::string const basic = JRULE_SOURCE_DIR "/stdlib/std/basic.jrule";
  file("two.jmap", "jmap 1\nmodel gmap 1\ndarts 4\n1 0\n0 1\n3 2\n2 3\n");
  Outcome const sewn = jrule({"apply", basic + ":sew[1]", "--in", "two.jmap", "--out", "one.jmap", "--at", "dart:1,dart:2"});
  EXPECT_EQ(sewn.exit_status, 0) << sewn.output;
  EXPECT_TRUE(contains(content("one.jmap"), "darts 4\n1 0\n0 2\n3 1\n2 3\n")) << content("one.jmap");
  Outcome const unsewn = jrule({"apply", basic + ":unsew[1]", "--in", "one.jmap", "--out", "again.jmap", "--at", "dart:1"});
  EXPECT_EQ(unsewn.exit_status, 0) << unsewn.output;
  EXPECT_EQ(content("again.jmap"), content("two.jmap"));
  EXPECT_EQ(jrule({"apply", basic + ":sew", "--in", "two.jmap", "--out", "x.jmap", "--at", "dart:1,dart:2"}).exit_status, 1);
  EXPECT_EQ(jrule({"apply", basic + ":sew[7]", "--in", "two.jmap", "--out", "x.jmap", "--at", "dart:1,dart:2"}).exit_status, 1);
}

// Imported rules are on the modelers of the file, so that no value is lost.
TEST_F(CommandLine, ImportedRulesKeepTheValuesOfTheFilesModelers) {
  file("lands.jrule",
       "import std.basic;\nimport std.subdivision;\n"
       "modeler Land on gmap(2) { embedding position : vertex -> Point3 { merge mean; } embedding soil : face -> Int { default 3; merge max; } }\n"
       "modeler Bare on gmap(2) {}\nmodeler Solid on gmap(3) {}\n");
  std::string const cube = JRULE_SOURCE_DIR "/tests/data/cube.obj";
  auto const apply = [&](std::string const& rule, std::string const& in, std::string const& out, std::string const& at) {
    return jrule({"apply", "lands.jrule:" + rule, "--in", in, "--out", out, "--at", at});
  };
  Outcome const open = apply("Land.unsew[2]", cube, "open.jmap", "dart:0");
  EXPECT_EQ(open.exit_status, 0) << open.output;
  EXPECT_NE(content("open.jmap").find("embedding soil Int 1"), std::string::npos);
  EXPECT_EQ(apply("Bare.unsew[2]", cube, "bare.jmap", "dart:0").exit_status, 0);
  EXPECT_EQ(content("bare.jmap").find("embedding"), std::string::npos);

  Outcome const which = apply("unsew[2]", cube, "x.jmap", "dart:0");
  EXPECT_EQ(which.exit_status, 1);
  EXPECT_NE(which.output.find("`unsew[2]` is a rule of several modelers"), std::string::npos) << which.output;
  EXPECT_NE(which.output.find("known here: `Land.unsew[2]`, `Bare.unsew[2]`"), std::string::npos) << which.output;
  Outcome const unknown = apply("Sea.unsew[2]", cube, "x.jmap", "dart:0");
  EXPECT_EQ(unknown.exit_status, 1);
  EXPECT_NE(unknown.output.find("`unsew[2]` is not a rule of the modeler `Sea`"), std::string::npos) << unknown.output;
  EXPECT_EQ(apply("Land.quad", cube, "fine.obj", "all").exit_status, 0);
  EXPECT_EQ(apply("Mesh.quad", cube, "fine.obj", "all").exit_status, 0);

  // In dimension 3 only one modeler takes it.
  file("two.jmap", "jmap 1\nmodel gmap 3\ndarts 2\n0 0 0 1\n1 1 1 0\n");
  Outcome const solid = apply("unsew[3]", "two.jmap", "apart.jmap", "dart:0");
  EXPECT_EQ(solid.exit_status, 0) << solid.output;
  // What is printed means the same.
  std::string const printed = jrule({"emit", "jrule", "lands.jrule"}).output;
  file("printed.jrule", printed);
  EXPECT_NE(printed.find("rule Land_quad on Land"), std::string::npos) << printed;
  EXPECT_EQ(jrule({"check", "printed.jrule"}).exit_status, 0);
}

TEST_F(Commands, ARuleThatCreatesNeedsNoMesh) {
  file("new.jrule", "modeler M on gmap(1);\nrule segment on M { left {} right { a; b; a -0- b; a -1- a; b -1- b; } }\n");
  Outcome const outcome = jrule({"apply", "new.jrule:segment", "--out", "edge.jmap"});
  EXPECT_EQ(outcome.exit_status, 0) << outcome.output;
  EXPECT_EQ(content("edge.jmap"), "jmap 1\nmodel gmap 1\ndarts 2\n1 0\n0 1\n");
}

TEST_F(Commands, AllAppliesToEachOrbitOnce) {
  file("two.off", "OFF\n8 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 0\n4 0 0\n4 1 0\n3 1 0\n4 0 1 2 3\n4 4 5 6 7\n");
  Outcome const outcome = jrule({"apply", demo("surface.jrule") + ":cone", "--in", "two.off", "--out", "p.off", "--at", "all", "apex=0,0,1"});
  EXPECT_EQ(outcome.exit_status, 0) << outcome.output;
  EXPECT_TRUE(contains(outcome.output, "cone: applied 2 times\n10 vertices, 16 edges, 10 faces, 64 darts, valid\n")) << outcome.output;
}

TEST_F(Commands, ArgumentsAreChecked) {
  auto const cone = [&](std::vector<std::string> const& values) {
    std::vector<std::string> words{"apply", demo("surface.jrule") + ":cone", "--in", demo("square.off"), "--out", "p.off", "--at", "face:0"};
    words.insert(words.end(), values.begin(), values.end());
    return jrule(words);
  };
  EXPECT_TRUE(contains(cone({}).output, "the parameter `apex` of `cone` is missing"));
  EXPECT_TRUE(contains(cone({"apex=1,2"}).output, "`1,2` is not a Point3"));
  EXPECT_TRUE(contains(cone({"apex=1,2,nan"}).output, "is not a Point3"));
  EXPECT_TRUE(contains(cone({"top=1,2,3"}).output, "`cone` has no parameter `top`"));
  EXPECT_TRUE(contains(cone({"apex=1,2,3", "apex=1,2,3"}).output, "given twice"));
  EXPECT_EQ(cone({}).exit_status, 2);
  EXPECT_EQ(files(), std::vector<std::string>{});
}

TEST_F(Commands, SelectionsAreChecked) {
  for (std::string const at : {"face:1", "dart:8", "dart:-1", "corner:0", "face", "", "volume:0", "dart:99999999999"}) {
    Outcome const outcome = jrule({"apply", demo("surface.jrule") + ":cone", "--in", demo("square.off"), "--out", "p.off", "--at=" + (at.empty() ? "," : at), "apex=0,0,1"});
    EXPECT_EQ(outcome.exit_status, 2) << at << ": " << outcome.output;
  }
  EXPECT_EQ(files(), std::vector<std::string>{});
}

TEST_F(Commands, ARefusedRuleIsNotApplied) {
  Outcome const outcome = jrule({"apply", demo("wrong.jrule") + ":breaks_a_cycle", "--in", bunny(), "--out", "x.obj"});
  EXPECT_EQ(outcome.exit_status, 1);
  EXPECT_TRUE(contains(outcome.output, "[J0321]")) << outcome.output;
  EXPECT_EQ(jrule({"apply", demo("surface.jrule") + ":conee", "--in", bunny(), "--out", "x.obj"}).exit_status, 1);
  EXPECT_EQ(jrule({"apply", demo("surface.jrule"), "--in", bunny(), "--out", "x.obj"}).exit_status, 2);
  EXPECT_EQ(files(), std::vector<std::string>{});
}

TEST_F(Commands, EmitShowsEachStage) {
  for (std::string const stage : {"ast", "ir", "jrule", "dot", "svg", "cpp", "certificate"}) {
    Outcome const outcome = jrule({"emit", stage, demo("surface.jrule")});
    EXPECT_EQ(outcome.exit_status, 0) << stage << ": " << outcome.output;
    EXPECT_TRUE(contains(outcome.output, "quad_subdivision")) << stage << ": " << outcome.output;
  }
  EXPECT_EQ(jrule({"emit", "soup", demo("surface.jrule")}).exit_status, 2);
}

TEST_F(Commands, EmitJruleWritesRulesOfTheSameVerdict) {
  for (std::string const name : {"surface.jrule", "halfedges.jrule", "wrong.jrule"}) {
    Outcome const before = jrule({"check", demo(name)});
    EXPECT_EQ(jrule({"emit", "jrule", demo(name), "-o", "out"}).exit_status, before.exit_status);
    Outcome const after = jrule({"check", "out/" + name});
    EXPECT_EQ(after.exit_status, before.exit_status) << after.output;
    EXPECT_EQ(jrule({"fmt", "--check", "out/" + name}).exit_status, 0);
    jrule({"emit", "ir", demo(name), "-o", "before"});
    jrule({"emit", "ir", "out/" + name, "-o", "after"});
    std::string const ir = name.substr(0, name.find('.')) + ".ir";
    EXPECT_TRUE(contains(content("before/" + ir), "rule "));
    EXPECT_EQ(content("after/" + ir), content("before/" + ir));
  }
}

TEST_F(Commands, EmitJruleShowsAnInstance) {
  std::string const sew = JRULE_SOURCE_DIR "/stdlib/std/basic.jrule:sew[2]";
  EXPECT_EQ(jrule({"emit", "jrule", sew, "--dimension", "3", "-o", "."}).exit_status, 0);
  EXPECT_EQ(files(), std::vector<std::string>{"sew_2.jrule"});
  EXPECT_TRUE(contains(content("sew_2.jrule"), "rule sew_2 on gmap(3) {")) << content("sew_2.jrule");
  EXPECT_TRUE(contains(content("sew_2.jrule"), "hook a <0>;")) << content("sew_2.jrule");
  EXPECT_EQ(jrule({"check", "sew_2.jrule"}).exit_status, 0);
  EXPECT_EQ(jrule({"emit", "ast", sew}).exit_status, 2);
  EXPECT_EQ(jrule({"emit", "jrule", JRULE_SOURCE_DIR "/stdlib/std/basic.jrule:seww[2]"}).exit_status, 1);
}

TEST_F(Commands, EmitJruleRefusesWhatItCannotWrite) {
  file("gaps.jrule", "model gaps(n) { dimensions 0..n-2, n+3; }\nmodeler Low on gaps(2);\nmodeler High on gaps(6);\n");
  Outcome const outcome = jrule({"emit", "jrule", "gaps.jrule", "-o", "out"});
  EXPECT_EQ(outcome.exit_status, 1);
  EXPECT_TRUE(contains(outcome.output, "[J0904]")) << outcome.output;
}

TEST_F(Commands, EmitNeverOverwritesASource) {
  file("surface.jrule", read(demo("surface.jrule")));
  Outcome const outcome = jrule({"emit", "jrule", "surface.jrule", "-o", "."});
  EXPECT_EQ(outcome.exit_status, 2);
  EXPECT_TRUE(contains(outcome.output, "`surface.jrule` would be overwritten")) << outcome.output;
  EXPECT_EQ(content("surface.jrule"), read(demo("surface.jrule")));
}

TEST_F(Commands, EmitCertificateLeavesRefusedRulesOut) {
  Outcome const outcome = jrule({"emit", "certificate", demo("wrong.jrule"), "-o", "out"});
  EXPECT_EQ(outcome.exit_status, 1);
  EXPECT_TRUE(contains(outcome.output, "[J0321]")) << outcome.output;
  EXPECT_FALSE(std::filesystem::exists(folder() / "out/breaks_a_cycle.certificate"));
  EXPECT_EQ(jrule({"emit", "certificate", demo("surface.jrule"), "-o", "out"}).exit_status, 0);
  EXPECT_TRUE(contains(content("out/cone.certificate"), "left cycle 2020 from a: L3 L1 L3 L1")) << content("out/cone.certificate");
}

TEST_F(Commands, EmitCppWritesAHeaderASourceAndADepfile) {
  file("surface.jrule", read(demo("surface.jrule")));
  Outcome const outcome = jrule({"emit", "cpp", "surface.jrule", "-o", "out", "--depfile", "out/surface.d", "--write-if-changed"});
  EXPECT_EQ(outcome.exit_status, 0) << outcome.output;
  EXPECT_TRUE(std::filesystem::exists(folder() / "out/surface.h"));
  EXPECT_TRUE(std::filesystem::exists(folder() / "out/surface.cpp"));
  std::string const depfile = content("out/surface.d");
  EXPECT_EQ(depfile, "out/surface.h out/surface.cpp: \\\n  surface.jrule\n");
  auto const before = std::filesystem::last_write_time(folder() / "out/surface.h");
  EXPECT_EQ(jrule({"emit", "cpp", "surface.jrule", "-o", "out", "--write-if-changed"}).exit_status, 0);
  EXPECT_EQ(std::filesystem::last_write_time(folder() / "out/surface.h"), before);
}

TEST_F(Commands, EmitCppOfARefusedRuleWritesNothing) {
  Outcome const outcome = jrule({"emit", "cpp", demo("wrong.jrule"), "-o", "out"});
  EXPECT_EQ(outcome.exit_status, 1);
  EXPECT_EQ(files(), std::vector<std::string>{});
}

TEST_F(Commands, Fmt) {
  std::string const canonical = read(demo("surface.jrule"));
  file("a.jrule", canonical);
  EXPECT_EQ(jrule({"fmt", "--check", "a.jrule"}).exit_status, 0) << jrule({"fmt", "--check", "a.jrule"}).output;
  file("b.jrule", "modeler   M on gmap( 2 ) ;");
  EXPECT_EQ(jrule({"fmt", "--check", "b.jrule"}).exit_status, 1);
  EXPECT_EQ(content("b.jrule"), "modeler   M on gmap( 2 ) ;");
  EXPECT_EQ(jrule({"fmt", "b.jrule"}).exit_status, 0);
  EXPECT_EQ(content("b.jrule"), "modeler M on gmap(2);\n");
}

TEST_F(Commands, Explain) {
  Outcome const outcome = jrule({"explain", "j0302"});
  EXPECT_EQ(outcome.exit_status, 0);
  EXPECT_TRUE(outcome.output.starts_with("# J0302: ")) << outcome.output;
  EXPECT_TRUE(contains(jrule({"explain"}).output, "J0302"));
  EXPECT_EQ(jrule({"explain", "J9999"}).exit_status, 2);
  EXPECT_EQ(jrule({"explain", "no-such.jrule:r"}).exit_status, 2);
}

TEST_F(Commands, ExplainsWhatARuleDoesToCells) {
  file("a.jrule", R"(rule kis on gmap(2) {
  left  { hook a <0,1,2>; }
  right { a <0,_,2>; b <_,2,_>; c <1,2,_>; a -1- b -0- c; }
}
rule fan on gmap(2) {
  left  { hook a <0,1>; }
  right { a <0,_>; b <_,2>; c <1,2>; a -1- b -0- c; }
}
)");
  file("copy.jrule", "rule copy on gmap(n) { left { hook a <0..n>; } right { a; b <0..n>; } }");
  file("refused.jrule", "rule refused on gmap(2) { left { hook a <0>; } right { a <_>; } }");
  EXPECT_EQ(jrule({"explain", "a.jrule:kis"}).output, R"(kis on gmap(2): applied to whole components
  vertices  new           `c`                  one for each face
            kept          `a`                  one for each vertex
  edges     new           `b`, `c`             one for each orbit <1>
            kept          `a`                  one for each edge
  faces     may be split  `a`                  one for each face
  V' = V + F
  E' = 3 * E   without a border or a folded edge
  F' = 2 * E   without a border or a folded edge
  D' = 3 * D

)");
  EXPECT_EQ(jrule({"explain", "a.jrule:fan"}).output, R"(fan on gmap(2): its pattern is the orbit <0,1> of `a`
  vertices  new           `c`                  one
            kept          `a`                  at most one for each orbit <1>
  edges     new           `b`, `c`             one for each orbit <1>
            kept          `a`                  at most one for each orbit <0>
  faces     may be split  `a`                  one
  V' = V + 1

)");
  char const* const json =
      R"~({"rule":"fan","modeler":"gmap(2)","whole_component":false,"cells":[{"dimension":0,"orbit":"<1,2>","created":[{"nodes":[")~"
      R"~(c"],"per":"<0,1>","single":true,"reaches_out":false}],"deleted":[],"split":[],"merged":[],"kept":[{"nodes":["a"],"per":")~"
      R"~(<1>","single":false,"reaches_out":true}],"count":{"sum":"V + 1","orbits":[],"without_border":false}},{"dimension":1,"orb)~"
      R"~(it":"<0,2>","created":[{"nodes":["b","c"],"per":"<1>","single":false,"reaches_out":false}],"deleted":[],"split":[],"merg)~"
      R"~(ed":[],"kept":[{"nodes":["a"],"per":"<0>","single":false,"reaches_out":true}],"count":null},{"dimension":2,"orbit":"<0,1)~"
      R"~(>","created":[],"deleted":[],"split":[{"nodes":["a"],"per":"<0,1>","single":true,"reaches_out":false}],"merged":[],"kept)~"
      R"~(":[],"count":null}],"darts":null})~"
      "\n";
  EXPECT_EQ(jrule({"explain", "--format", "json", "a.jrule:fan"}).output, json);
  Outcome const copy = jrule({"explain", "copy.jrule:copy", "--dimension", "3"});
  EXPECT_EQ(copy.exit_status, 0);
  EXPECT_TRUE(contains(copy.output, "  C' = 2 * C\n")) << copy.output;
  // Cells of dimension 4 and more have no letter.
  EXPECT_TRUE(contains(jrule({"explain", "copy.jrule:copy", "--dimension", "5"}).output, "  C' = 2 * C\n  4-cells' = ")) << copy.output;
  Outcome const refused = jrule({"explain", "refused.jrule:refused"});
  EXPECT_EQ(refused.exit_status, 1);
  EXPECT_TRUE(contains(refused.output, "J0305")) << refused.output;
  EXPECT_EQ(jrule({"explain", "a.jrule:none"}).exit_status, 1);
}

TEST_F(Commands, UsageErrors) {
  EXPECT_EQ(jrule({}).exit_status, 2);
  EXPECT_EQ(jrule({"frobnicate"}).exit_status, 2);
  EXPECT_EQ(jrule({"check"}).exit_status, 2);
  EXPECT_EQ(jrule({"check", "--no-such-option", "x"}).exit_status, 2);
  EXPECT_EQ(jrule({"--help"}).exit_status, 0);
  EXPECT_EQ(jrule({"apply", "--help"}).exit_status, 0);
  EXPECT_TRUE(contains(jrule({"--version"}).output, "jrule "));
  for (std::string const command : {"lsp"}) {
    Outcome const outcome = jrule({command, "x"});
    EXPECT_EQ(outcome.exit_status, 2);
    EXPECT_TRUE(contains(outcome.output, "[J0902]")) << outcome.output;
  }
}

TEST_F(Commands, RulesWithCppFromOutsideAreNotApplied) {
  file("land.jrule",
       "extern type Soil in \"soil.hpp\" as \"geo::Soil\";\n"
       "extern fn low() -> Real in \"soil.hpp\" as \"geo::low\";\n"
       "modeler Land on gmap(2) { embedding soil : face -> Soil; }\n"
       "modeler Surface on gmap(2) { embedding height : vertex -> Real; }\n"
       "rule keep on Land { left { hook a <0,1>; } right { a; } }\n"
       "rule sink on Surface { left { hook a <1,2>; } right { a { height = low(); } } }\n"
       "rule raise on Surface { left { hook a <1,2>; } right { a { height = 1; } } }\n");
  EXPECT_EQ(jrule({"check", "land.jrule"}).output, "land.jrule: 3 rules accepted\n");
  for (char const* stage : {"ast", "ir", "dot", "certificate", "cpp"}) EXPECT_EQ(jrule({"emit", stage, "land.jrule"}).exit_status, 0) << stage;

  Outcome const keep = jrule({"apply", "land.jrule:keep", "--in", demo("square.off"), "--out", "out.off"});
  EXPECT_EQ(keep.exit_status, 1);
  EXPECT_EQ(keep.output,
            "land.jrule:3:37: error: `keep` cannot be applied here: the embedding `soil` has the extern type `Soil` [J0903]\n"
            "1 | extern type Soil in \"soil.hpp\" as \"geo::Soil\";\n"
            "  |             ---- it is C++ from outside\n"
            "...\n"
            "3 | modeler Land on gmap(2) { embedding soil : face -> Soil; }\n"
            "  |                                     ^^^^\n"
            "  = note: generated C++ can: `jrule emit cpp`, or `jrule_add_rules` in CMake\n");
  Outcome const sink = jrule({"apply", "land.jrule:sink", "--in", demo("square.off"), "--out", "out.off"});
  EXPECT_EQ(sink.exit_status, 1);
  EXPECT_TRUE(contains(sink.output, "land.jrule:6:68: error: `sink` cannot be applied here: `height` of `a` calls the extern function `low` [J0903]\n")) << sink.output;
  // The file has C++ from outside, this rule has not: only the mesh lacks heights.
  EXPECT_TRUE(contains(jrule({"apply", "land.jrule:raise", "--in", demo("square.off"), "--out", "out.off"}).output, "the file has no values of embedding 'height'"));
  EXPECT_EQ(files(), std::vector<std::string>{"land.jrule"});
}

}  // namespace
}  // namespace jrule::tests
