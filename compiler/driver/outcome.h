// What became of a map: written, drawn and counted, or why it is as it was.
#pragma once

#include <string>

#include "jrule/map.h"
#include "jrule/result.h"

namespace jrule::driver {

struct OutcomeOptions {
  std::string out;      ///< the mesh to write
  std::string picture;  ///< an SVG; empty: none
  bool stats_json = false;
};

/// Writes the map and its picture, and prints its counts, as json or after the headline. `changed_by` is what has made it: a fault there
/// must not spread, so the map is checked. The exit status; what goes wrong is printed.
int write_outcome(Map const& map, OutcomeOptions const& options, std::string const& changed_by, std::string const& headline);

/// Prints the error and gives its exit status: exit_refused if the rule or operation does not apply there, else exit_usage.
int report_error(Error const& error);

}  // namespace jrule::driver
