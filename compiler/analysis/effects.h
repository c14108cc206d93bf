// Which cells a rule creates, deletes, splits and merges, and how many there are afterwards (theory: section 7).
//
// A cell is followed by its darts: it is new if none of them existed before, deleted if none is left, split if those that are left
// are of several cells, and cells merge where darts of several are of one afterwards.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compiler/analysis/orbit_count.h"
#include "compiler/analysis/plan.h"

namespace jrule::analysis {

/// Cells that lie alike in the pattern: the copies of the same nodes make them.
struct CellClass {
  std::vector<ir::NodeId> nodes;  ///< on the left of cells before, on the right of cells afterwards
  /// One for each orbit of the pattern under these words; several may be one cell where it reaches out of the matched part.
  OrbitType per;
  bool single = false;        ///< the pattern is one such orbit
  bool reaches_out = false;   ///< the cell may have darts that the rule does not match; never of what is created or deleted
};

struct CellEffects {
  int dimension = 0;
  OrbitType orbit;
  std::vector<CellClass> created;  ///< new cells
  std::vector<CellClass> deleted;  ///< cells before of which nothing is left
  std::vector<CellClass> split;    ///< cells before that are split in some map, as far as is known; all others never are
  std::vector<CellClass> merged;   ///< cells afterwards in which others merge in some map, as far as is known
  std::vector<CellClass> kept;     ///< cells before that are neither deleted nor split, and merge with no other
  /// How many there are afterwards: of a rule on whole components in the component of the hook (or of what was made of it); of any
  /// other, in the map, where all cells that change are wholly matched and known in number. None if it is not known.
  std::optional<OrbitCount> count{};
};

struct Effects {
  std::vector<CellEffects> cells;  ///< by dimension, those that the model has
  std::optional<OrbitCount> darts;  ///< their number afterwards, likewise
  bool whole = false;  ///< the rule is on whole components: its hook's type is all of one; or it creates, without a hook
};

/// Of an accepted rule with its plan. What is said of new, deleted and kept cells, and all counts, hold in every application.
Effects analyze_effects(ir::RuleScheme const& rule, Plan const& plan);

/// Why the number of cells (or of darts) is not known, for a message; it must have none.
std::string why_no_count(ir::RuleScheme const& rule, Effects const& effects, CellEffects const* cells);

}  // namespace jrule::analysis
