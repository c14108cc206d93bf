// All to which the rules of the library are applied to see what they do: surfaces and solids, closed and open, with one
// side and two, with corners of two edges and faces of two corners.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tests/stdlib/shapes.h"

namespace jrule::test {

struct Subject {
  std::string name;
  std::string shape;  ///< different for different maps, while its name is that of the G-map of the same shape
  Map map;
  /// It has no border, in a G-map either: as an O-map every shape is closed, its holes being faces, what is outside a
  /// volume.
  bool closed;
};

/// Maps of a modeler on gmap or omap of dimension 2 or 3, whose first embedding is of points on vertices. Of two
/// modelers of one dimension, subjects of the same name are the same shape; dart d of the O-map is dart 2d of the G-map
/// where that has one. For O-maps those with one side are left out, and faces of solids that stand by themselves.
std::vector<Subject> subjects(ir::Modeler const& modeler);
/// Of gmap(2), the open ones with two sides of faces that are open themselves: what rules make on their way.
std::vector<Subject> unfinished_subjects(ir::Modeler const& modeler);
/// Of gmap(n), 1 ≤ n ≤ 3, without values; no two are alike.
std::vector<Subject> bare_subjects(int n);

/// The cells of each dimension, with each hole as a face, of a solid what is outside as a volume: those of the O-map of
/// the same shape.
std::vector<std::size_t> closed_cells(Map const& map);

/// The arcs of a map, without its values.
Map bare(Map const& map);
/// n edges one after the other, open or round: a 1-G-map.
Map path(Dart n, bool round);

}  // namespace jrule::test
