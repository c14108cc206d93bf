// Does a value depend on which dart of its orbit it is computed at? (theory: section 5)
#pragma once

#include "compiler/algebra/group.h"
#include "compiler/analysis/placement.h"
#include "compiler/analysis/relations.h"

namespace jrule::analysis {

/// A clause's expression is evaluated once for an orbit, at one of the pattern darts whose copies of the clause's node lie in it:
/// u, or u·g for a generator g of the orbit's component. What it reads from u, at u·x_s·w, it reads from u·g at u·g·x_s·w. The two
/// values are the same if each part of the one is the same as a part of the other: values of one orbit, orbits as a whole where the
/// order of their values plays no part; the operands of sums, products and other commutative operations in any order.
class RepresentativeCheck {
 public:
  /// All must outlive this, and be of the same rule.
  RepresentativeCheck(ir::RuleScheme const& rule, algebra::Group const& group, Placement const& placement, PatternWords const& words)
      : rule_(rule), group_(group), placement_(placement), words_(words) {}

  /// The first part of the expression whose value at u·g may not be the one at u, if the whole expression's may not; null if it is
  /// the same in every map. A difference may be one that no map shows: sums are not multiplied out.
  ir::Expr const* changed_by(ir::Expr const& value, Word const& g) const;

 private:
  ir::RuleScheme const& rule_;
  algebra::Group const& group_;
  Placement const& placement_;
  PatternWords const& words_;
};

}  // namespace jrule::analysis
