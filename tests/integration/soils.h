// What terrain.jrule's values of C++ types are, as text.
#pragma once

#include <string>

#include "geo/soil.hpp"
#include "jrule/embedding.h"

namespace jrule::test {

inline std::string describe_soil(Embedding const& embedding, Handle value) {
  if (embedding.spec().extern_name != "geo::Soil") return std::to_string(embedding.values<geo::Label>()[value]);
  geo::Soil const& soil = embedding.values<geo::Soil>()[value];
  return soil.name + ' ' + std::to_string(soil.sand);
}

}  // namespace jrule::test
