#include "compiler/ir/rule_scheme.h"

namespace jrule::ir {

OrbitType RuleScheme::hook_orbit() const {
  OrbitType type;
  for (Letter const letter : hook_type) type.words.push_back({letter});
  return type;
}

Table::Table(std::size_t node_count, Side const& side)
    : out_(node_count * (max_dimension + 1)), in_(node_count * (max_dimension + 1)) {
  for (Arc const& arc : side.arcs) {
    out_[slot(arc.source, arc.dimension)].push_back(&arc);
    in_[slot(arc.target, arc.dimension)].push_back(&arc);
  }
}

Arc const* Table::out(NodeId node, int dimension) const {
  auto const& arcs = all_out(node, dimension);
  return arcs.empty() ? nullptr : arcs.front();
}

Arc const* Table::in(NodeId node, int dimension) const {
  auto const& arcs = all_in(node, dimension);
  return arcs.empty() ? nullptr : arcs.front();
}

Arc const* find_same(Side const& side, Arc const& arc) {
  for (Arc const& other : side.arcs) {
    if (other.same(arc)) return &other;
  }
  return nullptr;
}

}  // namespace jrule::ir
