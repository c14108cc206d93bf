// Operations that every model has.
#include "tests/property/operations.h"

#include <set>

#include "tests/property/growth.h"
#include "tests/property/rule_builder.h"

namespace jrule::property {

namespace {

using Modeler = std::shared_ptr<ir::Modeler const>;
using Result = std::optional<ir::RuleScheme>;
constexpr std::nullopt_t none = std::nullopt;

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
  rule.decorate(On::both, b, {letters.begin(), letters.end()})
      .arc(On::left, a, *i, b)
      .loops(On::right, a, {*i})
      .loops(On::right, b, {*i});
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
  ir::NodeId const a = rule.hook(On::both), c = rule.hook(On::both, letters), b = rule.node(On::both),
                   d = rule.node(On::both);
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
void add_map(RuleBuilder& rule, On side, ir::NodeId first, Map const& map, std::vector<int> const& type,
             std::vector<Word> const& gauge) {
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
  for (int const d : model.dimensions)
    (with_free && !model.is_oriented(d) && random.chance(40) ? free : type).push_back(d);
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

Result product_with_component(Modeler const& modeler, Random& random) { return product(modeler, random, false); }
Result product_with_free_component(Modeler const& modeler, Random& random) { return product(modeler, random, true); }

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
    return std::all_of(w.begin(), w.end(),
                       [&](Letter l) { return std::find(type.begin(), type.end(), int{l.dimension}) != type.end(); });
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

ir::RuleScheme random_operation(std::shared_ptr<ir::Modeler const> const& modeler, Random& random) {
  static std::vector<Operation> const all = [] {
    std::vector<Operation> operations = modelling_operations();
    for (Operation const operation :
         {sew, unsew, exchange_partners, product_with_component, product_with_free_component, inner_relabelling,
          replacement, frame, frame, frame, frame}) {
      operations.push_back(operation);
    }
    return operations;
  }();
  for (;;) {
    if (Result rule = random.pick(all)(modeler, random)) return std::move(*rule);
  }
}

}  // namespace jrule::property
