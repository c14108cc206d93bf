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

/// How many more calls of any function here succeed, of mix() alone; negative: all. A test sets them.
inline int calls_left = -1;
inline int mixes_left = -1;
/// Does total() throw?
inline bool total_fails = false;
/// How often grass() was called.
inline int grass_made = 0;

/// The first thing that each function does.
inline void called(char const* function) {
  if (calls_left == 0) throw Rock{function};
  if (calls_left > 0) --calls_left;
}

inline Soil grass() {
  called("grass");
  ++grass_made;
  return Soil("grass", 0.25);
}
inline Soil sand(double part) {
  called("sand");
  return Soil("sand", part);
}

inline Soil mix(Soil const& a, Soil const& b) {
  called("mix");
  if (mixes_left == 0) throw Rock{a.name + " on " + b.name};
  if (mixes_left > 0) --mixes_left;
  return Soil(a.name + "+" + b.name, (a.sand + b.sand) / 2);
}
inline Soil turned(Soil const& soil) {
  called("turned");
  return Soil("turned " + soil.name, soil.sand);
}
inline Soil wet(Soil const& soil, double rain) {
  called("wet");
  if (rain < 0) throw std::domain_error("negative rain");
  return Soil("wet " + soil.name, soil.sand - rain);
}

// One of several of its name.
inline double hardness(double sand) {
  called("hardness");
  return 1 - sand;
}
inline double hardness(Soil const& soil) { return hardness(soil.sand); }
inline double hardest(std::span<Soil const> soils) {
  called("hardest");
  double most = 0;
  for (Soil const& soil : soils) most = std::max(most, 1 - soil.sand);
  return most;
}

using Label = std::int64_t;
inline Label total(std::span<Label const> labels) {
  called("total");
  if (total_fails) throw Rock{"total"};
  return std::accumulate(labels.begin(), labels.end(), Label{0});
}
inline Label next(Label label) {
  called("next");
  return label + 1;
}
inline Label unlabelled() {
  called("unlabelled");
  return 7;
}

inline double lowest(double a, double b) {
  called("lowest");
  return a < b ? a : b;
}
inline bool is_steep(jrule::Point3 a, jrule::Point3 b) {
  called("is_steep");
  return a.z != b.z;
}

}  // namespace geo
