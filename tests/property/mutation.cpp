#include "tests/property/mutation.h"

#include <algorithm>
#include <array>

#include "tests/property/rule_builder.h"

namespace jrule::property {

namespace {

struct Mutation {
  ir::RuleScheme rule;
  Random& random;
  algebra::Group group{rule.model()};

  // ---- Edges: an arc with its reverse, on the sides where both are. ----

  ir::Side& side(bool left) { return left ? rule.left : rule.right; }

  bool has(bool left, ir::Arc const& arc) { return ir::find_same(side(left), arc) != nullptr; }
  void erase(bool left, ir::Arc const& arc) {
    for (ir::Arc const& a : with_reverse(group, arc.source, arc.dimension, arc.word, arc.target)) {
      std::erase_if(side(left).arcs, [&](ir::Arc const& other) { return other.same(a); });
    }
  }
  void insert(bool left, ir::Arc arc) {
    if (arc.source == arc.target && !rule.model().is_oriented(arc.dimension) && arc.word != group.inverse(arc.word) &&
        random.chance(85)) {
      arc.word = involution(arc.word);
    }
    for (ir::Arc const& a : with_reverse(group, arc.source, arc.dimension, arc.word, arc.target)) {
      if (!has(left, a)) side(left).arcs.push_back(a);
    }
  }

  /// The arc of a non-oriented loop is its own reverse: g·d·ḡ instead of the word g.
  Word involution(Word const& g) {
    std::vector<Word> letters{{}};
    for (Letter const l : rule.hook_type) {
      if (!rule.model().is_oriented(l.dimension)) letters.push_back({l});
    }
    return group.product(group.product(g, random.pick(letters)), group.inverse(g));
  }

  /// Replaces an edge of one side, or of both if both have it, mostly.
  bool replace(bool left, ir::Arc const& old, std::optional<ir::Arc> const& changed) {
    bool const on_both = has(!left, old) && random.chance(50);
    erase(left, old);
    if (on_both) erase(!left, old);
    if (!changed) return true;
    bool const careful = random.chance(80);
    for (bool const on_left : {left, !left}) {
      if (on_left != left && !on_both) continue;
      if (careful) make_room(on_left, *changed);
      insert(on_left, *changed);
    }
    return true;
  }

  std::optional<std::pair<bool, ir::Arc>> random_edge() {
    bool const left = !rule.left.arcs.empty() && random.chance(35);
    if (side(left).arcs.empty()) return {};
    return std::pair(left, random.pick(side(left).arcs));
  }

  std::vector<ir::NodeId> nodes_on(bool left) const {
    std::vector<ir::NodeId> ids;
    for (ir::NodeId id = 0; id < rule.nodes.size(); ++id) {
      if (left ? !rule.nodes[id].added() : !rule.nodes[id].deleted()) ids.push_back(id);
    }
    return ids;
  }

  Word random_word() {
    Word word;
    if (rule.hooks.empty()) return word;
    bool const any_letter = rule.hook_type.empty() || random.chance(25);
    for (std::size_t k = random.chance(40) ? 0 : random.between(1, 3); k > 0; --k) {
      int const d = any_letter ? random.pick(rule.model().dimensions) : int{random.pick(rule.hook_type).dimension};
      word.push_back(letter(d, rule.model().is_oriented(d) && random.chance(50)));
    }
    return group.normal_form(word);
  }

  /// Erases the arcs that cannot stand beside this one.
  void make_room(bool left, ir::Arc const& arc) {
    std::vector<ir::Arc> const arcs = side(left).arcs;
    for (ir::Arc const& a : with_reverse(group, arc.source, arc.dimension, arc.word, arc.target)) {
      for (ir::Arc const& other : arcs) {
        if (other.dimension == a.dimension && (other.source == a.source || other.target == a.target))
          erase(left, other);
      }
    }
  }

  /// Does the right side have to give the node such an arc?
  bool needs(ir::NodeId id, int d, bool outgoing) {
    if (rule.nodes[id].added()) return true;
    if (rule.nodes[id].deleted()) return false;
    return std::any_of(rule.left.arcs.begin(), rule.left.arcs.end(), [&](ir::Arc const& arc) {
      return arc.dimension == d && (outgoing ? arc.source : arc.target) == id;
    });
  }

  /// Most rules that break the incident-arcs condition say nothing about the others: gives the right side the arcs that it
  /// lacks, between random nodes, and takes those that are too many.
  void repair_incident_arcs() {
    for (int const d : rule.model().dimensions) {
      std::vector<ir::Arc> const arcs = rule.right.arcs;
      for (ir::Arc const& arc : arcs) {
        if (arc.dimension == d && !(needs(arc.source, d, true) && needs(arc.target, d, false))) erase(false, arc);
      }
      std::vector<ir::NodeId> sources, targets;
      ir::Table const right(rule.nodes.size(), rule.right);
      for (ir::NodeId id = 0; id < rule.nodes.size(); ++id) {
        if (needs(id, d, true) && !right.out(id, d)) sources.push_back(id);
        if (needs(id, d, false) && !right.in(id, d)) targets.push_back(id);
      }
      random.shuffle(sources);
      random.shuffle(targets);
      auto const some_word = [&] {
        bool const of_type = std::find(rule.hook_type.begin(), rule.hook_type.end(), letter(d)) != rule.hook_type.end();
        return random.chance(40) ? Word{} : of_type && random.chance(40) ? word(d) : random_word();
      };
      bool const oriented = rule.model().is_oriented(d);
      while (!sources.empty() && (!oriented || !targets.empty())) {
        ir::NodeId const s = sources.back();
        sources.pop_back();
        ir::NodeId t = s;
        if (oriented) {
          t = targets.back();
          targets.pop_back();
        } else if (!sources.empty() && random.chance(60)) {
          t = sources.back();
          sources.pop_back();
        }
        insert(false, {s, d, some_word(), t, {}});
      }
    }
  }

  // ---- Changes; each returns false if there is nothing to change. ----

  bool change_word() {
    auto const edge = random_edge();
    if (!edge) return false;
    ir::Arc changed = edge->second;
    if (!changed.word.empty() && random.chance(50)) {
      std::size_t const k = random.below(changed.word.size());
      switch (random.below(3)) {
        case 0: changed.word.erase(changed.word.begin() + static_cast<std::ptrdiff_t>(k)); break;
        case 1: {
          int const d = random.pick(rule.model().dimensions);
          changed.word[k] = letter(d, rule.model().is_oriented(d) && random.chance(50));
          break;
        }
        default: changed.word = algebra::conjugate(rule.model(), changed.word);
      }
    } else {
      changed.word = random_word();
    }
    return replace(edge->first, edge->second, changed);
  }

  bool relabel() {
    auto const edge = random_edge();
    if (!edge) return false;
    ir::Arc changed = edge->second;
    changed.dimension = random.pick(rule.model().dimensions);
    return replace(edge->first, edge->second, changed);
  }

  bool retarget() {
    auto const edge = random_edge();
    if (!edge) return false;
    ir::Arc changed = edge->second;
    changed.target = random.pick(nodes_on(edge->first));
    return replace(edge->first, edge->second, changed);
  }

  bool drop() {
    auto const edge = random_edge();
    return edge && replace(edge->first, edge->second, {});
  }

  bool add() {
    bool const left = random.chance(50);
    auto const nodes = nodes_on(left);
    if (nodes.empty()) return false;
    ir::Arc const arc{random.pick(nodes), random.pick(rule.model().dimensions), random_word(), random.pick(nodes), {}};
    if (random.chance(70)) make_room(left, arc);
    insert(left, arc);
    if (random.chance(60) && rule.nodes[arc.source].preserved() && rule.nodes[arc.target].preserved()) {
      make_room(!left, arc);
      insert(!left, arc);
    }
    return true;
  }

  /// Drops an arc without its reverse.
  bool orient() {
    auto const edge = random_edge();
    if (!edge || rule.model().is_oriented(edge->second.dimension)) return false;
    for (bool const left : {true, false}) {
      if (left != edge->first && random.chance(50)) continue;
      std::erase_if(side(left).arcs, [&](ir::Arc const& a) { return a.same(edge->second); });
    }
    return true;
  }

  /// s -d- t and s' -d- t' of the right become s -d- s' and t -d- t', or s -d- t' and s' -d- t.
  bool exchange() {
    if (rule.right.arcs.empty()) return false;
    ir::Arc const first = random.pick(rule.right.arcs);
    std::vector<ir::Arc> others;
    for (ir::Arc const& arc : rule.right.arcs) {
      if (arc.dimension == first.dimension && !arc.same(first)) others.push_back(arc);
    }
    if (others.empty()) return false;
    ir::Arc second = random.pick(others);
    erase(false, first);
    erase(false, second);
    if (!rule.model().is_oriented(first.dimension) && random.chance(50)) {
      insert(false, {first.source, first.dimension, random_word(), second.source, {}});
      insert(false, {first.target, first.dimension, random_word(), second.target, {}});
    } else {
      insert(false, {first.source, first.dimension, random.chance(60) ? first.word : random_word(), second.target, {}});
      insert(false,
             {second.source, first.dimension, random.chance(60) ? second.word : random_word(), first.target, {}});
    }
    return true;
  }

  /// s -d- t of the right becomes two loops, or two loops become s -d- t.
  bool cut_or_join() {
    std::vector<ir::Arc> loops, links;
    for (ir::Arc const& arc : rule.right.arcs) (arc.source == arc.target ? loops : links).push_back(arc);
    if (random.chance(50) && !links.empty()) {
      ir::Arc const link = random.pick(links);
      erase(false, link);
      insert(false, {link.source, link.dimension, {}, link.source, {}});
      insert(false, {link.target, link.dimension, {}, link.target, {}});
      return true;
    }
    if (loops.empty()) return false;
    ir::Arc const a = random.pick(loops), b = random.pick(loops);
    if (a.dimension != b.dimension || a.source == b.source) return false;
    erase(false, a);
    erase(false, b);
    insert(false, {a.source, a.dimension, random.chance(50) ? a.word : Word{}, b.source, {}});
    if (rule.model().is_oriented(a.dimension))
      insert(false, {b.source, a.dimension, random.chance(50) ? b.word : Word{}, a.source, {}});
    return true;
  }

  /// Renames the copies of a node, (u, s) to (u·g, s): an added node's do not matter, others' do.
  bool move_copies() {
    if (rule.nodes.empty()) return false;
    move_copies_of(static_cast<ir::NodeId>(random.below(rule.nodes.size())), random_word());
    return true;
  }
  void move_copies_of(ir::NodeId id, Word const& g) {
    for (ir::Arc& arc : rule.right.arcs) {
      if (arc.source == id) arc.word = group.product(g, arc.word);
      if (arc.target == id) arc.word = group.product(arc.word, group.inverse(g));
    }
  }

  /// A right arc between preserved nodes becomes matched as well, or a matched one is kept on the right.
  bool preserve() {
    auto const edge = random_edge();
    if (!edge || !rule.nodes[edge->second.source].preserved() || !rule.nodes[edge->second.target].preserved())
      return false;
    if (random.chance(80)) make_room(!edge->first, edge->second);
    insert(!edge->first, edge->second);
    return true;
  }

  void erase_arcs_at(ir::NodeId id, bool left) {
    std::erase_if(side(left).arcs, [&](ir::Arc const& arc) { return arc.source == id || arc.target == id; });
  }

  bool change_status() {
    if (rule.nodes.empty()) return false;
    auto const id = static_cast<ir::NodeId>(random.below(rule.nodes.size()));
    ir::Node& node = rule.nodes[id];
    if (node.preserved()) {
      bool const left = !node.hook && random.chance(40);
      (left ? node.left_span : node.right_span).reset();
      erase_arcs_at(id, left);
      return true;
    }
    bool const left = node.added();
    std::vector<ir::Arc> const arcs = side(!left).arcs;
    (left ? node.left_span : node.right_span) = ir::Span{};
    for (ir::Arc const& arc : arcs) {
      if (arc.source != id && arc.target != id) continue;
      ir::Node const& other = rule.nodes[arc.source == id ? arc.target : arc.source];
      if (left ? !other.added() : !other.deleted()) insert(left, arc);
    }
    return true;
  }

  bool remove_node() {
    if (rule.nodes.size() < 2) return false;
    auto const id = static_cast<ir::NodeId>(random.below(rule.nodes.size()));
    if (rule.nodes[id].hook) return false;
    erase_arcs_at(id, true);
    erase_arcs_at(id, false);
    rule.nodes.erase(rule.nodes.begin() + static_cast<std::ptrdiff_t>(id));
    auto const shift = [&](ir::NodeId& other) {
      if (other > id) --other;
    };
    for (ir::Side* s : {&rule.left, &rule.right}) {
      for (ir::Arc& arc : s->arcs) {
        shift(arc.source);
        shift(arc.target);
      }
    }
    for (ir::NodeId& hook : rule.hooks) shift(hook);
    return true;
  }

  bool run() {
    static constexpr std::array changes{&Mutation::change_word,   &Mutation::change_word, &Mutation::relabel,
                                        &Mutation::retarget,      &Mutation::drop,        &Mutation::add,
                                        &Mutation::add,           &Mutation::orient,      &Mutation::exchange,
                                        &Mutation::exchange,      &Mutation::exchange,    &Mutation::cut_or_join,
                                        &Mutation::cut_or_join,   &Mutation::move_copies, &Mutation::preserve,
                                        &Mutation::change_status, &Mutation::remove_node};
    return (this->*changes[random.below(changes.size())])();
  }
};

/// As sema has it: a hook's decoration has no `_`, and the first hook's is its type.
bool hooks_are_full(ir::RuleScheme const& rule) {
  return std::all_of(rule.hooks.begin(), rule.hooks.end(), [&](ir::NodeId hook) {
    return std::all_of(rule.hook_type.begin(), rule.hook_type.end(), [&](Letter op) {
      return std::any_of(rule.left.arcs.begin(), rule.left.arcs.end(), [&](ir::Arc const& arc) {
        return arc.source == hook && arc.target == hook && arc.word.size() == 1 &&
               arc.word[0].dimension == op.dimension &&
               (hook != rule.hooks[0] || (arc.dimension == op.dimension && arc.word[0] == op));
      });
    });
  });
}

}  // namespace

ir::RuleScheme mutate(ir::RuleScheme const& rule, Random& random) {
  for (int attempt = 0; attempt < 20; ++attempt) {
    Mutation mutation{rule, random};
    if (!mutation.run()) continue;
    if (random.chance(70)) mutation.repair_incident_arcs();
    if (ir::verify(mutation.rule) || (!hooks_are_full(mutation.rule) && !random.chance(5))) continue;
    renumber_spans(mutation.rule);
    return std::move(mutation.rule);
  }
  return rule;
}

ir::RuleScheme move_added_copies(ir::RuleScheme const& rule, Random& random) {
  Mutation moved{rule, random};
  for (ir::NodeId id = 0; id < rule.nodes.size(); ++id) {
    if (!rule.nodes[id].added() || rule.hook_type.empty() || random.chance(50)) continue;
    // Of letters that the pattern is closed under: others would make another, larger pattern of it.
    Word word;
    for (std::size_t k = random.between(1, 3); k > 0; --k) {
      int const d = random.pick(rule.hook_type).dimension;
      word.push_back({static_cast<std::uint8_t>(d), rule.model().is_oriented(d) && random.chance(50)});
    }
    moved.move_copies_of(id, moved.group.normal_form(word));
  }
  return std::move(moved.rule);
}

}  // namespace jrule::property
