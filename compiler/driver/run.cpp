#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "compiler/backend/interpreter/operation.h"
#include "compiler/driver/arguments.h"
#include "compiler/driver/compile.h"
#include "compiler/driver/outcome.h"
#include "compiler/driver/progress.h"
#include "compiler/driver/reference.h"
#include "compiler/driver/report.h"
#include "compiler/driver/selection.h"
#include "compiler/ir/extern_use.h"
#include "jrule/io.h"

namespace jrule::driver {

namespace {

// Which of the program's operations it is; none, printed, if it is none.
std::optional<std::size_t> find(ir::Program const& program, RuleReference const& reference) {
  auto const has_name = [&](auto const& thing) { return thing.name == reference.rule; };
  auto const found = std::find_if(program.operations.begin(), program.operations.end(), has_name);
  if (found != program.operations.end() && reference.dimensions.empty()) return static_cast<std::size_t>(found - program.operations.begin());
  if (std::any_of(program.rules.begin(), program.rules.end(), has_name)) {
    print_error(fmt::format("`{}` is a rule: `jrule apply` applies it", reference.rule));
    return {};
  }
  std::vector<std::string> names;
  for (ir::Operation const& operation : program.operations) names.push_back(operation.name);
  print_error(names.empty() ? fmt::format("`{}` has no operations", reference.file)
                            : fmt::format("`{}` has no operation `{}`; it has `{}`", reference.file, reference.rule, fmt::join(names, "`, `")));
  return {};
}

bool can_run(ir::Operation const& operation, ir::Program const& program, source::Diagnostics& diagnostics) {
  auto const use = ir::find_extern_use(operation, program);
  if (!use) return true;
  diagnostics.add({.code = source::Code::needs_cpp,
                   .span = use->span,
                   .message = fmt::format("`{}` cannot be run here: {}", operation.name, use->what),
                   .labels = {{use->declaration, "it is C++ from outside"}},
                   .notes = {"generated C++ can: `jrule emit cpp`, or `jrule_add_rules` in CMake"}});
  return false;
}

bool takes_darts(ir::Operation const& operation) {
  return std::any_of(operation.parameters.begin(), operation.parameters.end(), [](ir::Parameter const& p) { return p.dart; });
}

Result<Map> read_input(std::string const& path, ir::Operation const& operation) {
  if (!path.empty()) return read_map(path, operation.model(), operation.modeler->embeddings);
  if (!takes_darts(operation)) return Map(operation.model(), operation.modeler->embeddings);
  return fail(Error::Kind::bad_input, fmt::format("`{}` takes darts of a mesh: give one with `--in`", operation.name));
}

// The darts that `--at` selects, one for each parameter that is a dart; the others by their names.
Result<std::vector<ir::Evaluated>> read_arguments(RunOptions const& options, ir::Operation const& operation, Map const& map) {
  std::vector<NamedType> named;
  std::vector<std::string> darts;
  for (ir::Parameter const& p : operation.parameters) {
    if (p.dart) {
      darts.push_back(p.name);
    } else {
      named.push_back({p.name, p.type, p.default_value.has_value()});
    }
  }
  std::vector<Dart> selected;
  if (!options.at.empty()) {
    auto const selection = select(map, options.at);
    if (!selection) return tl::unexpected(selection.error());
    selected = *selection;
  }
  if (selected.size() != darts.size()) {
    std::string const wanted = darts.empty() ? "has no parameter that is a dart" : fmt::format("takes darts for `{}`", fmt::join(darts, "`, `"));
    return fail(Error::Kind::bad_input, fmt::format("`{}` {}, but `--at` selects {} dart{}{}", operation.name, wanted, selected.size(),
                                                    selected.size() == 1 ? "" : "s", options.at.empty() ? ": write `--at dart:0`" : ""));
  }
  auto const given = parse_arguments(operation.name, named, options.values);
  if (!given) return tl::unexpected(given.error());
  std::vector<ir::Evaluated> arguments;
  std::size_t next_dart = 0, next_value = 0;
  for (ir::Parameter const& p : operation.parameters) {
    if (p.dart) {
      arguments.emplace_back(selected[next_dart++]);
    } else {
      std::optional<Value> const& value = (*given)[next_value++];
      arguments.emplace_back(value ? *value : *p.default_value);
    }
  }
  return arguments;
}

std::string printed(std::optional<ir::Evaluated> const& result) {
  if (!result) return "";
  auto const* dart = std::get_if<Dart>(&*result);
  return dart ? fmt::format(", gives dart {}", *dart) : fmt::format(", gives {}", jrule::to_string(std::get<Value>(*result)));
}

}  // namespace

int run(RunOptions const& options) {
  auto const reference = parse_reference(options.operation);
  if (!reference) {
    print_error(fmt::format("`{}` is not of the form FILE:OPERATION", options.operation));
    return exit_usage;
  }
  auto const compilation = compile(reference->file, options.common);
  ir::Program const& program = compilation->program;
  std::optional<std::size_t> index;
  if (!compilation->diagnostics.has_errors()) {
    index = find(program, *reference);
    if (!index) return exit_usage;
    (void)can_run(program.operations[*index], program, compilation->diagnostics);
  }
  if (compilation->diagnostics.has_errors()) {
    print(compilation->sources, compilation->diagnostics, options.common);
    return status(compilation->diagnostics);
  }
  ir::Operation const& operation = program.operations[*index];

  auto map = read_input(options.in, operation);
  if (!map) return report_error(map.error());
  auto const arguments = read_arguments(options, operation, *map);
  if (!arguments) return report_error(arguments.error());
  rewrite::Workspace workspace;
  Result<std::optional<ir::Evaluated>> result;
  std::size_t count = 0;
  {
    ProgressLine line(operation.name);
    auto const progress = [&](std::size_t applications) {
      line.show(applications);
      return true;
    };
    result = interpreter::run({program, compilation->verdicts}, *index, *map, *arguments, workspace, progress, &count);
  }
  if (!result) return report_error(result.error());
  return write_outcome(*map, {options.out, options.picture, options.stats_json}, fmt::format("the operation `{}`", operation.name),
                       fmt::format("{}: {} rule{} applied{}", operation.name, count, count == 1 ? "" : "s", printed(*result)));
}

}  // namespace jrule::driver
