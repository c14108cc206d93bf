// Two applications, at the orbits P and Q of the hook, both found in the map before.
//
// Where they meet. A dart d that both match is m(u, s) = u·x_s = m(v, t) = v·x_t, with u in P and v in Q. If s = t then u = v,
// which is in both orbits: so s and t differ, and the hook's own darts are never shared under its name. A rule whose left side
// is the hook alone disturbs no other application's match.
//
// What must not be shared. The applications are parallel independent (Ehrig et al., "Fundamentals of algebraic graph
// transformation", Def. 3.15) if whatever both match, both preserve: no shared dart is deleted, and no arc that both match
// is removed. Then each match is still one after the other application, its pattern and all implied arcs included, and either
// order gives the map that both together give; by soundness of the rule it is a map of the model. A new arc starts at a
// new dart, or at a preserved one whose arc of that dimension was matched and removed: two new arcs clash only where two
// removed ones are the same.
//
// Values. An orbit of the result is joined from orbits of the map before by components of right nodes (embeddings.h), each of
// one application; if none of those is a merge, all of them had one value. A clause gives its whole orbit a value, so that
// orbit must lie in the copies of its own application.
#include "compiler/analysis/independence.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <queue>

#include "compiler/analysis/pattern.h"
#include "compiler/analysis/wording.h"

namespace jrule::analysis {

namespace {

struct Analysis : Pattern {
  Analysis(ir::RuleScheme const& its_rule, Plan const& its_plan) : Pattern(its_rule), plan(its_plan) {}

  Plan const& plan;
  ir::Table const left{rule.nodes.size(), completed.rule.left};
  ir::Table const right{rule.nodes.size(), completed.rule.right};
  std::vector<Dependence> reasons{};

  std::string const& name(ir::NodeId id) const { return rule.nodes[id].name; }
  EmbeddingSpec const& spec(std::size_t e) const { return rule.modeler->embeddings[e]; }
  bool is_removed(ir::Arc const* arc) const { return arc && !ir::find_same(completed.rule.right, *arc); }
  ir::Arc const* arc_at(ir::NodeId node, int d, bool out) const { return out ? left.out(node, d) : left.in(node, d); }
  bool changes(ir::NodeId node, int d) const { return is_removed(left.out(node, d)) || is_removed(left.in(node, d)); }

  // P is closed under all words of the rule; it must be no more than one orbit of the hook.
  void check_pattern() {
    for (Word const& word : plan.generators) {
      if (group.in_orbit(word, hook_orbit)) continue;
      source::Span span = rule.nodes[rule.hooks[0]].span();
      for (ir::Side const* side : {&rule.left, &rule.right}) {
        for (ir::Arc const& arc : side->arcs) {
          if (arc.word == word || arc.word == group.inverse(word)) span = arc.span;
        }
      }
      reasons.push_back({.kind = Dependence::Kind::pattern, .span = span,
                         .text = fmt::format("{} may lead from one {} to another, so that applications at both have the same pattern", describe(word),
                                             orbit_name(rule.model(), hook_orbit))});
    }
  }

  // May a dart be m(u, s) of one application and m(v, t) of another? If so, its neighbours along arcs that both match are of
  // both as well: (u·α, s') and (v·β, t'). It is impossible if so s' = t' comes out, or one copy that would be two.
  bool may_share(ir::NodeId s, ir::NodeId t) const {
    if (group.in_orbit(group.product(*placement.offset(s), group.inverse(*placement.offset(t))), hook_orbit)) return false;
    using Copy = std::pair<ir::NodeId, Word>;
    constexpr std::size_t most = 64;  // patterns are infinite in general; a contradiction shows within a few steps
    std::map<Copy, Copy> seen, seen_back;
    std::queue<std::pair<Copy, Copy>> open;
    auto const add = [&](Copy const& a, Copy const& b) {
      auto const [known, is_new] = seen.emplace(a, b);
      auto const [known_back, is_new_back] = seen_back.emplace(b, a);
      if (is_new && is_new_back) open.emplace(a, b);
      return a.first != b.first && known->second.first == b.first && known_back->second.first == a.first;
    };
    if (!add({s, {}}, {t, {}})) return false;
    while (!open.empty() && seen.size() < most) {
      auto const [a, b] = open.front();
      open.pop();
      for (int const d : rule.model().dimensions) {
        for (bool const out : {true, false}) {
          ir::Arc const *const from_a = arc_at(a.first, d, out), *const from_b = arc_at(b.first, d, out);
          if (!from_a || !from_b) continue;
          auto const next = [&](Copy const& copy, ir::Arc const& arc) -> Copy {
            return {out ? arc.target : arc.source, group.product(copy.second, out ? arc.word : group.inverse(arc.word))};
          };
          if (!add(next(a, *from_a), next(b, *from_b))) return false;
        }
      }
    }
    return true;
  }

  bool has_component(ir::NodeId node, std::size_t embedding, OrbitComponent::Kind kind) const {
    return std::any_of(plan.orbits.begin(), plan.orbits.end(), [&](OrbitComponent const& c) {
      return c.embedding == embedding && c.kind == kind &&
             std::any_of(c.members.begin(), c.members.end(), [&](auto const& m) { return m.node == node; });
    });
  }

  // What is wrong with a dart that is `s` of one application and `t` of another; none if nothing is.
  std::optional<Dependence> conflict(ir::NodeId s, ir::NodeId t) const {
    Dependence found{.first = s, .second = t, .span = rule.nodes[t].span()};
    std::string const shared = fmt::format("a dart may be `{}` of one application and `{}` of another", name(s), name(t));
    for (ir::NodeId const node : {s, t}) {
      if (!rule.nodes[node].deleted()) continue;
      found.kind = Dependence::Kind::deletion;
      found.text = fmt::format("{}, and `{}` is deleted", shared, name(node));
      return found;
    }
    for (int const d : rule.model().dimensions) {
      for (bool const out : {true, false}) {
        ir::Arc const *const of_s = arc_at(s, d, out), *const of_t = arc_at(t, d, out);
        if (!of_s || !of_t || (!is_removed(of_s) && !is_removed(of_t))) continue;
        found.kind = Dependence::Kind::arc;
        found.dimension = d;
        found.span = is_removed(of_s) ? of_s->span : of_t->span;
        found.text = is_removed(of_s) && is_removed(of_t)
                         ? fmt::format("{}, and both remove its {}-arc", shared, d)
                         : fmt::format("{}: both match its {}-arc, and that of `{}` is removed", shared, d, name(is_removed(of_s) ? s : t));
        return found;
      }
    }
    for (std::size_t e = 0; e < rule.modeler->embeddings.size(); ++e) {
      found.embedding = e;
      std::string const orbit = orbit_name(rule.model(), spec(e).orbit);
      auto const gives = [&](ir::NodeId node) { return has_component(node, e, OrbitComponent::Kind::assign); };
      auto const merges = [&](ir::NodeId node) { return has_component(node, e, OrbitComponent::Kind::merge); };
      if ((gives(s) && (gives(t) || merges(t))) || (gives(t) && merges(s))) {
        found.kind = Dependence::Kind::value;
        found.text = gives(s) && gives(t) ? fmt::format("{}, and both give its {} a value of `{}`", shared, orbit, spec(e).name)
                                          : fmt::format("{}: one gives its {} a value of `{}`, the other merges it with others", shared, orbit, spec(e).name);
        return found;
      }
      for (Word const& word : spec(e).orbit.words) {
        for (std::size_t k = 1; k < word.size(); ++k) {
          int const i = word[k - 1].dimension, j = word[k].dimension;
          if (!(changes(s, i) && changes(t, j)) && !(changes(s, j) && changes(t, i))) continue;
          found.kind = Dependence::Kind::path;
          found.text = fmt::format("{}: one changes its {}-arc, the other its {}-arc, and the {} of `{}` goes along both in one step", shared, i, j, orbit,
                                   spec(e).name);
          return found;
        }
      }
    }
    return {};
  }

  void check_shared_darts() {
    for (ir::NodeId s = 0; s < rule.nodes.size(); ++s) {
      for (ir::NodeId t = s + 1; t < rule.nodes.size(); ++t) {
        if (rule.nodes[s].added() || rule.nodes[t].added()) continue;
        if (auto found = conflict(s, t); found && may_share(s, t)) reasons.push_back(std::move(*found));
      }
    }
  }

  // The orbits that clauses give values to are made of copies of one application if every step from them is along arcs of the
  // right side: the words act on them as permutations, so there is no way in from outside either.
  void check_clauses() {
    for (OrbitComponent const& component : plan.orbits) {
      if (component.kind != OrbitComponent::Kind::assign) continue;
      auto const exit = find_exit(component);
      if (!exit) continue;
      std::string const orbit = orbit_name(rule.model(), spec(component.embedding).orbit);
      reasons.push_back({.kind = Dependence::Kind::value, .first = exit->first, .dimension = exit->second, .embedding = component.embedding,
                         .span = rule.clauses[component.clause.value()].span,
                         .text = fmt::format("the {} of `{}` may reach other applications, which give it a value of `{}` too: the rule does not match the {}-arcs of `{}`",
                                             orbit, name(component.members.front().node), spec(component.embedding).name, exit->second, name(exit->first))});
    }
  }

  // Where the orbit leaves the matched part.
  std::optional<std::pair<ir::NodeId, int>> find_exit(OrbitComponent const& component) const {
    for (auto const& member : component.members) {
      for (Word const& word : spec(component.embedding).orbit.words) {
        ir::NodeId at = member.node;
        for (Letter const letter : word) {
          ir::Arc const* const arc = letter.conjugate ? right.in(at, letter.dimension) : right.out(at, letter.dimension);
          if (!arc) return std::pair(at, int{letter.dimension});
          at = letter.conjugate ? arc->source : arc->target;
        }
      }
    }
    return {};
  }

  // A step of three letters or more may begin with a new arc of one application and end with one of another, though no dart is shared.
  void check_long_words() {
    auto const is_changed = [&](int d) {
      for (ir::NodeId id = 0; id < rule.nodes.size(); ++id) {
        if (rule.nodes[id].preserved() && changes(id, d)) return true;
      }
      return false;
    };
    for (std::size_t e = 0; e < rule.modeler->embeddings.size(); ++e) {
      for (Word const& word : spec(e).orbit.words) {
        for (std::size_t j = 2; j < word.size(); ++j) {
          bool const after_other = std::any_of(word.begin(), word.begin() + static_cast<std::ptrdiff_t>(j - 1),
                                               [&](Letter const letter) { return is_changed(letter.dimension); });
          if (!after_other || !is_changed(word[j].dimension)) continue;
          reasons.push_back({.kind = Dependence::Kind::path, .embedding = e, .span = rule.span,
                             .text = fmt::format("one step along {} of the {} of `{}` may use new arcs of several applications", describe(word),
                                                 orbit_name(rule.model(), spec(e).orbit), spec(e).name)});
          return;
        }
      }
    }
  }
};

}  // namespace

Independence analyze_independence(ir::RuleScheme const& rule, Plan const& plan) {
  if (rule.hooks.empty()) {
    return {{{.kind = Dependence::Kind::hooks, .span = rule.span, .text = fmt::format("`{}` has no hook: there are no orbits to apply it at", rule.name)}}};
  }
  if (rule.hooks.size() > 1) {
    return {{{.kind = Dependence::Kind::hooks, .first = rule.hooks[0], .second = rule.hooks[1], .span = rule.nodes[rule.hooks[1]].span(),
              .text = fmt::format("`{}` has {} hooks: it is applied at darts that are chosen together, not at each orbit", rule.name, rule.hooks.size())}}};
  }
  Analysis analysis(rule, plan);
  if (analysis.fills_components()) return {};  // components share nothing
  analysis.check_pattern();
  analysis.check_shared_darts();
  analysis.check_clauses();
  analysis.check_long_words();
  return {std::move(analysis.reasons)};
}

}  // namespace jrule::analysis
