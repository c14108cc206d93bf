// Requirements that ask the same of every dart of the hook's orbit, such as `not any(e@2 == e for e in <0,1,2>(a))`: at all
// orbits at once they are a loop over all darts, and no orbit is walked for them.
#pragma once

#include <optional>
#include <vector>

#include "compiler/ir/rule_scheme.h"

namespace jrule::cpp {

/// What must hold at each dart, or at none.
struct DartTest {
  ir::Bound dart;
  ir::ExprPtr condition;  ///< mentions no other dart
  bool must_hold;
};

/// The requirement as such tests, which hold at all darts of the orbit if and only if it holds; none if it is of another form.
std::optional<std::vector<DartTest>> dart_tests(ir::RuleScheme const& rule, ir::Requirement const& requirement);

}  // namespace jrule::cpp
