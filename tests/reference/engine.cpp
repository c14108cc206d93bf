#include "tests/reference/engine.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace jrule::reference {

namespace {

/// An arc of a graph labelled with dimensions.
struct PlainArc {
  Dart source;
  int dimension;
  Dart target;
  auto operator<=>(PlainArc const&) const = default;
};

/// An arc of ι(L, P) or ι(R, P): the product of an arc (w, d) of the scheme and a w-arc of P, projected on d.
struct ProductArc {
  Copy source;
  int dimension;
  Copy target;
  bool preserved;  ///< of ι(K, P)
};

using Match = std::map<Copy, Dart>;
using Failure = tl::unexpected<std::string>;

struct Engine {
  ir::RuleScheme const& rule;
  PlainMap const& g;
  std::vector<Dart> const& hooks;
  std::map<int, std::map<Dart, Dart>> sources{};  // of each dimension, the source of the arc into a dart
  std::set<Dart> pattern{};
  std::map<std::pair<Dart, Word>, Dart> pattern_arcs{};  // the w-arc that leaves u

  Dart target(Dart d, int i) const { return g.targets.at(d).at(i).at(0); }

  Dart walk(Dart d, Word const& word) const {
    for (Letter const l : word) d = l.conjugate ? sources.at(l.dimension).at(d) : target(d, l.dimension);
    return d;
  }
  Dart walk_back(Dart d, Word const& word) const {
    for (auto l = word.rbegin(); l != word.rend(); ++l)
      d = l->conjugate ? target(d, l->dimension) : sources.at(l->dimension).at(d);
    return d;
  }

  /// W: every word of the rule; the hook's type names words too.
  std::set<Word> words() const {
    std::set<Word> all;
    for (Letter const l : rule.hook_type) all.insert(Word{l});
    for (ir::Side const* side : {&rule.left, &rule.right}) {
      for (ir::Arc const& arc : side->arcs) all.insert(arc.word);
    }
    return all;
  }

  /// P_v (section 6.3): what is reached from v along arcs of the pattern functor's image ℙ(G), and against them. A rule without
  /// a left side is instantiated with the terminal pattern, one node.
  void extract_pattern() {
    std::set<Word> const all = words();
    if (hooks.empty()) {
      pattern = {0};
      for (Word const& word : all) pattern_arcs[{0, word}] = 0;
      return;
    }
    std::vector<Dart> open{hooks[0]};
    pattern.insert(hooks[0]);
    while (!open.empty()) {
      Dart const u = open.back();
      open.pop_back();
      for (Word const& word : all) {
        Dart const to = walk(u, word);
        pattern_arcs[{u, word}] = to;
        for (Dart const reached : {to, walk_back(u, word)}) {
          if (pattern.insert(reached).second) open.push_back(reached);
        }
      }
    }
  }

  /// ι(side, P) (Def. 19).
  std::vector<ProductArc> instantiate(ir::Side const& side, ir::Side const& other) const {
    std::vector<ProductArc> arcs;
    for (ir::Arc const& arc : side.arcs) {
      bool const preserved =
          std::any_of(other.arcs.begin(), other.arcs.end(), [&](ir::Arc const& o) { return o.same(arc); });
      for (Dart const u : pattern) {
        arcs.push_back({{u, arc.source}, arc.dimension, {pattern_arcs.at({u, arc.word}), arc.target}, preserved});
      }
    }
    return arcs;
  }

  /// Sends every arc at a dart that has an image to the only arc of G that it can go to, until nothing is new.
  void propagate(std::vector<ProductArc> const& arcs, Match& m) const {
    for (bool changed = true; changed;) {
      changed = false;
      for (ProductArc const& arc : arcs) {
        if (auto const from = m.find(arc.source); from != m.end() && !m.contains(arc.target)) {
          m[arc.target] = target(from->second, arc.dimension);
          changed = true;
        } else if (auto const to = m.find(arc.target); to != m.end() && !m.contains(arc.source)) {
          m[arc.source] = sources.at(arc.dimension).at(to->second);
          changed = true;
        }
      }
    }
  }

  /// The unique m: ι(L, P) ↪ G. The first hook's copies are the pattern itself; of a further hook, its dart is the image at the
  /// pattern's root, and its own loops have to determine the rest.
  tl::expected<Match, std::string> find_match(std::vector<ProductArc> const& left) const {
    Match m;
    for (std::size_t h = 0; h < hooks.size(); ++h) {
      ir::NodeId const node = rule.hooks[h];
      if (h == 0) {
        for (Dart const u : pattern) m[{u, node}] = u;
        continue;
      }
      m[{hooks[0], node}] = hooks[h];
      std::vector<ProductArc> loops;
      std::copy_if(left.begin(), left.end(), std::back_inserter(loops),
                   [&](ProductArc const& arc) { return arc.source.second == node && arc.target.second == node; });
      propagate(loops, m);
    }
    for (ir::NodeId const node : rule.hooks) {
      for (Dart const u : pattern) {
        if (!m.contains({u, node})) return Failure("a further hook's copy is not determined");
      }
    }
    propagate(left, m);
    std::set<Dart> matched;
    for (auto const& [copy, dart] : m) {
      if (!matched.insert(dart).second) return Failure(fmt::format("dart {} is matched twice", dart));
    }
    std::set<PlainArc> matched_arcs;
    for (ProductArc const& arc : left) {
      PlainArc const image{m.at(arc.source), arc.dimension, m.at(arc.target)};
      if (target(image.source, image.dimension) != image.target)
        return Failure(fmt::format("dart {} has another {}-arc", image.source, image.dimension));
      if (!matched_arcs.insert(image).second)
        return Failure(fmt::format("the {}-arc of dart {} is matched twice", image.dimension, image.source));
    }
    return m;
  }

  /// The dangling condition: every arc at a deleted dart is matched.
  std::optional<std::string> dangling(std::vector<ProductArc> const& left, Match const& m,
                                      std::set<Dart> const& deleted) const {
    std::set<PlainArc> matched;
    for (ProductArc const& arc : left) matched.insert({m.at(arc.source), arc.dimension, m.at(arc.target)});
    for (Dart const d : deleted) {
      for (int const i : g.dimensions) {
        if (!matched.contains({d, i, target(d, i)}) || !matched.contains({sources.at(i).at(d), i, d})) {
          return fmt::format("the {}-arcs of the deleted dart {} are not all matched", i, d);
        }
      }
    }
    return {};
  }

  tl::expected<Derivation, std::string> run() {
    for (Dart const hook : hooks) {
      if (!g.targets.contains(hook)) return Failure(fmt::format("there is no dart {}", hook));
    }
    for (auto const& [d, arcs] : g.targets) {
      for (int const i : g.dimensions) sources[i][arcs.at(i).at(0)] = d;
    }
    extract_pattern();
    std::vector<ProductArc> const left = instantiate(rule.left, rule.right), right = instantiate(rule.right, rule.left);
    auto const m = find_match(left);
    if (!m) return Failure(m.error());
    std::set<Dart> deleted;
    for (auto const& [copy, dart] : *m) {
      if (rule.nodes[copy.second].deleted()) deleted.insert(dart);
    }
    if (auto const arc = dangling(left, *m, deleted)) return Failure(*arc);

    Derivation derivation{g, {}, *m};
    PlainMap& h = derivation.result;
    for (ProductArc const& arc : left) {
      if (!arc.preserved) std::erase(h.targets.at(m->at(arc.source)).at(arc.dimension), m->at(arc.target));
    }
    for (Dart const d : deleted) h.targets.erase(d);
    Dart next = g.targets.empty() ? 0 : g.targets.rbegin()->first + 1;
    for (ir::NodeId node = 0; node < rule.nodes.size(); ++node) {
      for (Dart const u : pattern) {
        if (rule.nodes[node].preserved()) derivation.copies[{u, node}] = m->at({u, node});
        if (!rule.nodes[node].added()) continue;
        for (int const i : g.dimensions) h.targets[next][i];
        derivation.copies[{u, node}] = next++;
      }
    }
    for (ProductArc const& arc : right) {
      if (!arc.preserved)
        h.targets.at(derivation.copies.at(arc.source)).at(arc.dimension).push_back(derivation.copies.at(arc.target));
    }
    return derivation;
  }
};

}  // namespace

tl::expected<Derivation, std::string> derive(ir::RuleScheme const& rule, PlainMap const& map,
                                             std::vector<Dart> const& hooks) {
  return Engine{rule, map, hooks}.run();
}

}  // namespace jrule::reference
