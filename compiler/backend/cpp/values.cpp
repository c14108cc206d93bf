#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "compiler/backend/cpp/expression.h"
#include "compiler/backend/cpp/sections.h"
#include "compiler/backend/cpp/text.h"
#include "compiler/ir/extern_use.h"

namespace jrule::cpp {

using Kind = analysis::OrbitComponent::Kind;

void write_conditions(Writer& out, Function const& f) {
  for (std::size_t i = 0; i < f.rule.lets.size(); ++i) {
    ir::Expr const& value = *f.rule.lets[i].value;
    out.line("// {}", place(f.sources, value.span));
    out.line("{}{} const {} = {};", f.uses_let[i] ? "" : "[[maybe_unused]] ", type_name(value.type), f.lets[i],
             expression(value, f, Where::at_hooks));
  }
  for (ir::Requirement const& requirement : f.rule.requirements) {
    std::vector<std::string> hooks;
    for (std::size_t h = 0; h < f.hooks.size() && depends_on_place(f.rule, requirement); ++h) {
      hooks.push_back(fmt::format("{{{}, {}}}", literal(f.node(f.rule.hooks[h]).name), f.hooks[h]));
    }
    out.line("// {}", place(f.sources, requirement.condition->span));
    out.open("if (!({})) {{", expression(*requirement.condition, f, Where::at_hooks));
    out.line("return tl::unexpected(jrule::rewrite::requirement_failed({}, {}, {{{}}}));", literal(f.rule.name),
             literal(requirement.text), fmt::join(hooks, ", "));
    out.close();
  }
}

namespace {

void write_new_values(Writer& out, Function const& f) {
  for (std::size_t e = 0; e < f.embeddings.size(); ++e) {
    if (!f.adds_values[e]) continue;
    out.line("jrule::rewrite::NewValues<{}> {}({});", type_name(f.rule.modeler->value_type(e)), f.new_values[e], f.embeddings[e]);
  }
}

void write_clause_on_threads(Writer& out, Function const& f, std::size_t c) {
  auto const& component = f.plan.orbits[c];
  bool const dense = f.form == Form::dense;
  std::string const orbits = f.orbits_of(component);
  std::string const start =
      orbits.empty() ? fmt::format("jrule::rewrite::add_value_of_each{}({}, {}, {}, {}", dense ? "<jrule::Dart>" : "",
                                   f.new_values[component.embedding], f.handles[c], f.size, f.threads)
                     : fmt::format("jrule::rewrite::add_values{}({}, {}, {}, {}, {}", dense ? "<jrule::Dart>" : "",
                                   f.new_values[component.embedding], orbits, f.handles[c], f.size, f.threads);
  std::string const value = expression(*f.rule.clauses[*component.clause].value, f, Where::in_loop);
  out.open("{}, [&]({}{}) -> {} {{", start, dense ? "jrule::Dart" : "std::size_t", mentions(value, f.index) ? ' ' + f.index : "",
           type_name(f.rule.modeler->value_type(component.embedding)));
  out.line("return {};", value);
  out.close("});");
}

// One new value for each orbit, made at the first of its pattern darts.
void write_clause(Writer& out, Function const& f, std::size_t c) {
  auto const& component = f.plan.orbits[c];
  std::string const &handle = f.handles[c], orbits = f.orbits_of(component);
  std::string const add = fmt::format("{}.add({})", f.new_values[component.embedding],
                                      expression(*f.rule.clauses[*component.clause].value, f, Where::in_loop));
  out.line("jrule::Handle* const {} = {}.column({});", handle, f.workspace, f.size);
  if (f.takes_threads() && !ir::find_extern_use(f.rule)) return write_clause_on_threads(out, f, c);
  // On one thread: for a single orbit of the hook, or C++ from outside, which may be made for one.
  if (orbits.empty()) {
    out.line("{} {}[{}] = {};", f.loop(), handle, f.index, add);
    return;
  }
  out.line("std::fill({0}, {0} + {1}, jrule::no_handle);", handle, f.size);
  out.open("{} {{", f.loop());
  std::string const index = f.form == Form::dense ? f.index : fmt::format("static_cast<jrule::rewrite::Index>({})", f.index);
  out.line("if ({}[{}] != jrule::no_handle) continue;", handle, f.index);
  out.line("{}.fill({}, {}, {});", orbits, handle, index, add);
  out.close();
}

// Darts that are matched keep their handles until the commit reads them; those where a walk leads have to be read now.
bool has_inherited(analysis::OrbitComponent const& component) {
  return std::any_of(component.sources.begin(), component.sources.end(),
                     [](auto const& source) { return !source.tail.empty(); });
}

void write_inherited(Writer& out, Function const& f, std::size_t c) {
  auto const& component = f.plan.orbits[c];
  for (std::size_t i = 0; i < component.sources.size(); ++i) {
    auto const& source = component.sources[i];
    if (source.tail.empty()) continue;
    out.line("jrule::Handle* const {} = {}.column({});", f.inherited[c][i], f.workspace, f.size);
    out.text(f.each(fmt::format("{}[{}] = {}.handle({});", f.inherited[c][i], f.index, f.embeddings[component.embedding],
                                f.walk(f.dart(source.preserved, source.word), source.tail))));
  }
}

// Is there anything to do for it before the commit?
bool is_planned(analysis::OrbitComponent const& component) {
  switch (component.kind) {
    case Kind::fresh:
    case Kind::assign: return true;
    case Kind::inherit: return has_inherited(component);
    case Kind::merge: return false;
  }
  return true;
}

void write_component(Writer& out, Function const& f, std::size_t c) {
  auto const& component = f.plan.orbits[c];
  ir::Node const& root = f.node(component.members.front().node);
  EmbeddingSpec const& spec = f.spec(component.embedding);
  source::Span const span =
      component.clause ? f.rule.clauses[*component.clause].span : root.right_span.value_or(root.span());
  std::string const where = place(f.sources, span);
  out.line();
  switch (component.kind) {
    case Kind::fresh:
      if (!component.clause) {
        out.line("// {}: {}.{} by default", where, root.name, spec.name);
        out.line("jrule::Handle const {} = {}.add({});", f.handles[c], f.new_values[component.embedding],
                 default_value(*f.rule.modeler, component.embedding));
        return;
      }
      [[fallthrough]];
    case Kind::assign:
      out.line("// {}: {}.{}", where, root.name, spec.name);
      write_clause(out, f, c);
      return;
    case Kind::merge: return;  // the commit finds out
    case Kind::inherit:
      out.line("// {}: {} of the orbit that is joined", where, spec.name);
      write_inherited(out, f, c);
      return;
  }
}

}  // namespace

void write_values(Writer& out, Function const& f) {
  write_new_values(out, f);
  for (std::size_t c = 0; c < f.plan.orbits.size(); ++c) {
    if (is_planned(f.plan.orbits[c])) write_component(out, f, c);
  }
}

}  // namespace jrule::cpp
