#include "compiler/backend/interpreter/interpreter.h"

#include <fmt/format.h>

#include <algorithm>
#include <new>
#include <span>
#include <stdexcept>

#include "compiler/backend/interpreter/evaluate.h"
#include "jrule/orbit_walk.h"
#include "jrule/bulk.h"

namespace jrule::interpreter {

using rewrite::Column;
using rewrite::Index;

namespace {

// One application, or several at once. What comes before commit() may fail; commit() cannot.
struct Application {
  ir::RuleScheme const& rule;
  analysis::Plan const& plan;
  Map& map;
  std::vector<Value> const& arguments;
  rewrite::Workspace& workspace;
  Threads threads{};

  std::vector<Dart> pattern{};                  // of all applications
  Column number{};                              // by index in it, which application it is of; empty if there is only one
  std::map<Word, Column> columns{};             // of every word that is used
  std::vector<std::vector<Dart>> match{};       // by node

  // What plan() decides for commit(): of each touched orbit component the representatives and their handles.
  struct StagedOrbits {
    analysis::OrbitComponent const* component;
    Column orbit;                  // by pattern dart: the first of its orbit (fresh, assign, merge)
    std::vector<Handle> handle;    // by pattern dart; inherit: sources one after the other
  };
  std::vector<ir::Evaluated> lets{};             // those of one application after the other
  std::vector<StagedOrbits> staged{};
  std::vector<std::vector<Value>> new_values{};  // by embedding

  // The threads for a loop whose bodies take as long as so many steps of others: shorter loops are worth several.
  Threads each_costs(std::size_t steps) const { return {threads.count, std::max<std::size_t>(1, threads.grain / steps)}; }
  std::string const& name(ir::NodeId id) const { return rule.nodes[id].name; }
  std::size_t size() const { return pattern.size(); }

  Column const& column(Word const& word) {
    auto const known = columns.find(word);
    if (known != columns.end()) return known->second;
    if (word.empty() || !number.empty()) return columns[word] = rewrite::bulk_column(map, pattern, word, workspace, threads);
    return columns[word] = rewrite::column(map, pattern, word, workspace, threads);
  }

  void make_match_columns() {
    for (auto const& step : plan.steps) column(step.word);
    for (auto const& check : plan.checks) column(check.word);
  }

  // Columns need P's marks, which later steps reuse: all of them are made at once.
  void make_columns() {
    column({});
    for (Word const& word : plan.generators) column(word);
    for (auto const& hook : plan.further_hooks) {
      for (auto const& loop : hook.loops) column(loop.word);
    }
    make_match_columns();
    for (ir::Arc const& arc : plan.writes) column(arc.word);
    for (auto const& component : plan.orbits) {
      for (auto const& member : component.members) column(member.path);
      for (Word const& generator : component.generators) column(generator);
      for (auto const& source : component.sources) column(source.word);
    }
  }

  Result<void> find_match(std::vector<Dart> const& hooks) {
    match.resize(rule.nodes.size());
    for (std::size_t h = 0; h < hooks.size(); ++h) {
      if (!map.contains(hooks[h])) return tl::unexpected(rewrite::not_a_dart(rule.name, name(rule.hooks[h]), hooks[h]));
    }
    if (hooks.empty()) {
      pattern = {no_dart};  // a rule that creates has one copy of each node, and no words
      make_columns();
      return {};
    }
    pattern = rewrite::close_pattern(map, hooks[0], plan.generators, workspace);
    make_columns();
    match[rule.hooks[0]] = pattern;
    for (std::size_t h = 1; h < hooks.size(); ++h) {
      std::vector<rewrite::Loop> loops;
      for (auto const& loop : plan.further_hooks[h - 1].loops) loops.push_back({column(loop.word).data(), loop.dimension});
      ir::NodeId const node = rule.hooks[h];
      std::span<Dart const> const walked = rewrite::walk_in_step(map, hooks[h], size(), loops, workspace);
      match[node].assign(walked.begin(), walked.end());
      if (match[node].empty()) return tl::unexpected(rewrite::hook_not_determined(rule.name, name(node)));
    }
    match_other_nodes();
    return check_match();
  }

  void match_other_nodes() {
    for (auto const& step : plan.steps) {
      Column const& w = column(step.word);
      std::vector<Dart> const& from = match[step.from];
      std::vector<Dart>& to = match[step.node];
      to.resize(size());
      parallel::for_each<Index>(size(), threads, [&](Index k) { to[k] = map.step(from[w[k]], step.letter); });
    }
  }

  // Calls `differs` with the index, the dart, where its arc leads and where it should lead.
  template <class Differs>
  void test_arcs(analysis::MatchCheck const& check, Differs differs) {
    Column const& w = column(check.word);
    for (Index k = 0; k < size(); ++k) {
      Dart const at = match[check.source][k], to = map.target(at, check.dimension), expected = match[check.target][w[k]];
      if (to != expected) differs(k, at, to, expected);
    }
  }

  std::vector<std::span<Dart const>> match_columns() const {
    std::vector<std::span<Dart const>> matches;
    for (std::vector<Dart> const& m : match) {
      if (!m.empty()) matches.emplace_back(m);
    }
    return matches;
  }

  Result<void> check_match() {
    for (auto const& check : plan.checks) {
      std::optional<Error> error;
      test_arcs(check, [&](Index, Dart at, Dart to, Dart expected) {
        if (!error) error = rewrite::arc_differs(rule.name, name(check.source), check.dimension, name(check.target), at, to, expected);
      });
      if (error) return tl::unexpected(*error);
    }
    if (!plan.test_injectivity) return {};
    if (auto const twice = rewrite::matched_twice(match_columns(), workspace)) return tl::unexpected(rewrite::matched_twice_error(rule.name, *twice));
    return {};
  }

  // Matches the rule at these orbits of its hook, keeps the applications where it applies, and says how many they are.
  std::size_t find_all_matches(rewrite::Applications all) {
    workspace.begin();
    auto const use_pattern = [&] {
      pattern = all.pattern;
      number = all.number;
      columns.clear();
      rewrite::mark_pattern(map, pattern, workspace, threads);
    };
    use_pattern();
    make_match_columns();
    match.resize(rule.nodes.size());
    match[rule.hooks[0]] = pattern;
    match_other_nodes();

    std::vector<bool> refused(all.count(), false);
    for (auto const& check : plan.checks) {
      test_arcs(check, [&](Index k, Dart, Dart, Dart) { refused[number[k]] = true; });
    }
    if (plan.test_injectivity) rewrite::refuse_matched_twice(all, match_columns(), workspace, refused);
    for (Index a = 0; a < all.count(); ++a) {
      if (!refused[a] && evaluate_at_hooks(all.first[a])) refused[a] = true;
    }
    if (std::find(refused.begin(), refused.end(), true) != refused.end()) {
      for (std::vector<Dart>& m : match) m = rewrite::without(all, refused, m);
      all = rewrite::without(all, refused);
      use_pattern();
    } else {
      rewrite::mark_pattern(map, pattern, workspace, threads);  // again: the test of injectivity marks as well
    }
    make_columns();
    return all.count();
  }

  // What an expression sees that is evaluated at a dart of the a-th application.
  Scene scene(Index a) const {
    std::size_t const count = rule.lets.size();
    return {map, rule, match, arguments, std::span(lets).subspan(a * count, std::min(count, lets.size() - a * count))};
  }

  // Evaluates the lets and requirements of one more application, whose hook is the k-th dart. If a requirement is not met,
  // returns it, and the lets are forgotten.
  ir::Requirement const* evaluate_at_hooks(Index k) {
    std::size_t const before = lets.size();
    Index const a = rule.lets.empty() ? 0 : static_cast<Index>(before / rule.lets.size());
    for (ir::Let const& let : rule.lets) lets.push_back(evaluate(*let.value, scene(a), k));
    for (ir::Requirement const& requirement : rule.requirements) {
      if (std::get<bool>(evaluate_value(*requirement.condition, scene(a), k))) continue;
      lets.resize(before);
      return &requirement;
    }
    return nullptr;
  }

  Result<void> check_requirements() {
    if (ir::Requirement const* const failed = evaluate_at_hooks(0)) return tl::unexpected(requirement_failed(*failed));
    return {};
  }

  Error requirement_failed(ir::Requirement const& requirement) const {
    std::vector<rewrite::HookDart> hooks;
    if (depends_on_place(rule, requirement)) {
      for (ir::NodeId const hook : rule.hooks) hooks.push_back({name(hook), match[hook][0]});
    }
    return rewrite::requirement_failed(rule.name, requirement.text, hooks);
  }

  void evaluate_clauses() {
    new_values.resize(map.embedding_count());
    for (auto const& component : plan.orbits) stage(component);
  }

  void stage(analysis::OrbitComponent const& component) {
    using Kind = analysis::OrbitComponent::Kind;
    Embedding const& embedding = map.embedding(component.embedding);
    StagedOrbits orbits{&component, {}, {}};
    if (component.kind == Kind::inherit) {
      for (auto const& source : component.sources) {
        Column const& w = column(source.word);
        std::vector<Dart> const& from = match[source.preserved];
        std::size_t const base = orbits.handle.size();
        orbits.handle.resize(base + size());
        parallel::for_each(size(), threads, [&](std::size_t k) { orbits.handle[base + k] = embedding.handle(map.walk(from[w[k]], source.tail)); });
      }
    } else {
      std::vector<Index const*> generators;
      for (Word const& g : component.generators) generators.push_back(column(g).data());
      Index const* const orbit =
          rewrite::first_of_orbits(rewrite::PatternOrbits(size(), generators, workspace), size(), workspace);
      orbits.orbit = Column(orbit, orbit + size());
    }
    if (component.kind == Kind::fresh || component.kind == Kind::assign) {
      std::vector<Value>& values = new_values[component.embedding];
      std::size_t const base = embedding.value_count();
      orbits.handle.resize(size());
      if (!component.clause) {
        values.push_back(*embedding.spec().default_value);
        std::fill(orbits.handle.begin(), orbits.handle.end(), static_cast<Handle>(base + values.size() - 1));
      } else {
        // The values in the order of the first darts of their orbits, whoever computes them.
        ir::Expr const& value = *rule.clauses[*component.clause].value;
        std::vector<Index> firsts;
        for (Index k = 0; k < size(); ++k) {
          if (orbits.orbit[k] == k) {
            orbits.handle[k] = static_cast<Handle>(base + values.size() + firsts.size());
            firsts.push_back(k);
          } else {
            orbits.handle[k] = orbits.handle[orbits.orbit[k]];
          }
        }
        std::size_t const before = values.size();
        values.resize(before + firsts.size());
        parallel::for_each(firsts.size(), each_costs(64), [&](std::size_t i) {
          Index const k = firsts[i];
          values[before + i] = evaluate_value(value, scene(number.empty() ? 0 : number[k]), k);
        });
      }
    }
    staged.push_back(std::move(orbits));
  }

  // The last part that may throw; what it changes before it throws cannot be seen.
  std::vector<std::vector<Dart>> reserve() {
    for (std::size_t e = 0; e < map.embedding_count(); ++e) {
      std::size_t merges = 0;
      for (StagedOrbits const& s : staged) {
        if (s.component->embedding != e || s.component->kind != analysis::OrbitComponent::Kind::merge) continue;
        for (Index k = 0; k < size(); ++k) merges += s.orbit[k] == k;
      }
      map.embedding(e).reserve_values(new_values[e].size() + merges);
    }
    map.reserve_erase(plan.deleted.size() * size());
    workspace.reserve(map.dart_limit() + plan.added.size() * size());
    std::vector<std::vector<Dart>> copies(rule.nodes.size());
    for (ir::NodeId id = 0; id < rule.nodes.size(); ++id) {
      if (rule.nodes[id].preserved()) copies[id] = match[id];
      if (rule.nodes[id].added()) copies[id].resize(size());
    }
    std::vector<Dart> const added = map.add_darts(plan.added.size() * size());
    std::size_t next = 0;
    for (ir::NodeId const id : plan.added) {
      for (Dart& d : copies[id]) d = added[next++];
    }
    return copies;
  }

  void commit(std::vector<std::vector<Dart>> const& copies) noexcept {
    for (ir::NodeId const id : plan.deleted) {
      for (Dart const d : match[id]) map.erase(d);
    }
    for (ir::Arc const& arc : plan.writes) {
      Column const& w = columns.find(arc.word)->second;
      std::vector<Dart> const &source = copies[arc.source], &target = copies[arc.target];
      parallel::for_each(size(), threads, [&](std::size_t k) { map.set_target(source[k], arc.dimension, target[w[k]]); });
    }
    for (std::size_t e = 0; e < new_values.size(); ++e) {
      for (Value const& value : new_values[e]) map.embedding(e).add(value);
    }
    std::optional<std::pair<std::size_t, analysis::OrbitComponent::Kind>> group;
    for (StagedOrbits const& s : staged) {
      // One value for each orbit, also where two components meet beyond the pattern: the first gives it.
      auto const key = std::pair(s.component->embedding, s.component->kind);
      if (group != key) workspace.clear_marks();
      group = key;
      commit_values(s, copies);
    }
    rewrite::drop_unused_values(map, workspace, threads);
  }

  void commit_values(StagedOrbits const& s, std::vector<std::vector<Dart>> const& copies) noexcept {
    using Kind = analysis::OrbitComponent::Kind;
    analysis::OrbitComponent const& component = *s.component;
    Embedding& embedding = map.embedding(component.embedding);
    std::vector<Dart> const& root = copies[component.members.front().node];
    switch (component.kind) {
      case Kind::fresh:
        for (auto const& member : component.members) {
          Column const& w = columns.find(member.path)->second;
          for (Index k = 0; k < size(); ++k) embedding.set_handle(copies[member.node][w[k]], s.handle[k]);
        }
        return;
      case Kind::inherit: {
        std::size_t next = 0;
        for (auto const& source : component.sources) {
          for (Dart const d : copies[source.added]) embedding.set_handle(d, s.handle[next++]);
        }
        return;
      }
      case Kind::assign:
        for (Index k = 0; k < size(); ++k) {
          if (s.orbit[k] == k) rewrite::assign_orbit(map, component.embedding, root[k], s.handle[k], workspace);
        }
        return;
      case Kind::merge:
        if (auto const* const to = analysis::compared_with(rule, component)) return compare_and_merge(s, *to, copies);
        for (Index k = 0; k < size(); ++k) {
          if (s.orbit[k] == k) rewrite::merge_orbit(map, component.embedding, root[k], workspace);
        }
        return;
    }
  }

  void compare_and_merge(StagedOrbits const& s, analysis::OrbitComponent::Member const& to, std::vector<std::vector<Dart>> const& copies) noexcept {
    std::size_t const e = s.component->embedding;
    bool const by_first = map.embedding(e).spec().merge == MergePolicy::first;
    Column const& there = columns.find(to.path)->second;
    std::vector<Dart> const& root = copies[s.component->members.front().node];
    for (Index k = 0; k < size(); ++k) {
      Handle const value = map.embedding(e).handle(copies[to.node][there[s.orbit[k]]]);
      for (auto const& member : s.component->members) {
        Dart const other = copies[member.node][columns.find(member.path)->second[k]];
        if (by_first) {
          rewrite::join_orbit(map, e, other, value, workspace);
        } else {
          rewrite::merge_orbit_at(map, e, other, value, root[s.orbit[k]], workspace);
        }
      }
    }
  }
};

// The plan relies on the model's constraints and on the embeddings' policies.
Result<void> check_input(ir::RuleScheme const& rule, Map const& map, std::size_t hooks, std::size_t arguments) {
  if (auto const checked = rewrite::check_modeler(map, rule.model(), rule.modeler->embeddings); !checked) return tl::unexpected(checked.error());
  if (hooks == rule.hooks.size() && arguments == rule.parameters.size()) return {};
  return fail(Error::Kind::bad_input, fmt::format("`{}` takes {} darts and {} values", rule.name, rule.hooks.size(), rule.parameters.size()));
}

// All of an application goes through it, the check of its input too: whatever takes memory.
template <class Apply>
auto or_no_memory(ir::RuleScheme const& rule, Apply const& apply) -> decltype(apply()) {
  try {
    return apply();
  } catch (std::bad_alloc const&) {
    return tl::unexpected(rewrite::no_memory(rule.name));
  } catch (std::length_error const&) {
    return tl::unexpected(rewrite::no_memory(rule.name));
  }
}

}  // namespace

Result<Applied> apply(ir::RuleScheme const& rule, analysis::Plan const& plan, Map& map, std::vector<Dart> const& hooks,
                      std::vector<Value> const& arguments, rewrite::Workspace& workspace) {
  return or_no_memory(rule, [&]() -> Result<Applied> {
    if (auto const checked = check_input(rule, map, hooks.size(), arguments.size()); !checked) return tl::unexpected(checked.error());
    Application application{rule, plan, map, arguments, workspace};
    if (auto const matched = application.find_match(hooks); !matched) return tl::unexpected(matched.error());
    if (auto const met = application.check_requirements(); !met) return tl::unexpected(met.error());
    application.evaluate_clauses();
    Applied applied{application.reserve(), application.size()};
    application.commit(applied.copies);
    return applied;
  });
}

Result<std::size_t> apply_everywhere(ir::RuleScheme const& rule, analysis::Plan const& plan, Map& map,
                                     std::vector<Value> const& arguments, rewrite::Workspace& workspace) {
  return or_no_memory(rule, [&] {
    return rewrite::apply_everywhere(map, rule.hook_orbit(), [&](Dart d) -> Result<void> {
      auto const applied = apply(rule, plan, map, {d}, arguments, workspace);
      if (!applied) return tl::unexpected(applied.error());
      return {};
    });
  });
}

namespace {

// `find` gives the orbits of the hook, of which there is at least one if the map has darts.
template <class Find>
Result<std::size_t> apply_at_once(ir::RuleScheme const& rule, analysis::Plan const& plan, Map& map, std::vector<Value> const& arguments,
                                  rewrite::Workspace& workspace, Threads threads, Find const& find) {
  return or_no_memory(rule, [&]() -> Result<std::size_t> {
    if (auto const checked = check_input(rule, map, 1, arguments.size()); !checked) return tl::unexpected(checked.error());
    if (map.dart_count() == 0) return std::size_t{0};
    rewrite::Applications applications = find(rule.hook_orbit());
    Dart const first_dart = applications.pattern.front();
    Application all{rule, plan, map, arguments, workspace, threads};
    std::size_t const count = all.find_all_matches(std::move(applications));
    if (count == 0) {
      // Why not: what the first orbit alone says.
      Application first{rule, plan, map, arguments, workspace};
      if (auto const matched = first.find_match({first_dart}); !matched) return tl::unexpected(matched.error());
      if (auto const met = first.check_requirements(); !met) return tl::unexpected(met.error());
      throw std::logic_error(fmt::format("`{}` applies at one orbit, but not among all", rule.name));
    }
    all.evaluate_clauses();
    all.commit(all.reserve());
    return count;
  });
}

}  // namespace

Result<std::size_t> apply_all(ir::RuleScheme const& rule, analysis::Plan const& plan, Map& map,
                              std::vector<Value> const& arguments, rewrite::Workspace& workspace, Threads threads) {
  return apply_at_once(rule, plan, map, arguments, workspace, threads,
                       [&](OrbitType const& type) { return rewrite::all_applications(map, type); });
}

Result<std::size_t> apply_all_within(ir::RuleScheme const& rule, analysis::Plan const& plan, Map& map, OrbitType const& within, Dart d,
                                     std::vector<Value> const& arguments, rewrite::Workspace& workspace) {
  return apply_at_once(rule, plan, map, arguments, workspace, Threads{},
                       [&](OrbitType const& type) { return rewrite::applications_within(map, type, within, d); });
}

}  // namespace jrule::interpreter
