// examples/growth: a tissue, step by step.
#include <set>
#include <sstream>

#include "tests/cli/fixture.h"

namespace jrule::tests {
namespace {

class Growth : public CommandLine {
 protected:
  Outcome grow(std::string const& out, std::vector<std::string> arguments) const {
    std::vector<std::string> words{"run", rules() + ":grow", "--out", out};
    words.insert(words.end(), arguments.begin(), arguments.end());
    return jrule(words);
  }
  Outcome step(std::string const& in, std::string const& out, std::vector<std::string> arguments) const {
    std::vector<std::string> words{"run", rules() + ":step", "--in", in, "--at", "dart:0", "--out", out};
    words.insert(words.end(), arguments.begin(), arguments.end());
    return jrule(words);
  }
  /// The values of an embedding of one number, each once.
  std::set<std::string> values(std::string const& map, std::string const& embedding) const {
    std::istringstream lines(content(map));
    std::set<std::string> found;
    for (std::string line; std::getline(lines, line);) {
      std::istringstream words(line);
      std::string keyword, name, type;
      std::size_t count = 0;
      if (!(words >> keyword >> name >> type >> count) || keyword != "embedding" || name != embedding) continue;
      for (; count > 0 && std::getline(lines, line); --count) found.insert(line);
      return found;
    }
    ADD_FAILURE() << map << " has no " << embedding;
    return found;
  }

  static std::string rules() { return JRULE_SOURCE_DIR "/examples/growth/growth.jrule"; }
};

using Values = std::set<std::string>;

// Corners, walls and cells of each step. The steps go through files, as somebody has them who looks at each.
TEST_F(Growth, IsAWholeTissueAfterEachStep) {
  struct Cells {
    int corners, walls, cells;
  };
  std::vector<Cells> const expected{{4, 4, 1},       {6, 7, 2},       {6, 7, 2},       {6, 7, 2},       {10, 13, 4},
                                    {10, 13, 4},     {16, 22, 7},     {18, 25, 8},     {24, 34, 11},    {30, 43, 14},
                                    {38, 55, 18},    {48, 70, 23},    {68, 100, 33},   {82, 121, 40},   {118, 175, 58},
                                    {142, 211, 70},  {186, 277, 92},  {226, 337, 112}, {290, 433, 144}, {360, 539, 180},
                                    {416, 623, 208}, {522, 784, 263}, {588, 888, 301}, {711, 1071, 361}};
  ASSERT_EQ(grow("0.jmap", {"steps=0"}).exit_status, 0);
  for (std::size_t k = 0; k < expected.size(); ++k) {
    std::string const before = std::to_string(k) + ".jmap", after = std::to_string(k + 1) + ".jmap";
    Outcome const made = step(before, after, {});
    ASSERT_EQ(made.exit_status, 0) << "step " << k + 1 << ": " << made.output;
    Outcome const stats = jrule({"info", after, "--stats", "json"});
    auto const [corners, walls, cells] = expected[k];
    EXPECT_EQ(corners - walls + cells, 1) << "step " << k + 1;  // a disk
    std::string const counts =
        "\"cells\":[" + std::to_string(corners) + "," + std::to_string(walls) + "," + std::to_string(cells) + "]";
    EXPECT_NE(stats.output.find(counts), std::string::npos) << "step " << k + 1 << ": " << stats.output;
    for (std::string const part : {"\"components\":1,", "\"valid\":true"})
      EXPECT_NE(stats.output.find(part), std::string::npos) << stats.output;
  }
}

TEST_F(Growth, GivesTheSameBytesTwice) {
  ASSERT_EQ(grow("one.jmap", {"steps=18"}).exit_status, 0);
  ASSERT_EQ(grow("two.jmap", {"steps=18"}).exit_status, 0);
  EXPECT_EQ(content("one.jmap"), content("two.jmap"));
  ASSERT_EQ(step("one.jmap", "more.jmap", {}).exit_status, 0);
  ASSERT_EQ(grow("19.jmap", {"steps=19"}).exit_status, 0);
  EXPECT_EQ(content("more.jmap"), content("19.jmap"));
}

// States follow each other: stem cells, then some that have grown up, then some that die and go.
TEST_F(Growth, CellsGrowUpAndDie) {
  ASSERT_EQ(grow("young.jmap", {"steps=6"}).exit_status, 0);
  EXPECT_EQ(values("young.jmap", "kind"), (Values{"0"}));
  ASSERT_EQ(grow("grown.jmap", {"steps=16"}).exit_status, 0);
  EXPECT_EQ(values("grown.jmap", "kind"), (Values{"0", "1"}));
  ASSERT_EQ(grow("old.jmap", {"steps=24"}).exit_status, 0);
  EXPECT_EQ(values("old.jmap", "kind"), (Values{"0", "1", "2"}));
  // Who lives for ever leaves no gap.
  Outcome const immortal = grow("immortal.jmap", {"steps=24", "life=100"});
  EXPECT_EQ(values("immortal.jmap", "kind"), (Values{"0", "1"}));
  EXPECT_NE(immortal.output.find("374 faces"), std::string::npos) << immortal.output;
}

TEST_F(Growth, RefusesWhatMakesNoSense) {
  for (auto const& [argument, message] :
       std::vector<std::pair<std::string, std::string>>{{"steps=-1", "`grow` failed: time does not run backwards"},
                                                        {"rate=-0.1", "`step` failed: cells do not shrink to grow"},
                                                        {"life=-1", "`step` failed: a life is at least 0 steps long"},
                                                        {"steps=1.5", "`1.5` is not an Int: write `steps=3`"}}) {
    Outcome const refused = grow("x.jmap", {argument});
    EXPECT_NE(refused.exit_status, 0) << argument;
    EXPECT_NE(refused.output.find(message), std::string::npos) << refused.output;
  }
  EXPECT_EQ(files(), std::vector<std::string>{});
}

}  // namespace
}  // namespace jrule::tests
