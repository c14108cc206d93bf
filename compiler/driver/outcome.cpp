#include "compiler/driver/outcome.h"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>
#include <vector>

#include "compiler/backend/draw/draw.h"
#include "compiler/driver/commands.h"
#include "compiler/driver/report.h"
#include "compiler/driver/summary.h"
#include "jrule/io.h"

namespace jrule::driver {

int report_error(Error const& error) {
  print_error(error);
  using enum Error::Kind;
  return error.kind == not_applicable || error.kind == limit || error.kind == cancelled ? exit_refused : exit_usage;
}

int write_outcome(Map const& map, OutcomeOptions const& options, std::string const& changed_by, std::string const& headline) {
  // The analysis has proved that this cannot be; the output is checked all the same.
  if (auto const violation = find_violation(map)) throw std::logic_error(fmt::format("{} broke the map: {}", changed_by, violation->text));
  std::vector<FileText> files;
  if (!options.picture.empty()) {
    auto picture = draw::surface_svg(map);
    if (!picture) return report_error(picture.error());
    files.push_back({options.picture, std::move(*picture)});
  }
  auto text = map_text(map, options.out);
  if (!text) return report_error(text.error());
  files.push_back({options.out, std::move(*text)});
  if (auto const written = write_whole_files(files); !written) return report_error(written.error());
  Summary const summary = summarize(map);
  if (options.stats_json) {
    fmt::print("{}\n", summary_json(summary));
  } else {
    fmt::print("{}\n{}", headline, summary_text(summary));
  }
  return exit_ok;
}

}  // namespace jrule::driver
