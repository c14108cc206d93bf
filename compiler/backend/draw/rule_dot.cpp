// Rules as Graphviz graphs. An arc and its reverse (Def. 8) are one line; the reverse of (w, d) from s to t is (w̄, d)
// from t to s, so a line whose word is not its own conjugate wears a small ring at the end from which the word is read.
#include <fmt/format.h>

#include <string_view>
#include <vector>

#include "compiler/algebra/group.h"
#include "compiler/backend/draw/draw.h"
#include "compiler/backend/draw/rule_lines.h"

namespace jrule::draw {

namespace {

constexpr std::string_view changed = "color=\"#c62828\", fontcolor=\"#c62828\"";

/// A string of the DOT language. A backslash would begin an escape of labels, so it is doubled too.
std::string quoted(std::string_view text) {
  std::string result = "\"";
  for (char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    if (c == '\n') {
      result += "\\n";
    } else if (c != '\r' && c != '\0') {
      result += c;
    }
  }
  return result + '"';
}

/// The blanks keep nested loops and their labels apart.
std::string padded_label(ir::Arc const& arc) { return ' ' + arc_label(arc) + ' '; }

std::string print_node(ir::RuleScheme const& rule, ir::NodeId id, char side) {
  ir::Node const& node = rule.nodes[id];
  std::string text = fmt::format("    {}{} [label={}", side, id, quoted(node.name));
  if (node.hook) text += ", peripheries=2";
  if (!node.preserved()) text += fmt::format(", {}", changed);
  return text + "];\n";
}

std::string print_line(RuleLine const& line, char side) {
  ir::Arc const& arc = *line.arc;
  std::string text =
      fmt::format("    {0}{1} -> {0}{2} [label={3}", side, arc.source, arc.target, quoted(padded_label(arc)));
  if (line.both_ways) {
    bool const read_from_source = !line.palindrome && arc.source != arc.target;
    text += read_from_source ? ", dir=back, arrowtail=odot" : ", dir=none";
  }
  if (!line.preserved) text += fmt::format(", {}", changed);
  return text + "];\n";
}

std::string print_side(ir::RuleScheme const& rule, algebra::Group const& group, bool left) {
  char const side = left ? 'l' : 'r';
  std::string text = fmt::format("  subgraph cluster_{0} {{\n", left ? "left" : "right");
  text += fmt::format("    label=\"{}\"; style=rounded; color=gray60; margin=16;\n", left ? "left" : "right");
  bool empty = true;
  for (ir::NodeId id = 0; id < rule.nodes.size(); ++id) {
    ir::Node const& node = rule.nodes[id];
    if (left ? node.added() : node.deleted()) continue;
    text += print_node(rule, id, side);
    empty = false;
  }
  // Graphviz shows no cluster without nodes.
  if (empty) text += fmt::format("    {} [label=\"∅\", shape=plaintext];\n", side);
  for (RuleLine const& line : left ? rule_lines(group, rule.left, rule.right) : rule_lines(group, rule.right, rule.left)) {
    text += print_line(line, side);
  }
  return text + "  }\n";
}

}  // namespace

std::string rule_dot(ir::RuleScheme const& rule) {
  algebra::Group const group(rule.model());
  std::string text = fmt::format("digraph {} {{\n", quoted(rule.name));
  text += fmt::format("  graph [label={}, labelloc=t, fontname=\"Helvetica\", nodesep=0.5, ranksep=0.6];\n",
                      quoted(fmt::format("{} on {}", rule.name, rule.modeler->name)));
  text += "  node [shape=circle, fontname=\"Helvetica\", width=0.45, margin=0.03];\n";
  text += "  edge [fontname=\"Helvetica\", fontsize=11, arrowsize=0.7];\n";
  text += print_side(rule, group, true);
  text += print_side(rule, group, false);
  return text + "}\n";
}

}  // namespace jrule::draw
