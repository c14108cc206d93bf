// `--at SEL`: the darts at which a rule is applied.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "jrule/map.h"
#include "jrule/result.h"

namespace jrule::driver {

/// What a selection asks a map.
struct Selectable {
  int dimension;
  std::size_t dart_count;
  std::function<bool(Dart)> contains;
  std::function<std::optional<std::vector<Dart>>(int)> cells;  ///< the smallest dart of each, ascending; none if there are no such cells
};

/// A dart for each of the comma-separated parts: `dart:N`, or the smallest dart of `vertex:N`, `edge:N`, `face:N`, `volume:N`,
/// cells being numbered by their smallest darts.
Result<std::vector<Dart>> select(Selectable const& map, std::string const& selection);
Result<std::vector<Dart>> select(Map const& map, std::string const& selection);

}  // namespace jrule::driver
