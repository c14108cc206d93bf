// Random rules, how many and from which seed.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "compiler/ir/rule_scheme.h"

namespace jrule::property {

/// A rule is told by numbers: that of a sound operation, and one for each mutation. RapidCheck shrinks the list.
struct RuleCase {
  std::uint64_t operation = 0;
  std::vector<std::uint64_t> mutations;
};
/// Each modeler that `modelers` offers is drawn from; the rule satisfies ir::verify.
ir::RuleScheme make_rule(RuleCase const& rule_case, std::vector<std::shared_ptr<ir::Modeler const>> const& modelers);

/// The number of cases of a property: JRULE_CASES, or else `by_default`.
int case_count(int by_default);
/// Runs `by_default` (or JRULE_CASES) cases from the seed JRULE_SEED (else 1), the same ones each time. False, with the case
/// told on standard output, if one fails. `examine` gets a rule's case and a number for the maps.
bool check_cases(std::string const& description, int by_default, void (*examine)(RuleCase const&, std::uint64_t maps));

}  // namespace jrule::property
