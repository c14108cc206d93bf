#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "compiler/analysis/certify.h"
#include "compiler/backend/cpp/emit.h"
#include "compiler/backend/draw/draw.h"
#include "compiler/backend/text/print_jrule.h"
#include "compiler/driver/compile.h"
#include "compiler/driver/output.h"
#include "compiler/driver/reference.h"
#include "compiler/driver/report.h"
#include "compiler/syntax/format.h"

namespace jrule::driver {

namespace fs = std::filesystem;

namespace {

std::string file_name(std::string const& rule, std::string const& suffix) {
  std::string name = rule + suffix;
  std::erase(name, ']');
  std::replace_if(name.begin(), name.end(), [](char c) { return c == '[' || c == ','; }, '_');
  return name;
}

std::vector<Output> produce(EmitOptions const& options, Compilation& compilation, bool one_rule) {
  std::vector<Output> outputs;
  ir::Program const& program = compilation.program;
  if (options.stage == "ast") {
    outputs.push_back({program.module + ".ast", syntax::dump(compilation.modules.all.back().ast)});
  } else if (options.stage == "ir") {
    std::string text;
    for (auto const& modeler : program.modelers) text += ir::print(*modeler) + "\n";
    for (ir::RuleScheme const& rule : program.rules) text += ir::print(rule) + "\n";
    for (ir::Operation const& operation : program.operations) text += ir::print(operation, program) + "\n";
    outputs.push_back({program.module + ".ir", std::move(text)});
  } else if (options.stage == "jrule") {
    auto text = text::print_jrule(program);
    if (text) {
      outputs.push_back({file_name(one_rule ? program.rules[0].name : program.module, ".jrule"), std::move(*text)});
    } else {
      compilation.diagnostics.add({.code = source::Code::unspellable_program, .span = {},
                                   .message = fmt::format("`{}` cannot be written as one source file: {}", program.module, text.error().reason)});
    }
  } else if (options.stage == "dot") {
    for (ir::RuleScheme const& rule : program.rules) outputs.push_back({file_name(rule.name, ".dot"), draw::rule_dot(rule)});
  } else if (options.stage == "svg") {
    for (ir::RuleScheme const& rule : program.rules) outputs.push_back({file_name(rule.name, ".svg"), draw::rule_svg(rule)});
  } else if (options.stage == "certificate") {
    for (std::size_t i = 0; i < program.rules.size(); ++i) {
      ir::RuleScheme const& rule = program.rules[i];
      if (!compilation.verdicts[i].accepted()) continue;
      outputs.push_back({file_name(rule.name, ".certificate"), analysis::print(analysis::certify(rule), rule, compilation.sources)});
    }
  } else if (options.stage == "cpp") {
    std::vector<cpp::Rule> rules;
    for (std::size_t i = 0; i < program.rules.size(); ++i) rules.push_back({&program.rules[i], &compilation.verdicts[i].plan});
    for (auto& file : cpp::emit(program, rules, compilation.sources, {options.name_space, options.header_prefix}, compilation.diagnostics)) {
      outputs.push_back({std::move(file.name), std::move(file.text)});
    }
  }
  return outputs;
}

}  // namespace

int emit(EmitOptions const& options) {
  if (options.directory.empty() && (!options.depfile.empty() || options.write_if_changed)) {
    print_error("`--depfile` and `--write-if-changed` need a folder to write to: `-o DIR`");
    return exit_usage;
  }
  if (options.stage == "plugin") return emit_plugin(options);
  if (options.files.size() > 1) {
    print_error(fmt::format("`emit {}` shows one file, `emit plugin` takes several", options.stage));
    return exit_usage;
  }
  std::string const& file = options.files.front();
  // A file may have a colon in its name.
  auto const reference = fs::exists(file) ? std::nullopt : parse_reference(file);
  if (reference && options.stage == "ast") {
    print_error("`emit ast` shows files, not rules");
    return exit_usage;
  }
  auto const compilation = compile(reference ? reference->file : file, options.common);
  bool const found = compilation->read() && (!reference || keep_only(*reference, options.dimension, *compilation));
  // What a rule looks like can be shown even if it is refused; C++ is printed only for rules that are all accepted.
  std::vector<Output> outputs;
  bool const clean = !compilation->diagnostics.has_errors();
  if (found && (clean || options.stage != "cpp")) outputs = produce(options, *compilation, reference.has_value());
  print(compilation->sources, compilation->diagnostics, options.common);
  int const result = status(compilation->diagnostics);
  if (options.stage == "cpp" && result != exit_ok) return result;
  if (!options.directory.empty() && compilation->read()) {
    int const written = write_outputs(options, compilation->modules.paths, outputs);
    return written == exit_ok ? result : written;
  }
  for (Output const& output : outputs) {
    if (options.stage == "cpp") fmt::print("// ---- {} ----\n", output.name);
    fmt::print("{}", output.text);
  }
  return result;
}

int not_implemented(std::string const& command) {
  source::Diagnostics diagnostics;
  diagnostics.add({.code = source::Code::stage_not_implemented, .span = {}, .message = fmt::format("`jrule {}` is not yet implemented", command)});
  print(source::Sources{}, diagnostics, {});
  return exit_usage;
}

}  // namespace jrule::driver
