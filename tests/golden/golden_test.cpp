// tests/golden/<area>/<case>.jrule is checked in its folder, a <case>.jme imported by jrule import-jerboa; the exit status and
// all that is printed must be as in <case>.expected. Files in deeper folders are modules for the cases to import. With
// JRULE_UPDATE_GOLDEN=1 the .expected files are written instead (./dev test --update-golden); read the difference before you
// keep it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <initializer_list>
#include <vector>

#include "tests/process/process.h"

namespace jrule::golden {
namespace {

namespace fs = std::filesystem;

/// The files <area>/<name><extension>, relative to this folder, in order.
std::vector<std::string> files_with(std::initializer_list<std::string> extensions) {
  std::vector<std::string> found;
  fs::path const top = JRULE_GOLDEN_DIR;
  for (auto const& area : fs::directory_iterator(top)) {
    if (!area.is_directory()) continue;
    for (auto const& entry : fs::directory_iterator(area)) {
      bool const wanted = std::find(extensions.begin(), extensions.end(), entry.path().extension()) != extensions.end();
      if (wanted) found.push_back(fs::relative(entry.path(), top).string());
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

bool updating() {
  auto const* value = std::getenv("JRULE_UPDATE_GOLDEN");
  return value != nullptr && std::string(value) == "1";
}

/// "syntax/missing semicolon.jrule" -> "syntax__missing_semicolon"
std::string test_name(fs::path const& path) {
  auto name = path.parent_path().string() + "__" + path.stem().string();
  for (char& c : name) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  }
  return name;
}

/// The parameter is the path of the case.
class Golden : public testing::TestWithParam<std::string> {};

TEST_P(Golden, is_as_expected) {
  auto const source = fs::path(JRULE_GOLDEN_DIR) / GetParam();
  auto const outcome = tests::run(source.parent_path(), {JRULE_EXECUTABLE, source.extension() == ".jme" ? "import-jerboa" : "check", source.filename().string()});
  // The statuses that both commands document; anything else is a fault of the compiler, never expected.
  ASSERT_GE(outcome.exit_status, 0);
  ASSERT_LE(outcome.exit_status, 2) << outcome.output;

  auto const found = "exit " + std::to_string(outcome.exit_status) + "\n" + outcome.output;
  auto const expected = fs::path(source).replace_extension(".expected");
  if (updating()) {
    if (!fs::exists(expected) || tests::read(expected) != found) tests::write(expected, found);
    return;
  }
  ASSERT_TRUE(fs::exists(expected)) << "there is no " << expected << "; ./dev test --update-golden writes it:\n"
                                    << found;
  EXPECT_EQ(tests::read(expected), found);
}

INSTANTIATE_TEST_SUITE_P(Files, Golden, testing::ValuesIn(files_with({".jrule", ".jme"})),
                         [](auto const& golden) { return test_name(golden.param); });

TEST(GoldenFiles, each_expected_file_has_its_case) {
  for (auto const& expected : files_with({".expected"})) {
    auto source = fs::path(JRULE_GOLDEN_DIR) / fs::path(expected).replace_extension(".jrule");
    if (!fs::exists(source)) source.replace_extension(".jme");
    EXPECT_TRUE(fs::exists(source)) << expected << " is left over: there is no .jrule or .jme file of that name";
  }
}

}  // namespace
}  // namespace jrule::golden
