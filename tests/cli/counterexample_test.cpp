// `jrule check --counterexample DIR`: what it says and what it leaves in the folder.
#include "jrule/io.h"
#include "tests/cli/fixture.h"

namespace jrule::tests {
namespace {

class Counterexamples : public CommandLine {
 protected:
  Counterexamples() {
    file("bad.jrule",
         "modeler M on gmap(2);\n"
         "rule half on M { left { hook a <>; c; a -2- c; } right { a; c; a -2- a; c -2- c; } }\n"
         "rule never on M { left { hook a <0,1,2>; a -2- a; } right { a; } }\n"
         "rule good on M { left { hook a <0>; a -2- a; } right { a; a -2- a; } }\n");
  }
  static bool contains(std::string const& text, std::string const& part) {
    return text.find(part) != std::string::npos;
  }
};

TEST_F(Counterexamples, StandInTheNotes) {
  Outcome const outcome = jrule({"check", "bad.jrule"});
  EXPECT_EQ(outcome.exit_status, 1);
  EXPECT_TRUE(contains(outcome.output,
                       "note: counterexample: in this map of 4 darts, applied at dart 0 (hook `a`), the rule leaves no "
                       "2-G-map: dart 0: the path "
                       "0202 does not return (it ends at dart 1); dart 0 is a copy of `a`\n"))
      << outcome.output;
  EXPECT_TRUE(contains(outcome.output, "note: 2: 0-1 2-3\n")) << outcome.output;
  EXPECT_TRUE(contains(outcome.output, "note: no counterexample was found, nor any map that the left side matches\n"))
      << outcome.output;
  EXPECT_FALSE(contains(outcome.output, "written to")) << outcome.output;
  EXPECT_EQ(files(), std::vector<std::string>{"bad.jrule"});
}

TEST_F(Counterexamples, AreWritten) {
  Outcome const outcome = jrule({"check", "bad.jrule", "--counterexample", "shown"});
  EXPECT_EQ(outcome.exit_status, 1);
  EXPECT_TRUE(
      contains(outcome.output, "note: written to shown/half-before.jmap, shown/half-after.jmap and shown/half.svg\n"))
      << outcome.output;
  auto const before = read_jmap((folder() / "shown/half-before.jmap").string());
  ASSERT_TRUE(before) << to_string(before.error());
  EXPECT_EQ(before->dart_count(), 4U);
  EXPECT_FALSE(read_jmap((folder() / "shown/half-after.jmap").string()));
  EXPECT_TRUE(content("shown/half-after.jmap").starts_with("jmap 1\nmodel gmap 2\ndarts 4\n"));
  EXPECT_TRUE(content("shown/half.svg").starts_with("<svg "));
  EXPECT_FALSE(std::filesystem::exists(folder() / "shown/never-before.jmap"));
  EXPECT_FALSE(std::filesystem::exists(folder() / "shown/good-before.jmap"));
}

TEST_F(Counterexamples, AFolderThatCannotBeMadeIsAnError) {
  file("taken", "");
  EXPECT_EQ(jrule({"check", "bad.jrule", "--counterexample", "taken"}).exit_status, 2);
}

}  // namespace
}  // namespace jrule::tests
