// What outside.jrule takes from C++.
#pragma once

#include <cstdint>
#include <stdexcept>

namespace weather {

struct Cloud {
  std::int64_t drops;
};
struct Flash {};  // not an exception of the standard library

inline double least(double a, double b) { return a < b ? a : b; }
inline double rain(double on) {
  if (on < 0) throw std::domain_error("negative rain");
  if (on > 100) throw Flash{};
  return on;
}
inline Cloud today() { return {3}; }
inline std::int64_t wet(Cloud const& cloud) { return cloud.drops; }

}  // namespace weather
