// Rule schemes written in C++: what the front end makes of a `.jrule` text, without the text.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "compiler/algebra/group.h"
#include "compiler/ir/rule_scheme.h"

namespace jrule::property {

enum class On { left, right, both };

/// The arc and, for a non-oriented dimension, its reverse if that is another arc; words in normal form.
std::vector<ir::Arc> with_reverse(algebra::Group const& group, ir::NodeId source, int dimension, Word const& word,
                                  ir::NodeId target);
/// Gives every node and arc a place of its own, in order, as if it were written there.
void renumber_spans(ir::RuleScheme& rule);

class RuleBuilder {
 public:
  RuleBuilder(std::shared_ptr<ir::Modeler const> modeler, std::string name, std::vector<int> const& hook_type);

  Model const& model() const { return rule_.model(); }
  algebra::Group const& group() const { return group_; }
  std::size_t node_count() const { return rule_.nodes.size(); }

  ir::NodeId node(On side);
  /// A preserved (`On::both`) or deleted (`On::left`) node with the loops of its type on those sides.
  ir::NodeId hook(On side);
  /// A preserved hook whose loops are on the left only: the right side gives it others.
  ir::NodeId rewired_hook();
  /// A further hook, with these loops.
  ir::NodeId hook(On side, std::vector<Letter> const& loops);
  RuleBuilder& arc(On side, ir::NodeId source, int dimension, ir::NodeId target, Word const& word = {});
  /// The decoration `node <e1,…,ek>`; none is `_`.
  RuleBuilder& decorate(On side, ir::NodeId node, std::vector<std::optional<Letter>> const& letters);
  RuleBuilder& loops(On side, ir::NodeId node, std::vector<int> const& dimensions);

  ir::RuleScheme build();

 private:
  ir::RuleScheme rule_;
  algebra::Group group_;
};

inline Letter letter(int dimension, bool conjugate = false) {
  return {static_cast<std::uint8_t>(dimension), conjugate};
}
inline Word word(int a) { return {letter(a)}; }
inline Word word(int a, int b) { return {letter(a), letter(b)}; }

}  // namespace jrule::property
