#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <stdexcept>
#include <utility>

#include "jrule/map.h"

namespace jrule {
namespace {

using Faces = std::vector<std::vector<int>>;  // the vertices of each face, in order

/// A G-map from its faces: darts first + 2k and first + 2k + 1 are the ends of a face's k-th edge; arcs above 2 are
/// loops.
Map gmap_surface(Faces const& faces, Model model = gmap(2)) {
  Map map(std::move(model));
  std::map<std::pair<int, int>, Dart> waiting;  // edge -> its dart at the smaller vertex, on the first face
  for (auto const& face : faces) {
    std::size_t const n = face.size();
    auto const darts = map.add_darts(2 * n);
    for (std::size_t k = 0; k < n; ++k) {
      Dart a = darts[2 * k];
      Dart b = darts[2 * k + 1];
      map.link(a, 0, b);
      map.link(b, 1, darts[(2 * k + 2) % (2 * n)]);
      int const u = face[k];
      int const v = face[(k + 1) % n];
      if (u > v) std::swap(a, b);
      auto const [other, fresh] = waiting.try_emplace(std::minmax(u, v), a);
      if (fresh) continue;
      map.link(map.target(other->second, 0), 2, b);
      map.link(other->second, 2, a);
    }
  }
  return map;
}

/// An O-map from the faces of a closed, oriented surface: dart first + k runs along a face's k-th edge.
Map omap_surface(Faces const& faces) {
  Map map(omap(2));
  std::map<std::pair<int, int>, Dart> along;
  for (auto const& face : faces) {
    std::size_t const n = face.size();
    auto const darts = map.add_darts(n);
    for (std::size_t k = 0; k < n; ++k) {
      int const u = face[k];
      int const v = face[(k + 1) % n];
      map.link(darts[k], 1, darts[(k + 1) % n]);
      along[{u, v}] = darts[k];
      if (auto const back = along.find({v, u}); back != along.end()) map.link(darts[k], 2, back->second);
    }
  }
  return map;
}

Faces const square = {{0, 1, 2, 3}};
Faces const tetrahedron = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
Faces const cube = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};

/// A band of n quads whose ends are glued with a half twist.
Faces moebius(int n) {
  auto const vertex = [n](int i, int j) { return i < n ? 2 * i + j : 1 - j; };
  Faces faces;
  for (int i = 0; i < n; ++i) faces.push_back({vertex(i, 0), vertex(i + 1, 0), vertex(i + 1, 1), vertex(i, 1)});
  return faces;
}

/// A grid of n x n quads, one way round as a torus and the other way round mirrored.
Faces klein_bottle(int n) {
  auto const vertex = [n](int i, int j) { return i < n ? n * i + j % n : (n - j % n) % n; };
  Faces faces;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      faces.push_back({vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
    }
  }
  return faces;
}

std::string text_of(std::optional<Violation> const& v) { return v ? v->text : "none"; }

using Kind = Violation::Kind;
using Cells = std::vector<std::size_t>;

// --- darts and arcs ---

TEST(Map, NewDartsAreFree) {
  Map map(omap(2), {{"w", orbit_of_dimensions({1}), Type::Real, std::nullopt, MergePolicy::none}});
  EXPECT_EQ(map.dart_count(), 0u);
  EXPECT_EQ(map.add_darts(3), (std::vector<Dart>{0, 1, 2}));
  EXPECT_EQ(map.dart_limit(), 3u);
  for (Dart d : map.darts()) {
    for (int i : {1, 2}) {
      EXPECT_EQ(map.target(d, i), d);
      EXPECT_EQ(map.source(d, i), d);
    }
    EXPECT_EQ(map.embedding(0).handle(d), no_handle);
  }
  EXPECT_FALSE(map.contains(3));
  EXPECT_FALSE(map.contains(no_dart));
  EXPECT_TRUE(map.add_darts(0).empty());
}

TEST(Map, ErasedIndicesAreReusedSmallestFirst) {
  Map map(omap(2), {{"w", OrbitType{}, Type::Real, std::nullopt, MergePolicy::none}});
  auto const darts = map.add_darts(8);
  for (Dart d : darts) map.embedding(0).set_handle(d, map.embedding(0).add(1.0));
  map.link(2, 1, 5);
  map.link(5, 1, 2);
  map.link(5, 2, 7);
  map.reserve_erase(3);
  for (Dart d : {5U, 2U, 7U}) map.erase(d);
  EXPECT_EQ(map.dart_count(), 5u);
  EXPECT_EQ(map.dart_limit(), 8u);
  EXPECT_EQ(map.darts(), (std::vector<Dart>{0, 1, 3, 4, 6}));
  EXPECT_FALSE(map.contains(5));
  EXPECT_EQ(map.embedding(0).handle(5), no_handle);
  EXPECT_EQ(map.target(5, 2), no_dart);
  EXPECT_EQ(map.source(5, 1), no_dart);

  EXPECT_EQ(map.add_darts(2), (std::vector<Dart>{2, 5}));
  EXPECT_EQ(map.add_darts(3), (std::vector<Dart>{7, 8, 9}));
  EXPECT_EQ(map.dart_count(), 10u);
  EXPECT_EQ(map.embedding(0).handles().size(), 10u);
  for (Dart d : {2U, 5U, 7U, 8U, 9U}) {
    EXPECT_EQ(map.target(d, 1), d);
    EXPECT_EQ(map.source(d, 1), d);
    EXPECT_EQ(map.target(d, 2), d);
    EXPECT_EQ(map.embedding(0).handle(d), no_handle);
  }
}

TEST(Map, WhatIsOverwrittenIsNotCopiedToNewMemory) {
  Map map = gmap_surface({{0, 1, 2}, {0, 2, 1}});
  std::vector<std::vector<Dart>> before;
  for (int const i : {0, 1, 2}) before.emplace_back(map.targets(i).begin(), map.targets(i).end());
  auto const arcs = [&](std::span<Dart const> targets) { return std::vector<Dart>(targets.begin(), targets.begin() + 12); };
  int const overwritten[] = {0, 2};
  // First there is no room for more, then there is.
  for (bool const moves : {true, false}) {
    Map::FormerTargets former;
    Dart const* const memory[] = {map.targets(0).data(), map.targets(1).data(), map.targets(2).data()};
    EXPECT_EQ(map.append_darts(moves ? 100 : 1, {}, overwritten, former), moves ? 12U : 112U);
    for (int const i : {0, 1, 2}) {
      auto const d = static_cast<std::size_t>(i);
      EXPECT_EQ(arcs(map.targets(i, former)), before[d]);
      EXPECT_EQ(map.targets(i, former).data() == memory[d], !moves || i != 1);
      EXPECT_EQ(map.targets(i).data() == memory[d], !moves);
    }
    EXPECT_EQ(arcs(map.targets(1)), before[1]);
    for (int const i : overwritten) std::copy(before[static_cast<std::size_t>(i)].begin(), before[static_cast<std::size_t>(i)].end(), map.arcs(i));
    for (int const i : {0, 1, 2}) {
      for (Dart d = 12; d < map.dart_limit(); ++d) map.link(d, i, d);
    }
    EXPECT_EQ(map.dart_limit(), moves ? 112U : 113U);
    EXPECT_FALSE(find_violation(map));
    if (moves) map.reserve(1, 0);
  }
}

TEST(Map, TooManyDartsLeaveItAsItWas) {
  Map map = gmap_surface(square);
  map.erase(3);
  auto const before = map.darts();
  EXPECT_THROW(map.add_darts(std::size_t{0xffffffffU}), std::length_error);
  EXPECT_THROW(map.add_darts(static_cast<std::size_t>(-1)), std::length_error);
  EXPECT_EQ(map.darts(), before);
  EXPECT_EQ(map.dart_limit(), 8u);
  EXPECT_EQ(map.add_darts(1), (std::vector<Dart>{3})) << "the free index is still known";
}

TEST(Map, LinkSetsTheReverseOfNonOrientedArcsOnly) {
  Map map(omap(2));
  map.add_darts(3);
  map.link(0, 1, 1);
  map.link(1, 1, 2);
  map.link(2, 1, 0);
  map.link(0, 2, 2);
  EXPECT_EQ(map.target(0, 1), 1u);
  EXPECT_EQ(map.source(0, 1), 2u);
  EXPECT_EQ(map.target(2, 2), 0u);
  EXPECT_EQ(map.source(2, 2), 0u);
  EXPECT_EQ(map.walk(0, {{1, false}, {1, false}}), 2u);
  EXPECT_EQ(map.walk(0, {{1, true}}), 2u);
  EXPECT_EQ(map.walk(0, {{2, false}, {1, true}}), 1u);
  EXPECT_EQ(map.walk(0, {}), 0u);
}

TEST(Map, FindsEmbeddingsByName) {
  Map const map(gmap(2), {{"a", OrbitType{}, Type::Real, std::nullopt, MergePolicy::none},
                          {"b", orbit_of_dimensions({1, 2}), Type::Color, std::nullopt, MergePolicy::mean}});
  EXPECT_EQ(map.embedding_count(), 2u);
  EXPECT_EQ(map.find_embedding("b"), 1u);
  EXPECT_EQ(map.find_embedding("c"), std::nullopt);
  EXPECT_EQ(map.embedding(1).spec().type, Type::Color);
}

// --- orbits ---

TEST(Orbit, OfAGmapFaceGoesRound) {
  Map const map = gmap_surface(square);
  EXPECT_EQ(orbit(map, orbit_of_dimensions({0, 1}), 0), (std::vector<Dart>{0, 1, 2, 3, 4, 5, 6, 7}));
  EXPECT_EQ(orbit(map, orbit_of_dimensions({1, 2}), 2), (std::vector<Dart>{2, 1}));
  EXPECT_EQ(orbit(map, OrbitType{}, 4), (std::vector<Dart>{4}));
}

TEST(Orbit, OfAnOmapFaceGoesRound) {
  Map const map = omap_surface(cube);
  EXPECT_EQ(orbit(map, *cell_orbit(map.model(), 2), 6), (std::vector<Dart>{6, 7, 4, 5}));
  EXPECT_EQ(orbit(map, *cell_orbit(map.model(), 0), 6).size(), 3u);
}

TEST(Orbit, NumbersAgreeWithOrbits) {
  for (Map const& map : {gmap_surface(cube), omap_surface(cube), gmap_surface(moebius(5), gmap(3))}) {
    for (int i = 0; i <= map.model().dimension; ++i) {
      OrbitType const type = *cell_orbit(map.model(), i);
      OrbitNumbers const orbits = number_orbits(map, type);
      EXPECT_TRUE(std::is_sorted(orbits.first.begin(), orbits.first.end()));
      for (Dart d : map.darts()) {
        auto members = orbit(map, type, d);
        EXPECT_EQ(members.front(), d);
        std::sort(members.begin(), members.end());
        EXPECT_EQ(orbits.first[orbits.number[d]], members.front());
        std::vector<Dart> numbered;
        for (Dart e : map.darts()) {
          if (orbits.number[e] == orbits.number[d]) numbered.push_back(e);
        }
        EXPECT_EQ(members, numbered);
      }
    }
  }
}

TEST(Orbit, NumbersLeaveErasedDartsOut) {
  Map map(gmap(1));
  map.add_darts(4);
  map.link(1, 0, 3);
  map.erase(0);
  OrbitNumbers const orbits = number_orbits(map, orbit_of_dimensions({0}));
  EXPECT_EQ(std::vector(orbits.number.begin(), orbits.number.end()), (std::vector<std::uint32_t>{no_orbit, 0, 1, 0}));
  EXPECT_EQ(orbits.first, (std::vector<Dart>{1, 2}));
}

// --- violations ---

TEST(Violation, NoneInMapsOfTheirModels) {
  EXPECT_EQ(text_of(find_violation(Map(gmap(2)))), "none");
  for (auto const& faces : {square, cube, moebius(5), klein_bottle(4)}) {
    EXPECT_EQ(text_of(find_violation(gmap_surface(faces))), "none");
    EXPECT_EQ(text_of(find_violation(gmap_surface(faces, gmap(3)))), "none");
  }
  EXPECT_EQ(text_of(find_violation(omap_surface(cube))), "none");
  EXPECT_EQ(text_of(find_violation(gmap_surface(cube, closed_gmap(2)))), "none");
}

TEST(Violation, OfIncidentArcs) {
  Map dangling = gmap_surface(square);
  dangling.erase(1);
  auto v = find_violation(dangling);
  EXPECT_EQ(text_of(v), "dart 0: its 0-arc leads to dart 1, which is not in the map");
  EXPECT_EQ(v->kind, Kind::incident_arcs);
  EXPECT_EQ(v->dart, 0u);
  EXPECT_EQ(v->i, 0);
  EXPECT_EQ(v->j, -1);

  Map missing = gmap_surface(square);
  missing.set_target(5, 2, no_dart);
  EXPECT_EQ(text_of(find_violation(missing)), "dart 5: it has no 2-arc");

  Map shared = gmap_surface(square);
  shared.set_target(0, 0, 3);
  v = find_violation(shared);
  EXPECT_EQ(text_of(v), "dart 2: its 0-arc leads to dart 3, and so does the 0-arc of dart 0");
  EXPECT_EQ(v->dart, 2u);

  // Arcs written one by one in an order that leaves the inverse of an oriented dimension behind.
  Map stale(omap(2));
  stale.add_darts(2);
  stale.set_target(0, 1, 0);
  stale.set_target(1, 1, 0);
  stale.set_target(1, 1, 1);
  EXPECT_EQ(text_of(find_violation(stale)),
            "dart 0: the 1-arc of dart 0 leads to it, but dart 1 is recorded as the source");
}

TEST(Violation, OfNonOrientation) {
  Map map(gmap(2));
  map.add_darts(4);
  map.set_target(1, 0, 2);
  map.set_target(2, 0, 3);
  map.set_target(3, 0, 1);
  auto const v = find_violation(map);
  EXPECT_EQ(text_of(v), "dart 1: its 0-arc leads to dart 2, whose 0-arc leads to dart 3");
  EXPECT_EQ(v->kind, Kind::non_orientation);
  EXPECT_EQ(v->i, 0);

  Map oriented(omap(2));
  oriented.add_darts(3);
  for (Dart d : {0U, 1U, 2U}) oriented.link(d, 1, (d + 1) % 3);
  EXPECT_EQ(text_of(find_violation(oriented)), "none") << "an oriented dimension need not be an involution";
}

TEST(Violation, OfACycle) {
  Map map(gmap(2));
  map.add_darts(4);
  map.link(0, 0, 1);
  map.link(2, 0, 3);
  map.link(0, 2, 2);
  auto const v = find_violation(map);
  EXPECT_EQ(text_of(v), "dart 0: the path 0202 does not return (it ends at dart 2)");
  EXPECT_EQ(v->kind, Kind::cycle);
  EXPECT_EQ(v->i, 0);
  EXPECT_EQ(v->j, 2);
  map.link(1, 2, 3);
  EXPECT_EQ(text_of(find_violation(map)), "none");
}

TEST(Violation, OfClosedness) {
  auto const v = find_violation(gmap_surface(square, closed_gmap(2)));
  EXPECT_EQ(text_of(v), "dart 0: its 2-arc is a loop, but the model closed_gmap is closed");
  EXPECT_EQ(v->kind, Kind::closed);
  EXPECT_EQ(v->i, 2);
}

TEST(Violation, OfValues) {
  Map map(gmap(2), {{"position", orbit_of_dimensions({1, 2}), Type::Point3, std::nullopt, MergePolicy::none}});
  map.add_darts(4);
  map.link(1, 1, 2);
  Embedding& position = map.embedding(0);
  Handle const p = position.add(Point3{0, 0, 0});
  for (Dart d : {0U, 1U, 2U}) position.set_handle(d, p);
  auto v = find_violation(map);
  EXPECT_EQ(text_of(v), "dart 3: it has no value of `position`");
  EXPECT_EQ(v->kind, Kind::embedding);
  EXPECT_EQ(v->dart, 3u);

  position.set_handle(3, 4);
  EXPECT_EQ(text_of(find_violation(map)), "dart 3: its handle of `position` is 4, but the number of values is 1");

  position.set_handle(3, p);
  EXPECT_EQ(text_of(find_violation(map)), "none");
  position.set_handle(2, position.add(Point3{0, 0, 0}));
  EXPECT_EQ(text_of(find_violation(map)), "none") << "another handle, but the same value";
  position.set_handle(2, position.add(Point3{0, 0, 1}));
  v = find_violation(map);
  EXPECT_EQ(text_of(v), "darts 1 and 2 are of one <1,2>-orbit but their values of `position` differ");
  EXPECT_EQ(v->dart, 1u);
}

// One arc, one source or one value that is another: nothing of a closed surface may be left unnoticed.
TEST(Violation, OfAnyChange) {
  for (Map map : {gmap_surface(cube), omap_surface(cube)}) {
    auto const expect_noticed = [&](Dart& place) {
      for (Dart const other : {Dart{0}, Dart{7}, map.dart_limit(), no_dart}) {
        Dart const old = std::exchange(place, other);
        EXPECT_EQ(text_of(find_violation(map)) == "none", old == other) << "from " << old << " to " << other;
        place = old;
      }
    };
    for (int const i : map.model().dimensions) {
      for (Dart d = 0; d < map.dart_limit(); ++d) {
        expect_noticed(map.arcs(i)[d]);
        if (map.model().is_oriented(i)) expect_noticed(map.sources_of_arcs(i)[d]);
      }
    }
    EXPECT_EQ(text_of(find_violation(map)), "none");
  }
  for (auto const& [type, darts] : {std::pair(orbit_of_dimensions({1, 2}), 6), std::pair(orbit_of_dimensions({0, 1}), 8)}) {
    Map map = gmap_surface(cube);
    Map valued(gmap(2), {{.name = "x", .orbit = type, .type = Type::Int}});
    valued.add_darts(map.dart_count());
    for (int const i : map.model().dimensions) {
      for (Dart d = 0; d < map.dart_limit(); ++d) valued.set_target(d, i, map.target(d, i));
    }
    Embedding& x = valued.embedding(0);
    OrbitNumbers const orbits = number_orbits(valued, type);
    for (std::size_t k = 0; k < orbits.first.size(); ++k) x.add(Value(static_cast<std::int64_t>(k)));
    Handle const same = x.add(Value(std::int64_t{0})), another = x.add(Value(std::int64_t{-1}));
    for (Dart d = 0; d < valued.dart_limit(); ++d) x.set_handle(d, orbits.number[d]);
    EXPECT_EQ(text_of(find_violation(valued)), "none");
    int others = 0;
    for (Dart d = 0; d < valued.dart_limit(); ++d) {
      Handle const old = x.handle(d);
      for (Handle const handle : {another, static_cast<Handle>(x.value_count()), no_handle}) {
        x.set_handle(d, handle);
        EXPECT_NE(text_of(find_violation(valued)), "none") << "dart " << d;
      }
      x.set_handle(d, same);  // another place for the value of the first orbit
      EXPECT_EQ(text_of(find_violation(valued)) == "none", orbits.number[d] == 0) << "dart " << d;
      if (orbits.number[d] == 0) ++others;
      x.set_handle(d, old);
    }
    EXPECT_EQ(others, darts);
  }
}

TEST(Violation, IsTheFirstInTheOrderOfTheConstraints) {
  Map map(closed_gmap(2));
  map.add_darts(4);  // loops everywhere: closedness fails
  EXPECT_EQ(find_violation(map)->kind, Kind::closed);
  map.link(0, 0, 1);
  map.link(2, 0, 3);
  map.link(0, 2, 2);
  EXPECT_EQ(find_violation(map)->kind, Kind::cycle);
  map.set_target(0, 1, 1);
  map.set_target(1, 1, 2);
  map.set_target(2, 1, 0);
  EXPECT_EQ(find_violation(map)->kind, Kind::non_orientation);
  map.set_target(3, 2, 2);
  EXPECT_EQ(text_of(find_violation(map)), "dart 3: its 2-arc leads to dart 2, and so does the 2-arc of dart 0");
}

// --- summaries ---

struct Expected {
  std::string name;
  Map map;
  Cells cells;
  std::size_t components;
  long long euler;
  bool orientable;
  std::size_t boundary_darts;
};

Map two_squares() {
  Map map = gmap_surface({{0, 1, 2, 3}, {4, 5, 6, 7}, {8, 9, 10}});
  for (Dart d = 16; d < 22; ++d) map.erase(d);  // the triangle
  return map;
}

/// The cube's O-map with its two dimensions exchanged: the dual O-map of an octahedron.
Map octahedron() {
  Map const primal = omap_surface(cube);
  Map dual(dual_omap(2));
  dual.add_darts(primal.dart_count());
  for (Dart d : primal.darts()) {
    dual.set_target(d, 1, primal.target(d, 2));
    dual.set_target(d, 2, primal.target(d, 1));
  }
  return dual;
}

TEST(Summary, OfHandBuiltMaps) {
  std::vector<Expected> const all = {
      {"empty", Map(gmap(2)), {0, 0, 0}, 0, 0, true, 0},
      {"square", gmap_surface(square), {4, 4, 1}, 1, 1, true, 8},
      {"two squares", two_squares(), {8, 8, 2}, 2, 2, true, 16},
      {"cube", gmap_surface(cube), {8, 12, 6}, 1, 2, true, 0},
      {"block", gmap_surface(cube, gmap(3)), {8, 12, 6, 1}, 1, 1, true, 48},
      {"Möbius band", gmap_surface(moebius(5)), {10, 15, 5}, 1, 0, false, 20},
      {"Klein bottle", gmap_surface(klein_bottle(4)), {16, 32, 16}, 1, 0, false, 0},
      {"cube, O-map", omap_surface(cube), {8, 12, 6}, 1, 2, true, 0},
      {"tetrahedron, O-map", omap_surface(tetrahedron), {4, 6, 4}, 1, 2, true, 0},
      {"octahedron, dual O-map", octahedron(), {6, 12, 8}, 1, 2, true, 0},
  };
  for (Expected const& e : all) {
    SCOPED_TRACE(e.name);
    Summary const s = summarize(e.map);
    EXPECT_EQ(s.model, e.map.model().name);
    EXPECT_EQ(s.dimension, e.map.model().dimension);
    EXPECT_EQ(s.darts, e.map.dart_count());
    EXPECT_EQ(s.cells, e.cells);
    EXPECT_EQ(s.components, e.components);
    EXPECT_EQ(s.euler, e.euler);
    EXPECT_EQ(s.orientable, e.orientable);
    EXPECT_EQ(s.boundary_darts, e.boundary_darts);
    EXPECT_TRUE(s.valid);
  }
}

TEST(Summary, OfAModelWithoutVertices) {
  Model model;
  model.name = "sheets";
  model.dimension = 2;
  model.dimensions = {1, 2};
  Map map(model);
  map.add_darts(4);
  map.link(0, 1, 1);
  Summary const s = summarize(map);
  EXPECT_EQ(s.cells, (Cells{0, 4, 3}));
  EXPECT_EQ(s.euler, -1);
}

TEST(Summary, OfBrokenMaps) {
  Map cycle(gmap(2));
  cycle.add_darts(3);
  for (Dart d : {0U, 1U, 2U}) cycle.set_target(d, 0, (d + 1) % 3);
  EXPECT_FALSE(summarize(cycle).valid);
  EXPECT_EQ(summarize(cycle).components, 1u);

  Map dangling = gmap_surface(cube);
  dangling.erase(7);
  Summary const s = summarize(dangling);
  EXPECT_FALSE(s.valid);
  EXPECT_EQ(s.darts, 47u);
  EXPECT_EQ(s.cells, (Cells{0, 0, 0})) << "there are no orbits to count";
}

}  // namespace
}  // namespace jrule
