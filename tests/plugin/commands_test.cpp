// `jrule info` and `jrule apply --plugin`.
#include "tests/cli/fixture.h"

namespace jrule::tests {
namespace {

class PluginCommands : public CommandLine {
 protected:
  static std::string data(std::string const& name) { return JRULE_SOURCE_DIR "/tests/data/" + name; }
  Outcome apply(std::vector<std::string> words, std::string const& plugin = JRULE_PLUGIN) const {
    words.insert(words.begin(), {"apply", "--plugin", plugin, "--out", "out.jmap"});
    return jrule(words);
  }
  void refused(Outcome const& outcome, int status, std::string const& text) const {
    EXPECT_EQ(outcome.exit_status, status);
    EXPECT_EQ(outcome.output, text + "\n");
    EXPECT_FALSE(std::filesystem::exists(folder() / "out.jmap"));
  }
};

bool contains(std::string const& text, std::string const& part) { return text.find(part) != std::string::npos; }

TEST_F(PluginCommands, InfoListsWhatItOffers) {
  Outcome const outcome = jrule({"info", JRULE_PLUGIN});
  EXPECT_EQ(outcome.exit_status, 0);
  EXPECT_TRUE(outcome.output.starts_with("plugin shapes: 2 modelers, 11 rules\n")) << outcome.output;
  EXPECT_TRUE(contains(outcome.output,
                       "\nmodeler Surface on gmap(2)\n  Surfaces whose faces are counted, marked and painted.\n"
                       "  embedding position : <1,2> -> Point3\n    Where a \"corner\" lies.\n"
                       "  embedding color : <0,1> -> Color = Color(0.8, 0.8, 0.8)\n"
                       "  embedding visits : <0,1> -> Int = 0\n  embedding marked : <0,1> -> Bool = false\n"))
      << outcome.output;
  EXPECT_TRUE(
      contains(outcome.output,
               "\nmodeler Sky on omap(2)\n  Faces under clouds.\n  embedding cover : <1> -> extern = (computed)\n"))
      << outcome.output;
  EXPECT_TRUE(contains(outcome.output,
                       "\nrule square on Surface (shapes)\n  A square\n  that lies \\ stands alone.\n  parameter size "
                       ": Real [m] = 0.5\n    of its sides\n"))
      << outcome.output;
  EXPECT_TRUE(contains(outcome.output,
                       "\nrule cone on Surface (shapes)\n  Raises a cone on an isolated face.\n  hook a <0,1>\n    any "
                       "dart of the face\n  parameter apex : Point3 = Point3(0, 0, 1)\n"))
      << outcome.output;
  EXPECT_TRUE(contains(outcome.output, "  not callable: its parameter `cloud` is of the C++ type `Cloud`\n"))
      << outcome.output;
  refused(jrule({"info", JRULE_PLUGIN, "--stats", "json"}), 2,
          "jrule: error: `--stats` counts the cells of a mesh: a plugin has none");
}

TEST_F(PluginCommands, ApplyPrintsAndWritesWhatTheSourceDoes) {
  std::string const source = JRULE_SOURCE_DIR "/tests/plugin/rules/shapes.jrule:";
  struct Case {
    std::string rule;
    std::vector<std::string> words;
  };
  for (Case const& c :
       {Case{"quad_subdivision", {"--in", data("cube.obj")}}, Case{"square", {"size=3"}}, Case{"square", {}},
        Case{"paint", {"--in", data("patch.obj"), "--at", "face:2", "paint=0,0.5,1"}},
        Case{"zip", {"--in", data("patch.obj"), "--at", "dart:0,edge:3"}}}) {
    SCOPED_TRACE(c.rule);
    std::vector<std::string> words = c.words;
    words.insert(words.begin(), c.rule);
    words.insert(words.end(), {"--stats", "json"});
    Outcome const plugged = apply(words);
    words.insert(words.begin(), {"apply", "--out", "source.jmap"});
    words[3] = source + c.rule;
    Outcome const interpreted = jrule(words);
    EXPECT_EQ(plugged.exit_status, interpreted.exit_status);
    EXPECT_EQ(plugged.output, interpreted.output);
    ASSERT_EQ(std::filesystem::exists(folder() / "out.jmap"), interpreted.exit_status == 0);
    if (interpreted.exit_status != 0) continue;
    EXPECT_EQ(content("out.jmap"), content("source.jmap"));
    std::filesystem::remove(folder() / "out.jmap");
  }
  Outcome const people = apply({"quad_subdivision", "--in", data("cube.obj")});
  EXPECT_EQ(people.exit_status, 0);
  EXPECT_TRUE(people.output.starts_with(
      "quad_subdivision: applied everywhere\n26 vertices, 48 edges, 24 faces, 192 darts, valid\n"))
      << people.output;
}

TEST_F(PluginCommands, ARuleOfOneOfSeveralModules) {
  EXPECT_EQ(apply({"outside:soak", "--in", data("cube.obj"), "falls=2"}).exit_status, 0);
  EXPECT_EQ(apply({"soak", "--in", data("cube.obj"), "--at", "face:0"}).exit_status, 0);  // by its computed default
  std::filesystem::remove(folder() / "out.jmap");
  refused(apply({"sew", "--in", data("cube.obj"), "--at", "dart:0,dart:1"}), 2,
          std::string(JRULE_PLUGIN) + ": error: 2 modules have a rule `sew`: write `shapes:sew`");
  Outcome const chosen = apply({"shapes:sew", "--in", data("cube.obj"), "--at", "dart:0,dart:1"});
  EXPECT_EQ(chosen.exit_status, 1);
  EXPECT_TRUE(contains(chosen.output, "`sew` is not applicable")) << chosen.output;
}

TEST_F(PluginCommands, WhatIsWrongIsSaid) {
  std::string const error = "jrule: error: ";
  refused(apply({"spin", "--in", data("cube.obj")}), 2,
          std::string(JRULE_PLUGIN) + ": error: it has no rule or operation `spin`: `jrule info` lists what it has");
  refused(apply({"spin", "--in", data("cube.obj"), "--threads", "2"}), 2,
          error + "`--threads` is for rules of a source file: those of a plugin take one");
  refused(apply({"cone"}), 2, error + "`cone` is applied to a mesh: give one with `--in`");
  refused(apply({"cone", "--in", "none.obj"}), 2, "none.obj: error: cannot read the file: No such file or directory");
  refused(apply({"cone", "--in", data("cube.obj"), "height=3"}), 2,
          error + "`cone` has no parameter `height`; it has `apex`");
  refused(apply({"cone", "--in", data("cube.obj"), "apex=3"}), 2, error + "`3` is not a Point3: write `apex=0,0,1`");
  refused(apply({"paint", "--in", data("cube.obj")}), 2,
          error + "the parameter `paint` of `paint` is missing: write `paint=0,0,1`");
  refused(apply({"cone", "--in", data("cube.obj"), "--at", "face:6"}), 2,
          error + "there is no face 6: the map has 6 of them, numbered from 0");
  refused(apply({"cone", "--in", data("cube.obj"), "--at", "dart:48"}), 2,
          error + "there is no dart 48: the map has 48 darts");
  refused(apply({"cone", "--in", data("cube.obj"), "--at", "volume:0"}), 2,
          error + "a map of dimension 2 has no 3-cells");
  refused(apply({"cone", "--in", data("cube.obj"), "--at", "dart:0,dart:1"}), 2, error + "`cone` has 1 hook, not 2");
  refused(apply({"zip", "--in", data("cube.obj")}), 2,
          error + "`zip` has 2 hooks: give a dart for each, `--at dart:3,dart:17`");
  refused(apply({"square", "--at", "face:0"}), 2, error + "`square` has no hook: `--at` says nothing here");
  refused(apply({"cover", "--in", data("cube.obj")}), 2,
          error + "`cover` cannot be applied from here: its parameter `cloud` is of the C++ type `Cloud`");
  refused(apply({"soak", "--in", data("cube.obj"), "falls=-1"}), 2, error + "negative rain");
  refused(apply({"square", "--picture", "a.svg"}), 2,
          error + "`--picture` draws what rules of a source file give, not those of a plugin");
  Outcome const nowhere = apply({"cone", "--in", data("cube.obj")});
  EXPECT_EQ(nowhere.exit_status, 1);
  EXPECT_TRUE(nowhere.output.starts_with(error + "`cone` is not applicable: ")) << nowhere.output;
}

TEST_F(PluginCommands, LibrariesThatAreNoPlugins) {
  file("text.so", "not a library");
  struct Case {
    std::string path, what;
    bool is_there = true;
  };
  for (Case const& c :
       {Case{JRULE_WRONG_VERSION, "it is a plugin of version 999, but this jrule takes version 1: build it again"},
        Case{JRULE_WRONG_SIZES, "its tables are of other sizes than this jrule's: build it again"},
        Case{JRULE_NO_ENTRY, "it is no plugin: it does not export `jrule_plugin_entry`"},
        Case{"text.so", "it cannot be loaded as a plugin: "}, Case{"none.so", "cannot read the file", false}}) {
    SCOPED_TRACE(c.path);
    Outcome const applied = apply({"cone", "--in", data("cube.obj")}, c.path);
    EXPECT_EQ(applied.exit_status, 2);
    EXPECT_TRUE(applied.output.starts_with(c.path + ": error: " + c.what)) << applied.output;
    Outcome const listed = jrule({"info", c.path});
    EXPECT_EQ(listed.exit_status, c.is_there ? 1 : 2);
    EXPECT_EQ(listed.output, applied.output);
  }
  EXPECT_EQ(files(), std::vector<std::string>{"text.so"});
}

TEST_F(PluginCommands, EmitPlugin) {
  std::string const rules = JRULE_SOURCE_DIR "/tests/plugin/rules/";
  Outcome const one = jrule({"emit", "plugin", rules + "shapes.jrule", "-o", "one"});
  EXPECT_EQ(one.exit_status, 0) << one.output;
  EXPECT_TRUE(contains(content("one/shapes_plugin.cpp"), "#include \"shapes.h\"\n"));
  EXPECT_EQ(jrule({"emit", "plugin", rules + "shapes.jrule", rules + "outside.jrule", "--name", "both", "-o", "two",
                   "--depfile", "two/d"})
                .exit_status,
            0);
  EXPECT_TRUE(content("two/both_plugin.cpp")
                  .starts_with("// Generated by jrule from shapes.jrule, outside.jrule: changes will be lost.\n"));
  EXPECT_TRUE(contains(content("two/d"), "both_plugin.cpp: ")) << content("two/d");
  EXPECT_TRUE(contains(content("two/d"), "outside.jrule")) << content("two/d");

  refused(jrule({"emit", "cpp", rules + "shapes.jrule", rules + "outside.jrule"}), 2,
          "jrule: error: `emit cpp` shows one file, `emit plugin` takes several");
  refused(jrule({"emit", "plugin", rules + "shapes.jrule", demo("../../tests/plugin/rules/shapes.jrule")}), 2,
          "jrule: error: two files are called `shapes`: a plugin takes each name once");
  Outcome const wrong = jrule({"emit", "plugin", rules + "shapes.jrule", demo("wrong.jrule"), "-o", "three"});
  EXPECT_EQ(wrong.exit_status, 1);
  EXPECT_TRUE(contains(wrong.output, "wrong.jrule:")) << wrong.output;
  EXPECT_FALSE(std::filesystem::exists(folder() / "three"));
  file("names.jrule", "rule delete on gmap(2) { left { hook a <>; } right { a; } }\nmodeler M on gmap(2);\nrule new on M { left { hook a <>; } right { a; } }\n");
  Outcome const unusable = jrule({"emit", "plugin", "names.jrule", "-o", "three"});
  EXPECT_EQ(unusable.exit_status, 1);
  EXPECT_TRUE(contains(unusable.output, "[J0901]")) << unusable.output;
  EXPECT_FALSE(std::filesystem::exists(folder() / "three"));
}

}  // namespace
}  // namespace jrule::tests
