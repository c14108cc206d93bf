#include "tests/property/rule_builder.h"

namespace jrule::property {

std::vector<ir::Arc> with_reverse(algebra::Group const& group, ir::NodeId source, int dimension, Word const& word,
                                  ir::NodeId target) {
  std::vector<ir::Arc> arcs{{source, dimension, group.normal_form(word), target, {}}};
  if (group.model().is_oriented(dimension)) return arcs;
  ir::Arc const reverse{target, dimension, group.inverse(word), source, {}};
  if (!reverse.same(arcs[0])) arcs.push_back(reverse);
  return arcs;
}

void renumber_spans(ir::RuleScheme& rule) {
  std::uint32_t next = 0;
  auto const span = [&] {
    next += 2;
    return ir::Span{0, next - 2, next - 1};
  };
  rule.span = span();
  for (ir::Node& node : rule.nodes) {
    if (node.left_span) node.left_span = span();
  }
  for (ir::Arc& arc : rule.left.arcs) arc.span = span();
  for (ir::Node& node : rule.nodes) {
    if (node.right_span) node.right_span = span();
  }
  for (ir::Arc& arc : rule.right.arcs) arc.span = span();
}

RuleBuilder::RuleBuilder(std::shared_ptr<ir::Modeler const> modeler, std::string name,
                         std::vector<int> const& hook_type)
    : group_(modeler->model) {
  rule_.name = std::move(name);
  rule_.modeler = std::move(modeler);
  for (int const d : hook_type) rule_.hook_type.push_back(letter(d));
}

ir::NodeId RuleBuilder::node(On side) {
  ir::Node node;
  auto const id = static_cast<ir::NodeId>(rule_.nodes.size());
  node.name = "n" + std::to_string(id);
  if (side != On::right) node.left_span = ir::Span{};
  if (side != On::left) node.right_span = ir::Span{};
  rule_.nodes.push_back(std::move(node));
  return id;
}

ir::NodeId RuleBuilder::hook(On side) { return hook(side, rule_.hook_type); }

ir::NodeId RuleBuilder::hook(On side, std::vector<Letter> const& loops) {
  ir::NodeId const id = node(side);
  rule_.nodes[id].hook = rule_.hooks.size();
  rule_.hooks.push_back(id);
  decorate(side, id, {loops.begin(), loops.end()});
  return id;
}

ir::NodeId RuleBuilder::rewired_hook() {
  ir::NodeId const id = hook(On::left);
  rule_.nodes[id].right_span = ir::Span{};
  return id;
}

RuleBuilder& RuleBuilder::arc(On side, ir::NodeId source, int dimension, ir::NodeId target, Word const& word) {
  for (ir::Arc const& arc : with_reverse(group_, source, dimension, word, target)) {
    if (side != On::right) rule_.left.arcs.push_back(arc);
    if (side != On::left) rule_.right.arcs.push_back(arc);
  }
  return *this;
}

RuleBuilder& RuleBuilder::decorate(On side, ir::NodeId node, std::vector<std::optional<Letter>> const& letters) {
  for (std::size_t p = 0; p < letters.size() && p < rule_.hook_type.size(); ++p) {
    if (!letters[p]) continue;
    // `~d` at the position of o is the loop d[~o].
    arc(side, node, letters[p]->dimension, node, {Letter{rule_.hook_type[p].dimension, letters[p]->conjugate}});
  }
  return *this;
}

RuleBuilder& RuleBuilder::loops(On side, ir::NodeId node, std::vector<int> const& dimensions) {
  for (int const d : dimensions) arc(side, node, d, node);
  return *this;
}

ir::RuleScheme RuleBuilder::build() {
  renumber_spans(rule_);
  return rule_;
}

}  // namespace jrule::property
