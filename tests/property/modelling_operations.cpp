// Operations of geometric modelling, on G-maps, O-maps and the duals of O-maps.
#include "tests/property/operations.h"

#include "tests/property/rule_builder.h"

namespace jrule::property {

namespace {

using Modeler = std::shared_ptr<ir::Modeler const>;
using Result = std::optional<ir::RuleScheme>;
constexpr std::nullopt_t none = std::nullopt;

std::vector<int> dimensions_from(Model const& model, int first) {
  std::vector<int> dimensions;
  for (int const d : model.dimensions) {
    if (d >= first) dimensions.push_back(d);
  }
  return dimensions;
}

// ---- G-maps ----

bool is_gmap(Model const& model) {
  Model const pattern = gmap(model.dimension);
  return model.dimensions == pattern.dimensions && model.oriented == 0 && model.exchange == pattern.exchange;
}

/// A decoration for the type ⟨first, first + 1, …⟩ with these first letters; the rest keep their dimensions.
std::vector<std::optional<Letter>> decoration(std::vector<int> const& type, std::vector<int> const& letters) {
  std::vector<std::optional<Letter>> result;
  for (std::size_t p = 0; p < type.size(); ++p) {
    int const d = p < letters.size() ? letters[p] : type[p];
    result.push_back(d < 0 ? std::optional<Letter>() : letter(d));
  }
  return result;
}

/// Nodes in a chain, the first one the hook; each link is the dimension to the next node.
struct Chain {
  std::vector<std::vector<int>> decorations;  // by node; -1 is `_`
  std::vector<int> links;
};

Result chain_operation(Modeler const& modeler, std::string const& name, std::vector<int> const& type,
                       std::vector<int> const& free, Chain const& chain) {
  if (modeler->model.closed && !free.empty()) return none;
  RuleBuilder rule(modeler, name, type);
  ir::NodeId const a = rule.rewired_hook();
  rule.loops(On::left, a, free);
  rule.decorate(On::right, a, decoration(type, chain.decorations[0]));
  for (std::size_t k = 1; k < chain.decorations.size(); ++k) {
    ir::NodeId const b = rule.node(On::right);
    rule.decorate(On::right, b, decoration(type, chain.decorations[k]));
    rule.arc(On::right, b - 1, chain.links[k - 1], b);
  }
  return rule.build();
}

Result quad_subdivision(Modeler const& modeler, Random&) {
  if (!is_gmap(modeler->model) || modeler->model.dimension < 2) return none;
  return chain_operation(modeler, "quad_subdivision", modeler->model.dimensions, {},
                         {{{-1, 1, 2}, {-1, -1, 2}, {2, -1, -1}, {2, 1, -1}}, {0, 1, 0}});
}

Result triangulation(Modeler const& modeler, Random&) {
  if (!is_gmap(modeler->model) || modeler->model.dimension < 2) return none;
  std::vector<int> type{0, 1};
  for (int d = 3; d <= modeler->model.dimension; ++d) type.push_back(d);
  return chain_operation(modeler, "triangulation", type, {}, {{{0, -1}, {-1, 2}, {1, 2}}, {1, 0}});
}

Result cone(Modeler const& modeler, Random&) {
  if (!is_gmap(modeler->model) || modeler->model.dimension < 2) return none;
  std::vector<int> type{0, 1};
  for (int d = 3; d <= modeler->model.dimension; ++d) type.push_back(d);
  return chain_operation(modeler, "cone", type, {2}, {{{0, 1}, {0, -1}, {-1, 2}, {1, 2}}, {2, 1, 0}});
}

Result extrusion(Modeler const& modeler, Random&) {
  if (!is_gmap(modeler->model) || modeler->model.dimension < 2) return none;
  std::vector<int> type{0, 1};
  for (int d = 3; d <= modeler->model.dimension; ++d) type.push_back(d);
  return chain_operation(modeler, "extrusion", type, {2},
                         {{{0, 1}, {0, -1}, {-1, 2}, {-1, 2}, {0, -1}, {0, 1}}, {2, 1, 0, 1, 2}});
}

Result chamfer(Modeler const& modeler, Random&) {
  if (!is_gmap(modeler->model) || modeler->model.dimension != 2) return none;
  return chain_operation(modeler, "chamfer", {1, 2}, {}, {{{-1, 2}, {0, -1}, {0, 1}}, {1, 2}});
}

Result dual(Modeler const& modeler, Random&) {
  if (!is_gmap(modeler->model)) return none;
  std::vector<int> const reversed(modeler->model.dimensions.rbegin(), modeler->model.dimensions.rend());
  return chain_operation(modeler, "dual", modeler->model.dimensions, {}, {{reversed}, {}});
}

Result vertex_insertion(Modeler const& modeler, Random&) {
  if (!is_gmap(modeler->model) || modeler->model.dimension < 1) return none;
  std::vector<int> const type = dimensions_from(modeler->model, 2);
  RuleBuilder rule(modeler, "vertex_insertion", type);
  ir::NodeId const a = rule.hook(On::both), b = rule.node(On::both), c = rule.node(On::right), d = rule.node(On::right);
  rule.decorate(On::both, b, decoration(type, {}))
      .decorate(On::right, c, decoration(type, {}))
      .decorate(On::right, d, decoration(type, {}));
  rule.arc(On::left, a, 0, b).arc(On::right, a, 0, c).arc(On::right, c, 1, d).arc(On::right, d, 0, b);
  return rule.build();
}

Result vertex_removal(Modeler const& modeler, Random&) {
  if (!is_gmap(modeler->model) || modeler->model.dimension < 1) return none;
  std::vector<int> const type = dimensions_from(modeler->model, 2);
  RuleBuilder rule(modeler, "vertex_removal", type);
  ir::NodeId const c = rule.hook(On::left), d = rule.node(On::left), a = rule.node(On::both), b = rule.node(On::both);
  rule.decorate(On::both, a, decoration(type, {}))
      .decorate(On::both, b, decoration(type, {}))
      .decorate(On::left, d, decoration(type, {}));
  rule.arc(On::left, a, 0, c).arc(On::left, c, 1, d).arc(On::left, d, 0, b).arc(On::right, a, 0, b);
  return rule.build();
}

// Sound in dimension 2; above, only nearly so.
Result edge_removal(Modeler const& modeler, Random&) {
  if (!is_gmap(modeler->model) || modeler->model.dimension < 2) return none;
  std::vector<int> type{0};
  for (int d = 2; d <= modeler->model.dimension; ++d) type.push_back(d);
  RuleBuilder rule(modeler, "edge_removal", type);
  ir::NodeId const a = rule.hook(On::left), b = rule.node(On::both);
  rule.decorate(On::both, b, decoration(type, {-1, -1}));
  rule.arc(On::left, a, 1, b).arc(On::right, b, 1, b, word(2));
  return rule.build();
}

// ---- O-maps ----

bool is_omap(Model const& model, int n) { return model == omap(n); }

/// a -1-> b -1-> c -1-> a over each edge of a face: b goes to the centre, c comes back.
Result oriented_triangulation(Modeler const& modeler, Random&) {
  bool const solid = is_omap(modeler->model, 3);
  if (!solid && !is_omap(modeler->model, 2)) return none;
  RuleBuilder rule(modeler, "oriented_triangulation", solid ? std::vector<int>{1, 3} : std::vector<int>{1});
  ir::NodeId const a = rule.rewired_hook(), b = rule.node(On::right), c = rule.node(On::right);
  rule.arc(On::right, a, 1, b).arc(On::right, b, 1, c).arc(On::right, c, 1, a).arc(On::right, b, 2, c, word(1));
  if (solid) rule.arc(On::right, a, 3, a, word(3)).arc(On::right, b, 3, c, word(3));
  return rule.build();
}

Result oriented_quad_subdivision(Modeler const& modeler, Random&) {
  if (!is_omap(modeler->model, 2)) return none;
  RuleBuilder rule(modeler, "oriented_quad_subdivision", {1, 2});
  ir::NodeId const a = rule.rewired_hook(), b = rule.node(On::right), c = rule.node(On::right),
                   d = rule.node(On::right);
  rule.arc(On::right, a, 1, c).arc(On::right, c, 1, d).arc(On::right, d, 1, b).arc(On::right, b, 1, a);
  rule.arc(On::right, a, 2, b, word(2, 1)).arc(On::right, c, 2, d, word(1));
  return rule.build();
}

Result oriented_vertex_insertion(Modeler const& modeler, Random&) {
  if (!is_omap(modeler->model, 2)) return none;
  RuleBuilder rule(modeler, "oriented_vertex_insertion", {});
  ir::NodeId const a = rule.hook(On::both), b = rule.node(On::both), x = rule.node(On::both), y = rule.node(On::both);
  ir::NodeId const c = rule.node(On::right), d = rule.node(On::right);
  rule.arc(On::left, a, 2, b).arc(On::left, a, 1, x).arc(On::left, b, 1, y);
  rule.arc(On::right, a, 1, c)
      .arc(On::right, c, 1, x)
      .arc(On::right, b, 1, d)
      .arc(On::right, d, 1, y)
      .arc(On::right, a, 2, d)
      .arc(On::right, b, 2, c);
  return rule.build();
}

Result oriented_edge_removal(Modeler const& modeler, Random&) {
  if (!is_omap(modeler->model, 2)) return none;
  RuleBuilder rule(modeler, "oriented_edge_removal", {2});
  ir::NodeId const a = rule.hook(On::left), b = rule.node(On::both), c = rule.node(On::both);
  rule.arc(On::left, b, 1, a).arc(On::left, a, 1, c).arc(On::right, b, 1, c, word(2));
  return rule.build();
}

/// An operation of O-maps read in their duals, where dimension d is called n + 1 - d.
Result dual_of_oriented(Modeler const& modeler, Random& random) {
  int const n = modeler->model.dimension;
  if (modeler->model.dimensions.front() != 1 || modeler->model != dual_omap(n)) return none;
  auto primal = std::make_shared<ir::Modeler>(*modeler);
  primal->model = omap(n);
  static std::vector<Operation> const all{oriented_triangulation, oriented_quad_subdivision, oriented_vertex_insertion,
                                          oriented_edge_removal};
  Result rule = random.pick(all)(primal, random);
  if (!rule) return none;
  algebra::Group const group(modeler->model);
  auto const dual = [&](std::vector<Letter> letters) {
    for (Letter& l : letters) l.dimension = static_cast<std::uint8_t>(n + 1 - l.dimension);
    return letters;
  };
  rule->modeler = modeler;
  rule->hook_type = dual(rule->hook_type);
  for (ir::Side* side : {&rule->left, &rule->right}) {
    for (ir::Arc& arc : side->arcs) {
      arc.dimension = n + 1 - arc.dimension;
      arc.word = group.normal_form(dual(arc.word));
    }
  }
  return rule;
}

}  // namespace

std::vector<Operation> modelling_operations() {
  return {quad_subdivision,
          triangulation,
          cone,
          extrusion,
          chamfer,
          dual,
          vertex_insertion,
          vertex_removal,
          edge_removal,
          oriented_triangulation,
          oriented_quad_subdivision,
          oriented_vertex_insertion,
          oriented_edge_removal,
          dual_of_oriented,
          dual_of_oriented};
}

}  // namespace jrule::property
