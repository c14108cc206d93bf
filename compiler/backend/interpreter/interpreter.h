// IR -> application on a runtime map, without a C++ compiler.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "compiler/analysis/plan.h"
#include "compiler/ir/rule_scheme.h"
#include "jrule/rewrite.h"

namespace jrule::interpreter {

/// What an application did: for each right node the darts of its copies, by pattern dart.
struct Applied {
  std::vector<std::vector<Dart>> copies;  ///< by node; empty for deleted nodes
  std::size_t pattern_size = 0;
};

/// Applies an accepted rule at these darts, one for each hook, with one value for each parameter. On an error the map is bit
/// for bit as it was. The rule must need no C++ from outside (ir::find_extern_use). `workspace` may be used for other maps as well.
Result<Applied> apply(ir::RuleScheme const& rule, analysis::Plan const& plan, Map& map, std::vector<Dart> const& hooks,
                      std::vector<Value> const& arguments, rewrite::Workspace& workspace);

/// Applies it once for each orbit of the first hook's type, in the order of their smallest darts as numbered before the first
/// application; orbits where it is not applicable are left as they are. Returns how often it was applied; the first refusal
/// if nowhere, and then the map is as it was. For rules with one hook.
Result<std::size_t> apply_everywhere(ir::RuleScheme const& rule, analysis::Plan const& plan, Map& map,
                                     std::vector<Value> const& arguments, rewrite::Workspace& workspace);

/// Applies it at all these orbits at once: all expressions see the map before, and orbits where the rule is not applicable then are
/// left as they are. Returns at how many it was applied; the first one's refusal if nowhere. On an error the map is bit for bit as it
/// was. The rule must be proved independent (analysis/independence.h). The new darts of each added node are consecutive if
/// no dart is erased, by the pattern's darts ascending; a merged orbit gets what its policy makes of all values that come
/// together in it. O(darts of the map and of the result), apart from expressions. The map is bit for bit the same for any number of
/// threads.
Result<std::size_t> apply_all(ir::RuleScheme const& rule, analysis::Plan const& plan, Map& map,
                              std::vector<Value> const& arguments, rewrite::Workspace& workspace, Threads threads = {});

/// The same at the orbits of its hook inside ⟨within⟩(d), of which the hook's type is a subgroup; `d` must be in the map.
/// O(darts of that orbit and of the result), up to a logarithm.
Result<std::size_t> apply_all_within(ir::RuleScheme const& rule, analysis::Plan const& plan, Map& map, OrbitType const& within, Dart d,
                                     std::vector<Value> const& arguments, rewrite::Workspace& workspace);

}  // namespace jrule::interpreter
