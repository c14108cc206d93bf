// The only file that knows CLI11.
#include "compiler/driver/command_line.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <map>

#include "compiler/driver/commands.h"
#include "compiler/driver/plugin_host.h"

namespace jrule::driver {

namespace {

void add_common(CLI::App& app, Common& common) {
  app.add_option("-I,--import-dir", common.import_dirs, "folder in which imported modules are looked up")->type_name("DIR")->allow_extra_args(false);
  static std::map<std::string, MessageFormat> const formats{{"human", MessageFormat::human}, {"json", MessageFormat::json}};
  static std::map<std::string, ColorMode> const colors{{"auto", ColorMode::automatic}, {"always", ColorMode::always}, {"never", ColorMode::never}};
  app.add_option("--message-format", common.format, "human, or json: one object a line on standard output")
      ->transform(CLI::Transformer(formats))
      ->type_name("human|json");
  app.add_option_function<std::string>("-W", [&common](std::string const&) { common.warnings_are_errors = true; }, "-Werror: warnings are errors")
      ->check(CLI::IsMember({"error"}))
      ->type_name("error");
  app.add_option("--color", common.color, "colour of messages")->transform(CLI::Transformer(colors))->type_name("auto|always|never");
}

void add_stats(CLI::App& app, bool& json, std::string const& description) {
  app.add_option_function<std::string>("--stats", [&json](std::string const&) { json = true; }, description)
      ->check(CLI::IsMember({"json"}))
      ->type_name("json");
}

// What `in`, `at` and the values are for, in words: the rest is the same for all.
void add_change(CLI::App& app, ChangeOptions& change, char const* in, char const* at, char const* values) {
  app.add_option("--in", change.in, fmt::format("mesh: .obj .off .ply .stl .jmap; {}", in))->type_name("MESH");
  app.add_option("--out", change.out, "mesh to write")->type_name("MESH")->required();
  app.add_option("--at", change.at, at)->type_name("SEL");
  app.add_option("--picture", change.picture, "draw the result")->type_name("SVG");
  add_stats(app, change.stats_json, "print counts of the result as json");
  app.add_option("NAME=VALUE", change.values, values);
}

}  // namespace

int run(int argc, char const* const* argv) {
  CLI::App app("jrule: a compiler for rule schemes on generalized and oriented maps", "jrule");
  app.set_version_flag("--version", std::string("jrule ") + JRULE_VERSION);
  app.require_subcommand(1);
  int status = exit_ok;

  CheckOptions check_options;
  CLI::App& check_command = *app.add_subcommand("check", "parse, type-check and analyse rules");
  add_common(check_command, check_options.common);
  check_command.add_option("FILE", check_options.files, "source files")->required();
  check_command.add_option("--counterexample", check_options.counterexamples, "write a map that each refused rule breaks, as .jmap and SVG")->type_name("DIR");
  check_command.callback([&] { status = check(check_options); });

  EmitOptions emit_options;
  CLI::App& emit_command = *app.add_subcommand("emit", "show a stage of the compilation, or write C++");
  add_common(emit_command, emit_options.common);
  emit_command.add_option("STAGE", emit_options.stage, "ast, ir, jrule, cpp, plugin, dot, svg or certificate; jrule: the rules as one source file")
      ->required()
      ->check(CLI::IsMember({"ast", "ir", "jrule", "cpp", "plugin", "dot", "svg", "certificate"}));
  emit_command.add_option("FILE", emit_options.files, "source file, or FILE:RULE for one rule, e.g. basic.jrule:sew[2]; of a plugin, several files")->required();
  emit_command.add_option("--dimension", emit_options.dimension, "the n of a RULE on gmap(n)")->type_name("N");
  emit_command.add_option("-o,--output", emit_options.directory, "folder to write to instead of standard output")->type_name("DIR");
  emit_command.add_option("--depfile", emit_options.depfile, "write the files that were read, for the build system")->type_name("FILE");
  emit_command.add_flag("--write-if-changed", emit_options.write_if_changed, "leave files alone whose content stays the same");
  emit_command.add_option("--namespace", emit_options.name_space, "C++ namespace of the generated code")->type_name("NAME");
  emit_command.add_option("--header-prefix", emit_options.header_prefix, "folder in the generated #include")->type_name("DIR");
  emit_command.add_option("--name", emit_options.name, "name of the plugin")->type_name("NAME");
  emit_command.callback([&] { status = emit(emit_options); });

  ApplyOptions apply_options;
  CLI::App& apply_command = *app.add_subcommand("apply", "apply a rule to a mesh");
  add_common(apply_command, apply_options.common);
  apply_command.add_option("RULE", apply_options.rule, "FILE:RULE, e.g. surface.jrule:cone; of a plugin, RULE or MODULE:RULE")->required();
  apply_command.add_option("--plugin", apply_options.plugin, "take the rule from a plugin, made by jrule_add_plugin")->type_name("LIB");
  add_change(apply_command, apply_options, "not for rules that create",
             "all, dart:N, vertex:N, edge:N, face:N, volume:N; one for each hook: dart:3,dart:17", "parameters of the rule, e.g. apex=0,0,1");
  apply_command.add_option("--threads", apply_options.threads, "take so many threads at most, for rules applied at all orbits at once; default: all")
      ->check(CLI::Range(1U, 1024U));
  apply_command.callback([&] {
    status = apply_options.plugin.empty() ? apply(apply_options) : apply_plugin(apply_options);
  });

  RunOptions run_options;
  CLI::App& run_command = *app.add_subcommand("run", "run an operation");
  add_common(run_command, run_options.common);
  run_command.add_option("OPERATION", run_options.operation, "FILE:OPERATION, e.g. solid.jrule:house")->required();
  add_change(run_command, run_options, "without it, an empty map",
             "a dart for each parameter that is one: dart:N, vertex:N, edge:N, face:N, volume:N; dart:3,dart:17", "the other parameters, e.g. side=2");
  run_command.callback([&] { status = run(run_options); });

  InfoOptions info_options;
  CLI::App& info_command = *app.add_subcommand("info", "count the cells of a mesh and check it; or list what a plugin offers");
  info_command.add_option("MESH", info_options.mesh, "mesh: .obj .off .ply .stl .jmap; plugin: .so .dylib")->required();
  info_command.add_option("--model", info_options.model, "how a surface is read")
      ->check(CLI::IsMember({"gmap", "omap", "dual_omap", "closed_gmap"}))
      ->type_name("MODEL");
  add_stats(info_command, info_options.stats_json, "print as json");
  info_command.callback([&] { status = is_plugin_path(info_options.mesh) ? info_plugin(info_options) : info(info_options); });

  FormatOptions format_options;
  CLI::App& format_command = *app.add_subcommand("fmt", "bring sources into the canonical layout");
  add_common(format_command, format_options.common);
  format_command.add_flag("--check", format_options.check, "change nothing; exit 1 if a file would change");
  format_command.add_option("FILE", format_options.files, "source files")->required();
  format_command.callback([&] { status = format(format_options); });

  ImportOptions import_options;
  CLI::App& import_command = *app.add_subcommand("import-jerboa", "write the modeler and the rules of a Jerboa modeler as a source file");
  add_common(import_command, import_options.common);
  import_command.add_option("FILE", import_options.file, "modeler, as Jerboa's editor saves it: .jme")->required();
  import_command.add_option("-o,--output", import_options.output, "folder, or .jrule file, to write to instead of standard output")->type_name("DIR|FILE");
  import_command.callback([&] { status = import_jerboa(import_options); });

  ExplainOptions explain_options;
  std::string explain_format;
  CLI::App& explain_command = *app.add_subcommand("explain", "explain the code of a message, or what a rule does to vertices, edges and faces");
  add_common(explain_command, explain_options.common);
  explain_command.add_option("WHAT", explain_options.what, "a code such as J0302, FILE:RULE, or FILE; without it, all codes are listed");
  explain_command.add_option("--dimension", explain_options.dimension, "the n of a RULE on gmap(n)")->type_name("N");
  explain_command.add_option("--format", explain_format, "text, or json: one object a line for each rule")->check(CLI::IsMember({"text", "json"}))->type_name("text|json");
  explain_command.callback([&] {
    explain_options.json = explain_format == "json";
    status = explain(explain_options);
  });

  DocsOptions docs_options;
  CLI::App& docs_command = *app.add_subcommand("docs", "write a page on each file: what it documents, what is proved, and pictures of its rules");
  add_common(docs_command, docs_options.common);
  docs_command.add_option("FILE", docs_options.files, "source files; several get an index, index.html")->required();
  docs_command.add_option("-o,--output", docs_options.directory, "folder to write to; of one file, else to standard output")->type_name("DIR");
  docs_command.callback([&] { status = docs(docs_options); });

  for (char const* const name : {"lsp"}) {
    CLI::App& command = *app.add_subcommand(name, "not yet implemented");
    command.allow_extras();
    command.callback([&status, name] { status = not_implemented(name); });
  }

  try {
    app.parse(argc, argv);
  } catch (CLI::ParseError const& error) {
    // --help and --version come here too, with status 0.
    return app.exit(error) == 0 ? exit_ok : exit_usage;
  }
  return status;
}

}  // namespace jrule::driver
