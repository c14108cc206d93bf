// What the analysis concludes from, as plain data: positions of the arcs that a conclusion rests on.
#pragma once

#include <cstddef>
#include <vector>

#include "compiler/ir/rule_scheme.h"

namespace jrule::analysis {

/// A position among the arcs of one side: those that are written, then those that completion adds.
using ArcIndex = std::size_t;

/// The written left arc that says where a node lies: it leads from a placed node to `node`, or from `node` to a placed one.
struct PlacementEvidence {
  ir::NodeId node = 0;
  ArcIndex arc = 0;
  bool forwards = true;  ///< it leads to `node`
};

/// Why a word acts as ε on the pattern. All arcs are written left arcs.
struct RelationEvidence {
  enum class Kind {
    arc,              ///< of the first hook's component: u·x_s·d = u·w·x_t
    arc_and_reverse,  ///< of a non-oriented dimension, (u, s) to (u·w, t) to (u·w·w', s), which is (u, s)
    cycle,            ///< an ijij-cycle: (u, s) to (u·w, s), which is (u, s)
  } kind = Kind::arc;
  std::vector<ArcIndex> arcs;
};

/// Why the pattern is closed under a dimension.
struct ClosureEvidence {
  int dimension = 0;
  enum class Kind {
    hook_type,   ///< the dimension is in it
    left_word,   ///< it is the word of a left arc
    right_word,  ///< or of a right one
    relation,    ///< it occurs once in a relation whose other letters lead from the pattern into the pattern
  } kind = Kind::hook_type;
  std::size_t index = 0;  ///< of the letter, arc or relation
};

/// Why an arc that is not written is there wherever the left side matches. Its arcs are left arcs, written or implied before.
struct ImpliedEvidence {
  enum class Kind {
    reverse,    ///< of a non-oriented arc
    cycle,      ///< it closes an ijij-cycle of which the left side has three arcs
    placement,  ///< between nodes of the first hook's component: u·x_s·d = u·w·x_t in every map
  } kind = Kind::reverse;
  std::vector<ArcIndex> arcs;
};

}  // namespace jrule::analysis
