#include "tests/property/operations.h"

#include <functional>
#include <set>

#include "tests/property/growth.h"
#include "tests/property/rule_builder.h"

namespace jrule::property {

namespace {

using Modeler = std::shared_ptr<ir::Modeler const>;
using Result = std::optional<ir::RuleScheme>;
using Operation = std::function<Result(Modeler const&, Random&)>;
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

Result chain_operation(Modeler const& modeler, std::string const& name, std::vector<int> const& type, std::vector<int> const& free, Chain const& chain) {
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
  return chain_operation(modeler, "quad_subdivision", modeler->model.dimensions, {}, {{{-1, 1, 2}, {-1, -1, 2}, {2, -1, -1}, {2, 1, -1}}, {0, 1, 0}});
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
  return chain_operation(modeler, "extrusion", type, {2}, {{{0, 1}, {0, -1}, {-1, 2}, {-1, 2}, {0, -1}, {0, 1}}, {2, 1, 0, 1, 2}});
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
  rule.decorate(On::both, b, decoration(type, {})).decorate(On::right, c, decoration(type, {})).decorate(On::right, d, decoration(type, {}));
  rule.arc(On::left, a, 0, b).arc(On::right, a, 0, c).arc(On::right, c, 1, d).arc(On::right, d, 0, b);
  return rule.build();
}

Result vertex_removal(Modeler const& modeler, Random&) {
  if (!is_gmap(modeler->model) || modeler->model.dimension < 1) return none;
  std::vector<int> const type = dimensions_from(modeler->model, 2);
  RuleBuilder rule(modeler, "vertex_removal", type);
  ir::NodeId const c = rule.hook(On::left), d = rule.node(On::left), a = rule.node(On::both), b = rule.node(On::both);
  rule.decorate(On::both, a, decoration(type, {})).decorate(On::both, b, decoration(type, {})).decorate(On::left, d, decoration(type, {}));
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
  ir::NodeId const a = rule.rewired_hook(), b = rule.node(On::right), c = rule.node(On::right), d = rule.node(On::right);
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
  rule.arc(On::right, a, 1, c).arc(On::right, c, 1, x).arc(On::right, b, 1, d).arc(On::right, d, 1, y).arc(On::right, a, 2, d).arc(On::right, b, 2, c);
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
  static std::vector<Operation> const all{oriented_triangulation, oriented_quad_subdivision, oriented_vertex_insertion, oriented_edge_removal};
  Result rule = random.pick(all)(primal, random);
  if (!rule) return none;
  algebra::Group const group(modeler->model);
  auto const rename = [&](Word& word) {
    for (Letter& l : word) l.dimension = static_cast<std::uint8_t>(n + 1 - l.dimension);
    word = group.normal_form(word);
  };
  rule->modeler = modeler;
  rename(rule->hook_type);
  for (ir::Side* side : {&rule->left, &rule->right}) {
    for (ir::Arc& arc : side->arcs) {
      arc.dimension = n + 1 - arc.dimension;
      rename(arc.word);
    }
  }
  return rule;
}

// ---- Any model ----

std::vector<int> exchangeable_with(Model const& model, int i) {
  std::vector<int> dimensions;
  for (int const j : model.dimensions) {
    if (model.exchanges(i, j)) dimensions.push_back(j);
  }
  return dimensions;
}

/// An i-arc turns the dimensions exchangeable with i around: i·j·i = ~j.
std::vector<Letter> turned(Model const& model, std::vector<int> const& type) {
  std::vector<Letter> letters;
  for (int const d : type) letters.push_back(letter(d, model.is_oriented(d)));
  return letters;
}

std::optional<int> non_oriented(Model const& model, Random& random) {
  int const i = random.pick(model.dimensions);
  return model.is_oriented(i) ? std::optional<int>() : i;
}

Result sew(Modeler const& modeler, Random& random) {
  Model const& model = modeler->model;
  auto const i = non_oriented(model, random);
  if (!i || model.closed) return none;
  auto const type = exchangeable_with(model, *i);
  RuleBuilder rule(modeler, "sew", type);
  ir::NodeId const a = rule.hook(On::both), b = rule.hook(On::both, turned(model, type));
  rule.loops(On::left, a, {*i}).loops(On::left, b, {*i}).arc(On::right, a, *i, b);
  return rule.build();
}

Result unsew(Modeler const& modeler, Random& random) {
  Model const& model = modeler->model;
  auto const i = non_oriented(model, random);
  if (!i || model.closed) return none;
  auto const type = exchangeable_with(model, *i);
  RuleBuilder rule(modeler, "unsew", type);
  ir::NodeId const a = rule.hook(On::both), b = rule.node(On::both);
  auto const letters = turned(model, type);
  rule.decorate(On::both, b, {letters.begin(), letters.end()}).arc(On::left, a, *i, b).loops(On::right, a, {*i}).loops(On::right, b, {*i});
  return rule.build();
}

/// a -i- b and c -i- d become a -i- c and b -i- d.
Result exchange_partners(Modeler const& modeler, Random& random) {
  Model const& model = modeler->model;
  auto const i = non_oriented(model, random);
  if (!i) return none;
  auto const type = exchangeable_with(model, *i);
  auto const letters = turned(model, type);
  RuleBuilder rule(modeler, "exchange_partners", type);
  ir::NodeId const a = rule.hook(On::both), c = rule.hook(On::both, letters), b = rule.node(On::both), d = rule.node(On::both);
  rule.decorate(On::both, b, {letters.begin(), letters.end()});
  rule.loops(On::both, d, {});
  for (int const j : type) rule.arc(On::both, d, j, d, word(j));
  rule.arc(On::left, a, *i, b).arc(On::left, c, *i, d).arc(On::right, a, *i, c).arc(On::right, b, *i, d);
  return rule.build();
}

std::optional<Map> small_map(Model const& model, Random& random) {
  Growth growth(model);
  for (std::size_t k = random.between(1, 3); k > 0; --k) growth.add_dart();
  return growth.complete(random, random.between(2, 6));
}

Word random_word(Model const& model, std::vector<int> const& dimensions, Random& random) {
  Word word;
  if (dimensions.empty()) return word;
  for (std::size_t k = random.below(3); k > 0; --k) {
    int const d = random.pick(dimensions);
    word.push_back(letter(d, model.is_oriented(d) && random.chance(50)));
  }
  return word;
}

/// The arcs of a map as arcs of a side, node 0 its dart 0; (x, d) carries the word of d, moved by a word at each node.
void add_map(RuleBuilder& rule, On side, ir::NodeId first, Map const& map, std::vector<int> const& type, std::vector<Word> const& gauge) {
  algebra::Group const& group = rule.group();
  for (Dart const x : map.darts()) {
    for (int const d : map.model().dimensions) {
      Dart const y = map.target(x, d);
      if (!map.model().is_oriented(d) && y < x) continue;
      Word const own = std::find(type.begin(), type.end(), d) != type.end() ? word(d) : Word{};
      rule.arc(side, first + x, d, first + y, group.product(group.product(gauge[x], own), group.inverse(gauge[y])));
    }
  }
}

/// Multiplies a component by a finite map X: (u, x)·d = (u·d, x·d). With `free` dimensions, a component of the others whose
/// arcs of those dimensions are loops.
Result product(Modeler const& modeler, Random& random, bool with_free) {
  Model const& model = modeler->model;
  std::vector<int> type, free;
  for (int const d : model.dimensions) (with_free && !model.is_oriented(d) && random.chance(40) ? free : type).push_back(d);
  auto const map = small_map(model, random);
  if (!map || (model.closed && !free.empty())) return none;
  RuleBuilder rule(modeler, "product", type);
  ir::NodeId const a = rule.rewired_hook();
  rule.loops(On::left, a, free);
  std::vector<Word> gauge{{}};
  for (Dart x = 1; x < map->dart_limit(); ++x) {
    rule.node(On::right);
    gauge.push_back(random.chance(40) ? random_word(model, type, random) : Word{});
  }
  add_map(rule, On::right, a, *map, type, gauge);
  return rule.build();
}

/// Relabels every arc of a component by the same word: (u)·d = u·g·d·ḡ.
Result inner_relabelling(Modeler const& modeler, Random& random) {
  Model const& model = modeler->model;
  RuleBuilder rule(modeler, "inner_relabelling", model.dimensions);
  ir::NodeId const a = rule.rewired_hook();
  Word const g = random_word(model, model.dimensions, random);
  algebra::Group const& group = rule.group();
  for (int const d : model.dimensions) {
    rule.arc(On::right, a, d, a, group.product(group.product(g, word(d)), group.inverse(g)));
  }
  return rule.build();
}

/// Replaces a finite map by another one; either may be empty.
Result replacement(Modeler const& modeler, Random& random) {
  RuleBuilder rule(modeler, "replacement", {});
  auto const before = small_map(modeler->model, random), after = small_map(modeler->model, random);
  std::size_t const kind = random.below(3);
  if (!before || !after) return none;
  if (kind != 0) {
    rule.hook(On::left);
    for (Dart x = 1; x < before->dart_limit(); ++x) rule.node(On::left);
    if (number_orbits(*before, component_orbit(modeler->model)).first.size() > 1) return none;
    add_map(rule, On::left, 0, *before, {}, std::vector<Word>(before->dart_limit()));
  }
  if (kind != 1) {
    auto const first = static_cast<ir::NodeId>(rule.node_count());
    for (Dart x = 0; x < after->dart_limit(); ++x) rule.node(On::right);
    add_map(rule, On::right, first, *after, {}, std::vector<Word>(after->dart_limit()));
  }
  return rule.build();
}

/// Keeps what it matches: a hook of a random type, some nodes around it, and those arcs between them that hold in every map.
Result frame(Modeler const& modeler, Random& random) {
  Model const& model = modeler->model;
  std::vector<int> type;
  std::size_t const density = random.between(20, 90);
  for (int const d : model.dimensions) {
    if (random.chance(density)) type.push_back(d);
  }
  RuleBuilder rule(modeler, "frame", type);
  algebra::Group const& group = rule.group();
  auto const in_type = [&](Word const& w) {
    return std::all_of(w.begin(), w.end(), [&](Letter l) { return std::find(type.begin(), type.end(), int{l.dimension}) != type.end(); });
  };
  rule.hook(On::both);
  std::vector<Word> offset{{}};  // node s lies at u·offset
  // The node and word that an arc from `s` along `l` leads to.
  auto const end_of = [&](ir::NodeId s, Letter l) -> std::optional<std::pair<ir::NodeId, Word>> {
    for (ir::NodeId t = 0; t < offset.size(); ++t) {
      Word const w = group.product(group.product(offset[s], {l}), group.inverse(offset[t]));
      if (in_type(w)) return std::pair(t, w);
    }
    return none;
  };
  std::set<std::pair<ir::NodeId, int>> tree;  // arcs that a node hangs on
  for (std::size_t k = random.below(5); k > 0; --k) {
    auto const s = static_cast<ir::NodeId>(random.below(offset.size()));
    int const d = random.pick(model.dimensions);
    Letter const l = letter(d, model.is_oriented(d) && random.chance(50));
    if (end_of(s, l)) continue;
    ir::NodeId const t = rule.node(On::both);
    offset.push_back(group.product(offset[s], {l}));
    tree.emplace(l.conjugate ? t : s, d);
    if (!model.is_oriented(d)) tree.emplace(t, d);
  }
  for (ir::NodeId s = 0; s < offset.size(); ++s) {
    for (int const d : model.dimensions) {
      auto const end = end_of(s, letter(d));
      if (!end) {
        if (!model.closed && !model.is_oriented(d) && random.chance(12)) rule.loops(On::both, s, {d});
        continue;
      }
      auto const& [t, w] = *end;
      bool const hook_loop = s == 0 && t == 0 && w == word(d);
      if (hook_loop || (!model.is_oriented(d) && t < s)) continue;  // there already
      if (tree.contains({s, d}) || random.chance(80)) rule.arc(On::both, s, d, t, w);
    }
  }
  if (random.chance(25)) {
    std::vector<Letter> loops;
    for (int const d : type) loops.push_back(letter(d, model.is_oriented(d) && random.chance(50)));
    ir::NodeId const b = rule.hook(On::both, loops);
    for (int const d : model.dimensions) {
      if (!in_type(word(d)) && !model.closed && random.chance(40)) rule.loops(On::both, b, {d});
    }
  }
  return rule.build();
}

}  // namespace

ir::RuleScheme random_operation(Modeler const& modeler, Random& random) {
  static Operation const with_all = [](Modeler const& m, Random& r) { return product(m, r, false); };
  static Operation const with_free = [](Modeler const& m, Random& r) { return product(m, r, true); };
  static std::vector<Operation> const all{
      quad_subdivision, triangulation, cone, extrusion, chamfer, dual, vertex_insertion, vertex_removal, edge_removal,
      oriented_triangulation, oriented_quad_subdivision, oriented_vertex_insertion, oriented_edge_removal, dual_of_oriented, dual_of_oriented,
      sew, unsew, exchange_partners, with_all, with_free, inner_relabelling, replacement, frame, frame, frame, frame};
  for (;;) {
    if (Result rule = random.pick(all)(modeler, random)) return std::move(*rule);
  }
}

}  // namespace jrule::property
