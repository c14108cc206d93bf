#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "compiler/backend/cpp/sections.h"
#include "compiler/backend/cpp/text.h"

namespace jrule::cpp {

using Kind = analysis::OrbitComponent::Kind;

namespace {

// "3 * n"; "n" for 1. If dense, n is a dart.
std::string times(std::size_t count, Function const& f) {
  if (count == 1) return f.size;
  return f.form == Form::dense ? fmt::format("std::size_t{{{}}} * {}", count, f.size) : fmt::format("{} * {}", count, f.size);
}

// Do all arcs of the component's orbits lie on the right side? Then the orbits are its members, and reach nothing else.
bool is_closed(Function const& f, analysis::OrbitComponent const& component) {
  ir::Table const table(f.rule.nodes.size(), f.rule.right);
  for (auto const& member : component.members) {
    for (Word const& word : f.spec(component.embedding).orbit.words) {
      ir::NodeId at = member.node;
      for (Letter const letter : word) {
        ir::Arc const* const arc = letter.conjugate ? table.in(at, letter.dimension) : table.out(at, letter.dimension);
        if (arc == nullptr) return false;
        at = letter.conjugate ? arc->source : arc->target;
      }
    }
  }
  return true;
}

// Has the application to walk its orbits, to find which darts get the value?
bool is_walked(Function const& f, analysis::OrbitComponent const& component) {
  return component.kind == Kind::merge || (component.kind == Kind::assign && !is_closed(f, component));
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
      if (component.embedding == e && component.kind == Kind::merge && !f.merges_on_trial(e)) ++merges;
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

// The added nodes' darts: those of one node follow on those of the one before.
void write_additions(Writer& out, Function const& f) {
  if (f.plan.added.empty()) return;
  std::string const count = times(f.plan.added.size(), f);
  std::string first;
  if (f.form == Form::dense) {
    first = fmt::format("{}.append_darts({})", f.map, count);
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
  for (auto const& [word, name] : f.columns) {
    if (!f.is_aliased(word)) continue;
    out.line("{} = {}.{}({}).data();", name, f.map, word.front().conjugate ? "sources" : "targets", word.front().dimension);
  }
}

void write_arcs(Writer& out, Function const& f) {
  for (ir::Arc const* arc : f.writes) {
    out.line("// {}: {}", place(f.sources, arc->span), arc_text(f.rule, arc->source, arc->dimension, arc->word, arc->target));
    auto const d = static_cast<std::size_t>(arc->dimension);
    if (f.merges_on_trial()) {
      out.line("{} {}.set_target({}, {}, {});", f.loop(), f.local("trial"), f.dart(arc->source), arc->dimension,
               f.dart(arc->target, arc->word));
    } else if (!f.rule.model().is_oriented(arc->dimension)) {
      out.line("{} {}[{}] = {};", f.stream(), f.arcs[d], f.place(arc->source), f.written(arc->target, arc->word));
    } else {
      out.open("{} {{", f.stream());
      out.line("std::size_t const {} = {}, {} = {};", f.local("at"), f.place(arc->source), f.local("to"), f.place(arc->target, arc->word));
      out.line("{}[{}] = static_cast<jrule::Dart>({});", f.arcs[d], f.local("at"), f.local("to"));
      out.line("{}[{}] = static_cast<jrule::Dart>({});", f.arc_sources[d], f.local("to"), f.local("at"));
      out.close();
    }
  }
}

// Visits each orbit of the pattern once.
std::string if_first(Function const& f, analysis::OrbitComponent const& component) {
  std::string const first = f.first(component);
  return first.empty() ? "" : fmt::format("if ({0}[{1}] == {1}) ", first, f.index);
}

// The handles of one component's darts.
void write_handles(Writer& out, Function const& f, std::size_t c) {
  auto const& component = f.plan.orbits[c];
  std::string const handle =
      component.kind == Kind::fresh && !component.clause ? f.handles[c] : fmt::format("{}[{}]", f.handles[c], f.index);
  if (component.kind == Kind::inherit) {
    for (std::size_t i = 0; i < component.sources.size(); ++i) {
      auto const& source = component.sources[i];
      // Matched darts still have their handles; where a walk led from them, it led before the arcs changed.
      std::string const value = source.tail.empty()
                                    ? fmt::format("{}[{}]", f.dart_handles[component.embedding], f.place(source.preserved, source.word))
                                    : fmt::format("{}[{}]", f.inherited[c][i], f.index);
      out.line("{} {}[{}] = {};", f.stream(), f.dart_handles[component.embedding], f.place(source.added), value);
    }
  } else if (is_walked(f, component)) {
    std::string const value = component.kind == Kind::assign ? handle + ", " : "";
    out.open("{} {{", f.loop());
    out.line("{}jrule::rewrite::{}_orbit({}, {}, {}, {}{});", if_first(f, component),
             component.kind == Kind::assign ? "assign" : "merge", f.map, component.embedding, f.dart(component.members.front().node), value,
             f.workspace);
    out.close();
  } else {
    std::size_t overwritten = 0;
    for (auto const& member : component.members) {
      if (!f.node(member.node).added()) ++overwritten;
      out.line("{} {}[{}] = {};", f.stream(), f.dart_handles[component.embedding], f.place(member.node, member.path), handle);
    }
    if (overwritten != 0) out.line("{}.count_overwritten({});", f.embeddings[component.embedding], times(overwritten, f));
  }
}

// What merged orbits get, where functions say it.
void write_trial(Writer& out, Function const& f) {
  std::string const& trial = f.local("trial");
  write_arcs(out, f);
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

// Orbits whose darts are known are written in columns; others are walked when all arcs are there.
void write_embeddings(Writer& out, Function const& f, bool walked) {
  std::optional<std::pair<std::size_t, Kind>> group;
  for (std::size_t c = 0; c < f.plan.orbits.size(); ++c) {
    auto const& component = f.plan.orbits[c];
    if (walked != is_walked(f, component)) continue;
    bool const new_embedding = !group || group->first != component.embedding;
    bool const new_group = group != std::pair(component.embedding, component.kind);
    group = std::pair(component.embedding, component.kind);
    if (new_embedding) out.line("// {}", f.spec(component.embedding).name);
    if (component.kind == Kind::merge && f.merges_on_trial(component.embedding)) {
      if (new_group) out.line("{}.commit_merges({});", f.local("trial"), component.embedding);
      continue;
    }
    // The marks remember which orbits have their value: two components may meet beyond the pattern.
    if (new_group && walked) out.line("{}.clear_marks();", f.workspace);
    write_handles(out, f, c);
  }
}

// Darts that no handle is written to: their embedding is walked.
void write_missing_handles(Writer& out, Function const& f) {
  if (f.form != Form::dense || f.plan.added.empty()) return;
  for (std::size_t e = 0; e < f.embeddings.size(); ++e) {
    std::vector<ir::NodeId> missing = f.plan.added;
    for (auto const& component : f.plan.orbits) {
      if (component.embedding != e) continue;
      std::erase_if(missing, [&](ir::NodeId id) {
        if (component.kind != Kind::inherit && !is_walked(f, component)) {
          return std::any_of(component.members.begin(), component.members.end(), [&](auto const& m) { return m.node == id; });
        }
        return component.kind == Kind::inherit &&
               std::any_of(component.sources.begin(), component.sources.end(), [&](auto const& s) { return s.added == id; });
      });
    }
    for (ir::NodeId const id : missing) {
      out.line("{} {}.embedding({}).handles_of_darts()[{}] = jrule::no_handle;", f.loop(), f.map, e, f.dart(id));
    }
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
  if (f.form == Form::dense) {
    // Before the arcs: columns that are the map's own are still what they were.
    write_missing_handles(out, f);
    write_embeddings(out, f, false);
    write_arcs(out, f);
    write_deletions(out, f);
  } else {
    write_deletions(out, f);
    if (!f.merges_on_trial()) write_arcs(out, f);
    write_embeddings(out, f, false);
  }
  write_embeddings(out, f, true);
  out.close("};");
  out.line("{}();", f.local("commit"));
  // Darts that are added had no values, so without a hook there is nothing to drop.
  bool const drops = !f.plan.deleted.empty() || overwrites_values(f);
  if (drops && !f.rule.hooks.empty() && !f.embeddings.empty()) {
    out.line("jrule::rewrite::drop_unused_values({}, {});", f.map, f.workspace);
  }
}

}  // namespace jrule::cpp
