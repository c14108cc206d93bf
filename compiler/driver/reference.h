// Rules as the command line names them.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace jrule::driver {

/// `surface.jrule:cone`, `basic.jrule:sew[2]`
struct RuleReference {
  std::string file, rule;
  std::vector<int> dimensions;
};

/// None if the text is not of the form FILE:RULE or FILE:RULE[2,1].
std::optional<RuleReference> parse_reference(std::string const& text);

}  // namespace jrule::driver
