#include <fmt/format.h>

#include "compiler/driver/commands.h"
#include "compiler/driver/report.h"

namespace jrule::driver {

int explain(ExplainOptions const& options) {
  if (options.code.empty()) {
    for (source::CodeInfo const& code : source::all_codes()) fmt::print("{}  {}\n", code.number, code.title);
    return exit_ok;
  }
  source::CodeInfo const* const code = source::find_code(options.code);
  if (!code) {
    print_error(fmt::format("there is no code `{}`; `jrule explain` lists all", options.code));
    return exit_usage;
  }
  fmt::print("{}", source::explanation(code->code));
  return exit_ok;
}

}  // namespace jrule::driver
