#include "compiler/backend/docs/shapes.h"

namespace jrule::docs {

namespace {

// Pictures are seen from +x, +y and +z, with y up.
Shape cube() {
  double constexpr h = 0.5;
  return {"a cube",
          {{h, h, h}, {h, h, -h}, {-h, h, -h}, {-h, h, h}, {h, -h, h}, {h, -h, -h}, {-h, -h, -h}, {-h, -h, h}},
          {{0, 1, 2, 3}, {0, 4, 5, 1}, {0, 3, 7, 4}, {1, 5, 6, 2}, {2, 6, 7, 3}, {4, 7, 6, 5}}};
}

Shape octahedron() {
  double constexpr r = 0.7;
  return {"an octahedron",
          {{0, r, 0}, {0, 0, r}, {r, 0, 0}, {0, 0, -r}, {-r, 0, 0}, {0, -r, 0}},
          {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}, {5, 2, 1}, {5, 3, 2}, {5, 4, 3}, {5, 1, 4}}};
}

/// Three by three squares, the middle one first.
Shape grid() {
  Shape shape{"a grid", {}, {}, true};
  for (int z = 0; z < 4; ++z) {
    for (int x = 0; x < 4; ++x) shape.points.push_back({x / 3.0 - 0.5, 0, z / 3.0 - 0.5});
  }
  for (std::uint32_t const first : {5U, 0U, 1U, 2U, 4U, 6U, 8U, 9U, 10U}) shape.faces.push_back({first + 5, first + 1, first, first + 4});
  return shape;
}

Shape square() { return {"a square", {{0.5, 0, 0.5}, {0.5, 0, -0.5}, {-0.5, 0, -0.5}, {-0.5, 0, 0.5}}, {{0, 1, 2, 3}}, true}; }

Shape two_squares() {
  double constexpr h = 0.5, near = 0.1, far = 1.1;
  return {"two squares",
          {{-near, 0, h}, {-near, 0, -h}, {-far, 0, -h}, {-far, 0, h}, {near, 0, h}, {far, 0, h}, {far, 0, -h}, {near, 0, -h}},
          {{0, 1, 2, 3}, {4, 5, 6, 7}},
          true,
          true};
}

Shape two_cubes() {
  double constexpr h = 0.5, near = 0.2, far = 1.2;
  Shape shape{"two cubes", {}, {}, false, true};
  for (double const side : {-1.0, 1.0}) {
    for (double const x : {side * near, side * far}) {
      for (Point3 const corner : {Point3{x, h, h}, {x, -h, h}, {x, -h, -h}, {x, h, -h}}) shape.points.push_back(corner);
    }
  }
  // Of the left one from its right face on, of the right one up to its left face.
  shape.faces = {{0, 1, 2, 3},     {7, 6, 5, 4},     {0, 4, 5, 1},   {1, 5, 6, 2},   {2, 6, 7, 3},   {3, 7, 4, 0},
                 {12, 13, 14, 15}, {9, 13, 12, 8},   {10, 14, 13, 9}, {11, 15, 14, 10}, {8, 12, 15, 11}, {8, 11, 10, 9}};
  return shape;
}

}  // namespace

std::vector<Shape> const& shapes() {
  static std::vector<Shape> const all = {two_cubes(), cube(), octahedron(), grid(), two_squares(), square()};
  return all;
}

}  // namespace jrule::docs
