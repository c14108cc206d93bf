#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "compiler/driver/compile.h"
#include "compiler/driver/report.h"
#include "jrule/io.h"

namespace jrule::driver {

namespace {

int write(CounterexampleFiles const& counterexamples) {
  if (counterexamples.files.empty()) return exit_ok;
  std::error_code error;
  std::filesystem::create_directories(counterexamples.directory, error);  // if it fails, writing says so
  auto const written = write_whole_files(counterexamples.files);
  if (written) return exit_ok;
  print_error(written.error());
  return exit_usage;
}

}  // namespace

int check(CheckOptions const& options) {
  int result = exit_ok;
  for (std::string const& file : options.files) {
    CounterexampleFiles counterexamples{options.counterexamples, {}};
    auto const compilation = compile(file, options.common, options.counterexamples.empty() ? nullptr : &counterexamples);
    result = std::max(result, write(counterexamples));
    print(compilation->sources, compilation->diagnostics, options.common);
    result = std::max(result, status(compilation->diagnostics));
    if (options.common.format == MessageFormat::human && compilation->read()) {
      auto const accepted = std::count_if(compilation->verdicts.begin(), compilation->verdicts.end(), [](auto const& v) { return v.accepted(); });
      auto const shown = compilation->diagnostics.sorted();  // without repetitions
      auto const count = [&](source::Severity severity) {
        return std::count_if(shown.begin(), shown.end(), [&](auto const& d) { return source::severity(d) == severity; });
      };
      auto const errors = count(source::Severity::error), warnings = count(source::Severity::warning);
      fmt::print("{}: {} rule{} accepted", file, accepted, accepted == 1 ? "" : "s");
      if (auto const operations = compilation->program.operations.size(); operations != 0) {
        fmt::print(", {} operation{}", operations, operations == 1 ? "" : "s");
      }
      if (errors != 0) fmt::print(", {} error{}", errors, errors == 1 ? "" : "s");
      if (warnings != 0) fmt::print(", {} warning{}", warnings, warnings == 1 ? "" : "s");
      fmt::print("\n");
    }
  }
  return result;
}

}  // namespace jrule::driver
