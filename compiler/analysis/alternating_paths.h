// What the cycle condition C(i,j) asks of a rule: the walks that it speaks of (paper, Def. 14 to 16).
#pragma once

#include <vector>

#include "compiler/analysis/evidence.h"
#include "compiler/ir/rule_scheme.h"

namespace jrule::analysis {

/// Arcs of one side in order, their dimensions alternating between i and j.
using AlternatingPath = std::vector<ir::Arc const*>;
/// Four arcs that return to their node: an ijij-cycle.
bool closes(AlternatingPath const& path);

/// One side of a completed rule beside the other.
struct SideView {
  ir::Side const& side;
  ir::Side const& other;
  ir::Table table;

  SideView(std::size_t nodes, ir::Side const& s, ir::Side const& o) : side(s), other(o), table(nodes, s) {}
  /// Added on the right, deleted on the left.
  bool changed(ir::Arc const& arc) const { return ir::find_same(other, arc) == nullptr; }
  ArcIndex index_of(ir::Arc const& arc) const { return static_cast<ArcIndex>(&arc - side.arcs.data()); }
  /// The arcs from which a closed cycle is the same cycle: its own, and where both dimensions are non-oriented their reverses.
  std::vector<ir::Arc const*> arcs_of(AlternatingPath const& cycle, Model const& model) const;
  /// At most four steps i, j, i, j from a node; shorter where an arc is not there.
  AlternatingPath walk(ir::NodeId from, int i, int j) const;
  /// The maximal alternating path of changed arcs that starts with this arc; empty if it starts earlier.
  AlternatingPath maximal_from(ir::Arc const& first, int other_dimension) const;
};

/// A walk about which C(i,j) has to hold.
struct CycleObligation {
  bool added;              ///< through added arcs of the right side; else through deleted arcs of the left
  AlternatingPath path;    ///< the four steps from a changed arc; where there are less, a maximal path of changed arcs
  AlternatingPath partner; ///< of a maximal path: that of the other side, in no cycle, with its ends and labels; empty if there is none
  bool four_steps() const { return path.size() == 4; }
};

/// For every changed arc of dimension i or j the four steps from it, or the maximal path that starts with it; deleted arcs first.
/// A path of non-oriented dimensions is the same read backwards: it is listed from one of its ends.
std::vector<CycleObligation> cycle_obligations(SideView const& left, SideView const& right, Model const& model, int i, int j);

}  // namespace jrule::analysis
