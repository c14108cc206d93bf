#include <fmt/format.h>

#include <filesystem>

#include "compiler/driver/commands.h"
#include "compiler/driver/reference.h"
#include "compiler/driver/report.h"

namespace jrule::driver {

int explain(ExplainOptions const& options) {
  if (options.what.empty()) {
    for (source::CodeInfo const& code : source::all_codes()) fmt::print("{}  {}\n", code.number, code.title);
    return exit_ok;
  }
  source::CodeInfo const* const code = source::find_code(options.what);
  if (!code && (std::filesystem::exists(options.what) || parse_reference(options.what))) return explain_rule(options);
  if (!code) {
    print_error(fmt::format("there is no code `{}`; `jrule explain` lists all", options.what));
    return exit_usage;
  }
  fmt::print("{}", source::explanation(code->code));
  return exit_ok;
}

}  // namespace jrule::driver
