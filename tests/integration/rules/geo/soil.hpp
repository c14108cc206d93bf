// What terrain.jrule takes from outside: a type that can neither be made from nothing nor assigned nor compared, and
// functions that throw when told to.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <numeric>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>

#include <jrule/value.h>

namespace geo {

struct Soil {
  explicit Soil(std::string made_of, double sand_part = 0) : name(std::move(made_of)), sand(sand_part) {}
  std::string name;
  double const sand;
};

/// Not an exception of the standard library.
struct Rock {
  std::string where;
};

/// How many more calls of mix() succeed; negative: all. A test sets it.
inline int mixes_left = -1;
/// Does total() throw?
inline bool total_fails = false;
/// How often grass() was called.
inline int grass_made = 0;

inline Soil grass() {
  ++grass_made;
  return Soil("grass", 0.25);
}
inline Soil sand(double part) { return Soil("sand", part); }

inline Soil mix(Soil const& a, Soil const& b) {
  if (mixes_left == 0) throw Rock{a.name + " on " + b.name};
  if (mixes_left > 0) --mixes_left;
  return Soil(a.name + "+" + b.name, (a.sand + b.sand) / 2);
}
inline Soil turned(Soil const& soil) { return Soil("turned " + soil.name, soil.sand); }
inline Soil wet(Soil const& soil, double rain) {
  if (rain < 0) throw std::domain_error("negative rain");
  return Soil("wet " + soil.name, soil.sand - rain);
}

inline double hardness(Soil const& soil) { return 1 - soil.sand; }
// One of several of its name.
inline double hardness(double sand) { return 1 - sand; }
inline double hardest(std::span<Soil const> soils) {
  double most = 0;
  for (Soil const& soil : soils) most = std::max(most, hardness(soil));
  return most;
}

using Label = std::int64_t;
inline Label total(std::span<Label const> labels) {
  if (total_fails) throw Rock{"total"};
  return std::accumulate(labels.begin(), labels.end(), Label{0});
}
inline Label next(Label label) { return label + 1; }
inline Label unlabelled() { return 7; }

inline double lowest(double a, double b) { return a < b ? a : b; }
inline bool is_steep(jrule::Point3 a, jrule::Point3 b) { return a.z != b.z; }

}  // namespace geo
