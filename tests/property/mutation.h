// Small changes of a rule that leave most of it right.
#pragma once

#include "compiler/ir/rule_scheme.h"
#include "tests/property/random.h"

namespace jrule::property {

/// The rule with one random change; it satisfies ir::verify. The rule itself if no change was found that does.
ir::RuleScheme mutate(ir::RuleScheme const& rule, Random& random);

/// The same rule in other words: the copies (u, s) of some added nodes s are named (u·g, s).
ir::RuleScheme move_added_copies(ir::RuleScheme const& rule, Random& random);

}  // namespace jrule::property
