#include <fmt/format.h>

#include <algorithm>

#include "compiler/driver/commands.h"
#include "compiler/driver/report.h"
#include "compiler/source/read.h"
#include "compiler/syntax/format.h"
#include "compiler/syntax/parse.h"
#include "jrule/io.h"

namespace jrule::driver {

namespace {

int format_file(std::string const& path, FormatOptions const& options) {
  auto const text = source::read_file(path);
  if (!text) {
    print_error(fmt::format("cannot read `{}`: {}", path, text.error()));
    return exit_usage;
  }
  source::Sources sources;
  source::Diagnostics diagnostics;
  syntax::parse(sources, sources.add(path, *text), diagnostics);
  if (diagnostics.has_errors()) {
    print(sources, diagnostics, options.common);
    return exit_refused;
  }
  std::string const formatted = syntax::format(*text);
  if (formatted == *text) return exit_ok;
  if (options.check) {
    fmt::print("{}: not in the canonical layout\n", path);
    return exit_refused;
  }
  if (auto const written = write_whole_file(path, formatted); !written) {
    print_error(written.error());
    return exit_usage;
  }
  return exit_ok;
}

}  // namespace

int format(FormatOptions const& options) {
  int result = exit_ok;
  for (std::string const& file : options.files) result = std::max(result, format_file(file, options));
  return result;
}

}  // namespace jrule::driver
