// Does a rule do to the numbers of cells what it says that it does?
#pragma once

#include "compiler/analysis/plan.h"
#include "compiler/analysis/refusal.h"

namespace jrule::analysis {

/// `expect V' = V + E + F;` is wrong (J0514) if the number is another one in some map; where the number is not known as a sum of
/// cells and darts, it is not decided (J0515). Both refuse the rule. `rule` is accepted apart from that, `plan` is its plan.
Refusals check_expectations(ir::RuleScheme const& rule, Plan const& plan);

}  // namespace jrule::analysis
