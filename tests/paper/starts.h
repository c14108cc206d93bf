// The maps to which the papers' rules are applied.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "jrule/map.h"

namespace jrule::paper {

/// A free n-gon of a G-map. Darts 2k and 2k + 1 are the ends of its k-th edge.
Map polygon(Model const& model, Dart sides);
/// Two n-gons of a 2-O-map back to back: darts 0..n-1 are one face, n..2n-1 the other.
Map flat_volume(Model const& model, Dart sides);
/// A surface from a file of tests/data or of this folder.
Map mesh(Model const& model, std::string const& file);

/// The cycles of one dimension's permutation; darts that are in none have a loop.
using Cycles = std::pair<int, std::vector<std::vector<Dart>>>;
Map permutations(Model const& model, Dart darts, std::vector<Cycles> const& dimensions);

/// Two copies side by side.
Map twice(Map const& map);
/// The volume that a 2-O-map bounds as a 3-O-map, 3-linked to the external volume, its mirror image.
Map in_external_volume(Map const& surface);
/// A 2-G-map as a 3-G-map whose 3-arcs are all loops.
Map in_space(Map const& surface);

}  // namespace jrule::paper
