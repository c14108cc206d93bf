#pragma once

#include "jrule/value.h"

namespace jrule::test {

/// A point with the operations that OpenSubdiv asks for.
struct Mixed {
  Point3 point{};
  void Clear() { point = {}; }
  void AddWithWeight(Mixed const& other, double weight) {
    point = {point.x + weight * other.point.x, point.y + weight * other.point.y, point.z + weight * other.point.z};
  }
};

}  // namespace jrule::test
