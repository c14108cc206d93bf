#include <fmt/format.h>
#include <fmt/ranges.h>

#include "compiler/backend/cpp/sections.h"
#include "compiler/backend/cpp/text.h"

namespace jrule::cpp {

namespace {

std::string refuse(std::string const& error) {
  return fmt::format("return tl::unexpected(jrule::rewrite::{});", error);
}

void write_pattern(Writer& out, Function const& f) {
  for (std::size_t h = 0; h < f.hooks.size(); ++h) {
    out.line("if (!{}.contains({})) {}", f.map, f.hooks[h],
             refuse(fmt::format("not_a_dart({}, {}, {})", literal(f.rule.name), literal(f.node(f.rule.hooks[h]).name),
                                f.hooks[h])));
  }
  std::string generators = "{}";
  if (!f.plan.generators.empty()) {
    generators = f.local("generators");
    std::vector<std::string> words;
    for (Word const& word : f.plan.generators) words.push_back(initializer(word));
    out.line("static jrule::Word const {}[] = {{{}}};", generators, fmt::join(words, ", "));
  }
  std::string const& pattern = f.darts[f.rule.hooks[0]];
  out.line("std::vector<jrule::Dart> {} = jrule::rewrite::close_pattern({}, {}, {}, {});", pattern, f.map, f.hooks[0],
           generators, f.workspace);
  // A rule that only tests need not know it.
  bool const alone = f.columns.empty() && f.plan.further_hooks.empty() && f.plan.steps.empty() &&
                     f.plan.checks.empty() && f.plan.added.empty() && f.plan.deleted.empty() && f.plan.writes.empty() &&
                     f.plan.orbits.empty();
  if (!alone) out.line("std::size_t const {} = {}.size();", f.size, pattern);
}

void write_columns(Writer& out, Function const& f) {
  if (f.columns.empty()) return;
  out.line();
  out.line("// {}[{}] is the place in the pattern of the dart where the word {} leads from its {}-th dart; and so on.",
           f.columns.begin()->second, f.index, jrule::to_string(f.columns.begin()->first), f.index);
  std::vector<std::string> columns;
  for (auto const& [word, name] : f.columns) columns.push_back(fmt::format("{}({})", name, f.size));
  out.line("jrule::rewrite::Column {};", fmt::join(columns, ", "));
  out.open("{} {{", f.loop());
  out.line("jrule::Dart const {} = {};", f.local("u"), f.dart(f.rule.hooks[0]));
  for (auto const& [word, name] : f.columns) {
    out.line("{}[{}] = {}.value({});", name, f.index, f.workspace, walk(f.map, f.local("u"), word));
  }
  out.close();
}

void write_further_hooks(Writer& out, Function const& f) {
  for (auto const& hook : f.plan.further_hooks) {
    ir::Node const& node = f.node(hook.node);
    std::string const& dart = f.hooks[*node.hook];
    out.line();
    out.line("// {}: {}, walked in step with {}", place(f.sources, node.span()), node.name,
             f.node(f.rule.hooks[0]).name);
    std::vector<std::string> loops;
    for (auto const& loop : hook.loops)
      loops.push_back(fmt::format("{{&{}, {}}}", f.columns.at(loop.word), loop.dimension));
    std::string const name = loops.empty() ? "{}" : f.hook_loops[*node.hook];
    if (!loops.empty()) out.line("jrule::rewrite::Loop const {}[] = {{{}}};", name, fmt::join(loops, ", "));
    out.line("std::vector<jrule::Dart> {} = jrule::rewrite::walk_in_step({}, {}, {}, {});", f.darts[hook.node], f.map,
             dart, f.size, name);
    out.line("if ({}.empty()) {}", f.darts[hook.node],
             refuse(fmt::format("hook_not_determined({}, {})", literal(f.rule.name), literal(node.name))));
  }
}

void write_steps(Writer& out, Function const& f) {
  for (auto const& s : f.plan.steps) {
    ir::Node const& node = f.node(s.node);
    out.line();
    out.line("// {}: {}", place(f.sources, node.span()), node.name);
    out.line("std::vector<jrule::Dart> {}({});", f.darts[s.node], f.size);
    out.line("{} {} = {};", f.loop(), f.dart(s.node), step(f.map, f.dart(s.from, s.word), s.letter));
  }
}

void write_checks(Writer& out, Function const& f) {
  for (auto const& check : f.plan.checks) {
    std::string const &at = f.local("at"), &to = f.local("to"), &expected = f.local("expected");
    out.line();
    out.line("// {}: {}", place(f.sources, check.span),
             arc_text(f.rule, check.source, check.dimension, check.word, check.target));
    out.open("{} {{", f.loop());
    out.line("jrule::Dart const {0} = {1}, {2} = {4}.target({0}, {5}), {3} = {6};", at, f.dart(check.source), to,
             expected, f.map, check.dimension, f.dart(check.target, check.word));
    out.line("if ({} != {}) {}", to, expected,
             refuse(fmt::format("arc_differs({}, {}, {}, {}, {}, {}, {})", literal(f.rule.name),
                                literal(f.node(check.source).name), check.dimension, literal(f.node(check.target).name),
                                at, to, expected)));
    out.close();
  }
}

void write_injectivity(Writer& out, Function const& f) {
  if (!f.plan.test_injectivity) return;
  std::vector<std::string> matches;
  for (ir::NodeId id = 0; id < f.rule.nodes.size(); ++id) {
    if (!f.node(id).added()) matches.push_back('&' + f.darts[id]);
  }
  out.line();
  out.line("std::vector<jrule::Dart> const* const {}[] = {{{}}};", f.local("matches"), fmt::join(matches, ", "));
  out.open("if (auto const {} = jrule::rewrite::matched_twice({}, {})) {{", f.local("twice"), f.local("matches"),
           f.workspace);
  out.text(refuse(fmt::format("matched_twice_error({}, *{})", literal(f.rule.name), f.local("twice"))));
  out.close();
}

}  // namespace

void write_match(Writer& out, Function const& f) {
  if (f.rule.hooks.empty()) {
    if (!f.plan.added.empty()) out.line("std::size_t const {} = 1;  // one copy of each node", f.size);
    return;
  }
  out.line();
  out.line("// ---- Match: the darts of each left node ----");
  out.line();
  write_pattern(out, f);
  write_columns(out, f);
  write_further_hooks(out, f);
  write_steps(out, f);
  write_checks(out, f);
  write_injectivity(out, f);
}

}  // namespace jrule::cpp
