// refine IN: subdivides a surface by a rule of the library, and tries a rule of its own where it does not fit.
#include <iostream>

#include "refine.h"  // generated

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  auto mesh = refine::Painted::read(argv[1]);
  if (!mesh) {
    std::cerr << to_string(mesh.error()) << '\n';
    return 1;
  }
  jrule::Dart const corner = 0;
  auto const subdivided = refine::catmull_clark(*mesh, corner);
  if (!subdivided) {
    std::cerr << to_string(subdivided.error()) << '\n';
    return 1;
  }
  jrule::Summary const counts = jrule::summarize(mesh->map());
  std::cout << counts.cells[0] << " vertices, " << counts.cells[1] << " edges, " << counts.cells[2] << " faces\n";
  jrule::Point3 const at = mesh->position(corner);
  std::cout.precision(3);
  std::cout << "at (" << at.x << ", " << at.y << ", " << at.z << ")\n";
  if (auto const cone = refine::cone(*mesh, corner, jrule::Point3{}); !cone) {
    std::cout << "not applicable: " << to_string(cone.error()) << '\n';
  }
  return 0;
}
