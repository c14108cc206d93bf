#include "compiler/analysis/counterexample/counterexample.h"

#include <algorithm>
#include <set>
#include <stdexcept>

#include "compiler/analysis/counterexample/literal_application.h"
#include "compiler/analysis/counterexample/sample_maps.h"

namespace jrule::analysis {

namespace {

/// Patterns of up to that many darts are tried one by one, then larger ones at random.
constexpr Dart exhaustive_size = 4;
constexpr std::size_t exhaustive_count = 150;
constexpr Dart random_size = 10;
/// Left sides' instances that are larger are tried with the smallest patterns only.
constexpr Dart dart_limit = 64;
/// Random maps that are tried once there is a counterexample, to find a smaller one.
constexpr std::size_t improvements = 150;

/// The model of some dimensions alone: of the pattern, before the rest of the map is there.
Model restricted(Model model, std::set<int> const& dimensions) {
  model.dimensions.assign(dimensions.begin(), dimensions.end());
  std::erase_if(model.exchange,
                [&](auto const& pair) { return model.column(pair.first) < 0 || model.column(pair.second) < 0; });
  return model;
}

std::set<int> letters_of(ir::RuleScheme const& rule) {
  std::set<int> letters;
  for (Letter const l : rule.hook_type) letters.insert(l.dimension);
  for (ir::Side const* side : {&rule.left, &rule.right}) {
    for (ir::Arc const& arc : side->arcs) {
      for (Letter const l : arc.word) letters.insert(l.dimension);
    }
  }
  return letters;
}

struct Searching {
  ir::RuleScheme const& rule;
  std::size_t budget;
  LiteralApplication application{rule};
  Model pattern_model = restricted(rule.model(), letters_of(rule));
  Choices choices{};
  std::size_t tried = 0, applications = 0;

  struct Found {
    PartialMap map;
    std::vector<Dart> hooks;
    bool doubled;  // nothing is wrong but arcs that are there twice: taken if there is nothing better
  };
  std::optional<Found> best{};

  bool refuted() const { return best && !best->doubled; }
  /// Larger maps are of no interest any more.
  Dart largest() const { return refuted() ? best->map.size() - 1 : dart_limit; }

  void consider(PartialMap const& map, std::vector<Dart> const& hooks) {
    auto const outcome = application.apply(map, hooks);
    if (outcome == LiteralApplication::Outcome::no_match) return;
    ++applications;
    if (outcome == LiteralApplication::Outcome::map) return;
    bool const doubled = outcome == LiteralApplication::Outcome::doubled_arcs;
    if (!best || std::pair(doubled, map.size()) < std::pair(best->doubled, best->map.size()))
      best = Found{map, hooks, doubled};
  }

  struct Instance {
    PartialMap map;
    std::vector<Dart> hooks;
  };

  /// The left side at each dart of the pattern, as the beginning of a map; none if no map contains it.
  std::optional<Instance> instantiate(PartialMap const& pattern) const {
    Model const& model = rule.model();
    Instance instance{PartialMap(model), {}};
    std::vector<Dart> first(rule.nodes.size(), no_dart);
    for (ir::NodeId s = 0; s < rule.nodes.size(); ++s) {
      if (rule.nodes[s].added()) continue;
      first[s] = instance.map.size();
      for (Dart u = 0; u < pattern.size(); ++u) instance.map.add_dart();
    }
    auto const column = [&](int d) { return static_cast<std::size_t>(model.column(d)); };
    // The first hook's copies are the pattern itself.
    for (std::size_t c = 0; c < pattern.columns(); ++c) {
      for (Dart u = 0; u < pattern.size(); ++u) {
        Dart const hook = first[rule.hooks[0]];
        if (!instance.map.set(hook + u, column(pattern_model.dimensions[c]), hook + pattern.target(u, c))) return {};
      }
    }
    for (ir::Arc const& arc : rule.left.arcs) {
      for (Dart u = 0; u < pattern.size(); ++u) {
        if (!instance.map.set(first[arc.source] + u, column(arc.dimension),
                              first[arc.target] + pattern.walk(u, arc.word)))
          return {};
      }
    }
    for (ir::NodeId const hook : rule.hooks) instance.hooks.push_back(first[hook]);
    return instance;
  }

  Dart left_nodes() const {
    return static_cast<Dart>(
        std::count_if(rule.nodes.begin(), rule.nodes.end(), [](ir::Node const& node) { return !node.added(); }));
  }

  /// Completes the instance in so many ways.
  void try_pattern(PartialMap const& pattern, std::size_t ways) {
    ++tried;
    auto instance = instantiate(pattern);
    if (!instance) return;
    if (instance->map.complete()) return consider(instance->map, instance->hooks);
    PartialMap::Mark const mark = instance->map.mark();
    for (std::size_t k = 0; k < ways; ++k) {
      // At first no new darts and only loops, so that small maps come first; later at times room for a second copy.
      Manner const manner = k == 0 ? Manner{100, 0, false} : draw_manner(choices);
      Dart const room = k == 0 ? 0 : choices.percent(30) ? mark.size : static_cast<Dart>(choices.below(2 * k + 2));
      if (k > 0) ++tried;
      if (complete(instance->map, std::min(mark.size + room, std::max(largest(), mark.size)), manner, choices))
        consider(instance->map, instance->hooks);
      instance->map.undo(mark);
    }
  }

  void run() {
    if (rule.hooks.empty()) return consider(PartialMap(rule.model()), {});
    Dart const nodes = left_nodes();
    auto const of_interest = [&](Dart size) { return size * nodes <= largest() || (size == 1 && !refuted()); };
    for (Dart size = 1; size <= exhaustive_size && of_interest(size); ++size) {
      for (PartialMap const& pattern : connected_maps(pattern_model, size, exhaustive_count)) {
        if (tried < budget && of_interest(size)) try_pattern(pattern, 6);
      }
    }
    for (std::size_t last = budget; tried < last;) {
      auto const size = static_cast<Dart>(1 + choices.below(random_size));
      PartialMap pattern(pattern_model);
      pattern.add_dart();
      if (!complete(pattern, size, draw_manner(choices), choices) || !of_interest(pattern.size())) {
        ++tried;
        continue;
      }
      bool const before = refuted();
      try_pattern(pattern, 3);
      if (refuted() && !before) last = std::min(budget, tried + improvements);
    }
  }

  std::optional<Counterexample> counterexample() {
    if (!best) return {};
    // What lies apart from the match has no part in it.
    if (application.apply(best->map, best->hooks) == LiteralApplication::Outcome::no_match)
      throw std::logic_error("a counterexample is lost");
    std::vector<Dart> matched;
    for (ir::NodeId id = 0; id < rule.nodes.size(); ++id) {
      if (!rule.nodes[id].added())
        matched.insert(matched.end(), application.copies()[id].begin(), application.copies()[id].end());
    }
    std::vector<Dart> kept = best->hooks;
    kept.insert(kept.end(), matched.begin(), matched.end());
    PartialMap const map = best->map.components_of(kept);
    std::vector<Dart> const hooks(kept.begin(), kept.begin() + static_cast<std::ptrdiff_t>(best->hooks.size()));
    application.apply(map, hooks);
    Graph after = application.result();
    auto violation = find_violation(after, rule.model());
    if (!violation) throw std::logic_error("a counterexample breaks nothing");
    return Counterexample{map.to_map(), hooks, application.copies(), std::move(after), std::move(*violation)};
  }
};

}  // namespace

Search search_counterexample(ir::RuleScheme const& rule, std::size_t budget) {
  Searching searching{rule, budget};
  searching.run();
  return {searching.counterexample(), searching.applications};
}

std::optional<Counterexample> find_counterexample(ir::RuleScheme const& rule, std::size_t budget) {
  return search_counterexample(rule, budget).counterexample;
}

}  // namespace jrule::analysis
