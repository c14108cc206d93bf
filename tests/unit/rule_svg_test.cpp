#include <gtest/gtest.h>

#include <algorithm>
#include <pugixml.hpp>
#include <set>
#include <string>
#include <vector>

#include "compiler/backend/draw/draw.h"
#include "compiler/backend/draw/grid_layout.h"
#include "tests/unit/drawn_rule.h"

namespace jrule::draw {
namespace {

using tests::letter;
using tests::RuleBuilder;
using tests::Side;

// ---- The layout ----

bool shares_cell(std::vector<GridNode> const& nodes, std::vector<Cell> const& at) {
  for (std::size_t a = 0; a < nodes.size(); ++a) {
    for (std::size_t b = a + 1; b < nodes.size(); ++b) {
      if (at[a] == at[b] && (nodes[a].sides & nodes[b].sides) != 0) return true;
    }
  }
  return false;
}

std::vector<GridLink> chain(std::size_t count, Sides sides) {
  std::vector<GridLink> links;
  for (std::size_t i = 0; i + 1 < count; ++i) links.push_back({i, i + 1, sides});
  return links;
}

TEST(GridLayout, AChainIsReadFromLeftToRight) {
  std::vector<Cell> const at = grid_layout(std::vector<GridNode>(4, {right_side, 0}), chain(4, right_side));
  for (int i = 0; i < 4; ++i) EXPECT_EQ(at[static_cast<std::size_t>(i)], (Cell{at[0].column + i, at[0].row}));
}

TEST(GridLayout, ACubeHasNoCrossingsAndNoLinkThroughANode) {
  std::vector<GridLink> links;
  for (std::size_t a = 0; a < 8; ++a) {
    for (std::size_t const bit : {1U, 2U, 4U}) {
      if ((a & bit) == 0) links.push_back({a, a | bit, left_side});
    }
  }
  std::vector<GridNode> const nodes(8, {left_side, 0});
  std::vector<Cell> const at = grid_layout(nodes, links);
  EXPECT_FALSE(shares_cell(nodes, at));
  auto const turn = [&](std::size_t p, std::size_t q, std::size_t r) {
    int const x = at[q].column - at[p].column, y = at[q].row - at[p].row;
    return x * (at[r].row - at[p].row) - y * (at[r].column - at[p].column);
  };
  for (GridLink const& a : links) {
    for (std::size_t node = 0; node < 8; ++node) {
      if (node == a.from || node == a.to || turn(a.from, a.to, node) != 0) continue;
      EXPECT_FALSE(std::min(at[a.from].column, at[a.to].column) <= at[node].column && at[node].column <= std::max(at[a.from].column, at[a.to].column) &&
                   std::min(at[a.from].row, at[a.to].row) <= at[node].row && at[node].row <= std::max(at[a.from].row, at[a.to].row))
          << a.from << '-' << a.to << " through " << node;
    }
    for (GridLink const& b : links) {
      bool const crossing = turn(a.from, a.to, b.from) * turn(a.from, a.to, b.to) < 0 && turn(b.from, b.to, a.from) * turn(b.from, b.to, a.to) < 0;
      EXPECT_FALSE(crossing) << a.from << '-' << a.to << " and " << b.from << '-' << b.to;
    }
  }
}

TEST(GridLayout, NodesOfOneSideNeverShareACell) {
  for (std::size_t const count : {0U, 1U, 2U, 9U, 30U, 400U}) {
    std::vector<GridNode> nodes;
    for (std::size_t i = 0; i < count; ++i) nodes.push_back({i % 3 == 0 ? left_side : i % 3 == 1 ? right_side : left_side | right_side, 0});
    std::vector<GridLink> links;
    for (std::size_t i = 0; i < count; ++i) links.push_back({i, (7 * i + 3) % count == i ? (i + 1) % count : (7 * i + 3) % count, left_side});
    if (count < 2) links.clear();
    std::vector<Cell> const at = grid_layout(nodes, links);
    ASSERT_EQ(at.size(), count);
    EXPECT_FALSE(shares_cell(nodes, at)) << count;
    EXPECT_EQ(grid_layout(nodes, links), at) << count;
  }
}

// ---- The picture ----

pugi::xml_document parsed(std::string const& svg) {
  pugi::xml_document document;
  auto const result = document.load_string(svg.c_str());
  EXPECT_TRUE(result) << result.description() << '\n' << svg;
  return document;
}

/// The texts of the left and the right panel.
std::vector<std::multiset<std::string>> texts(pugi::xml_document const& svg) {
  std::vector<std::multiset<std::string>> panels;
  for (auto const& panel : svg.child("svg").children("g")) {
    panels.emplace_back();
    for (auto const& text : panel.children("text")) panels.back().insert(text.text().get());
  }
  return panels;
}
using Texts = std::multiset<std::string>;

TEST(RuleSvg, QuadSubdivision) {
  RuleBuilder const builder = tests::quad_subdivision();
  ir::RuleScheme rule = builder.rule();
  rule.hook_type = {letter(0), letter(1), letter(2)};
  ASSERT_EQ(ir::verify(rule), std::nullopt);
  std::string const svg = rule_svg(rule);
  pugi::xml_document const document = parsed(svg);
  auto const panels = texts(document);
  ASSERT_EQ(panels.size(), 2U);
  EXPECT_EQ(panels[0], (Texts{"a", "<0,1,2>"}));
  EXPECT_EQ(panels[1], (Texts{"a", "<_,1,2>", "b", "<_,_,2>", "c", "<2,_,_>", "d", "<2,1,_>", "0", "1", "0"}));
  // The hook has two outlines on each side, the others one; labels of arcs have none.
  auto const outlines = document.select_nodes("//g/rect[@stroke]");
  EXPECT_EQ(outlines.size(), 7U);
  EXPECT_EQ(document.select_nodes("//rect[@fill='#c8e6c9']").size(), 3U);  // added
  EXPECT_EQ(rule_svg(rule), svg);
}

TEST(RuleSvg, ArcsWithWordsHaveTipsAndRings) {
  RuleBuilder builder("turn", omap(2));
  builder.node("a", Side::both, true).node("b", Side::right).node("c", Side::left);
  builder.arc(Side::left, 0, 1, {letter(1)}, 0);
  builder.arc(Side::right, 1, 1, {letter(1, true)}, 0);
  builder.arc(Side::right, 0, 2, {letter(1)}, 1).arc(Side::right, 1, 2, {letter(1, true)}, 0);  // not its own conjugate
  builder.arc(Side::left, 2, 2, {}, 2);
  pugi::xml_document const svg = parsed(rule_svg(builder.rule()));
  auto const panels = texts(svg);
  ASSERT_EQ(panels.size(), 2U);
  EXPECT_EQ(panels[0], (Texts{"a", "1[1]", "c", "2"}));
  EXPECT_EQ(panels[1], (Texts{"a", "b", "1[~1]", "2[1]"}));
  EXPECT_EQ(svg.select_nodes("//circle").size(), 1U);
  EXPECT_EQ(svg.select_nodes("//g/path[not(@stroke)]").size(), 2U);        // tips of the two 1-arcs
  EXPECT_EQ(svg.select_nodes("//rect[@fill='#ffcdd2']").size(), 1U);       // c is deleted
  EXPECT_EQ(svg.select_nodes("//path[@stroke-dasharray='7 3']").size(), 2U);
}

TEST(RuleSvg, AnEmptySideIsShownAndNamesAreEscaped) {
  RuleBuilder builder("a<b&\"c\"", gmap(0));
  builder.node("node", Side::right).arc(Side::right, 0, 0, {}, 0);
  pugi::xml_document const svg = parsed(rule_svg(builder.rule()));
  auto const panels = texts(svg);
  ASSERT_EQ(panels.size(), 2U);
  EXPECT_EQ(panels[0], Texts{"∅"});
  EXPECT_EQ(panels[1], (Texts{"node", "0"}));
  EXPECT_EQ(std::string(svg.child("svg").child_value("title")), "a<b&\"c\" on Surface: its left and its right side");
}

}  // namespace
}  // namespace jrule::draw
