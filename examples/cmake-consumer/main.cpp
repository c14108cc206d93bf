// refine IN OUT: splits every face of a surface into quads, and tries to raise a cone where none fits.
#include <iostream>

#include "surface.h"  // generated: the class Surface, and a function for each rule

namespace {

void print_counts(char const* when, surface::Surface const& mesh) {
  jrule::Summary const s = jrule::summarize(mesh.map());
  std::cout << when << ": " << s.cells[0] << " vertices, " << s.cells[1] << " edges, " << s.cells[2] << " faces\n";
}

int fail(jrule::Error const& error) {
  std::cerr << to_string(error) << '\n';
  return 1;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "usage: refine IN OUT\n";
    return 2;
  }
  auto mesh = surface::Surface::read(argv[1]);
  if (!mesh) return fail(mesh.error());
  print_counts("read", *mesh);

  auto const subdivided = surface::quad_subdivision_everywhere(*mesh);
  if (!subdivided) return fail(subdivided.error());
  print_counts("subdivided", *mesh);

  // A cone needs a face without neighbours. Where there is none the mesh stays as it is.
  jrule::Dart const face = mesh->cells(2).front();
  if (auto const cone = surface::cone(*mesh, face, jrule::Point3{0, 0, 2}); !cone) {
    std::cout << "not applicable: " << to_string(cone.error()) << '\n';
  } else {
    mesh->set_position(cone->d, mesh->position(cone->d) + jrule::Vec3{0, 0, 1});
  }
  print_counts("written", *mesh);

  auto const written = mesh->write(argv[2]);
  return written ? 0 : fail(written.error());
}
