#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "compiler/backend/cpp/dart_tests.h"
#include "compiler/backend/cpp/expression.h"
#include "compiler/backend/cpp/sections.h"
#include "compiler/backend/cpp/text.h"

namespace jrule::cpp {

namespace {

std::string refuse(std::string const& error) {
  return fmt::format("return tl::unexpected(jrule::rewrite::{});", error);
}

// Do the pattern's darts lie on a circle or a path, and are all its columns of the letters that lead along it? Then no marks are
// needed to find them.
bool is_line(Function const& f) {
  auto const& generators = f.plan.generators;
  bool const dihedral = generators.size() == 2 && f.is_involution(generators[0]) && f.is_involution(generators[1]);
  bool const cycle = generators.size() == 1 && generators[0].size() == 1 && !f.is_involution(generators[0]);
  if ((!dihedral && !cycle) || f.hooks.size() != 1) return false;
  return std::all_of(f.columns.begin(), f.columns.end(), [&](auto const& column) {
    return std::all_of(column.first.begin(), column.first.end(), [&](Letter const letter) {
      return std::any_of(generators.begin(), generators.end(), [&](Word const& g) { return g.front().dimension == letter.dimension; });
    });
  });
}

void write_line(Writer& out, Function const& f) {
  auto const& generators = f.plan.generators;
  Letter const first = generators[0].front();
  bool const cycle = generators.size() == 1;
  Letter const second = cycle ? Letter{first.dimension, !first.conjugate} : generators[1].front();
  std::string const& line = f.local("line");
  out.line("{}.begin();", f.workspace);
  if (f.plan.test_injectivity) out.line("{}.reserve({}.dart_limit());", f.workspace, f.map);
  out.line("jrule::rewrite::LinePattern const {} = jrule::rewrite::{}_pattern({}, {}, {}, {});", line, cycle ? "cycle" : "dihedral",
           f.steps.at(first), f.steps.at(second), f.hooks[0], f.workspace);
  out.line("std::span<jrule::Dart const> const {} = {}.darts;", f.darts[f.rule.hooks[0]], line);
}

// What such a pattern knows; words of several letters lead through several columns.
void write_line_columns(Writer& out, Function const& f) {
  auto const column = [&](Letter const letter) {
    Letter const first = f.plan.generators[0].front();
    bool const is_first = letter.dimension == first.dimension && (f.plan.generators.size() == 2 || letter.conjugate == first.conjugate);
    return fmt::format("{}.{}", f.local("line"), is_first ? "first" : "second");
  };
  for (auto const& [word, name] : f.columns) {
    if (word.size() == 1) {
      out.line("[[maybe_unused]] jrule::rewrite::Index const* const {} = {};", name, column(word.front()));
      continue;
    }
    std::string at = f.index;
    for (Letter const letter : word) at = fmt::format("{}[{}]", column(letter), at);
    out.line("jrule::rewrite::Index* const {} = {}.column({});", name, f.workspace, f.size);
    out.line("{} {}[{}] = {};", f.loop(), name, f.index, at);
  }
}

void write_closure(Writer& out, Function const& f) {
  out.line("{}.begin();", f.workspace);
  out.line("{}.reserve({}.dart_limit());", f.workspace, f.map);
  out.line("{}.clear_marks();", f.workspace);
  out.line("{}.meet({});", f.workspace, f.hooks[0]);
  if (!f.plan.generators.empty()) {
    out.open("for (std::size_t {0} = 0; {0} < {1}.pattern().size(); ++{0}) {{", f.index, f.workspace);
    out.line("jrule::Dart const {} = {}.pattern()[{}];", f.local("u"), f.workspace, f.index);
    for (Word const& word : f.plan.generators) {
      out.line("{}.meet({});", f.workspace, f.walk(f.local("u"), word));
      if (f.is_involution(word)) continue;
      Word conjugate(word.rbegin(), word.rend());
      for (Letter& letter : conjugate) letter.conjugate = f.rule.model().is_oriented(letter.dimension) && !letter.conjugate;
      out.line("{}.meet({});", f.workspace, f.walk(f.local("u"), conjugate));
    }
    out.close();
  }
  out.line("std::span<jrule::Dart const> const {} = {}.pattern();", f.darts[f.rule.hooks[0]], f.workspace);
}

void write_pattern(Writer& out, Function const& f) {
  for (std::size_t h = 0; h < f.hooks.size(); ++h) {
    out.line("if (!{}.contains({})) {}", f.map, f.hooks[h],
             refuse(fmt::format("not_a_dart({}, {}, {})", literal(f.rule.name), literal(f.node(f.rule.hooks[h]).name),
                                f.hooks[h])));
  }
  is_line(f) ? write_line(out, f) : write_closure(out, f);
  // A rule that only tests need not know it.
  bool const alone = !f.independent && f.columns.empty() && f.plan.further_hooks.empty() && f.plan.steps.empty() &&
                     f.plan.checks.empty() && f.plan.added.empty() && f.plan.deleted.empty() && f.plan.writes.empty() &&
                     f.plan.orbits.empty();
  if (!alone) out.line("std::size_t const {} = {}.size();", f.size, f.darts[f.rule.hooks[0]]);
}

void write_columns(Writer& out, Function const& f) {
  if (f.columns.empty()) return;
  out.line();
  out.line("// {}[{}] is the place in the pattern of the dart where the word {} leads from its {}-th dart; and so on.",
           f.columns.begin()->second, f.index, jrule::to_string(f.columns.begin()->first), f.index);
  if (is_line(f)) return write_line_columns(out, f);
  for (auto const& [word, name] : f.columns) out.line("jrule::rewrite::Index* const {} = {}.column({});", name, f.workspace, f.size);
  out.open("{} {{", f.loop());
  out.line("jrule::Dart const {} = {};", f.local("u"), f.dart(f.rule.hooks[0]));
  for (auto const& [word, name] : f.columns) {
    out.line("{}[{}] = {}.value({});", name, f.index, f.workspace, f.walk(f.local("u"), word));
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
      loops.push_back(fmt::format("{{{}, {}}}", f.columns.at(loop.word), loop.dimension));
    std::string const name = loops.empty() ? "{}" : f.hook_loops[*node.hook];
    if (!loops.empty()) out.line("jrule::rewrite::Loop const {}[] = {{{}}};", name, fmt::join(loops, ", "));
    out.line("std::span<jrule::Dart const> const {} = jrule::rewrite::walk_in_step({}, {}, {}, {}, {});", f.darts[hook.node], f.map,
             dart, f.size, name, f.workspace);
    out.line("if ({}.empty()) {}", f.darts[hook.node],
             refuse(fmt::format("hook_not_determined({}, {})", literal(f.rule.name), literal(node.name))));
  }
}

void write_steps(Writer& out, Function const& f) {
  for (auto const& s : f.plan.steps) {
    ir::Node const& node = f.node(s.node);
    out.line();
    out.line("// {}: {}", place(f.sources, node.span()), node.name);
    out.line("jrule::Dart* const {} = {}.column({});", f.darts[s.node], f.workspace, f.size);
    out.text(f.each(fmt::format("{} = {};", f.dart(s.node), f.walk(f.dart(s.from, s.word), {s.letter}))));
  }
}

// "jrule::Dart const at = k, to = targets_2[at], expected = k;"
std::string arc_of_map(Function const& f, analysis::MatchCheck const& check) {
  std::string const& at = f.local("at");
  return fmt::format("jrule::Dart const {0} = {1}, {2} = {4}, {3} = {5};", at, f.dart(check.source), f.local("to"), f.local("expected"),
                     f.walk(at, {{static_cast<std::uint8_t>(check.dimension), false}}), f.dart(check.target, check.word));
}

// Tests each arc of the left side that not every map has; where it is another one, `refuse` follows.
template <class Refuse>
void write_checks(Writer& out, Function const& f, Refuse refuse) {
  for (auto const& check : f.plan.checks) {
    out.line();
    out.line("// {}: {}", place(f.sources, check.span),
             arc_text(f.rule, check.source, check.dimension, check.word, check.target));
    out.open("{} {{", f.loop());
    out.text(arc_of_map(f, check));
    out.line("if ({} != {}) {}", f.local("to"), f.local("expected"), refuse(check));
    out.close();
  }
}

// The match columns of all left nodes, for a test of injectivity.
void write_matches(Writer& out, Function const& f) {
  std::vector<std::string> matches;
  for (ir::NodeId id = 0; id < f.rule.nodes.size(); ++id) {
    if (f.node(id).added()) continue;
    bool const is_column = std::any_of(f.plan.steps.begin(), f.plan.steps.end(), [&](auto const& s) { return s.node == id; });
    matches.push_back(is_column ? fmt::format("{{{}, {}}}", f.darts[id], f.size) : f.darts[id]);
  }
  out.line();
  out.line("std::span<jrule::Dart const> const {}[] = {{{}}};", f.local("matches"), fmt::join(matches, ", "));
}

void write_injectivity(Writer& out, Function const& f) {
  if (!f.plan.test_injectivity) return;
  write_matches(out, f);
  out.open("if (auto const {} = jrule::rewrite::matched_twice({}, {})) {{", f.local("twice"), f.local("matches"),
           f.workspace);
  out.text(refuse(fmt::format("matched_twice_error({}, *{})", literal(f.rule.name), f.local("twice"))));
  out.close();
}

// ---- All applications ----

// The columns over the union of the patterns; then what they are for, `text`.
void write_with_all_columns(Writer& out, Function const& f, std::string const& text) {
  std::string const& all = f.local("all");
  std::string const& hook = f.darts[f.rule.hooks[0]];
  out.line("{}.begin();", f.workspace);
  out.line("jrule::rewrite::mark_pattern({}, {}.pattern, {}, {});", f.map, all, f.workspace, f.threads);
  std::vector<Local> locals{{hook, fmt::format("std::span<jrule::Dart const> const {} = {}.pattern;", hook, all)},
                            {f.size, fmt::format("std::size_t const {} = {}.size();", f.size, hook)}};
  for (auto const& [word, name] : f.columns) {
    locals.push_back({name, fmt::format("jrule::rewrite::Column const {} = jrule::rewrite::bulk_column({}, {}.pattern, jrule::Word{}, {}, {});",
                                        name, f.map, all, initializer(word), f.workspace, f.threads)});
  }
  write_with_locals(out, locals, text);
}

bool can_refuse(Function const& f) {
  return !f.plan.checks.empty() || f.plan.test_injectivity || !f.rule.requirements.empty() || !f.rule.lets.empty();
}

// Of each application that is not refused yet, its lets; the requirements.
void write_all_conditions(Writer& out, Function const& f) {
  if (f.rule.lets.empty() && f.rule.requirements.empty()) return;
  std::string const &all = f.local("all"), &refused = f.local("refused"), &i = f.local("i");
  out.line();
  out.open("for (std::size_t {0} = 0; {0} < {1}.count(); ++{0}) {{", i, all);
  out.line("if ({}[{}]) continue;", refused, i);
  out.line("[[maybe_unused]] std::size_t const {} = {}.first[{}];", f.index, all, i);
  for (std::size_t l = 0; l < f.rule.lets.size(); ++l) {
    ir::Expr const& value = *f.rule.lets[l].value;
    out.line("// {}", place(f.sources, value.span));
    out.line("[[maybe_unused]] {} const {} = {};", type_name(value.type), f.lets[l], expression(value, f, Where::at_each_hook));
  }
  for (ir::Requirement const& requirement : f.rule.requirements) {
    out.line("// {}", place(f.sources, requirement.condition->span));
    out.open("if (!({})) {{", expression(*requirement.condition, f, Where::at_each_hook));
    out.line("{}[{}] = true;", refused, i);
    out.line("continue;");
    out.close();
  }
  for (std::size_t l = 0; l < f.rule.lets.size(); ++l) {
    if (f.uses_let[l]) out.line("{}.push_back({});", f.let_lists[l], f.lets[l]);
  }
  out.close();
}

void write_refusals(Writer& out, Function const& f) {
  std::string const &all = f.local("all"), &refused = f.local("refused");
  for (std::size_t l = 0; l < f.rule.lets.size(); ++l) {
    if (f.uses_let[l]) out.line("std::vector<{}> {};", stored_type(f.rule.lets[l].value->type), f.let_lists[l]);
  }
  out.line("std::vector<bool> {}({}.count(), false);", refused, all);
  out.open("{{");
  Writer tests(out.depth());
  write_steps(tests, f);
  // On one thread: the flags of several applications lie in one word.
  write_checks(tests, f, [&](auto const&) { return fmt::format("{}[{}.number[{}]] = true;", refused, all, f.index); });
  if (f.plan.test_injectivity) {
    write_matches(tests, f);
    tests.line("jrule::rewrite::refuse_matched_twice({}, {}, {}, {});", all, f.local("matches"), f.workspace, refused);
  }
  write_all_conditions(tests, f);
  write_with_all_columns(out, f, tests.all());
  out.close();
  out.line("{0} = jrule::rewrite::without({0}, {1});", all, refused);
}

}  // namespace

void write_all_matches(Writer& out, Function const& f, std::string const& find, std::string const& text) {
  out.line("jrule::rewrite::Applications {} = {};", f.local("all"), find);
  if (can_refuse(f)) write_refusals(out, f);
  Writer steps(out.depth());
  write_steps(steps, f);
  write_with_all_columns(out, f, steps.all() + text);
}

void write_dense_checks(Writer& out, Function const& f) {
  for (auto const& check : f.plan.checks) {
    out.line();
    out.line("// {}: {}", place(f.sources, check.span),
             arc_text(f.rule, check.source, check.dimension, check.word, check.target));
    out.open("if (!jrule::parallel::all_of<jrule::Dart>({}, {}, [&](jrule::Dart {}) {{", f.size, f.threads, f.index);
    out.text(arc_of_map(f, check));
    out.line("return {} == {};", f.local("to"), f.local("expected"));
    out.close("})) return false;");
  }
  for (ir::Requirement const& requirement : f.rule.requirements) {
    out.line();
    out.line("// {}", place(f.sources, requirement.condition->span));
    auto const tests = dart_tests(f.rule, requirement);
    for (DartTest const& test : tests.value()) {
      std::string const condition = expression(*test.condition, f, Where::in_loop), &dart = f.variables.at(test.dart.name);
      out.open("if (!jrule::parallel::all_of<jrule::Dart>({}, {}, [&](jrule::Dart{}) {{", f.size, f.threads,
               mentions(condition, dart) ? ' ' + dart : "");
      out.line("{}", test.must_hold ? fmt::format("return {};", condition) : fmt::format("return !({});", condition));
      out.close("})) return false;");
    }
  }
}

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
  write_checks(out, f, [&](analysis::MatchCheck const& check) {
    return refuse(fmt::format("arc_differs({}, {}, {}, {}, {}, {}, {})", literal(f.rule.name), literal(f.node(check.source).name),
                              check.dimension, literal(f.node(check.target).name), f.local("at"), f.local("to"), f.local("expected")));
  });
  write_injectivity(out, f);
}

}  // namespace jrule::cpp
