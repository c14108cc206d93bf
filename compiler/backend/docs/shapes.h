// The small surfaces that rules are shown on.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "jrule/value.h"

namespace jrule::docs {

struct Shape {
  std::string name;  ///< "a cube"
  std::vector<Point3> points;
  std::vector<std::vector<std::uint32_t>> faces;  ///< the first one is seen from above, and so are its first corner and edge
  bool border = false;
  bool pair = false;  ///< of two parts, whose first and last darts face each other: for what joins the two
};

/// From the first one on a rule is tried: what most rules are about, then what is left for others.
std::vector<Shape> const& shapes();

}  // namespace jrule::docs
