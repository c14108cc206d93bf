#include "compiler/analysis/orbit_links.h"

namespace jrule::analysis {

namespace {

struct Walker {
  ir::RuleScheme const& rule;
  ir::Table const& table;
  algebra::Group const& group;
  OrbitLinks found{};

  ir::Arc const* along(ir::NodeId at, Letter letter) const {
    return letter.conjugate ? table.in(at, letter.dimension) : table.out(at, letter.dimension);
  }

  // A walk that comes from outside the rule, by an unmatched arc, and is at `id` after k letters: the dart where it started
  // is of the orbit of the node where it ends. (The first k - 1 letters are walked as the map was before.)
  void enter(ir::NodeId id, Word const& path, std::size_t k) {
    Letter const last = path[k - 1];
    if (last.conjugate ? table.out(id, last.dimension) : table.in(id, last.dimension)) return;
    ir::NodeId at = id;
    Word word;
    for (std::size_t next = k; next < path.size(); ++next) {
      Letter const letter = path[next];
      ir::Arc const* const arc = along(at, letter);
      if (!arc) return;
      word = group.product(word, letter.conjugate ? group.inverse(arc->word) : arc->word);
      at = letter.conjugate ? arc->source : arc->target;
    }
    Word const prefix(path.begin(), path.begin() + static_cast<std::ptrdiff_t>(k));
    found.anchors.push_back({at, group.inverse(word), id, group.inverse(prefix)});
  }

  void walk(ir::NodeId start, Word const& path) {
    ir::NodeId at = start;
    Word word;
    source::Span span = rule.nodes[start].span();
    for (std::size_t k = 0; k < path.size(); ++k) {
      Letter const letter = path[k];
      ir::Arc const* const arc = along(at, letter);
      if (!arc) {
        // A preserved node whose arc is not matched: the walk leaves the rule and goes on along arcs of the map. Where all of
        // it does, it joins nothing that was not of one orbit before.
        if (k > 0) found.anchors.push_back({start, word, at, Word(path.begin() + static_cast<std::ptrdiff_t>(k), path.end())});
        return;
      }
      word = group.product(word, letter.conjugate ? group.inverse(arc->word) : arc->word);
      at = letter.conjugate ? arc->source : arc->target;
      span = arc->span;
    }
    found.links.push_back({start, word, at, span});
  }
};

}  // namespace

OrbitLinks orbit_links(ir::RuleScheme const& rule, bool left, ir::Table const& table, OrbitType const& orbit, algebra::Group const& group) {
  Walker walker{rule, table, group};
  for (ir::NodeId id = 0; id < rule.nodes.size(); ++id) {
    if (left ? rule.nodes[id].added() : rule.nodes[id].deleted()) continue;
    if (rule.nodes[id].preserved()) walker.found.anchors.push_back({id, {}, id, {}});
    for (Word const& word : orbit.words) {
      walker.walk(id, word);
      for (std::size_t k = 1; k < word.size(); ++k) walker.enter(id, word, k);
    }
  }
  return std::move(walker.found);
}

}  // namespace jrule::analysis
