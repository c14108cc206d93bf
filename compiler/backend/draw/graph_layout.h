// Where the darts of a small graph are drawn.
#pragma once

#include <utility>
#include <vector>

#include "jrule/map.h"

namespace jrule::draw {

struct Position {
  double x = 0, y = 0;
};

/// Places `count` darts so that those with a link lie near each other and others apart: from a circle, in the order in
/// which links reach them, by Fruchterman's and Reingold's springs. Neighbours come about 1 apart. Equal input, equal
/// layout.
std::vector<Position> spring_layout(std::size_t count, std::vector<std::pair<Dart, Dart>> const& links);

}  // namespace jrule::draw
