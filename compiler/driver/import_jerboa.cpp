#include <fmt/format.h>

#include <filesystem>

#include "compiler/driver/commands.h"
#include "compiler/driver/output.h"
#include "compiler/driver/report.h"
#include "compiler/jerboa/read.h"
#include "compiler/jerboa/write.h"
#include "compiler/source/read.h"
#include "compiler/syntax/format.h"
#include "compiler/syntax/parse.h"

namespace jrule::driver {

namespace fs = std::filesystem;

int import_jerboa(ImportOptions const& options) {
  source::Sources sources;
  source::Diagnostics diagnostics;
  auto const text = source::read_file(options.file);
  source::FileId const file = sources.add(options.file, text.value_or(""));
  std::string const name = fs::path(options.file).stem().string() + ".jrule";
  std::string written;
  if (!text) {
    diagnostics.add({.code = source::Code::cannot_read_file, .span = {file, 0, 0}, .message = fmt::format("cannot read the file: {}", text.error())});
  } else if (auto const modeler = jerboa::read(sources, file, diagnostics)) {
    written = jerboa::write(*modeler, fs::path(options.file).filename().string(), diagnostics);
    // Only a modeler beyond the limits of the language has errors here.
    syntax::parse(sources, sources.add(name, written), diagnostics);
  }
  if (options.common.warnings_are_errors) diagnostics.make_errors_of_warnings();
  print(sources, diagnostics, options.common);
  if (int const result = status(diagnostics); result != exit_ok) return result;

  written = syntax::format(written);
  if (options.output.empty()) {
    fmt::print("{}", written);
    return exit_ok;
  }
  fs::path const output = options.output;
  bool const is_file = output.extension() == ".jrule" && !fs::is_directory(output);
  std::string const folder = is_file ? output.parent_path().string() : output.string();
  EmitOptions where;
  where.directory = folder.empty() ? "." : folder;
  return write_outputs(where, {options.file}, {{is_file ? output.filename().string() : name, written}});
}

}  // namespace jrule::driver
