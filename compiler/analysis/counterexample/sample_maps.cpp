#include "compiler/analysis/counterexample/sample_maps.h"

#include <algorithm>

namespace jrule::analysis {

namespace {

struct Slot {
  Dart dart;
  std::size_t column;
};

std::optional<Slot> first_missing(PartialMap const& map, bool by_dimension) {
  if (map.complete()) return {};
  if (by_dimension) {
    for (std::size_t c = 0; c < map.columns(); ++c) {
      for (Dart d = 0; d < map.size(); ++d) {
        if (map.target(d, c) == no_dart) return Slot{d, c};
      }
    }
  }
  for (Dart d = 0; d < map.size(); ++d) {
    for (std::size_t c = 0; c < map.columns(); ++c) {
      if (map.target(d, c) == no_dart) return Slot{d, c};
    }
  }
  return {};
}

/// Depth first; new darts are numbered in the order in which they are reached, so each map is met once.
struct Enumeration {
  Dart darts;
  std::size_t most;
  PartialMap map;
  std::vector<PartialMap> found{};

  void run() {
    if (found.size() == most) return;
    auto const slot = first_missing(map, false);
    if (!slot) {
      if (map.size() == darts) found.push_back(map);
      return;
    }
    PartialMap::Mark const mark = map.mark();
    for (Dart to = 0; to <= map.size() && to < darts; ++to) {
      if (to == map.size()) {
        map.add_dart();
      } else if (map.source(to, slot->column) != no_dart) {
        continue;
      }
      bool const last = map.size() != mark.size;
      if (map.set(slot->dart, slot->column, to)) run();
      map.undo(mark);
      if (last) break;
    }
  }
};

struct Completion {
  PartialMap& map;
  Dart limit;
  Manner manner;
  Choices& choices;
  int steps = 300;

  bool attempt(Slot const& slot, Dart to) {
    PartialMap::Mark const mark = map.mark();
    if (to == map.size()) map.add_dart();
    if (map.set(slot.dart, slot.column, to) && run()) return true;
    map.undo(mark);
    return false;
  }

  bool run() {
    auto const slot = first_missing(map, manner.by_dimension);
    if (!slot) return true;
    bool const may_grow = map.size() < limit;
    bool const grow_first = may_grow && choices.percent(manner.fresh);
    if (--steps < 0) return false;
    if (grow_first && attempt(*slot, map.size())) return true;
    std::vector<Dart> targets;
    for (Dart d = 0; d < map.size(); ++d) {
      if (map.source(d, slot->column) == no_dart) targets.push_back(d);
    }
    for (std::size_t k = targets.size(); k > 1; --k) std::swap(targets[k - 1], targets[choices.below(k)]);
    if (choices.percent(manner.loops)) {
      auto const loop = std::find(targets.begin(), targets.end(), slot->dart);
      if (loop != targets.end()) std::swap(*loop, targets.front());
    }
    for (Dart const to : targets) {
      if (steps < 0) return false;
      if (attempt(*slot, to)) return true;
    }
    return may_grow && !grow_first && steps >= 0 && attempt(*slot, map.size());
  }
};

}  // namespace

std::vector<PartialMap> connected_maps(Model const& model, Dart darts, std::size_t most) {
  Enumeration enumeration{darts, most, PartialMap(model)};
  enumeration.map.add_dart();
  enumeration.run();
  return std::move(enumeration.found);
}

Manner draw_manner(Choices& choices) { return {choices.below(70), choices.below(60), choices.percent(50)}; }

bool complete(PartialMap& map, Dart limit, Manner manner, Choices& choices) {
  return Completion{map, limit, manner, choices}.run();
}

}  // namespace jrule::analysis
