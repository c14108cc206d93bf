// The heights of a massif, from a table of its mountains: what a program knows and rules do not.
#pragma once

#include <jrule/value.h>

#include <cmath>

namespace relief {

struct Mountain {
  double x, z;    // m
  double height;  // m
  double radius;  // m
};

inline constexpr Mountain mountains[] = {
    {-60, -110, 130, 90}, {70, -60, 90, 80}, {140, 120, 50, 60}, {-150, 60, 60, 70}, {0, 0, 60, 260},
};

/// [m] of the ground.
inline double height(jrule::Point3 place) {
  double sum = 0;
  for (Mountain const& m : mountains) {
    double const dx = (place.x - m.x) / m.radius, dz = (place.z - m.z) / m.radius;
    sum += m.height * std::exp(-dx * dx - dz * dz);
  }
  return sum;
}

}  // namespace relief
