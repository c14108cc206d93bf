// Every code of diagnostics.def is shown by a golden test and explained by a page whose examples do what it says.
#include <gtest/gtest.h>
#include <unistd.h>

#include <optional>
#include <ostream>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "compiler/source/diagnostic.h"
#include "tests/process/process.h"

namespace jrule::source {

/// How GoogleTest names a code in its messages.
void PrintTo(CodeInfo const& code, std::ostream* out) { *out << code.number << " " << code.name; }

}  // namespace jrule::source

namespace jrule::golden {
namespace {

namespace fs = std::filesystem;
using source::CodeInfo;

std::vector<std::string> lines_of(std::string_view text) {
  std::istringstream in{std::string(text)};
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

// ---------------------------------------------------------------------------------------------------------- exempt.txt

struct Exemptions {
  std::set<std::string> golden;
  std::set<std::string> page;
  std::vector<std::string> malformed;
};

Exemptions exemptions() {
  Exemptions result;
  for (auto const& line : lines_of(tests::read(fs::path(JRULE_GOLDEN_DIR) / "exempt.txt"))) {
    if (line.empty() || line.starts_with('#')) continue;
    std::istringstream words(line);
    std::string code, kinds, reason;
    words >> code >> kinds >> reason;
    bool const golden = kinds == "golden" || kinds == "golden,page";
    bool const page = kinds == "page" || kinds == "golden,page";
    if (reason.empty() || !(golden || page) || source::find_code(code) == nullptr) result.malformed.push_back(line);
    if (golden) result.golden.insert(code);
    if (page) result.page.insert(code);
  }
  return result;
}

TEST(Exemptions, are_of_known_codes_and_have_reasons) { EXPECT_EQ(exemptions().malformed, std::vector<std::string>{}); }

// ----------------------------------------------------------------------------------------------------------------
// pages

/// The text of the first block fenced as ```KIND.
std::optional<std::string> block(std::string_view page, std::string const& kind) {
  std::optional<std::string> text;
  for (auto const& line : lines_of(page)) {
    if (text && line == "```") return text;
    if (text) *text += line + "\n";
    if (!text && line == "```" + kind) text = "";
  }
  return std::nullopt;
}

/// The part of the page below a heading, to the next one of the same level.
std::string section(std::string_view page, std::string const& heading) {
  std::string text;
  bool inside = false;
  for (auto const& line : lines_of(page)) {
    if (line.starts_with("## ")) inside = line == "## " + heading;
    if (inside) text += line + "\n";
  }
  return text;
}

/// A folder that is gone when the test ends.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    auto name = (fs::temp_directory_path() / "jrule-example-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot make a folder like " + name);
    path_ = name;
  }
  ~TemporaryFolder() {
    std::error_code ignored;  // a destructor cannot report it
    fs::remove_all(path_, ignored);
  }
  TemporaryFolder(TemporaryFolder const&) = delete;
  TemporaryFolder& operator=(TemporaryFolder const&) = delete;
  fs::path const& path() const { return path_; }

 private:
  fs::path path_;
};

tests::Outcome check_text(std::string const& text) {
  TemporaryFolder const folder;
  tests::write(folder.path() / "example.jrule", text);
  return tests::run(folder.path(), {JRULE_EXECUTABLE, "check", "example.jrule"});
}

// ----------------------------------------------------------------------------------------------------------------
// tests

class EachCode : public testing::TestWithParam<CodeInfo> {
 protected:
  std::string number() const { return std::string(GetParam().number); }
  std::string tag() const { return "[" + number() + "]"; }
  std::string_view page() const { return source::explanation(GetParam().code); }
};

TEST_P(EachCode, is_shown_by_a_golden_test) {
  std::vector<fs::path> shown;
  for (auto const& entry : fs::recursive_directory_iterator(JRULE_GOLDEN_DIR)) {
    if (entry.path().extension() != ".expected") continue;
    if (tests::read(entry.path()).find(tag()) != std::string::npos) shown.push_back(entry.path());
  }
  if (exemptions().golden.contains(number())) {
    EXPECT_TRUE(shown.empty()) << "exempt.txt need not exempt it: it is shown by " << shown.front();
  } else {
    EXPECT_FALSE(shown.empty()) << "no golden test shows " << number() << " (" << GetParam().name << ")";
  }
}

TEST_P(EachCode, has_a_page) {
  auto const file = "compiler/source/explain/" + number() + ".md";
  ASSERT_FALSE(page().empty()) << "there is no " << file;
  auto const lines = lines_of(page());
  EXPECT_EQ(lines.front(), "# " + number() + ": " + std::string(GetParam().title)) << file;
  for (auto const* heading : {"Wrong", "Right", "Reference"}) {
    EXPECT_NE(section(page(), heading).find_first_not_of("# \n", 4 + std::string_view(heading).size()),
              std::string::npos)
        << file << " has nothing under `## " << heading << "`";
  }
}

TEST_P(EachCode, has_examples_that_are_wrong_and_right) {
  auto const wrong = block(section(page(), "Wrong"), "jrule wrong");
  auto const right = block(section(page(), "Right"), "jrule right");
  if (exemptions().page.contains(number())) {
    EXPECT_FALSE(wrong && right) << "exempt.txt need not exempt the page";
    EXPECT_TRUE(wrong || block(section(page(), "Wrong"), "text")) << "no example under `## Wrong`";
    EXPECT_TRUE(right || block(section(page(), "Right"), "text")) << "no example under `## Right`";
  } else {
    EXPECT_TRUE(wrong) << "no block ```jrule wrong under `## Wrong`";
    EXPECT_TRUE(right) << "no block ```jrule right under `## Right`";
  }
  if (wrong) {
    auto const outcome = check_text(*wrong);
    EXPECT_EQ(outcome.exit_status, GetParam().severity == source::Severity::error ? 1 : 0) << outcome.output;
    EXPECT_NE(outcome.output.find(tag()), std::string::npos) << outcome.output;
  }
  if (right) {
    auto const outcome = check_text(*right);
    EXPECT_EQ(outcome.exit_status, 0) << outcome.output;
    EXPECT_EQ(outcome.output.find(tag()), std::string::npos) << outcome.output;
  }
}

INSTANTIATE_TEST_SUITE_P(Codes, EachCode, testing::ValuesIn(source::all_codes()),
                         [](auto const& tested) { return std::string(tested.param.number); });

TEST(Pages, belong_to_codes) {
  for (auto const& entry : fs::directory_iterator(fs::path(JRULE_SOURCE_DIR) / "compiler/source/explain")) {
    EXPECT_NE(source::find_code(entry.path().stem().string()), nullptr) << "no code has the page " << entry.path();
  }
}

}  // namespace
}  // namespace jrule::golden
