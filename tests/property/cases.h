// Random rules, and how many of them.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <memory>
#include <string>
#include <vector>

#include <rapidcheck.h>

#include "compiler/ir/rule_scheme.h"
#include "tests/property/sites.h"

namespace jrule::property {

/// A case is told by numbers: that of a sound operation, one for each mutation of it, one for the maps that it is applied to.
struct Case {
  std::uint64_t operation = 0;
  std::vector<std::uint64_t> mutations;
  std::uint64_t maps = 0;
};
std::ostream& operator<<(std::ostream& out, Case const& c);

/// RapidCheck shrinks a case by leaving out mutations. It draws the same cases each time: as many as JRULE_CASES says (else
/// 10000), from the seed JRULE_SEED (else 1); RC_PARAMS overrides both.
rc::Gen<Case> cases();
int case_count();
std::uint64_t case_seed();

/// The rule of a case, on a random one of the models; it satisfies ir::verify.
ir::RuleScheme make_rule(Case const& c, std::shared_ptr<ir::Modeler const> (*modeler_of)(Model const&));
/// Maps and hooks: some where the rule matches, and some where it may not. Smaller ones first.
std::vector<Site> make_sites(Case const& c, ir::RuleScheme const& rule);

/// What a failing property says of its case: the rule, the map and the hooks.
std::string describe(ir::RuleScheme const& rule, Site const& site);

}  // namespace jrule::property
