// Names of Jerboa as names of jrule.
#pragma once

#include <set>
#include <string>
#include <string_view>

namespace jrule::jerboa {

/// The names of one scope, each given once.
class Names {
 public:
  /// `wanted`, if it is a name of the language and free; else the nearest that is.
  std::string take(std::string_view wanted);

 private:
  std::set<std::string, std::less<>> taken_;
};

}  // namespace jrule::jerboa
