#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

#include "compiler/backend/draw/draw.h"
#include "tests/unit/drawn_rule.h"

namespace jrule::draw {
namespace {

using tests::letter;
using tests::RuleBuilder;
using tests::Side;

/// The statements of the picture that contain `part`.
std::vector<std::string> lines_with(std::string const& text, std::string const& part) {
  std::vector<std::string> found;
  for (std::size_t begin = 0; begin < text.size();) {
    std::size_t const end = text.find('\n', begin);
    std::string line = text.substr(begin, end - begin);
    line.erase(0, line.find_first_not_of(' '));
    if (line.find(part) != std::string::npos) found.push_back(std::move(line));
    begin = end + 1;
  }
  return found;
}

using Lines = std::vector<std::string>;

TEST(RuleDot, QuadSubdivision) {
  RuleBuilder const builder = tests::quad_subdivision();
  ASSERT_EQ(ir::verify(builder.rule()), std::nullopt);
  EXPECT_EQ(rule_dot(builder.rule()), R"(digraph "quad_subdivision" {
  graph [label="quad_subdivision on Surface", labelloc=t, fontname="Helvetica", nodesep=0.5, ranksep=0.6];
  node [shape=circle, fontname="Helvetica", width=0.45, margin=0.03];
  edge [fontname="Helvetica", fontsize=11, arrowsize=0.7];
  subgraph cluster_left {
    label="left"; style=rounded; color=gray60; margin=16;
    l0 [label="a", peripheries=2];
    l0 -> l0 [label=" 0[0] ", dir=none, color="#c62828", fontcolor="#c62828"];
    l0 -> l0 [label=" 1[1] ", dir=none];
    l0 -> l0 [label=" 2[2] ", dir=none];
  }
  subgraph cluster_right {
    label="right"; style=rounded; color=gray60; margin=16;
    r0 [label="a", peripheries=2];
    r1 [label="b", color="#c62828", fontcolor="#c62828"];
    r2 [label="c", color="#c62828", fontcolor="#c62828"];
    r3 [label="d", color="#c62828", fontcolor="#c62828"];
    r0 -> r0 [label=" 1[1] ", dir=none];
    r0 -> r0 [label=" 2[2] ", dir=none];
    r1 -> r1 [label=" 2[2] ", dir=none, color="#c62828", fontcolor="#c62828"];
    r2 -> r2 [label=" 2[0] ", dir=none, color="#c62828", fontcolor="#c62828"];
    r3 -> r3 [label=" 2[0] ", dir=none, color="#c62828", fontcolor="#c62828"];
    r3 -> r3 [label=" 1[1] ", dir=none, color="#c62828", fontcolor="#c62828"];
    r0 -> r1 [label=" 0 ", dir=none, color="#c62828", fontcolor="#c62828"];
    r1 -> r2 [label=" 1 ", dir=none, color="#c62828", fontcolor="#c62828"];
    r2 -> r3 [label=" 0 ", dir=none, color="#c62828", fontcolor="#c62828"];
  }
}
)");
}

TEST(RuleDot, OrientedArcsAndWords) {
  RuleBuilder builder("quad_subdivision", omap(2));
  builder.node("a", Side::both, true).node("b", Side::right);
  builder.arc(Side::left, 0, 1, {letter(1)}, 0);                                            // an oriented loop
  builder.arc(Side::right, 1, 1, {letter(1, true)}, 0);                                     // an oriented arc
  builder.arc(Side::right, 0, 2, {letter(1)}, 1).arc(Side::right, 1, 2, {letter(1, true)}, 0);  // not its own conjugate
  std::string const dot = rule_dot(builder.rule());
  EXPECT_EQ(lines_with(dot, "->"),
            (Lines{"l0 -> l0 [label=\" 1[1] \", color=\"#c62828\", fontcolor=\"#c62828\"];",
                   "r1 -> r0 [label=\" 1[~1] \", color=\"#c62828\", fontcolor=\"#c62828\"];",
                   "r0 -> r1 [label=\" 2[1] \", dir=back, arrowtail=odot, color=\"#c62828\", "
                   "fontcolor=\"#c62828\"];"}));
}

TEST(RuleDot, ALoopAndItsReverseAreOneLine) {
  RuleBuilder builder("twist", gmap(3));
  builder.node("a", Side::both, true);
  Word const turn{letter(0), letter(1)}, back{letter(1), letter(0)};
  builder.arc(Side::both, 0, 3, turn, 0).arc(Side::both, 0, 3, back, 0);
  EXPECT_EQ(lines_with(rule_dot(builder.rule()), "->"),
            (Lines{"l0 -> l0 [label=\" 3[0,1] \", dir=none];", "r0 -> r0 [label=\" 3[0,1] \", dir=none];"}));
}

TEST(RuleDot, AReverseOfAnotherColourIsAnArrowOfItsOwn) {
  RuleBuilder builder("half", gmap(2));
  builder.node("a", Side::both, true).node("b", Side::both);
  builder.arc(Side::both, 0, 2, {}, 1).arc(Side::left, 1, 2, {}, 0);
  EXPECT_EQ(lines_with(rule_dot(builder.rule()), "->"),
            (Lines{"l0 -> l1 [label=\" 2 \"];", "l1 -> l0 [label=\" 2 \", color=\"#c62828\", fontcolor=\"#c62828\"];",
                   "r0 -> r1 [label=\" 2 \"];"}));
}

TEST(RuleDot, AnEmptySideIsShown) {
  RuleBuilder builder("point", gmap(0));
  builder.node("a", Side::right).line(Side::right, 0, 0, 0);
  std::string const dot = rule_dot(builder.rule());
  EXPECT_EQ(lines_with(dot, "∅"), (Lines{"l [label=\"∅\", shape=plaintext];"}));
  EXPECT_EQ(lines_with(dot, "l0"), Lines{});
}

TEST(RuleDot, QuotesAndBackslashesAreEscaped) {
  RuleBuilder builder("say \"\\N\"\n", gmap(0));
  builder.node("a", Side::both, true);
  EXPECT_EQ(lines_with(rule_dot(builder.rule()), "digraph"), (Lines{R"(digraph "say \"\\N\"\n" {)"}));
}

}  // namespace
}  // namespace jrule::draw
