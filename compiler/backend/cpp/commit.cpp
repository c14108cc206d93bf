#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <optional>

#include "compiler/backend/cpp/sections.h"
#include "compiler/backend/cpp/streams.h"
#include "compiler/backend/cpp/text.h"

namespace jrule::cpp {

using Kind = analysis::OrbitComponent::Kind;

namespace {

// "3 * n"; "n" for 1. If dense, n is a dart.
std::string times(std::size_t count, Function const& f) {
  if (count == 1) return f.size;
  return f.form == Form::dense ? fmt::format("std::size_t{{{}}} * {}", count, f.size) : fmt::format("{} * {}", count, f.size);
}

bool visits_orbits(Function const& f) {
  return std::any_of(f.plan.orbits.begin(), f.plan.orbits.end(), [&](auto const& component) { return is_walked(f, component); });
}

bool overwrites_values(Function const& f) {
  return std::any_of(f.plan.orbits.begin(), f.plan.orbits.end(),
                     [](auto const& component) { return component.kind == Kind::assign || component.kind == Kind::merge; });
}

void write_reserve(Writer& out, Function const& f) {
  for (std::size_t e = 0; e < f.embeddings.size(); ++e) {
    std::size_t merges = 0;
    for (auto const& component : f.plan.orbits) {
      bool const adds = component.kind == Kind::merge && f.spec(e).merge != MergePolicy::first && !f.merges_on_trial(e);
      if (component.embedding == e && adds) ++merges;
    }
    if (merges != 0) out.line("{}.reserve_values({});", f.embeddings[e], times(merges, f));
  }
  if (!f.plan.deleted.empty()) out.line("{}.reserve_erase({});", f.map, times(f.plan.deleted.size(), f));
  if (visits_orbits(f)) {
    out.line("{}.reserve({}.dart_limit(){});", f.workspace, f.map,
             f.plan.added.empty() ? "" : " + " + times(f.plan.added.size(), f));
  }
  if (f.merges_on_trial()) {
    out.line("jrule::rewrite::Trial {}({}, {}, {});", f.local("trial"), f.map, f.workspace, times(f.plan.writes.size(), f));
  }
}

// Of a map whose darts are all matched: the dimensions whose arcs are all written. Oriented ones have two columns, of which one may stay.
std::vector<int> overwritten_dimensions(Function const& f) {
  std::vector<int> dimensions;
  if (f.form != Form::dense || f.plan.added.empty()) return dimensions;
  for (ir::Arc const& arc : f.plan.writes) {
    if (!f.node(arc.source).added() && !f.rule.model().is_oriented(arc.dimension)) dimensions.push_back(arc.dimension);
  }
  std::sort(dimensions.begin(), dimensions.end());
  return dimensions;
}

// The added nodes' darts: those of one node follow on those of the one before.
void write_additions(Writer& out, Function const& f) {
  if (f.plan.added.empty()) return;
  std::string const count = times(f.plan.added.size(), f);
  std::string first;
  if (f.form == Form::dense) {
    auto const overwritten = overwritten_dimensions(f);
    std::string former;
    if (!overwritten.empty()) {
      out.line("jrule::Map::FormerTargets {};", f.local("former"));
      out.line("int const {}[] = {{{}}};", f.local("overwritten"), fmt::join(overwritten, ", "));
      former = fmt::format(", {}, {}", f.local("overwritten"), f.local("former"));
    }
    first = fmt::format("{}.append_darts({}, {}{})", f.map, count, f.threads, former);
  } else if (f.merges_on_trial()) {
    first = fmt::format("{}.add_darts({}).data()", f.local("trial"), count);
  } else {
    first = f.local("added");
    out.line("jrule::Dart* const {} = {}.column({});", first, f.workspace, count);
    out.line("{}.add_darts(std::span({}, {}));", f.map, first, count);
  }
  for (std::size_t i = 0; i < f.plan.added.size(); ++i) {
    std::string const& name = f.darts[f.plan.added[i]];
    std::string const start = i == 0 ? first : fmt::format("{} + {}", f.darts[f.plan.added[i - 1]], f.size);
    out.line("{} const {} = {};", f.form == Form::dense ? "std::size_t" : "jrule::Dart const*", name, start);
  }
}

// On one thread: the indices are given back one after the other.
void write_deletions(Writer& out, Function const& f) {
  for (ir::NodeId const id : f.plan.deleted) {
    out.line("// {}: {} is deleted", place(f.sources, f.node(id).span()), f.node(id).name);
    out.line("{} {}.erase({});", f.loop(), f.map, f.dart(id));
  }
}

// The columns of the map that change, as they lie once darts are added.
void write_views_of_map(Writer& out, Function const& f) {
  Model const& model = f.rule.model();
  for (int const d : model.dimensions) {
    auto const index = static_cast<std::size_t>(d);
    bool const written = std::any_of(f.writes.begin(), f.writes.end(), [&](ir::Arc const* arc) { return arc->dimension == d; });
    if (!written || f.merges_on_trial()) continue;
    out.line("jrule::Dart* const {} = {}.arcs({});", f.arcs[index], f.map, d);
    if (model.is_oriented(d)) out.line("jrule::Dart* const {} = {}.sources_of_arcs({});", f.arc_sources[index], f.map, d);
  }
  for (std::size_t e = 0; e < f.embeddings.size(); ++e) {
    bool const written = std::any_of(f.plan.orbits.begin(), f.plan.orbits.end(), [&](auto const& c) {
      return c.embedding == e && !is_walked(f, c);
    });
    if (written) out.line("jrule::Handle* const {} = {}.handles_of_darts();", f.dart_handles[e], f.embeddings[e]);
  }
}

// The map's own columns have moved if darts were added.
void write_aliases_again(Writer& out, Function const& f) {
  if (f.form != Form::dense || f.plan.added.empty()) return;
  auto const overwritten = overwritten_dimensions(f);
  for (auto const& [word, name] : f.columns) {
    if (!f.is_aliased(word)) continue;
    Letter const letter = word.front();
    bool const is_former = std::binary_search(overwritten.begin(), overwritten.end(), letter.dimension);
    out.line("{} = {}.{}({}{}).data();", name, f.map, letter.conjugate ? "sources" : "targets", letter.dimension,
             is_former ? ", " + f.local("former") : "");
  }
}

void write_arcs_on_trial(Writer& out, Function const& f) {
  for (ir::Arc const* arc : f.writes) {
    out.line("// {}", arc_comment(f, *arc));
    out.line("{} {}.set_target({}, {}, {});", f.loop(), f.local("trial"), f.dart(arc->source), arc->dimension, f.dart(arc->target, arc->word));
  }
}

// Visits each orbit of the pattern once.
std::string if_first(Function const& f, analysis::OrbitComponent const& component) {
  std::string const first = f.first(component);
  return first.empty() ? "" : fmt::format("if ({0}[{1}] == {1}) ", first, f.index);
}

// Those of a component whose members' values are compared with that of one.
void write_comparison(Writer& out, Function const& f, analysis::OrbitComponent const& component, analysis::OrbitComponent::Member const& to) {
  std::string const first = f.first(component), value = f.local("compared");
  std::string const k = first.empty() ? f.index : fmt::format("{}[{}]", first, f.index);
  std::string const at = to.path.empty() ? k : fmt::format("{}[{}]", f.columns.at(to.path), k);
  auto const dart_at = [&](ir::NodeId node, std::string const& index) {
    if (f.form != Form::dense) return fmt::format("{}[{}]", f.darts[node], index);
    return f.node(node).added() ? fmt::format("static_cast<jrule::Dart>({} + {})", f.darts[node], index) : index;
  };
  bool const by_first = f.spec(component.embedding).merge == MergePolicy::first;
  std::string const root = by_first ? "" : dart_at(component.members.front().node, k) + ", ";
  out.open("{} {{", f.loop());
  out.line("jrule::Handle const {} = {}.embedding({}).handle({});", value, f.map, component.embedding, dart_at(to.node, at));
  for (auto const& member : component.members) {
    if (&member == &to && first.empty()) continue;  // its own
    out.line("jrule::rewrite::{}({}, {}, {}, {}, {}{});", by_first ? "join_orbit" : "merge_orbit_at", f.map, component.embedding,
             f.dart(member.node, member.path), value, root, f.workspace);
  }
  out.close();
}

// Those of a component whose orbits are walked.
void write_walk(Writer& out, Function const& f, std::size_t c) {
  auto const& component = f.plan.orbits[c];
  if (auto const* const to = analysis::compared_with(f.rule, component)) return write_comparison(out, f, component, *to);
  bool const assigns = component.kind == Kind::assign;
  out.open("{} {{", f.loop());
  out.line("{}jrule::rewrite::{}_orbit({}, {}, {}, {}{});", if_first(f, component), assigns ? "assign" : "merge", f.map, component.embedding,
           f.dart(component.members.front().node), assigns ? fmt::format("{}[{}], ", f.handles[c], f.index) : "", f.workspace);
  out.close();
}

// What merged orbits get, where functions say it.
void write_trial(Writer& out, Function const& f) {
  std::string const& trial = f.local("trial");
  write_arcs_on_trial(out, f);
  for (std::size_t e = 0; e < f.embeddings.size(); ++e) {
    if (!f.merges_on_trial(e)) continue;
    out.line("// {}", f.spec(e).name);
    out.line("{}.begin_merges({});", trial, e);
    for (auto const kind : {Kind::assign, Kind::merge}) {
      for (auto const& component : f.plan.orbits) {
        if (component.embedding != e || component.kind != kind) continue;
        out.line("{} {}{}.{}({});", f.loop(), if_first(f, component), trial, kind == Kind::assign ? "exclude" : "merge",
                 f.dart(component.members.front().node));
      }
    }
  }
  out.line("{}.keep();", trial);
}

void write_overwritten(Writer& out, Function const& f) {
  for (auto const& component : f.plan.orbits) {
    if (component.kind == Kind::inherit || is_walked(f, component)) continue;
    auto const overwritten = static_cast<std::size_t>(std::count_if(component.members.begin(), component.members.end(),
                                                                    [&](auto const& member) { return !f.node(member.node).added(); }));
    if (overwritten != 0) out.line("{}.count_overwritten({});", f.embeddings[component.embedding], times(overwritten, f));
  }
}

// The others are walked when all arcs are there; one after the other, for two may be parts of one orbit.
void write_walks(Writer& out, Function const& f) {
  std::optional<std::pair<std::size_t, Kind>> group;
  for (std::size_t c = 0; c < f.plan.orbits.size(); ++c) {
    auto const& component = f.plan.orbits[c];
    if (!is_walked(f, component)) continue;
    bool const new_embedding = !group || group->first != component.embedding;
    bool const new_group = group != std::pair(component.embedding, component.kind);
    group = std::pair(component.embedding, component.kind);
    if (new_embedding) out.line("// {}", f.spec(component.embedding).name);
    if (component.kind == Kind::merge && f.merges_on_trial(component.embedding)) {
      if (new_group) out.line("{}.commit_merges({});", f.local("trial"), component.embedding);
      continue;
    }
    // The marks remember which orbits have their value: two components may meet beyond the pattern.
    bool const by_marks = analysis::compared_with(f.rule, component) == nullptr || f.spec(component.embedding).merge != MergePolicy::first;
    if (new_group && by_marks) out.line("{}.clear_marks();", f.workspace);
    write_walk(out, f, c);
  }
}

}  // namespace

void write_result(Writer& out, Function const& f) {
  std::string firsts, copies;
  for (ir::NodeId id = 0; id < f.rule.nodes.size(); ++id) {
    if (f.node(id).deleted()) continue;
    firsts += fmt::format("{}{}[0]", firsts.empty() ? "" : ", ", f.darts[id]);
    copies += fmt::format("{}{{{}, {}}}", copies.empty() ? "" : ", ",
                          f.form == Form::one && !f.node(id).added() && f.node(id).hook ? f.darts[id] + ".data()" : f.darts[id], f.size);
  }
  out.line();
  if (firsts.empty() || f.rule.hooks.empty()) {
    out.line("return {}{{{}}};", f.names.result, firsts);
  } else {
    out.line("return {}{{{},", f.names.result, firsts);
    out.line("{:{}}{{{}}}}};", "", f.names.result.size() + 8, copies);
  }
}

void write_commit(Writer& out, Function const& f) {
  bool const changes =
      !f.plan.deleted.empty() || !f.plan.added.empty() || !f.plan.writes.empty() || !f.plan.orbits.empty();
  if (!changes) return;
  out.line();
  out.line("// ---- Room for all of it{} ----", f.merges_on_trial() ? "" : ": the last part that may fail");
  out.line();
  write_reserve(out, f);
  write_additions(out, f);
  out.line();
  if (f.merges_on_trial()) {
    out.line("// ---- Trial: the new arcs, for merging values; if a function throws, all of it is undone ----");
    out.line();
    write_trial(out, f);
    out.line();
  }
  out.line("// ---- Commit ----");
  out.line();
  write_views_of_map(out, f);
  write_aliases_again(out, f);
  out.open("auto const {} = [&]() noexcept {{", f.local("commit"));
  for (std::size_t e = 0; e < f.embeddings.size(); ++e) {
    if (f.adds_values[e]) out.line("{}.keep();", f.new_values[e]);
  }
  // Where darts are erased, columns that are the map's own are read before.
  if (f.form != Form::dense) write_deletions(out, f);
  write_streams(out, f);
  if (f.form == Form::dense) write_deletions(out, f);
  write_overwritten(out, f);
  write_walks(out, f);
  out.close("};");
  out.line("{}();", f.local("commit"));
  // Darts that are added had no values, so without a hook there is nothing to drop.
  bool const drops = !f.plan.deleted.empty() || overwrites_values(f);
  if (drops && !f.rule.hooks.empty() && !f.embeddings.empty()) {
    out.line("jrule::rewrite::drop_unused_values({}, {}{});", f.map, f.workspace, f.takes_threads() ? ", " + f.threads : "");
  }
}

}  // namespace jrule::cpp
