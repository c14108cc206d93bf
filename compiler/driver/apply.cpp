#include <fmt/format.h>

#include "compiler/analysis/independence.h"
#include "compiler/backend/interpreter/interpreter.h"
#include "compiler/driver/arguments.h"
#include "compiler/driver/compile.h"
#include "compiler/driver/outcome.h"
#include "compiler/driver/reference.h"
#include "compiler/driver/report.h"
#include "compiler/driver/selection.h"
#include "compiler/ir/extern_use.h"
#include "jrule/io.h"

namespace jrule::driver {

namespace {

Result<Map> read_input(ApplyOptions const& options, ir::RuleScheme const& rule) {
  if (!options.in.empty()) return read_map(options.in, rule.model(), rule.modeler->embeddings);
  if (rule.hooks.empty()) return Map(rule.model(), rule.modeler->embeddings);
  return fail(Error::Kind::bad_input, fmt::format("`{}` is applied to a mesh: give one with `--in`", rule.name));
}

// The dimension of a map whose rule leaves it open (`on gmap(n)`): the input's.
std::optional<int> input_dimension(std::string const& path) {
  if (path.empty()) return {};
  if (!path.ends_with(".jmap")) return 2;
  auto const map = read_jmap(path);
  return map ? std::optional(map->model().dimension) : std::nullopt;
}

Result<void> apply_at(ir::RuleScheme const& rule, analysis::Plan const& plan, Map& map, std::string const& at, std::vector<Value> const& values,
                      Threads threads, std::size_t& count) {
  rewrite::Workspace workspace;
  std::vector<Dart> hooks;
  if (rule.hooks.empty()) {
    if (!at.empty()) return fail(Error::Kind::bad_input, fmt::format("`{}` has no hook: `--at` says nothing here", rule.name));
  } else if (at.empty() || at == "all") {
    if (rule.hooks.size() > 1) {
      return fail(Error::Kind::bad_input, fmt::format("`{}` has {} hooks: give a dart for each, `--at dart:3,dart:17`", rule.name, rule.hooks.size()));
    }
    auto const applied = analysis::analyze_independence(rule, plan).independent()
                             ? interpreter::apply_all(rule, plan, map, values, workspace, threads)
                             : interpreter::apply_everywhere(rule, plan, map, values, workspace);
    if (!applied) return tl::unexpected(applied.error());
    count = *applied;
    return {};
  } else {
    auto const selected = select(map, at);
    if (!selected) return tl::unexpected(selected.error());
    if (selected->size() != rule.hooks.size()) {
      return fail(Error::Kind::bad_input, fmt::format("`{}` has {} hook{}, but `--at` selects {} dart{}", rule.name, rule.hooks.size(),
                                                      rule.hooks.size() == 1 ? "" : "s", selected->size(), selected->size() == 1 ? "" : "s"));
    }
    hooks = *selected;
  }
  auto const applied = interpreter::apply(rule, plan, map, hooks, values, workspace);
  if (!applied) return tl::unexpected(applied.error());
  count = 1;
  return {};
}

// The rule among those elaborated already, or one of its dimensions.
struct Chosen {
  ir::RuleScheme rule;
  analysis::Plan plan;
};
std::optional<Chosen> choose(Compilation& compilation, RuleReference const& reference, ApplyOptions const& options) {
  auto const& rules = compilation.program.rules;
  for (std::size_t i = 0; i < rules.size(); ++i) {
    if (rules[i].name == reference.rule && reference.dimensions.empty() && compilation.verdicts[i].accepted()) {
      return Chosen{rules[i], compilation.verdicts[i].plan};
    }
  }
  std::optional<int> const n = input_dimension(options.in);
  auto rule = sema::instantiate(compilation.modules, reference.rule, reference.dimensions, n, compilation.diagnostics);
  if (!rule) return {};
  analysis::Verdict verdict = judge(*rule, compilation.diagnostics);
  if (!verdict.accepted()) return {};
  return Chosen{std::move(*rule), std::move(verdict.plan)};
}

// Rules with C++ from outside are checked like all others, but only their generated code can run.
bool can_run(ir::RuleScheme const& rule, source::Diagnostics& diagnostics) {
  auto const use = ir::find_extern_use(rule);
  if (!use) return true;
  diagnostics.add({.code = source::Code::needs_cpp,
                   .span = use->span,
                   .message = fmt::format("`{}` cannot be applied here: {}", rule.name, use->what),
                   .labels = {{use->declaration, "it is C++ from outside"}},
                   .notes = {"generated C++ can: `jrule emit cpp`, or `jrule_add_rules` in CMake"}});
  return false;
}

}  // namespace

int apply(ApplyOptions const& options) {
  auto const reference = parse_reference(options.rule);
  if (!reference) {
    print_error(fmt::format("`{}` is not of the form FILE:RULE", options.rule));
    return exit_usage;
  }
  auto const compilation = compile(reference->file, options.common);
  std::optional<Chosen> chosen;
  if (!compilation->diagnostics.has_errors()) chosen = choose(*compilation, *reference, options);
  if (chosen) (void)can_run(chosen->rule, compilation->diagnostics);
  // Notes on other rules of the file are for `check`.
  if (compilation->diagnostics.has_errors()) {
    print(compilation->sources, compilation->diagnostics, options.common);
    return status(compilation->diagnostics);
  }
  ir::RuleScheme const& rule = chosen->rule;

  auto const values = parse_arguments(rule, options.values);
  if (!values) return report_error(values.error());
  auto map = read_input(options, rule);
  if (!map) return report_error(map.error());
  Threads const threads = options.threads == 0 ? Threads::all() : Threads{options.threads};
  std::size_t count = 0;
  if (auto const applied = apply_at(rule, chosen->plan, *map, options.at, *values, threads, count); !applied) return report_error(applied.error());
  return write_outcome(*map, {options.out, options.picture, options.stats_json}, fmt::format("applying the accepted rule `{}`", rule.name),
                       fmt::format("{}: applied {}", rule.name, count == 1 ? "once" : fmt::format("{} times", count)));
}

}  // namespace jrule::driver
