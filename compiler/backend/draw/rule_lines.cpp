#include "compiler/backend/draw/rule_lines.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <optional>

namespace jrule::draw {

std::vector<RuleLine> rule_lines(algebra::Group const& group, ir::Side const& side, ir::Side const& other_side) {
  std::vector<RuleLine> result;
  std::vector<bool> drawn(side.arcs.size(), false);
  for (std::size_t i = 0; i < side.arcs.size(); ++i) {
    if (drawn[i]) continue;
    ir::Arc const& arc = side.arcs[i];
    ir::Arc const reverse{arc.target, arc.dimension, group.inverse(arc.word), arc.source, {}};
    bool const preserved = ir::find_same(other_side, arc) != nullptr;
    bool both_ways = reverse.same(arc);
    for (std::size_t j = i + 1; j < side.arcs.size() && !both_ways; ++j) {
      if (drawn[j] || !side.arcs[j].same(reverse)) continue;
      if ((ir::find_same(other_side, reverse) != nullptr) != preserved) continue;
      both_ways = drawn[j] = true;
    }
    result.push_back({&arc, both_ways, reverse.word == arc.word, preserved});
  }
  return result;
}

std::string arc_label(ir::Arc const& arc) {
  std::string label = std::to_string(arc.dimension);
  for (std::size_t i = 0; i < arc.word.size(); ++i) {
    label += i == 0 ? '[' : ',';
    label += to_string(Word{arc.word[i]});
  }
  return label + (arc.word.empty() ? "" : "]");
}

namespace {

/// What the hook's op-arcs become on the node, if the line says that: `2`, `~1`.
std::optional<std::string> relabelling(ir::RuleScheme const& rule, RuleLine const& line, ir::NodeId node, Letter op) {
  ir::Arc const& arc = *line.arc;
  if (arc.source != node || arc.target != node || arc.word.size() != 1 || arc.word[0].dimension != op.dimension) return {};
  Model const& model = rule.model();
  if (model.is_oriented(op.dimension) && !model.is_oriented(arc.dimension)) return {};
  return to_string(Word{Letter{static_cast<std::uint8_t>(arc.dimension), arc.word[0].conjugate}});
}

}  // namespace

DecoratedSide decorated_side(ir::RuleScheme const& rule, algebra::Group const& group, bool left) {
  DecoratedSide result{std::vector<std::string>(rule.nodes.size()),
                       left ? rule_lines(group, rule.left, rule.right) : rule_lines(group, rule.right, rule.left)};
  if (rule.hook_type.empty()) return result;
  for (ir::NodeId id = 0; id < rule.nodes.size(); ++id) {
    std::vector<std::string> positions(rule.hook_type.size(), "_");
    for (std::size_t p = 0; p < positions.size(); ++p) {
      for (std::size_t i = 0; i < result.lines.size(); ++i) {
        auto const letter = relabelling(rule, result.lines[i], id, rule.hook_type[p]);
        if (!letter) continue;
        positions[p] = *letter;
        result.lines.erase(result.lines.begin() + static_cast<std::ptrdiff_t>(i));
        break;
      }
    }
    result.decorations[id] = fmt::format("<{}>", fmt::join(positions, ","));
  }
  return result;
}

}  // namespace jrule::draw
