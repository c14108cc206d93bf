// jrule import-jerboa; how single files are imported is in tests/golden/jerboa.
#include <cstdlib>
#include <string_view>

#include "tests/cli/fixture.h"

namespace jrule::tests {
namespace {

class ImportJerboa : public CommandLine {
 protected:
  static std::string golden(std::string const& name) { return JRULE_SOURCE_DIR "/tests/golden/jerboa/" + name; }
};

std::size_t count(std::string_view text, std::string_view part) {
  std::size_t result = 0;
  for (std::size_t at = text.find(part); at != std::string_view::npos; at = text.find(part, at + 1)) ++result;
  return result;
}

TEST_F(ImportJerboa, WritesAModuleThatIsChecked) {
  Outcome const imported = jrule({"import-jerboa", golden("translated.jme"), "-o", "out"});
  ASSERT_EQ(imported.exit_status, 0) << imported.output;
  Outcome const layout = jrule({"fmt", "--check", "out/translated.jrule"});
  EXPECT_EQ(layout.exit_status, 0) << layout.output;
  // `Broken` is written as it is, and it is for the compiler to refuse it.
  Outcome const checked = jrule({"check", "out/translated.jrule"});
  EXPECT_EQ(checked.exit_status, 1);
  EXPECT_NE(checked.output.find("J0210"), std::string::npos) << checked.output;
  EXPECT_EQ(count(checked.output, "error:"), 1U) << checked.output;
}

TEST_F(ImportJerboa, ImportedRulesRun) {
  std::string module = jrule({"import-jerboa", golden("translated.jme")}).output;
  file("m.jrule", module.substr(0, module.find("rule Broken")));
  ASSERT_EQ(jrule({"apply", "m.jrule:Triangle", "--out", "triangle.jmap"}).exit_status, 0);
  Outcome const cone = jrule({"apply", "m.jrule:Cone", "--in", "triangle.jmap", "--out", "cone.jmap", "--stats", "json", "height=2"});
  EXPECT_NE(cone.output.find("\"cells\":[4,6,4]"), std::string::npos) << cone.output;
  EXPECT_NE(content("cone.jmap").find("1 0.5 1\n"), std::string::npos) << content("cone.jmap");
}

TEST_F(ImportJerboa, WritesToAFileAFolderOrStandardOutput) {
  ASSERT_EQ(jrule({"import-jerboa", golden("translated.jme"), "-o", "a.jrule"}).exit_status, 0);
  ASSERT_EQ(jrule({"import-jerboa", golden("translated.jme"), "-o", "deep/folder"}).exit_status, 0);
  Outcome const printed = jrule({"import-jerboa", golden("translated.jme")});
  EXPECT_EQ(printed.exit_status, 0);
  EXPECT_EQ(content("a.jrule"), printed.output);
  EXPECT_EQ(content("deep/folder/translated.jrule"), printed.output);
}

TEST_F(ImportJerboa, LeavesTheOutputAloneIfThereAreErrors) {
  file("m.jrule", "// mine\n");
  for (auto const* wrong : {"not_closed.jme", "missing.jme", "arcs.jme"}) {
    EXPECT_EQ(jrule({"import-jerboa", golden(wrong), "-o", "m.jrule"}).exit_status, 1) << wrong;
  }
  EXPECT_EQ(jrule({"import-jerboa", golden("untranslated.jme"), "-Werror", "-o", "m.jrule"}).exit_status, 1);
  EXPECT_EQ(content("m.jrule"), "// mine\n");
  EXPECT_EQ(files(), std::vector<std::string>{"m.jrule"});
}

TEST_F(ImportJerboa, FilesThatCannotBeReadOrWritten) {
  EXPECT_EQ(jrule({"import-jerboa", "absent.jme"}).exit_status, 2);
  EXPECT_EQ(jrule({"import-jerboa", golden("translated.jme"), "-o", "/proc/none/m.jrule"}).exit_status, 2);
  file("same.jrule", "<jerboamodelereditor><modeler name=\"M\" dimension=\"2\"/></jerboamodelereditor>");
  EXPECT_EQ(jrule({"import-jerboa", "same.jrule", "-o", "same.jrule"}).exit_status, 2);
  EXPECT_TRUE(content("same.jrule").starts_with("<jerboa"));
}

TEST_F(ImportJerboa, MessagesAsJson) {
  Outcome const outcome = jrule({"import-jerboa", golden("arcs.jme"), "--message-format", "json"});
  EXPECT_EQ(outcome.exit_status, 1);
  EXPECT_NE(outcome.output.find("\"code\":\"J0605\""), std::string::npos) << outcome.output;
}

// Whatever is cut off, there is a message and nothing is written.
TEST_F(ImportJerboa, PiecesOfAFile) {
  std::string const whole = read(golden("translated.jme"));
  for (std::size_t size = 0; size + 40 < whole.size(); size += 397) {
    file("piece.jme", whole.substr(0, size));
    Outcome const outcome = jrule({"import-jerboa", "piece.jme", "-o", "out"});
    EXPECT_EQ(outcome.exit_status, 1) << size;
    EXPECT_NE(outcome.output.find("error: "), std::string::npos) << size;
  }
  EXPECT_EQ(files(), std::vector<std::string>{"piece.jme"});
}

// What is no text, behind entities.
TEST_F(ImportJerboa, EntitiesThatAreNoText) {
  file("m.jme", "<jerboamodelereditor><modeler name=\"a&#1;b\" dimension=\"2\"><comment>&#xD800;&#x7;&#xE9;</comment><rules/></modeler></jerboamodelereditor>");
  Outcome const outcome = jrule({"import-jerboa", "m.jme", "-o", "m.jrule"});
  EXPECT_EQ(outcome.exit_status, 0) << outcome.output;
  EXPECT_EQ(jrule({"check", "m.jrule"}).exit_status, 0) << content("m.jrule");
}

// A modeler of 50 rules from elsewhere: JRULE_JERBOA_SAMPLE names it.
TEST_F(ImportJerboa, AModelerOfFiftyRules) {
  char const* const named = std::getenv("JRULE_JERBOA_SAMPLE");
  if (named == nullptr || *named == '\0') GTEST_SKIP() << "JRULE_JERBOA_SAMPLE names no .jme file: JerboaTrackingOrbit.jme of the project jerboa-rebuild";
  ASSERT_TRUE(std::filesystem::exists(named)) << named;
  Outcome const imported = jrule({"import-jerboa", named, "-o", "sample.jrule"});
  ASSERT_EQ(imported.exit_status, 0) << imported.output;
  EXPECT_EQ(count(content("sample.jrule"), "\nrule "), 50U);
  EXPECT_EQ(jrule({"fmt", "--check", "sample.jrule"}).exit_status, 0);
  Outcome const shown = jrule({"emit", "ast", "sample.jrule"});
  EXPECT_EQ(shown.output.find("[J01"), std::string::npos);
  // Every value is translated; what is not is code around the applications.
  EXPECT_EQ(count(imported.output, "the value of"), 0U) << imported.output;
  EXPECT_EQ(count(imported.output, "[J0611]"), 4U) << imported.output;
}

}  // namespace
}  // namespace jrule::tests
