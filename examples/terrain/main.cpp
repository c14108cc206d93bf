// terrain landscape|massif OUT: the operations of terrain.jrule and massif.jrule, called from a program.
#include <iostream>
#include <string>
#include <vector>

#include "massif.h"   // generated: the operation `massif`
#include "terrain.h"  // generated: the class Terrain, and a function for each rule and operation

namespace {

int fail(jrule::Error const& error) {
  std::cerr << to_string(error) << '\n';
  return 1;
}

/// How much of the ground is under water.
double wet_part(terrain::Terrain const& ground) {
  std::vector<jrule::Dart> const fields = ground.cells(2);
  double wet = 0;
  for (jrule::Dart const field : fields) wet += ground.wet(field) ? 1 : 0;
  return wet / static_cast<double>(fields.size());
}

}  // namespace

int main(int argc, char** argv) {
  std::string const what = argc == 3 ? argv[1] : "";
  if (what != "landscape" && what != "massif") {
    std::cerr << "usage: terrain landscape|massif OUT\n";
    return 2;
  }
  terrain::Terrain ground;
  auto const mouth = what == "massif" ? massif::massif(ground) : terrain::landscape(ground);
  if (!mouth) return fail(mouth.error());

  jrule::Summary const s = jrule::summarize(ground.map());
  jrule::Point3 const end = ground.position(*mouth);
  std::cout << s.cells[2] << " fields, " << static_cast<int>(100 * wet_part(ground) + 0.5)
            << "% under water; the river ends at (" << static_cast<int>(end.x) << ", " << static_cast<int>(end.z)
            << ")\n";

  auto const written = ground.write(argv[2]);
  return written ? 0 : fail(written.error());
}
