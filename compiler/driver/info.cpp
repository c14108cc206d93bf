#include <fmt/format.h>

#include "compiler/driver/commands.h"
#include "compiler/driver/report.h"
#include "compiler/driver/summary.h"
#include "jrule/io.h"

namespace jrule::driver {

namespace {

Result<Map> read(InfoOptions const& options) {
  if (options.mesh.ends_with(".jmap")) return read_jmap(options.mesh);
  Model const model = *builtin_model(options.model, 2);
  EmbeddingSpec position;
  position.name = "position";
  position.orbit = *cell_orbit(model, 0);
  position.type = Type::Point3;
  return read_map(options.mesh, model, {position});
}

}  // namespace

int info(InfoOptions const& options) {
  auto const map = read(options);
  if (!map) {
    print_error(map.error());
    return map.error().kind == Error::Kind::bad_input ? exit_refused : exit_usage;
  }
  Summary const summary = summarize(*map);
  if (options.stats_json) {
    fmt::print("{}\n", summary_json(summary));
  } else {
    fmt::print("{}", summary_text(summary));
  }
  return summary.valid ? exit_ok : exit_refused;
}

}  // namespace jrule::driver
