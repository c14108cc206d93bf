#include "compiler/analysis/counterexample/literal_application.h"

#include <algorithm>

namespace jrule::analysis {

LiteralApplication::LiteralApplication(ir::RuleScheme const& rule) : rule_(rule) {
  for (Letter const letter : rule.hook_type) word_index({letter});
  left_ = arcs_of(rule.left, rule.right);
  right_ = arcs_of(rule.right, rule.left);
  for (std::size_t a = 0; a < left_.size(); ++a) {
    for (std::size_t b = a + 1; b < left_.size(); ++b) {
      if (left_[a].column != left_[b].column) continue;
      if (left_[a].source == left_[b].source || left_[a].target == left_[b].target) contradictory_ = true;
    }
  }
  plan_placing();
  steps_.resize(words_.size());
  copies_.resize(rule.nodes.size());
  out_.resize(rule.model().dimensions.size());
}

std::size_t LiteralApplication::word_index(Word const& word) {
  auto const known = std::find(words_.begin(), words_.end(), word);
  if (known == words_.end()) {
    words_.push_back(word);
    return words_.size() - 1;
  }
  return static_cast<std::size_t>(known - words_.begin());
}

std::vector<LiteralApplication::ArcUse> LiteralApplication::arcs_of(ir::Side const& side, ir::Side const& other) {
  std::vector<ArcUse> uses;
  for (ir::Arc const& arc : side.arcs) {
    auto const column = static_cast<std::size_t>(rule_.model().column(arc.dimension));
    uses.push_back({arc.source, column, word_index(arc.word), arc.target, ir::find_same(other, arc) == nullptr});
  }
  return uses;
}

// The order in which left arcs lead from the hooks to the other nodes.
void LiteralApplication::plan_placing() {
  std::vector<bool> placed(rule_.nodes.size(), false);
  for (ir::NodeId const hook : rule_.hooks) placed[hook] = true;
  for (bool changed = true; changed;) {
    changed = false;
    for (ArcUse const& arc : left_) {
      if (placed[arc.source] == placed[arc.target]) continue;
      placing_.push_back({arc, placed[arc.source]});
      placed[arc.source] = placed[arc.target] = changed = true;
    }
  }
}

// P, the first hook's copies, and the others, walked in step along their own loops.
bool LiteralApplication::match_hooks(PartialMap const& map, std::vector<Dart> const& hooks) {
  std::vector<Dart>& pattern = copies_[rule_.hooks[0]];
  std::vector<Dart> index(map.size(), no_dart);
  auto const reach = [&](Dart d) {
    if (index[d] != no_dart) return;
    index[d] = static_cast<Dart>(pattern.size());
    pattern.push_back(d);
  };
  reach(hooks[0]);
  for (std::size_t k = 0; k < pattern.size(); ++k) {
    for (Word const& word : words_) {
      Dart const u = pattern[k];
      reach(map.walk(u, word));
      reach(map.walk_back(u, word));
    }
  }
  for (std::size_t w = 0; w < words_.size(); ++w) {
    steps_[w].resize(pattern.size());
    for (std::size_t k = 0; k < pattern.size(); ++k) steps_[w][k] = index[map.walk(pattern[k], words_[w])];
  }
  for (std::size_t h = 1; h < hooks.size(); ++h) {
    std::vector<Dart>& copies = copies_[rule_.hooks[h]];
    copies.assign(pattern.size(), no_dart);
    copies[0] = hooks[h];
    std::vector<std::size_t> open{0};
    for (std::size_t next = 0; next < open.size(); ++next) {
      std::size_t const k = open[next];
      for (ArcUse const& arc : left_) {
        if (arc.source != rule_.hooks[h] || arc.target != rule_.hooks[h]) continue;
        Dart const to = steps_[arc.word][k];
        if (copies[to] != no_dart) continue;
        copies[to] = map.target(copies[k], arc.column);
        open.push_back(to);
      }
    }
    if (open.size() != pattern.size()) return false;
  }
  return true;
}

bool LiteralApplication::match(PartialMap const& map, std::vector<Dart> const& hooks) {
  if (contradictory_) return false;
  for (std::vector<Dart>& copies : copies_) copies.clear();
  if (hooks.empty()) {
    // The pattern of a rule that creates is one dart of which nothing is known.
    for (auto& step : steps_) step.assign(1, 0);
    return true;
  }
  if (!match_hooks(map, hooks)) return false;
  std::size_t const size = copies_[rule_.hooks[0]].size();
  for (auto const& [arc, forwards] : placing_) {
    copies_[forwards ? arc.target : arc.source].assign(size, no_dart);
    for (std::size_t k = 0; k < size; ++k) {
      Dart const to = steps_[arc.word][k];
      if (forwards) {
        copies_[arc.target][to] = map.target(copies_[arc.source][k], arc.column);
      } else {
        copies_[arc.source][k] = map.source(copies_[arc.target][to], arc.column);
      }
    }
  }
  for (ArcUse const& arc : left_) {
    for (std::size_t k = 0; k < size; ++k) {
      if (map.target(copies_[arc.source][k], arc.column) != copies_[arc.target][steps_[arc.word][k]]) return false;
    }
  }
  std::vector<bool> matched(map.size(), false);
  for (auto const& copies : copies_) {
    for (Dart const d : copies) {
      if (matched[d]) return false;
      matched[d] = true;
    }
  }
  return true;
}

void LiteralApplication::rewrite(PartialMap const& map) {
  std::size_t const size = rule_.hooks.empty() ? 1 : copies_[rule_.hooks[0]].size();
  live_.assign(map.size(), true);
  for (std::size_t c = 0; c < out_.size(); ++c) {
    out_[c].resize(map.size());
    for (Dart d = 0; d < map.size(); ++d) out_[c][d] = map.target(d, c);
  }
  extras_.clear();
  for (ArcUse const& arc : left_) {
    if (!arc.changed) continue;
    for (Dart const d : copies_[arc.source]) out_[arc.column][d] = no_dart;
  }
  for (ir::NodeId id = 0; id < rule_.nodes.size(); ++id) {
    if (!rule_.nodes[id].deleted()) continue;
    for (Dart const d : copies_[id]) live_[d] = false;
  }
  for (ir::NodeId id = 0; id < rule_.nodes.size(); ++id) {
    if (!rule_.nodes[id].added()) continue;
    for (std::size_t k = 0; k < size; ++k) copies_[id].push_back(static_cast<Dart>(live_.size() + k));
    live_.resize(live_.size() + size, true);
  }
  for (auto& column : out_) column.resize(live_.size(), no_dart);
  for (ArcUse const& arc : right_) {
    if (!arc.changed) continue;
    for (std::size_t k = 0; k < size; ++k) {
      Dart const from = copies_[arc.source][k], to = copies_[arc.target][steps_[arc.word][k]];
      Dart& out = out_[arc.column][from];
      if (out == no_dart) {
        out = to;
      } else {
        extras_.push_back({from, arc.column, to});
      }
    }
  }
}

bool LiteralApplication::is_map_but_for_doubled() const {
  Model const& model = rule_.model();
  auto const size = static_cast<Dart>(live_.size());
  for (auto const& column : out_) {
    incoming_.assign(size, no_dart);
    for (Dart d = 0; d < size; ++d) {
      if (live_[d] == (column[d] == no_dart)) return false;
      if (!live_[d]) continue;
      if (!live_[column[d]] || incoming_[column[d]] != no_dart) return false;
      incoming_[column[d]] = d;
    }
  }
  for (std::size_t c = 0; c < out_.size(); ++c) {
    bool const oriented = model.is_oriented(model.dimensions[c]);
    for (Dart d = 0; d < size; ++d) {
      if (!live_[d]) continue;
      if (!oriented && out_[c][out_[c][d]] != d) return false;
      if (model.closed && out_[c][d] == d) return false;
    }
  }
  for (auto const& [i, j] : model.exchange) {
    auto const& a = out_[static_cast<std::size_t>(model.column(i))];
    auto const& b = out_[static_cast<std::size_t>(model.column(j))];
    for (Dart d = 0; d < size; ++d) {
      if (live_[d] && b[a[b[a[d]]]] != d) return false;
    }
  }
  return true;
}

LiteralApplication::Outcome LiteralApplication::judge() const {
  bool const parallel =
      std::all_of(extras_.begin(), extras_.end(), [&](Extra const& e) { return out_[e.column][e.from] == e.to; });
  if (!parallel || !is_map_but_for_doubled()) return Outcome::broken;
  return extras_.empty() ? Outcome::map : Outcome::doubled_arcs;
}

LiteralApplication::Outcome LiteralApplication::apply(PartialMap const& map, std::vector<Dart> const& hooks) {
  if (!match(map, hooks)) return Outcome::no_match;
  rewrite(map);
  return judge();
}

Graph LiteralApplication::result() const {
  Graph graph;
  graph.targets.resize(live_.size());
  for (Dart d = 0; d < live_.size(); ++d) {
    if (live_[d]) graph.darts.push_back(d);
    for (auto const& column : out_)
      graph.targets[d].push_back(column[d] == no_dart ? std::vector<Dart>{} : std::vector<Dart>{column[d]});
  }
  for (Extra const& extra : extras_) {
    auto& targets = graph.targets[extra.from][extra.column];
    targets.insert(std::upper_bound(targets.begin(), targets.end(), extra.to), extra.to);
  }
  return graph;
}

}  // namespace jrule::analysis
