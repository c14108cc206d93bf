#include <fmt/format.h>

#include <optional>

#include "compiler/backend/cpp/sections.h"
#include "compiler/backend/cpp/text.h"

namespace jrule::cpp {

using Kind = analysis::OrbitComponent::Kind;

namespace {

// "3 * n"; "n" for 1.
std::string times(std::size_t count, std::string const& size) {
  return count == 1 ? size : fmt::format("{} * {}", count, size);
}

bool visits_orbits(Function const& f) {
  for (auto const& component : f.plan.orbits) {
    if (component.kind == Kind::assign || component.kind == Kind::merge) return true;
  }
  return false;
}

void write_reserve(Writer& out, Function const& f) {
  for (std::size_t e = 0; e < f.embeddings.size(); ++e) {
    std::size_t merges = 0;
    for (auto const& component : f.plan.orbits) {
      if (component.embedding == e && component.kind == Kind::merge && !f.merges_on_trial(e)) ++merges;
    }
    std::string const more = merges == 0 ? "" : times(merges, f.size);
    if (f.adds_values[e]) {
      out.line("{}.reserve({});", f.new_values[e], more);
    } else if (merges != 0) {
      out.line("{}.reserve_values({});", f.embeddings[e], more);
    }
  }
  if (!f.plan.deleted.empty()) out.line("{}.reserve_erase({});", f.map, times(f.plan.deleted.size(), f.size));
  if (visits_orbits(f)) {
    out.line("{}.reserve({}.dart_limit(){});", f.workspace, f.map,
             f.plan.added.empty() ? "" : " + " + times(f.plan.added.size(), f.size));
  }
  std::string darts = f.map;
  if (f.merges_on_trial()) {
    darts = f.local("trial");
    out.line("jrule::rewrite::Trial {}({}, {}, {});", darts, f.map, f.workspace, times(f.plan.writes.size(), f.size));
  }
  if (f.plan.added.empty()) return;
  std::string columns;
  for (ir::NodeId const id : f.plan.added)
    columns += fmt::format("{}{}({})", columns.empty() ? "" : ", ", f.darts[id], f.size);
  out.line("std::vector<jrule::Dart> {};", columns);
  out.line("{} const {} = {}.add_darts({});", f.merges_on_trial() ? "std::span<jrule::Dart const>" : "std::vector<jrule::Dart>",
           f.local("added"), darts, times(f.plan.added.size(), f.size));
  out.open("{} {{", f.loop());
  for (std::size_t i = 0; i < f.plan.added.size(); ++i) {
    out.line("{} = {}[{}{}];", f.dart(f.plan.added[i]), f.local("added"), i == 0 ? "" : times(i, f.size) + " + ",
             f.index);
  }
  out.close();
}

void write_deletions(Writer& out, Function const& f) {
  for (ir::NodeId const id : f.plan.deleted) {
    out.line("// {}: {} is deleted", place(f.sources, f.node(id).span()), f.node(id).name);
    out.line("{} {}.erase({});", f.loop(), f.map, f.dart(id));
  }
}

// `to`: the map, or the trial.
void write_arcs(Writer& out, Function const& f, std::string const& to) {
  for (ir::Arc const& arc : f.plan.writes) {
    out.line("// {}: {}", place(f.sources, arc.span),
             arc_text(f.rule, arc.source, arc.dimension, arc.word, arc.target));
    out.line("{} {}.set_target({}, {}, {});", f.loop(), to, f.dart(arc.source), arc.dimension,
             f.dart(arc.target, arc.word));
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
  std::string const& embedding = f.embeddings[component.embedding];
  std::string const handle =
      component.kind == Kind::fresh && !component.clause ? f.handles[c] : fmt::format("{}[{}]", f.handles[c], f.index);
  ir::NodeId const root = component.members.front().node;
  switch (component.kind) {
    case Kind::fresh:
      for (auto const& member : component.members) {
        out.line("{} {}.set_handle({}, {});", f.loop(), embedding, f.dart(member.node, member.path), handle);
      }
      return;
    case Kind::inherit:
      for (std::size_t i = 0; i < component.sources.size(); ++i) {
        auto const& source = component.sources[i];
        // Matched darts still have their handles; where a walk led from them, it led before the arcs changed.
        std::string const value = source.tail.empty()
                                      ? fmt::format("{}.handle({})", embedding, f.dart(source.preserved, source.word))
                                      : fmt::format("{}[{}]", f.inherited[c][i], f.index);
        out.line("{} {}.set_handle({}, {});", f.loop(), embedding, f.dart(source.added), value);
      }
      return;
    case Kind::assign:
    case Kind::merge: {
      std::string const value = component.kind == Kind::assign ? handle + ", " : "";
      out.open("{} {{", f.loop());
      out.line("{}jrule::rewrite::{}_orbit({}, {}, {}, {}{});", if_first(f, component),
               component.kind == Kind::assign ? "assign" : "merge", f.map, component.embedding, f.dart(root), value,
               f.workspace);
      out.close();
      return;
    }
  }
}

// What merged orbits get, where functions say it.
void write_trial(Writer& out, Function const& f) {
  std::string const& trial = f.local("trial");
  write_arcs(out, f, trial);
  for (std::size_t e = 0; e < f.embeddings.size(); ++e) {
    if (!f.merges_on_trial(e)) continue;
    out.line("// {}", f.spec(e).name);
    if (f.adds_values[e]) out.line("{}.commit();", f.new_values[e]);
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

void write_embeddings(Writer& out, Function const& f) {
  std::optional<std::pair<std::size_t, Kind>> group;
  for (std::size_t c = 0; c < f.plan.orbits.size(); ++c) {
    auto const& component = f.plan.orbits[c];
    bool const new_embedding = !group || group->first != component.embedding;
    bool const new_group = group != std::pair(component.embedding, component.kind);
    group = std::pair(component.embedding, component.kind);
    if (new_embedding) {
      out.line("// {}", f.spec(component.embedding).name);
      if (f.adds_values[component.embedding] && !f.merges_on_trial(component.embedding))
        out.line("{}.commit();", f.new_values[component.embedding]);
    }
    if (component.kind == Kind::merge && f.merges_on_trial(component.embedding)) {
      if (new_group) out.line("{}.commit_merges({});", f.local("trial"), component.embedding);
      continue;
    }
    // The marks remember which orbits have their value: two components may meet beyond the pattern.
    if (new_group && (component.kind == Kind::assign || component.kind == Kind::merge))
      out.line("{}.clear_marks();", f.workspace);
    write_handles(out, f, c);
  }
}

// "return ConeResult{match_a[0], added_b[0], {std::move(match_a), std::move(added_b)}};"
void write_result(Writer& out, Function const& f) {
  std::string firsts, copies;
  for (ir::NodeId id = 0; id < f.rule.nodes.size(); ++id) {
    if (f.node(id).deleted()) continue;
    firsts += fmt::format("{}{}[0]", firsts.empty() ? "" : ", ", f.darts[id]);
    copies += fmt::format("{}std::move({})", copies.empty() ? "" : ", ", f.darts[id]);
  }
  out.line();
  if (firsts.empty() || f.rule.hooks.empty()) {
    out.line("return {}{{{}}};", f.names.result, firsts);
  } else {
    out.line("return {}{{{},", f.names.result, firsts);
    out.line("{:{}}{{{}}}}};", "", f.names.result.size() + 8, copies);
  }
}

}  // namespace

void write_commit(Writer& out, Function const& f) {
  bool const changes =
      !f.plan.deleted.empty() || !f.plan.added.empty() || !f.plan.writes.empty() || !f.plan.orbits.empty();
  if (changes) {
    out.line();
    out.line("// ---- Room for all of it{} ----", f.merges_on_trial() ? "" : ": the last part that may fail");
    out.line();
    write_reserve(out, f);
    out.line();
    if (f.merges_on_trial()) {
      out.line("// ---- Trial: the new arcs, for merging values; if a function throws, all of it is undone ----");
      out.line();
      write_trial(out, f);
      out.line();
    }
    out.line("// ---- Commit ----");
    out.line();
    out.open("auto const {} = [&]() noexcept {{", f.local("commit"));
    write_deletions(out, f);
    if (!f.merges_on_trial()) write_arcs(out, f, f.map);
    write_embeddings(out, f);
    out.close("};");
    out.line("{}();", f.local("commit"));
  }
  write_result(out, f);
}

}  // namespace jrule::cpp
