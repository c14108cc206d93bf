#include "compiler/backend/interpreter/interpreter.h"

#include <fmt/format.h>

#include <new>
#include <stdexcept>

#include "compiler/backend/interpreter/evaluate.h"

namespace jrule::interpreter {

using rewrite::Column;
using rewrite::Index;

namespace {

// One application. match() and plan() may fail; commit() cannot.
struct Application {
  ir::RuleScheme const& rule;
  analysis::Plan const& plan;
  Map& map;
  std::vector<Value> const& arguments;
  rewrite::Workspace& workspace;

  std::vector<Dart> pattern{};
  std::map<Word, Column> columns{};             // of every word that is used
  std::vector<std::vector<Dart>> match{};       // by node

  // What plan() decides for commit(): of each touched orbit component the representatives and their handles.
  struct StagedOrbits {
    analysis::OrbitComponent const* component;
    Column orbit;                  // by pattern dart: the first of its orbit (fresh, assign, merge)
    std::vector<Handle> handle;    // by pattern dart; inherit: sources one after the other
  };
  std::vector<StagedOrbits> staged{};
  std::vector<std::vector<Value>> new_values{};  // by embedding

  std::string const& name(ir::NodeId id) const { return rule.nodes[id].name; }
  std::size_t size() const { return pattern.size(); }

  Column const& column(Word const& word) {
    auto const known = columns.find(word);
    if (known != columns.end()) return known->second;
    if (!word.empty()) return columns[word] = rewrite::column(map, pattern, word, workspace);
    Column identity(size());
    for (Index k = 0; k < size(); ++k) identity[k] = k;
    return columns[word] = std::move(identity);
  }

  // Columns need P's marks, which later steps reuse: all of them are made at once.
  void make_columns() {
    column({});
    for (Word const& word : plan.generators) column(word);
    for (auto const& hook : plan.further_hooks) {
      for (auto const& loop : hook.loops) column(loop.word);
    }
    for (auto const& step : plan.steps) column(step.word);
    for (auto const& check : plan.checks) column(check.word);
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
      for (auto const& loop : plan.further_hooks[h - 1].loops) loops.push_back({&column(loop.word), loop.dimension});
      ir::NodeId const node = rule.hooks[h];
      match[node] = rewrite::walk_in_step(map, hooks[h], size(), loops);
      if (match[node].empty()) return tl::unexpected(rewrite::hook_not_determined(rule.name, name(node)));
    }
    for (auto const& step : plan.steps) {
      Column const& w = column(step.word);
      std::vector<Dart> const& from = match[step.from];
      std::vector<Dart>& to = match[step.node];
      to.resize(size());
      for (Index k = 0; k < size(); ++k) to[k] = map.step(from[w[k]], step.letter);
    }
    return check_match();
  }

  Result<void> check_match() {
    for (auto const& check : plan.checks) {
      Column const& w = column(check.word);
      for (Index k = 0; k < size(); ++k) {
        Dart const at = match[check.source][k], to = map.target(at, check.dimension), expected = match[check.target][w[k]];
        if (to != expected) {
          return tl::unexpected(rewrite::arc_differs(rule.name, name(check.source), check.dimension, name(check.target), at, to, expected));
        }
      }
    }
    if (!plan.test_injectivity) return {};
    std::vector<std::vector<Dart> const*> matches;
    for (std::vector<Dart> const& m : match) {
      if (!m.empty()) matches.push_back(&m);
    }
    if (auto const twice = rewrite::matched_twice(matches, workspace)) return tl::unexpected(rewrite::matched_twice_error(rule.name, *twice));
    return {};
  }

  Result<void> evaluate_expressions() {
    Scene scene{map, rule, match, arguments, {}};
    for (ir::Let const& let : rule.lets) scene.lets.push_back(evaluate(*let.value, scene, 0));
    for (ir::ExprPtr const& requirement : rule.requirements) {
      if (!std::get<bool>(evaluate_value(*requirement, scene, 0))) {
        return tl::unexpected(rewrite::requirement_failed(rule.name, ir::print(*requirement, rule)));
      }
    }
    new_values.resize(map.embedding_count());
    for (auto const& component : plan.orbits) stage(component, scene);
    return {};
  }

  void stage(analysis::OrbitComponent const& component, Scene const& scene) {
    using Kind = analysis::OrbitComponent::Kind;
    Embedding const& embedding = map.embedding(component.embedding);
    StagedOrbits orbits{&component, {}, {}};
    if (component.kind == Kind::inherit) {
      for (auto const& source : component.sources) {
        Column const& w = column(source.word);
        for (Index k = 0; k < size(); ++k) orbits.handle.push_back(embedding.handle(map.walk(match[source.preserved][w[k]], source.tail)));
      }
    } else {
      std::vector<Column const*> generators;
      for (Word const& g : component.generators) generators.push_back(&column(g));
      orbits.orbit = rewrite::pattern_orbits(size(), generators);
    }
    if (component.kind == Kind::fresh || component.kind == Kind::assign) {
      std::vector<Value>& values = new_values[component.embedding];
      std::size_t const base = embedding.value_count();
      orbits.handle.resize(size());
      if (!component.clause) {
        values.push_back(*embedding.spec().default_value);
        std::fill(orbits.handle.begin(), orbits.handle.end(), static_cast<Handle>(base + values.size() - 1));
      } else {
        ir::Expr const& value = *rule.clauses[*component.clause].value;
        for (Index k = 0; k < size(); ++k) {
          if (orbits.orbit[k] == k) {
            values.push_back(evaluate_value(value, scene, k));
            orbits.handle[k] = static_cast<Handle>(base + values.size() - 1);
          } else {
            orbits.handle[k] = orbits.handle[orbits.orbit[k]];
          }
        }
      }
    }
    staged.push_back(std::move(orbits));
  }

  // The last part that may throw; what it changes before it throws cannot be seen.
  std::vector<std::vector<Dart>> reserve() {
    for (std::size_t e = 0; e < map.embedding_count(); ++e) {
      std::size_t merges = 0;
      for (StagedOrbits const& s : staged) {
        if (s.component->embedding == e && s.component->kind == analysis::OrbitComponent::Kind::merge) merges += size();
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
      for (Index k = 0; k < size(); ++k) map.set_target(copies[arc.source][k], arc.dimension, copies[arc.target][w[k]]);
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
        for (Index k = 0; k < size(); ++k) {
          if (s.orbit[k] == k) rewrite::merge_orbit(map, component.embedding, root[k], workspace);
        }
        return;
    }
  }
};

}  // namespace

Result<Applied> apply(ir::RuleScheme const& rule, analysis::Plan const& plan, Map& map, std::vector<Dart> const& hooks,
                      std::vector<Value> const& arguments, rewrite::Workspace& workspace) {
  // The plan relies on the model's constraints and on the embeddings' policies.
  if (auto const checked = rewrite::check_modeler(map, rule.model(), rule.modeler->embeddings); !checked) return tl::unexpected(checked.error());
  if (hooks.size() != rule.hooks.size() || arguments.size() != rule.parameters.size()) {
    return fail(Error::Kind::bad_input, fmt::format("`{}` takes {} darts and {} values", rule.name, rule.hooks.size(), rule.parameters.size()));
  }
  try {
    Application application{rule, plan, map, arguments, workspace};
    if (auto const matched = application.find_match(hooks); !matched) return tl::unexpected(matched.error());
    if (auto const evaluated = application.evaluate_expressions(); !evaluated) return tl::unexpected(evaluated.error());
    Applied applied{application.reserve(), application.size()};
    application.commit(applied.copies);
    return applied;
  } catch (std::bad_alloc const&) {
    return tl::unexpected(rewrite::no_memory(rule.name));
  } catch (std::length_error const&) {
    return tl::unexpected(rewrite::no_memory(rule.name));
  }
}

Result<std::size_t> apply_everywhere(ir::RuleScheme const& rule, analysis::Plan const& plan, Map& map,
                                     std::vector<Value> const& arguments, rewrite::Workspace& workspace) {
  OrbitType type;
  for (Letter const letter : rule.hook_type) type.words.push_back({letter});
  return rewrite::apply_everywhere(map, type, [&](Dart d) -> Result<void> {
    auto const applied = apply(rule, plan, map, {d}, arguments, workspace);
    if (!applied) return tl::unexpected(applied.error());
    return {};
  });
}

}  // namespace jrule::interpreter
