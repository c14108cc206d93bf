// `--at SEL`: the darts at which a rule is applied.
#pragma once

#include <string>
#include <vector>

#include "jrule/map.h"
#include "jrule/result.h"

namespace jrule::driver {

/// A dart for each of the comma-separated parts: `dart:N`, or the smallest dart of `vertex:N`, `edge:N`, `face:N`, `volume:N`,
/// cells being numbered by their smallest darts.
Result<std::vector<Dart>> select(Map const& map, std::string const& selection);

}  // namespace jrule::driver
