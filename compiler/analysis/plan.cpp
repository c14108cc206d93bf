#include "compiler/analysis/plan.h"

#include <algorithm>

#include "compiler/algebra/group.h"
#include "compiler/analysis/placement.h"

namespace jrule::analysis {

namespace {

struct Planner {
  ir::RuleScheme const& rule;
  algebra::Group group{rule.model()};
  Plan plan{};
  std::vector<bool> placed = std::vector<bool>(rule.nodes.size(), false);
  std::vector<bool> used = std::vector<bool>(rule.left.arcs.size(), false);  // left arcs that place a node

  void add_generator(Word const& word) {
    if (word.empty()) return;
    Word const inverse = group.inverse(word);
    for (Word const& known : plan.generators) {
      if (known == word || known == inverse) return;
    }
    plan.generators.push_back(word);
  }

  void place_hooks() {
    for (ir::NodeId const hook : rule.hooks) placed[hook] = true;
    for (std::size_t h = 1; h < rule.hooks.size(); ++h) {
      FurtherHook further{rule.hooks[h], {}};
      for (ir::Arc const& arc : rule.left.arcs) {
        if (arc.source == further.node && arc.target == further.node && !arc.word.empty()) further.loops.push_back({arc.word, arc.dimension});
      }
      plan.further_hooks.push_back(std::move(further));
    }
  }

  void place_nodes() {
    bool changed = true;
    while (changed) {
      changed = false;
      for (std::size_t i = 0; i < rule.left.arcs.size(); ++i) {
        ir::Arc const& arc = rule.left.arcs[i];
        auto const d = static_cast<std::uint8_t>(arc.dimension);
        if (placed[arc.source] && !placed[arc.target]) {
          // m(u·w, t) = m(u, s)·d, so m(u, t) = m(u·w̄, s)·d.
          plan.steps.push_back({arc.target, arc.source, group.inverse(arc.word), {d, false}});
        } else if (!placed[arc.source] && placed[arc.target]) {
          plan.steps.push_back({arc.source, arc.target, arc.word, {d, rule.model().is_oriented(arc.dimension)}});
        } else {
          continue;
        }
        placed[arc.source] = placed[arc.target] = used[i] = changed = true;
      }
    }
  }

  void collect_checks() {
    Placement const placement(rule, group);
    for (std::size_t i = 0; i < rule.left.arcs.size(); ++i) {
      ir::Arc const& arc = rule.left.arcs[i];
      if (used[i] || placement.holds_everywhere(arc)) continue;
      // Of a non-oriented pair one direction says it all.
      bool const reversed = std::any_of(plan.checks.begin(), plan.checks.end(), [&](MatchCheck const& c) {
        return !rule.model().is_oriented(arc.dimension) && c.source == arc.target && c.target == arc.source && c.dimension == arc.dimension &&
               c.word == group.inverse(arc.word);
      });
      if (!reversed) plan.checks.push_back({arc.source, arc.dimension, arc.word, arc.target, arc.span});
    }
  }

  Plan run() {
    for (Letter const letter : rule.hook_type) add_generator({letter});
    for (ir::Side const* side : {&rule.left, &rule.right}) {
      for (ir::Arc const& arc : side->arcs) add_generator(arc.word);
    }
    place_hooks();
    place_nodes();
    collect_checks();
    std::size_t left_nodes = 0;
    for (ir::NodeId id = 0; id < rule.nodes.size(); ++id) {
      if (!rule.nodes[id].added()) ++left_nodes;
      if (rule.nodes[id].added()) plan.added.push_back(id);
      if (rule.nodes[id].deleted()) plan.deleted.push_back(id);
    }
    plan.test_injectivity = left_nodes > 1;
    for (ir::Arc const& arc : rule.right.arcs) {
      if (!ir::find_same(rule.left, arc)) plan.writes.push_back(arc);
    }
    return std::move(plan);
  }
};

}  // namespace

OrbitComponent::Member const* compared_with(ir::RuleScheme const& rule, OrbitComponent const& component) {
  EmbeddingSpec const& spec = rule.modeler->embeddings[component.embedding];
  auto const is_letter = [](Word const& word) { return word.size() == 1; };
  if (component.kind != OrbitComponent::Kind::merge || spec.merge == MergePolicy::function) return nullptr;
  if (!std::all_of(spec.orbit.words.begin(), spec.orbit.words.end(), is_letter)) return nullptr;
  OrbitComponent::Member const* first = nullptr;
  for (auto const& member : component.members) {
    if (!rule.nodes[member.node].added() && (first == nullptr || member.node < first->node)) first = &member;
  }
  return first;
}

Plan plan_application(ir::RuleScheme const& rule) { return Planner{rule}.run(); }

}  // namespace jrule::analysis
