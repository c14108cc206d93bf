// A model: the set of constraints that makes an arc-labelled graph a map.
//
// The paper's D, N, O and E (section 9.1). A graph whose darts have exactly one outgoing and one incoming d-arc for every
// d of D is a combinatorial graph (Def. 10); it is a map of the model if besides every arc of a non-oriented dimension
// has its reverse (Def. 8) and every dart is the source of an ijij-cycle for each exchangeable pair {i, j} (Def. 9).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "jrule/word.h"

namespace jrule {

/// The greatest dimension of a map.
inline constexpr int max_dimension = 9;

struct Model {
  std::string name;             ///< "gmap", "omap", … as a `modeler` names it
  int dimension = 0;            ///< the n of an n-map
  std::vector<int> dimensions;  ///< D, ascending, each in 0..9
  std::uint16_t oriented = 0;   ///< O as a bit set: bit d is set iff d is oriented; N is the rest of D
  std::vector<std::pair<int, int>> exchange;  ///< E: pairs i < j, ascending
  bool closed = false;                        ///< no arc may be a loop

  bool has(int d) const noexcept;
  bool is_oriented(int d) const noexcept { return d >= 0 && d <= max_dimension && ((oriented >> d) & 1U) != 0; }
  bool exchanges(int i, int j) const noexcept;
  /// Position of d in `dimensions`; -1 when d is not in D.
  int column(int d) const noexcept;
  bool operator==(Model const&) const = default;
};

/// Generalized maps: D = 0..n, all non-oriented, {i, j} exchangeable iff i + 2 <= j (Def. 10).
Model gmap(int n);
/// Oriented maps: D = 1..n, 1 oriented (Def. 10).
Model omap(int n);
/// Dual oriented maps: D = 1..n, n oriented.
Model dual_omap(int n);
/// G-maps in which no arc is a loop.
Model closed_gmap(int n);
/// The built-in model of that name ("gmap", "omap", "dual_omap", "closed_gmap"); none if the name or n is unknown.
std::optional<Model> builtin_model(std::string const& name, int n);

/// The orbit type of the model's i-cells (theory: G-maps, all dimensions but i; O-maps, the vertex is the orbit of the
/// words j·i for i < j; dual O-maps, dually). None where the model has no i-cells.
std::optional<OrbitType> cell_orbit(Model const& model, int i);
/// The orbit type of connected components: every dimension.
OrbitType component_orbit(Model const& model);

}  // namespace jrule
