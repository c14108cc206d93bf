#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "compiler/backend/cpp/plugin.h"
#include "compiler/driver/compile.h"
#include "compiler/driver/output.h"
#include "compiler/driver/report.h"

namespace jrule::driver {

namespace {

// Their headers have their names.
bool two_are_called_alike(std::vector<std::string> const& files) {
  std::vector<std::string> names;
  for (std::string const& file : files) names.push_back(std::filesystem::path(file).stem().string());
  std::sort(names.begin(), names.end());
  auto const twice = std::adjacent_find(names.begin(), names.end());
  if (twice == names.end()) return false;
  print_error(fmt::format("two files are called `{}`: a plugin takes each name once", *twice));
  return true;
}

}  // namespace

int emit_plugin(EmitOptions const& options) {
  if (two_are_called_alike(options.files)) return exit_usage;
  std::vector<std::unique_ptr<Compilation>> compilations;
  int result = exit_ok;
  for (std::string const& file : options.files) {
    compilations.push_back(compile(file, options.common));
    result = std::max(result, status(compilations.back()->diagnostics));
  }
  std::optional<cpp::GeneratedFile> file;
  if (result == exit_ok) {
    std::vector<cpp::PluginModule> modules;
    for (auto const& compilation : compilations) {
      ir::Program const& program = compilation->program;
      modules.push_back({program, {}, compilation->sources, compilation->diagnostics});
      for (std::size_t i = 0; i < program.rules.size(); ++i)
        modules.back().rules.push_back({&program.rules[i], &compilation->verdicts[i].plan});
    }
    std::string const name = options.name.empty() ? modules.front().program.module : options.name;
    file = cpp::emit_plugin(name, modules, {options.name_space, options.header_prefix});
  }
  std::vector<std::string> sources;
  for (auto const& compilation : compilations) result = std::max(result, status(compilation->diagnostics));
  for (auto const& compilation : compilations) {
    // Warnings are for `emit cpp`, which the same files go through.
    if (result != exit_ok) print(compilation->sources, compilation->diagnostics, options.common);
    sources.insert(sources.end(), compilation->modules.paths.begin(), compilation->modules.paths.end());
  }
  if (!file) return result;
  if (!options.directory.empty())
    return write_outputs(options, sources, {{std::move(file->name), std::move(file->text)}});
  fmt::print("// ---- {} ----\n{}", file->name, file->text);
  return result;
}

}  // namespace jrule::driver
