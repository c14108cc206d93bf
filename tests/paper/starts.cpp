#include "tests/paper/starts.h"

#include <filesystem>
#include <stdexcept>

#include "jrule/io.h"

namespace jrule::paper {

Map permutations(Model const& model, Dart darts, std::vector<Cycles> const& dimensions) {
  Map map(model);
  map.add_darts(darts);
  for (auto const& [dimension, cycles] : dimensions) {
    for (auto const& cycle : cycles) {
      for (std::size_t k = 0; k < cycle.size(); ++k) map.set_target(cycle[k], dimension, cycle[(k + 1) % cycle.size()]);
    }
  }
  return map;
}

Map polygon(Model const& model, Dart sides) {
  Cycles edges{0, {}}, corners{1, {}};
  for (Dart k = 0; k < sides; ++k) {
    edges.second.push_back({2 * k, 2 * k + 1});
    corners.second.push_back({2 * k + 1, (2 * k + 2) % (2 * sides)});
  }
  return permutations(model, 2 * sides, {edges, corners});
}

Map flat_volume(Model const& model, Dart sides) {
  Cycles faces{1, {{}, {}}}, edges{2, {}};
  for (Dart k = 0; k < sides; ++k) {
    faces.second[0].push_back(k);
    faces.second[1].push_back(2 * sides - 1 - k);
    edges.second.push_back({k, sides + k});
  }
  return permutations(model, 2 * sides, {faces, edges});
}

Map mesh(Model const& model, std::string const& file) {
  auto path = std::filesystem::path(JRULE_PAPER_DIR) / file;
  if (!std::filesystem::exists(path)) path = std::filesystem::path(JRULE_SOURCE_DIR) / "tests/data" / file;
  Result<Map> map = read_map(path.string(), model, {});
  if (!map) throw std::runtime_error(to_string(map.error()));
  return *map;
}

Map twice(Map const& map) {
  Dart const n = map.dart_limit();
  Map both(map.model());
  both.add_darts(2 * n);
  for (int const i : map.model().dimensions) {
    for (Dart const d : map.darts()) {
      both.set_target(d, i, map.target(d, i));
      both.set_target(n + d, i, n + map.target(d, i));
    }
  }
  return both;
}

Map in_external_volume(Map const& surface) {
  Dart const n = surface.dart_limit();
  Map map(omap(3));
  map.add_darts(2 * n);
  for (Dart const d : surface.darts()) {
    map.set_target(d, 1, surface.target(d, 1));
    map.set_target(n + surface.target(d, 1), 1, n + d);
    map.link(d, 2, surface.target(d, 2));
    map.link(n + d, 2, n + surface.target(d, 2));
    map.link(d, 3, n + d);
  }
  return map;
}

Map in_space(Map const& surface) {
  Map map(gmap(3));
  map.add_darts(surface.dart_limit());
  for (Dart const d : surface.darts()) {
    for (int const i : surface.model().dimensions) map.set_target(d, i, surface.target(d, i));
  }
  return map;
}

}  // namespace jrule::paper
