// The shapes to which the tests of the library apply its rules.
#pragma once

#include <string>
#include <vector>

#include "compiler/ir/rule_scheme.h"
#include "tests/smoothing/polygons.h"

namespace jrule::test {

/// Faces turn to the left seen from outside, so that they make an O-map too.
struct Shape {
  std::string name;
  Polygons polygons;
};

/// The five Platonic solids.
std::vector<Shape> const& platonic_solids();
/// The same, a torus of 4 × 4 quads, and the bunny: all closed surfaces.
std::vector<Shape> const& closed_surfaces();
/// A prism on a polygon of n sides.
Shape prism(std::size_t n);
/// n × m quads in a plane.
Shape grid(std::size_t n, std::size_t m);
/// A strip of n quads with half a turn, which has one side.
Shape moebius(std::size_t n);
/// Every face cut into triangles around its centre.
Shape kis(Shape shape);

/// A map of a modeler on gmap(2) or omap(2) whose first embedding is of points on vertices; others have their defaults.
/// Faces become darts in their order. A free edge stays a loop: none for an O-map.
Map build(ir::Modeler const& modeler, Polygons const& polygons);

/// Volumes that share points: of each, its faces, which turn to the left seen from outside.
struct Solid {
  std::string name;
  std::vector<Point3> points;
  std::vector<std::vector<Vertices>> volumes;
};
/// The Platonic solids, one volume each; the same with a volume outside, so that there is no border; a prism, and
/// blocks of cubes.
std::vector<Solid> const& solids();
/// n × m × k cubes.
Solid block(std::size_t n, std::size_t m, std::size_t k);

/// With a volume of all faces that belong to one volume only, turned round.
Solid with_outside(Solid solid);

/// A map of a modeler on gmap(3) or omap(3), likewise. Faces with the same vertices are glued. An O-map needs the
/// outside.
Map build(ir::Modeler const& modeler, Solid const& solid);

}  // namespace jrule::test
