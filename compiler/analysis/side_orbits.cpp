#include "compiler/analysis/side_orbits.h"

#include <algorithm>

#include "compiler/analysis/orbit_links.h"
#include "compiler/analysis/subgroup.h"

namespace jrule::analysis {

namespace {

// Nodes, and behind them the darts outside the rule that walks lead to: vertices of a graph whose edges carry words.
struct Edge {
  std::size_t from;
  Word word;
  std::size_t to;
};
using Key = std::pair<ir::NodeId, Word>;

bool steps_out(ir::Table const& table, ir::NodeId id, OrbitType const& orbit) {
  auto const matched = [&](Letter letter, bool conjugate) {
    return (conjugate ? table.in(id, letter.dimension) : table.out(id, letter.dimension)) != nullptr;
  };
  return std::any_of(orbit.words.begin(), orbit.words.end(), [&](Word const& word) {
    return !matched(word.front(), word.front().conjugate) || !matched(word.back(), !word.back().conjugate);
  });
}

}  // namespace

SideOrbits::SideOrbits(ir::RuleScheme const& rule, bool left, OrbitType const& orbit, algebra::Group const& group, PatternWords const& words)
    : group_(group), words_(words) {
  ir::Table const table(rule.nodes.size(), left ? rule.left : rule.right);
  OrbitLinks const joined = orbit_links(rule, left, table, orbit, group);
  std::vector<Edge> edges;
  for (OrbitLink const& link : joined.links) edges.push_back({link.from, link.word, link.to});
  std::vector<Key> outside;
  for (OrbitAnchor const& anchor : joined.anchors) {
    if (anchor.tail.empty()) continue;  // the node itself
    auto const known = std::find(outside.begin(), outside.end(), Key(anchor.preserved, anchor.tail));
    edges.push_back({anchor.node, anchor.word, rule.nodes.size() + static_cast<std::size_t>(known - outside.begin())});
    if (known == outside.end()) outside.emplace_back(anchor.preserved, anchor.tail);
  }

  std::vector<std::optional<Word>> path(rule.nodes.size() + outside.size());
  for (ir::NodeId root = 0; root < rule.nodes.size(); ++root) {
    if ((left ? rule.nodes[root].added() : rule.nodes[root].deleted()) || path[root]) continue;
    SideOrbit found;
    std::vector<std::size_t> members{root};
    path[root] = Word{};
    for (std::size_t next = 0; next < members.size(); ++next) {
      std::size_t const at = members[next];
      for (Edge const& edge : edges) {
        for (bool const forwards : {true, false}) {
          if ((forwards ? edge.from : edge.to) != at) continue;
          std::size_t const to = forwards ? edge.to : edge.from;
          Word const there = group.product(*path[at], forwards ? edge.word : group.inverse(edge.word));
          if (!path[to]) {
            path[to] = there;
            members.push_back(to);
          } else if (Word const closed = group.product(there, group.inverse(*path[to])); !words.trivial(closed)) {
            found.generators.push_back(closed);
          }
        }
      }
    }
    found.generators = reduced(group, std::move(found.generators));
    for (std::size_t const member : members) {
      auto const survive = [&](ir::NodeId node, Word const& tail) {
        found.survivors.push_back({node, tail, *path[member]});
        places_.emplace(Key(node, tail), Place{orbits_.size(), *path[member]});
      };
      if (member >= rule.nodes.size()) {
        auto const& [node, tail] = outside[member - rule.nodes.size()];
        survive(node, tail);
        found.reaches_out = true;
        continue;
      }
      auto const id = static_cast<ir::NodeId>(member);
      found.nodes.push_back(id);
      if (rule.nodes[id].preserved()) survive(id, {});
      found.reaches_out = found.reaches_out || steps_out(table, id, orbit);
    }
    orbits_.push_back(std::move(found));
  }
}

bool SideOrbits::generated(Word const& word, std::vector<Word> const& by) const {
  if (words_.trivial(word)) return true;
  std::vector<Word> all = by;
  for (Relation const& relation : words_.relations()) all.push_back(relation.word);
  return generates(group_, all, word);
}

// (u·a, s) is of the orbit whose root's copy is at u·a·p⁻¹, p being the path to s; likewise (u·b, t). The roots' copies are of one
// orbit iff a generated word leads from one to the other.
bool SideOrbits::joins(SideOrbit::Survivor const& s, SideOrbit::Survivor const& t) const {
  auto const of_s = places_.find(Key(s.node, s.tail)), of_t = places_.find(Key(t.node, t.tail));
  if (of_s == places_.end() || of_t == places_.end() || of_s->second.orbit != of_t->second.orbit) return false;
  Word const from = group_.product(s.path, group_.inverse(of_s->second.path));
  Word const to = group_.product(t.path, group_.inverse(of_t->second.path));
  return generated(group_.product(group_.inverse(from), to), orbits_[of_s->second.orbit].generators);
}

}  // namespace jrule::analysis
