#include "tests/property/sites.h"

#include <algorithm>
#include <map>
#include <set>

namespace jrule::property {

namespace {

using Faces = std::vector<std::vector<int>>;

Faces polygon(int n) {
  Faces faces(1);
  for (int k = 0; k < n; ++k) faces[0].push_back(k);
  return faces;
}

Faces prism(int n) {
  Faces faces{{}, {}};
  for (int k = 0; k < n; ++k) {
    int const next = (k + 1) % n;
    faces[0].push_back(n - 1 - k);
    faces[1].push_back(n + k);
    faces.push_back({k, next, n + next, n + k});
  }
  return faces;
}

Faces pyramid(int n) {
  Faces faces(1);
  for (int k = 0; k < n; ++k) {
    faces[0].push_back(n - 1 - k);
    faces.push_back({k, (k + 1) % n, n});
  }
  return faces;
}

/// Open, or closed to a torus.
Faces grid(int width, int height, bool torus) {
  Faces faces;
  int const columns = torus ? width : width + 1, rows = torus ? height : height + 1;
  auto const at = [&](int x, int y) { return (y % rows) * columns + x % columns; };
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) faces.push_back({at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)});
  }
  return faces;
}

Faces random_faces(Random& random) {
  auto const n = static_cast<int>(random.between(1, 5)), m = static_cast<int>(random.between(1, 3));
  switch (random.below(6)) {
    case 0: return polygon(n);
    case 1: return prism(n);
    case 2: return pyramid(std::max(n, 2));
    case 3: return grid(m, static_cast<int>(random.between(1, 2)), false);
    case 4: return grid(m, static_cast<int>(random.between(1, 2)), true);
    default: {
      Faces faces = polygon(n);
      for (std::size_t k = random.below(3); k > 0; --k) {
        Faces const more = polygon(static_cast<int>(random.between(1, 4)));
        faces.push_back({});
        for (int const v : more[0]) faces.back().push_back(100 * static_cast<int>(k) + v);
      }
      return faces;
    }
  }
}

/// The dimensions that turn around a face and cross an edge: 0, 1, 2 of G-maps, 1 and 2 of O-maps, n and n-1 of their duals.
bool add_surface(Growth& growth, Model const& model, Faces const& faces) {
  bool const flags = !model.is_oriented(model.dimensions.front()) && model.has(0) && model.has(1);
  int const turn = flags ? 1 : model.is_oriented(1) ? 1 : model.dimension;
  int const cross = flags ? 2 : turn == 1 ? 2 : model.dimension - 1;
  if (!flags && (!model.has(turn) || !model.is_oriented(turn))) return false;
  std::map<std::pair<int, int>, Dart> starts;  // of the side of a face from one vertex to the next
  bool sound = true;
  auto const set = [&](Dart a, int d, Dart b) { sound = sound && growth.set(a, d, b); };
  for (auto const& face : faces) {
    std::vector<Dart> darts;
    for (std::size_t k = 0; k < face.size() * (flags ? 2 : 1); ++k) darts.push_back(growth.add_dart());
    for (std::size_t k = 0; k < face.size(); ++k) {
      std::size_t const next = (k + 1) % face.size();
      if (flags) {
        set(darts[2 * k], 0, darts[2 * k + 1]);
        set(darts[2 * k + 1], 1, darts[2 * next]);
      } else {
        set(darts[k], turn, darts[next]);
      }
      starts.emplace(std::pair(face[k], face[next]), darts[flags ? 2 * k : k]);
    }
  }
  if (!model.has(cross)) return sound;
  for (auto const& [ends, dart] : starts) {
    auto const other = starts.find({ends.second, ends.first});
    if (other == starts.end() || other->second == dart) continue;
    if (!flags) {
      set(dart, cross, other->second);
    } else {
      set(dart, cross, growth.target(other->second, 0));
    }
  }
  return sound;
}

Map product(Map const& a, Map const& b) {
  Map map(a.model());
  auto const rows = static_cast<Dart>(b.dart_limit());
  map.add_darts(a.dart_count() * b.dart_count());
  for (Dart x = 0; x < a.dart_limit(); ++x) {
    for (Dart y = 0; y < rows; ++y) {
      for (int const d : a.model().dimensions) map.set_target(x * rows + y, d, a.target(x, d) * rows + b.target(y, d));
    }
  }
  return map;
}

Map disjoint_union(Map const& a, Map const& b) {
  Map map = a;
  auto const first = static_cast<Dart>(a.dart_limit());
  map.add_darts(b.dart_count());
  for (Dart y = 0; y < b.dart_limit(); ++y) {
    for (int const d : a.model().dimensions) map.set_target(first + y, d, first + b.target(y, d));
  }
  return map;
}

std::optional<Map> random_map(Model const& model, Random& random) {
  Growth growth(model);
  if (random.chance(50)) {
    if (!add_surface(growth, model, random_faces(random))) return {};
  } else {
    for (std::size_t k = random.between(1, 12); k > 0; --k) growth.add_dart();
  }
  return growth.complete(random, std::max<std::size_t>(growth.size(), 4) + random.below(10));
}

std::vector<int> letters_of(ir::RuleScheme const& rule) {
  std::set<int> letters;
  for (Letter const l : rule.hook_type) letters.insert(l.dimension);
  for (ir::Side const* side : {&rule.left, &rule.right}) {
    for (ir::Arc const& arc : side->arcs) {
      for (Letter const l : arc.word) letters.insert(l.dimension);
    }
  }
  return {letters.begin(), letters.end()};
}

/// The model of the letters alone: what a pattern is before the rest of the map is there.
Model restricted(Model model, std::vector<int> const& dimensions) {
  model.dimensions = dimensions;
  std::erase_if(model.exchange,
                [&](auto const& pair) { return model.column(pair.first) < 0 || model.column(pair.second) < 0; });
  return model;
}

}  // namespace

std::vector<Map> random_maps(Model const& model, std::size_t count, Random& random) {
  std::vector<Map> maps;
  while (maps.size() < count) {
    if (maps.size() >= 2 && random.chance(25)) {
      Map const& a = random.pick(maps);
      Map const& b = random.pick(maps);
      if (random.chance(50) && a.dart_count() * b.dart_count() <= 100) {
        maps.push_back(product(a, b));
      } else if (a.dart_count() + b.dart_count() <= 60) {
        maps.push_back(disjoint_union(a, b));
      }
    } else if (auto map = random_map(model, random)) {
      maps.push_back(std::move(*map));
    }
  }
  return maps;
}

std::optional<Site> grow_site(ir::RuleScheme const& rule, Random& random) {
  Model const& model = rule.model();
  if (rule.hooks.empty()) return Site{random_maps(model, 1, random)[0], {}};
  std::vector<int> const letters = letters_of(rule);
  Growth growth(model);
  std::optional<Map> pattern;
  if (!letters.empty()) {
    Model const part = restricted(model, letters);
    Growth seed(part);
    seed.add_dart();
    pattern = seed.complete(random, random.between(1, 8));
    if (!pattern) return {};
  }
  auto const size = static_cast<Dart>(pattern ? pattern->dart_count() : 1);
  std::vector<Dart> first(rule.nodes.size(), no_dart);  // of each left node, the copy at pattern dart 0
  for (ir::NodeId s = 0; s < rule.nodes.size(); ++s) {
    if (rule.nodes[s].added()) continue;
    first[s] = static_cast<Dart>(growth.size());
    for (Dart u = 0; u < size; ++u) growth.add_dart();
  }
  // The first hook's copies are the pattern: letters are arcs there.
  ir::Table const left(rule.nodes.size(), rule.left);
  for (int const d : letters) {
    if (left.out(rule.hooks[0], d)) continue;
    for (Dart u = 0; u < size; ++u) {
      if (!growth.set(first[rule.hooks[0]] + u, d, first[rule.hooks[0]] + pattern->target(u, d))) return {};
    }
  }
  for (ir::Arc const& arc : rule.left.arcs) {
    for (Dart u = 0; u < size; ++u) {
      Dart const to = pattern ? pattern->walk(u, arc.word) : u;
      if (!growth.set(first[arc.source] + u, arc.dimension, first[arc.target] + to)) return {};
    }
  }
  auto map = growth.complete(random, growth.size() + random.below(12));
  if (!map) return {};
  auto const u = static_cast<Dart>(random.below(size));
  Site site{std::move(*map), {}};
  for (ir::NodeId const hook : rule.hooks) site.hooks.push_back(first[hook] + u);
  return site;
}

}  // namespace jrule::property
