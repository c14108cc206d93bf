// NAME=VALUE arguments of a rule.
#pragma once

#include <string>
#include <vector>

#include "compiler/ir/rule_scheme.h"
#include "jrule/result.h"

namespace jrule::driver {

/// One value for each parameter of the rule, from the arguments, else its default. A value is `0.5`, `true`, `0,0,1`,
/// `(0,0,1)` or `Point3(0,0,1)`.
Result<std::vector<Value>> parse_arguments(ir::RuleScheme const& rule, std::vector<std::string> const& arguments);

}  // namespace jrule::driver
