// Small random maps, as permutations of a few darts that satisfy a model's relations. Found by search straight from the
// definition of a map, so that they say something about the group without using it.
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

#include "jrule/model.h"

namespace jrule::test {

class FiniteAction {
 public:
  FiniteAction(Model const& model, int darts)
      : next_(max_dimension + 1, std::vector<int>(index(darts), none)), previous_(next_), model_(model) {}

  int darts() const { return static_cast<int>(next_[0].size()); }
  int next(int d, int dart) const { return next_[index(d)][index(dart)]; }
  int previous(int d, int dart) const { return previous_[index(d)][index(dart)]; }

  int walk(int dart, Word const& word) const {
    for (Letter const l : word) dart = l.conjugate ? previous(l.dimension, dart) : next(l.dimension, dart);
    return dart;
  }

  /// Fills what is undefined at random; false if no way was found within `budget` assignments. The dimensions are
  /// filled in random order too: the first ones are the freest.
  bool complete(std::mt19937& random, int& budget) {
    std::shuffle(model_.dimensions.begin(), model_.dimensions.end(), random);
    return complete_in_order(random, budget);
  }

 private:
  static constexpr int none = -1;
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }

  bool complete_in_order(std::mt19937& random, int& budget) {
    for (int const d : model_.dimensions) {
      for (int dart = 0; dart < darts(); ++dart) {
        if (next(d, dart) != none) continue;
        std::vector<int> candidates(index(darts()));
        std::iota(candidates.begin(), candidates.end(), 0);
        std::shuffle(candidates.begin(), candidates.end(), random);
        for (int const target : candidates) {
          if (model_.closed && target == dart) continue;
          if (--budget < 0) return false;
          FiniteAction attempt = *this;
          if (attempt.define(d, dart, target) && attempt.close_cycles() && attempt.complete_in_order(random, budget)) {
            next_ = std::move(attempt.next_);
            previous_ = std::move(attempt.previous_);
            return true;
          }
        }
        return false;
      }
    }
    return true;
  }

  bool define(int d, int dart, int target) {
    if (next(d, dart) == target) return true;
    if (next(d, dart) != none || previous(d, target) != none || (model_.closed && dart == target)) return false;
    next_[index(d)][index(dart)] = target;
    previous_[index(d)][index(target)] = dart;
    return model_.is_oriented(d) || define(d, target, dart);
  }

  /// Defines the last arc of every ijij-cycle of which three are known, until there is none.
  bool close_cycles() {
    for (bool changed = true; changed;) {
      changed = false;
      for (auto const& [a, b] : model_.exchange) {
        for (auto const& [i, j] : {std::pair{a, b}, std::pair{b, a}}) {
          for (int dart = 0; dart < darts(); ++dart) {
            int end = dart;
            for (int const d : {i, j, i}) {
              if (end != none) end = next(d, end);
            }
            if (end == none || next(j, end) == dart) continue;
            if (!define(j, end, dart)) return false;
            changed = true;
          }
        }
      }
    }
    return true;
  }

  std::vector<std::vector<int>> next_, previous_;  // by dimension, then by dart
  Model model_;
};

/// `count` maps of at most `max_darts` darts.
inline std::vector<FiniteAction> random_actions(Model const& model, std::size_t count, int max_darts,
                                                std::mt19937& random) {
  std::vector<FiniteAction> actions;
  while (actions.size() < count) {
    int const half = std::uniform_int_distribution<int>(1, max_darts / 2)(random);
    FiniteAction action(model, 2 * half);
    int budget = 500;
    if (action.complete(random, budget)) actions.push_back(std::move(action));
  }
  return actions;
}

}  // namespace jrule::test
