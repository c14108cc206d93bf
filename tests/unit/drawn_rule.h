// Rules put together without the front end, so that a test of pictures shows every arc that they have.
#pragma once

#include <memory>
#include <string>
#include <utility>

#include "compiler/ir/rule_scheme.h"

namespace jrule::tests {

enum class Side { left, right, both };

class RuleBuilder {
 public:
  RuleBuilder(std::string name, Model model) {
    auto modeler = std::make_shared<ir::Modeler>();
    modeler->name = "Surface";
    modeler->model = std::move(model);
    rule_.modeler = std::move(modeler);
    rule_.name = std::move(name);
  }

  RuleBuilder& node(std::string name, Side side, bool hook = false) {
    ir::Node node;
    node.name = std::move(name);
    if (side != Side::right) node.left_span = source::Span{};
    if (side != Side::left) node.right_span = source::Span{};
    if (hook) {
      node.hook = rule_.hooks.size();
      rule_.hooks.push_back(static_cast<ir::NodeId>(rule_.nodes.size()));
    }
    rule_.nodes.push_back(std::move(node));
    return *this;
  }
  RuleBuilder& arc(Side side, ir::NodeId source, int dimension, Word word, ir::NodeId target) {
    ir::Arc const arc{source, dimension, std::move(word), target, {}};
    if (side != Side::right) rule_.left.arcs.push_back(arc);
    if (side != Side::left) rule_.right.arcs.push_back(arc);
    return *this;
  }
  /// An arc whose word is its own conjugate, and its reverse.
  RuleBuilder& line(Side side, ir::NodeId source, int dimension, ir::NodeId target) {
    return arc(side, source, dimension, {}, target).arc(side, target, dimension, {}, source);
  }
  ir::RuleScheme const& rule() const { return rule_; }

 private:
  ir::RuleScheme rule_;
};

inline constexpr Letter letter(int d, bool conjugate = false) { return {static_cast<std::uint8_t>(d), conjugate}; }

/// Splits every n-gon of a surface into n quads (paper, Fig. 29).
inline RuleBuilder quad_subdivision() {
  RuleBuilder builder("quad_subdivision", gmap(2));
  builder.node("a", Side::both, true).node("b", Side::right).node("c", Side::right).node("d", Side::right);
  builder.arc(Side::left, 0, 0, {letter(0)}, 0).arc(Side::both, 0, 1, {letter(1)}, 0);
  builder.arc(Side::both, 0, 2, {letter(2)}, 0).arc(Side::right, 1, 2, {letter(2)}, 1);
  builder.arc(Side::right, 2, 2, {letter(0)}, 2).arc(Side::right, 3, 2, {letter(0)}, 3);
  builder.arc(Side::right, 3, 1, {letter(1)}, 3);
  builder.line(Side::right, 0, 0, 1).line(Side::right, 1, 1, 2).line(Side::right, 2, 0, 3);
  return builder;
}

}  // namespace jrule::tests
