#include "compiler/analysis/pattern.h"

#include <algorithm>

namespace jrule::analysis {

bool Pattern::fills_components() const {
  auto const& dimensions = rule.model().dimensions;
  return std::all_of(dimensions.begin(), dimensions.end(),
                     [&](int d) { return group.in_orbit({Letter{static_cast<std::uint8_t>(d), false}}, hook_orbit); });
}

}  // namespace jrule::analysis
