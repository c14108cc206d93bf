// Units of parameters, which their documentation begins with: `/// [m] length of a side`.
#pragma once

#include <string>

namespace jrule::sema {

struct Documented {
  std::string unit;  ///< "m"; empty if none is given
  std::string doc;   ///< the rest
};
/// A unit stands in brackets on the first line. An interval (`[0, 1]`) and a link (`[text](address)`) are none.
Documented split_unit(std::string const& doc);

}  // namespace jrule::sema
