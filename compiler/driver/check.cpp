#include <fmt/format.h>

#include <algorithm>

#include "compiler/driver/compile.h"
#include "compiler/driver/report.h"

namespace jrule::driver {

int check(CheckOptions const& options) {
  int result = exit_ok;
  for (std::string const& file : options.files) {
    auto const compilation = compile(file, options.common);
    print(compilation->sources, compilation->diagnostics, options.common);
    result = std::max(result, status(compilation->diagnostics));
    if (options.common.format == MessageFormat::human && compilation->read()) {
      auto const accepted = std::count_if(compilation->verdicts.begin(), compilation->verdicts.end(), [](auto const& v) { return v.accepted(); });
      auto const shown = compilation->diagnostics.sorted();  // without repetitions
      auto const errors =
          std::count_if(shown.begin(), shown.end(), [](auto const& d) { return source::info(d.code).severity == source::Severity::error; });
      fmt::print("{}: {} rule{} accepted", file, accepted, accepted == 1 ? "" : "s");
      if (errors != 0) fmt::print(", {} error{}", errors, errors == 1 ? "" : "s");
      fmt::print("\n");
    }
  }
  return result;
}

}  // namespace jrule::driver
