#include "compiler/backend/cpp/function.h"

#include <fmt/format.h>

#include <algorithm>

#include "compiler/analysis/independence.h"
#include "compiler/backend/cpp/dart_tests.h"
#include "compiler/backend/cpp/text.h"

namespace jrule::cpp {

using Kind = analysis::OrbitComponent::Kind;

namespace {

// The generators of a component's orbits in the pattern, if the application visits these one by one.
std::vector<Word> visited_orbits(analysis::OrbitComponent const& component) {
  if (component.kind != Kind::merge && !component.clause) return {};
  std::vector<Word> generators = component.generators;
  std::sort(generators.begin(), generators.end());
  return generators;
}

}  // namespace

Function::Function(Rule const& accepted, source::Sources const& files, PublicNames public_names, Scope taken)
    : rule(*accepted.scheme),
      plan(*accepted.plan),
      sources(files),
      names(std::move(public_names)),
      independent(rule.hooks.size() == 1 && analysis::analyze_independence(rule, plan).independent()),
      scope(std::move(taken)) {
  // First what the caller sees: it keeps its names, the rest gives way.
  for (ir::NodeId const hook : rule.hooks) hooks.push_back(scope.take(node(hook).name));
  for (ir::Parameter const& p : rule.parameters) parameters.push_back(scope.take(p.name));
  modeler = scope.take(snake_case(names.class_name));
  map = scope.take("map");
  workspace = scope.take("workspace");
  threads = scope.take("threads");
  size = scope.take("n");
  index = scope.take("k");
  for (char const* name :
       {"at", "to", "expected", "u", "added", "matches", "twice", "commit", "orbit", "applied", "trial", "all", "line", "refused", "number",
        "i", "kept", "begin", "end", "type", "from", "compared", "former", "overwritten"})
    locals[name] = scope.take(name);
  locals["listed"] = scope.take("rewrite_" + names.function);
  locals["dense"] = scope.take("rewrite_all_" + names.function);
  for (ir::Let const& let : rule.lets) {
    lets.push_back(scope.take(let.name));
    let_lists.push_back(scope.take("all_" + let.name));
  }
  for (int d = 0; d <= rule.model().dimensions.back(); ++d) {
    arcs.push_back(scope.take(fmt::format("arcs_{}", d)));
    arc_sources.push_back(scope.take(fmt::format("sources_{}", d)));
  }
  for (int const d : rule.model().dimensions) {
    auto const dimension = static_cast<std::uint8_t>(d);
    steps[{dimension, false}] = steps[{dimension, true}] = scope.take(fmt::format("to_{}", d));
    if (rule.model().is_oriented(d)) steps[{dimension, true}] = scope.take(fmt::format("from_{}", d));
  }
  for (ir::Arc const& arc : plan.writes) writes.push_back(&arc);

  for (ir::NodeId const hook : rule.hooks) hook_loops.push_back(scope.take("loops_" + node(hook).name));

  Scope member_names;
  for (std::string const& name : {std::string("copies"), std::string("Copies"), names.result})
    member_names.reserve(name);
  for (ir::Node const& n : rule.nodes) {
    darts.push_back(scope.take((n.added() ? "added_" : "match_") + n.name));
    members.push_back(n.deleted() ? "" : member_names.take(n.name));
  }
  name_columns();

  name_values();
}

void Function::name_values() {
  std::size_t const embedding_count = rule.modeler->embeddings.size();
  adds_values.resize(embedding_count);
  uses_parameter.resize(rule.parameters.size());
  uses_let.resize(rule.lets.size());
  for (EmbeddingSpec const& e : rule.modeler->embeddings) {
    embeddings.push_back(scope.take(e.name));
    values.push_back(scope.take(e.name + "_of"));
    new_values.push_back(scope.take("new_" + e.name));
    dart_handles.push_back(scope.take(e.name + "_handles"));
  }
  for (auto const& component : plan.orbits) {
    std::string const& embedding = spec(component.embedding).name;
    handles.push_back(scope.take(fmt::format("handle_{}_{}", embedding, node(component.members.front().node).name)));
    inherited.emplace_back();
    for (auto const& source : component.sources) {
      inherited.back().push_back(scope.take(fmt::format("handle_{}_{}", embedding, node(source.added).name)));
    }
    if (auto const generators = visited_orbits(component); !generators.empty() && !firsts.contains(generators)) {
      std::string words;
      for (Word const& word : generators) words += "_" + name_part(word);
      std::string const& name = orbits[generators] = scope.take("orbits" + words);
      locals[name + "_columns"] = scope.take(name + "_columns");
      firsts[generators] = scope.take("first" + words);
    }
    if (component.kind == Kind::fresh || component.kind == Kind::assign) {
      adds_values[component.embedding] = true;
      if (component.clause) use(*rule.clauses[*component.clause].value);
    }
  }
  for (ir::Let const& let : rule.lets) use(*let.value);
  for (ir::Requirement const& requirement : rule.requirements) use(*requirement.condition);
}

void Function::name_walk(ir::Darts const& over) {
  std::pair const key(over.orbit, over.by);
  if (walks.contains(key)) return;
  std::string name = "walk";
  for (Word const& word : over.orbit.words) name += "_" + name_part(word);
  if (!over.by.words.empty()) name += "_by";
  for (Word const& word : over.by.words) name += "_" + name_part(word);
  walks[key] = scope.take(name);
  // Of types that take a set.
  locals[walks[key] + "_type"] = scope.take(name + "_type");
  locals[walks[key] + "_parts"] = scope.take(name + "_parts");
}

void Function::use(ir::Expr const& expr) {
  if (auto const* p = std::get_if<ir::ParameterRef>(&expr.value)) uses_parameter[p->index] = true;
  if (auto const* l = std::get_if<ir::LetRef>(&expr.value)) uses_let[l->index] = true;
  if (auto const* d = std::get_if<ir::Darts>(&expr.value)) name_walk(*d);
  if (auto const* c = std::get_if<ir::Collect>(&expr.value)) name_walk(c->over);
  if (auto const* e = std::get_if<ir::ForEach>(&expr.value)) {
    std::string const& name = e->variable.name;
    if (!variables.contains(name)) variables[name] = scope.take(name);
    name_walk(e->over);
  }
  for (ir::ExprPtr const& part : ir::parts(expr)) use(*part);
}

void Function::name_columns() {
  auto const add = [&](Word const& word) {
    if (!word.empty() && !columns.contains(word)) columns[word] = scope.take("at_" + name_part(word));
  };
  for (auto const& hook : plan.further_hooks) {
    for (auto const& loop : hook.loops) add(loop.word);
  }
  for (auto const& step : plan.steps) add(step.word);
  for (auto const& check : plan.checks) add(check.word);
  for (ir::Arc const& arc : plan.writes) add(arc.word);
  for (auto const& component : plan.orbits) {
    if (component.kind == Kind::fresh || component.kind == Kind::assign || analysis::compared_with(rule, component) != nullptr) {
      for (auto const& member : component.members) add(member.path);
    }
    for (Word const& generator : visited_orbits(component)) add(generator);
    for (auto const& source : component.sources) add(source.word);
  }
}

std::string Function::at(Word const& word) const {
  return word.empty() ? index : fmt::format("{}[{}]", columns.at(word), index);
}

std::string Function::place(ir::NodeId id, Word const& word) const {
  if (form != Form::dense) return fmt::format("{}[{}]", darts[id], at(word));
  return node(id).added() ? fmt::format("{} + {}", darts[id], at(word)) : at(word);
}

std::string Function::dart(ir::NodeId id, Word const& word) const {
  std::string const dart = place(id, word);
  return form == Form::dense && node(id).added() ? fmt::format("static_cast<jrule::Dart>({})", dart) : dart;
}

std::string Function::written(ir::NodeId id, Word const& word) const {
  std::string const dart = place(id, word);
  bool const is_dart = form != Form::dense || (!node(id).added() && !word.empty());
  return is_dart ? dart : fmt::format("static_cast<jrule::Dart>({})", dart);
}

std::string Function::walk(std::string const& dart, Word const& word) const {
  std::string at = dart;
  for (Letter const letter : word) at = fmt::format("{}[{}]", steps.at(letter), at);
  return at;
}

std::string Function::orbits_of(analysis::OrbitComponent const& component) const {
  auto const found = orbits.find(visited_orbits(component));
  return found == orbits.end() ? "" : found->second;
}

std::string Function::first(analysis::OrbitComponent const& component) const {
  auto const found = firsts.find(visited_orbits(component));
  return found == firsts.end() ? "" : found->second;
}

bool Function::merges_on_trial(std::size_t embedding) const {
  if (spec(embedding).merge != MergePolicy::function) return false;
  return std::any_of(plan.orbits.begin(), plan.orbits.end(),
                     [&](auto const& c) { return c.embedding == embedding && c.kind == Kind::merge; });
}

bool Function::merges_on_trial() const {
  for (std::size_t e = 0; e < embeddings.size(); ++e) {
    if (merges_on_trial(e)) return true;
  }
  return false;
}

std::string Function::loop() const {
  return fmt::format("for ({0} {1} = 0; {1} < {2}; ++{1})", form == Form::dense ? "jrule::Dart" : "std::size_t", index, size);
}

std::string Function::each(std::string const& statement) const {
  if (!takes_threads()) return loop() + ' ' + statement;
  std::string const dart = form == Form::dense ? "jrule::Dart" : "std::size_t";
  return fmt::format("jrule::parallel::for_each{}({}, {}, [&]({} {}) {{ {} }});", form == Form::dense ? "<jrule::Dart>" : "", size, threads, dart,
                     index, statement);
}

std::string Function::stream() const {
  return fmt::format("for (std::size_t {0} = {1}; {0} < {2}; ++{0})", index, takes_threads() ? local("begin") : "0",
                     takes_threads() ? local("end") : size);
}

bool Function::can_be_dense() const {
  return independent && plan.steps.empty() && !plan.test_injectivity && rule.lets.empty() && !merges_on_trial() &&
         std::all_of(rule.requirements.begin(), rule.requirements.end(),
                     [&](ir::Requirement const& requirement) { return dart_tests(rule, requirement).has_value(); });
}

Function Function::in(Form other) const {
  Function f = *this;
  f.form = other;
  if (other == Form::dense) f.order_writes();
  return f;
}

// Dense columns of one letter are the map's own, which the new arcs overwrite: each is written when nothing reads it any more.
// Where arcs wait for each other in a circle, a column is copied.
void Function::order_writes() {
  Model const& model = rule.model();
  using ColumnOfMap = std::pair<int, bool>;  // dimension; sources?
  auto const key = [&](int d, bool backwards) { return ColumnOfMap(d, backwards && model.is_oriented(d)); };
  auto const reads = [&](ir::Arc const& arc, ColumnOfMap const& column) {
    return is_aliased(arc.word) && key(arc.word.front().dimension, arc.word.front().conjugate) == column;
  };
  auto const overwrites = [&](ir::Arc const& arc) {
    std::vector<ColumnOfMap> all;
    if (!node(arc.source).added()) all.push_back(key(arc.dimension, false));
    if (!node(arc.target).added() && model.is_oriented(arc.dimension)) all.push_back(key(arc.dimension, true));
    return all;
  };
  // An arc reads and writes the targets at one index, but its sources at another one.
  for (ir::Arc const* arc : writes) {
    for (ColumnOfMap const& column : overwrites(*arc)) {
      if (column.second && reads(*arc, column)) copied.insert(arc->word);
    }
  }
  // Values are compared when all arcs are there.
  for (auto const& component : plan.orbits) {
    if (analysis::compared_with(rule, component) == nullptr) continue;
    for (auto const& member : component.members) copied.insert(member.path);
  }
  std::vector<ir::Arc const*> waiting = std::exchange(writes, {});
  while (!waiting.empty()) {
    auto const has_to_wait = [&](ir::Arc const* arc) {
      for (ColumnOfMap const& column : overwrites(*arc)) {
        for (ir::Arc const* other : waiting) {
          if (other != arc && reads(*other, column)) return true;
        }
      }
      return false;
    };
    auto const free = std::find_if(waiting.begin(), waiting.end(), [&](ir::Arc const* arc) { return !has_to_wait(arc); });
    if (free != waiting.end()) {
      writes.push_back(*free);
      waiting.erase(free);
    } else {
      auto const reader = std::find_if(waiting.begin(), waiting.end(), [&](ir::Arc const* arc) { return is_aliased(arc->word); });
      copied.insert((*reader)->word);
    }
  }
}

}  // namespace jrule::cpp
