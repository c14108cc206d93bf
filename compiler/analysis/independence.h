// May a rule be applied at every orbit of its hook at once (theory: section 7)?
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compiler/analysis/plan.h"

namespace jrule::analysis {

/// Why applications of a rule at two orbits of its hook may disturb each other, in some map.
struct Dependence {
  enum class Kind {
    hooks,     ///< there is no hook, or there are several: no orbits to apply the rule at
    pattern,   ///< two orbits of the hook may be of one pattern
    deletion,  ///< a dart that one application deletes may be matched by another
    arc,       ///< an arc that one application removes may be matched by another
    value,     ///< two applications may give one orbit a value
    path,      ///< one step of an orbit's words may use new arcs of two applications
  } kind = Kind::hooks;
  /// The two nodes that match one dart, each in its application; of `value`, if `second` is none, the node whose orbit reaches
  /// beyond the matched part.
  std::optional<ir::NodeId> first{}, second{};
  int dimension = -1;                      ///< of `arc`; of `value`, in which the orbit leaves the matched part
  std::optional<std::size_t> embedding{};  ///< of `value` and `path`
  source::Span span{};                     ///< what to point at: a hook, an arc, a node, a clause
  std::string text{};                      ///< as a note says it
};

struct Independence {
  std::vector<Dependence> reasons;  ///< empty iff the rule is proved independent
  bool independent() const { return reasons.empty(); }
};

/// Are applications at any two distinct orbits of the hook's type parallel independent, in every map of the model? Then all of
/// them together give what they give one after another, in any order: the same map up to the names of new darts. That is proved
/// or not: what is refused may yet be independent. `plan` is that of the accepted rule. Of each pair of nodes only the first
/// reason is told.
///
/// Values are those of an application of all at once, where expressions and requirements see the map before: no order gives
/// those. Each orbit of the result gets one value: that of the only application whose clause gives it one; else, if several
/// orbits are merged in it, what the policy makes of all their values; else the value that its darts had.
Independence analyze_independence(ir::RuleScheme const& rule, Plan const& plan);

}  // namespace jrule::analysis
