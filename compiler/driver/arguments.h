// NAME=VALUE arguments of a rule.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compiler/ir/rule_scheme.h"
#include "jrule/result.h"

namespace jrule::driver {

struct NamedType {
  std::string name;
  Type type;
  bool has_default;
};
/// One value for each parameter of the rule, none where no argument gives one and there is a default. A value is `0.5`, `true`,
/// `0,0,1`, `(0,0,1)` or `Point3(0,0,1)`.
Result<std::vector<std::optional<Value>>> parse_arguments(std::string const& rule, std::vector<NamedType> const& parameters,
                                                          std::vector<std::string> const& arguments);

/// The same with the defaults, of which none is computed by C++ from outside.
Result<std::vector<Value>> parse_arguments(ir::RuleScheme const& rule, std::vector<std::string> const& arguments);

}  // namespace jrule::driver
