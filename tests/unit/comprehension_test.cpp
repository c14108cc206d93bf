// The values of comprehensions, counted orbits and darts on whole surfaces, at every dart, against plain C++.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "compiler/backend/interpreter/evaluate.h"
#include "compiler/backend/interpreter/interpreter.h"
#include "jrule/io.h"
#include "tests/unit/rule_fixture.h"

namespace jrule {
namespace {

std::string const surface = "modeler S on gmap(2) { embedding position : vertex -> Point3; }\n";
std::string const halfedges = "modeler S on omap(2) { embedding position : vertex -> Point3; }\n";

// An expression in the place of a rule's `let`, at any dart of a surface.
struct Formula {
  ir::RuleScheme rule;
  Map map;

  Formula(std::string const& modeler, std::string const& text, std::string const& file)
      : rule(tests::program_of(modeler + "rule r on S { left { hook a <>; let v = " + text + "; } right { a; } }").rules.at(0)),
        map(*read_map(JRULE_SOURCE_DIR "/tests/data/" + file, rule.model(), rule.modeler->embeddings)) {}

  template <class T>
  T at(Dart d) const {
    std::vector<std::vector<Dart>> const match{{d}};
    return std::get<T>(interpreter::evaluate_value(*rule.lets[0].value, {map, rule, match, {}, {}}, 0));
  }
  template <class T>
  void expect_everywhere(std::function<T(Dart)> const& expected) const {
    ASSERT_GT(map.dart_count(), 0U);
    for (Dart const d : map.darts()) ASSERT_EQ(at<T>(d), expected(d)) << "at dart " << d;
  }
};

Point3 position(Map const& map, Dart d) {
  return std::get<Point3>(map.embedding(0).value(map.embedding(0).handle(d)));
}

Point3 mean_of(std::vector<Point3> const& points) { return mean(std::span<Point3 const>(points)); }

std::vector<Dart> one_each(Map const& map, OrbitType const& type, OrbitType const& by, Dart d) {
  std::vector<Dart> firsts;
  for (Dart const member : orbit(map, type, d)) {
    bool known = false;
    for (Dart const other : orbit(map, by, member)) {
      known = known || std::find(firsts.begin(), firsts.end(), other) != firsts.end();
    }
    if (!known) firsts.push_back(member);
  }
  return firsts;
}

OrbitType const vertex = orbit_of_dimensions({1, 2}), face = orbit_of_dimensions({0, 1});

struct Counts {
  char const* file;
  std::int64_t darts, vertices, edges, faces, border;
};
constexpr Counts surfaces[] = {{"cube.obj", 48, 8, 12, 6, 0}, {"tetrahedron.off", 24, 4, 6, 4, 0}, {"grid.ply", 32, 9, 12, 4, 8}};

TEST(Count, CellsOfWholeSurfaces) {
  for (Counts const& s : surfaces) {
    auto const expect = [&](char const* text, std::int64_t expected) {
      Formula(surface, text, s.file).expect_everywhere<std::int64_t>([&](Dart) { return expected; });
    };
    expect("count(connected(a))", s.darts);
    expect("count(connected(a) by <>)", s.darts);
    expect("count(connected(a) by vertex)", s.vertices);
    expect("count(connected(a) by edge)", s.edges);
    expect("count(connected(a@[0,1]) by <0,1>)", s.faces);
    expect("count(connected(a) by connected)", 1);
    expect("count(<>(a))", 1);
    expect("sum(if e@2 == e then 1 else 0 for e in connected(a) by edge)", s.border);
  }
}

TEST(Count, CellsAroundADart) {
  for (Counts const& s : surfaces) {
    for (auto const& [text, type, by] : {std::tuple{"count(<0,1>(a) by <0>)", face, orbit_of_dimensions({0})},
                                         {"count(<0,1>(a) by <1>)", face, orbit_of_dimensions({1})},
                                         {"count(<1,2>(a) by <2>)", vertex, orbit_of_dimensions({2})},
                                         {"count(<1,2>(a) by <1>)", vertex, orbit_of_dimensions({1})},
                                         {"count(<0,1,2>(a) by <[0,1],[1,2]>)", orbit_of_dimensions({0, 1, 2}),
                                          OrbitType{{{{0}, {1}}, {{1}, {2}}}}}}) {
      Formula const formula(surface, text, s.file);
      formula.expect_everywhere<std::int64_t>([&, &t = type, &b = by](Dart d) {
        return static_cast<std::int64_t>(one_each(formula.map, t, b, d).size());
      });
    }
  }
  // Corner, side and middle of the open grid: faces and edges.
  Formula const faces(surface, "count(<1,2>(a) by <1>)", "grid.ply"), edges(surface, "count(<1,2>(a) by <2>)", "grid.ply");
  std::vector<int> seen(5);
  for (Dart const d : faces.map.darts()) {
    auto const n = faces.at<std::int64_t>(d);
    EXPECT_EQ(edges.at<std::int64_t>(d), n == 4 ? 4 : n + 1);
    ++seen[static_cast<std::size_t>(n)];
  }
  EXPECT_EQ(seen, (std::vector<int>{0, 8, 16, 0, 8}));
}

TEST(Count, OrientableSurfacesFallIntoTwoByWordsOfEvenLength) {
  Formula(surface, "count(connected(a) by <[0,1],[1,2]>)", "cube.obj").expect_everywhere<std::int64_t>([](Dart) { return 2; });
  Formula(surface, "count(connected(a) by <[0,1],[1,2]>)", "moebius.obj").expect_everywhere<std::int64_t>([](Dart) { return 1; });
}

TEST(Count, CellsOfOrientedMaps) {
  auto const expect = [&](char const* text, std::int64_t expected) {
    Formula(halfedges, text, "cube.obj").expect_everywhere<std::int64_t>([&](Dart) { return expected; });
  };
  expect("count(connected(a))", 24);
  expect("count(connected(a) by vertex)", 8);
  expect("count(connected(a) by <2>)", 12);
  expect("count(connected(a) by face)", 6);
  expect("count(face(a))", 4);
  expect("count(vertex(a))", 3);
  expect("count(vertex(a@~1) by vertex)", 1);
  expect("count(connected(a) by <[2,1]>)", 8);
}

TEST(Comprehension, MeanOfTheMeansOfTheFacesAround) {
  for (Counts const& s : surfaces) {
    Formula const formula(surface, "mean(mean(<0,1>(f).position) for f in <1,2>(a) by <1>)", s.file);
    Map const& map = formula.map;
    formula.expect_everywhere<Point3>([&](Dart d) {
      std::vector<Point3> faces;
      for (Dart const f : one_each(map, vertex, orbit_of_dimensions({1}), d)) {
        std::vector<Point3> corners;
        for (Dart const c : one_each(map, face, orbit_of_dimensions({1}), f)) corners.push_back(position(map, c));
        faces.push_back(mean_of(corners));
      }
      return mean_of(faces);
    });
  }
}

TEST(Comprehension, OuterNamesAreSeenInside) {
  Formula const formula(surface,
                        "sum(sum(distance(g@0.position, f.position) * norm(a.position - g.position) "
                        "for g in <1,2>(f@0) by <2>) for f in <0,1>(a))",
                        "cube.obj");
  Map const& map = formula.map;
  formula.expect_everywhere<double>([&](Dart d) {
    double outer = 0;
    for (Dart const f : orbit(map, face, d)) {
      double inner = 0;
      for (Dart const g : one_each(map, vertex, orbit_of_dimensions({2}), map.target(f, 0))) {
        inner += distance(position(map, map.target(g, 0)), position(map, f)) * norm(position(map, d) - position(map, g));
      }
      outer += inner;
    }
    return outer;
  });
}

TEST(Comprehension, OverOrbitsOfWords) {
  Formula const formula(halfedges, "mean(mean(g.position for g in face(f)) for f in vertex(a))", "tetrahedron.off");
  Map const& map = formula.map;
  OrbitType const around{{{{2}, {1}}}}, side = orbit_of_dimensions({1});
  formula.expect_everywhere<Point3>([&](Dart d) {
    std::vector<Point3> faces;
    for (Dart const f : orbit(map, around, d)) {
      std::vector<Point3> corners;
      for (Dart const g : orbit(map, side, f)) corners.push_back(position(map, g));
      faces.push_back(mean_of(corners));
    }
    return mean_of(faces);
  });
}

TEST(Comprehension, TheListIsInTheOrderOfTheWalk) {
  for (Counts const& s : surfaces) {
    Formula const by_hand(surface, "area_vector(f.position for f in <0,1>(a) by <1>)", s.file);
    Formula const collected(surface, "area_vector(<0,1>(a).position)", s.file);
    by_hand.expect_everywhere<Vec3>([&](Dart d) { return collected.at<Vec3>(d); });
    Formula const first(surface, "first(f.position for f in <1,2>(a@0) by <2>)", s.file);
    first.expect_everywhere<Point3>([&](Dart d) { return position(first.map, first.map.target(d, 0)); });
  }
}

TEST(Comprehension, EveryAggregate) {
  auto const expect = [&]<class T>(char const* text, T expected) {
    Formula(surface, text, "cube.obj").expect_everywhere<T>([&](Dart) { return expected; });
  };
  expect("min(f.position.x for f in connected(a))", 0.0);
  expect("max(f.position.x + f.position.y for f in connected(a) by vertex)", 2.0);
  expect("sum(count(<0,1>(f) by <0>) for f in connected(a) by face)", std::int64_t{24});
  expect("mean(count(<0,1>(f) by <0>) for f in connected(a) by face)", 4.0);
  expect("sum(Color(1, f.position.x, 0) for f in connected(a) by vertex)", Color{8, 4, 0});
  expect("all(f@2@2 == f for f in connected(a))", true);
  expect("all(f.position.x < 1 for f in connected(a))", false);
  expect("any(f.position.x < 1 for f in connected(a))", true);
  expect("any(f@2 == f for f in connected(a))", false);
  expect("count(true for f in connected(a) by edge)", std::int64_t{12});
  expect("first(f == a for f in connected(a))", true);
  expect("norm(area_vector(f.position for f in <0,1>(a) by <1>))", 1.0);
}

TEST(Collect, ByChoosesTheDarts) {
  // Each end of an edge is read once for each of its two darts.
  Formula const formula(surface, "count((<0,2>(a) by <>).position) * 10 + count(<0,2>(a).position)", "cube.obj");
  formula.expect_everywhere<std::int64_t>([](Dart) { return 42; });
  Formula const ends(surface, "count((<0,2>(a) by <0>).position)", "grid.ply");
  ends.expect_everywhere<std::int64_t>([&](Dart d) { return ends.map.target(d, 2) == d ? 1 : 2; });
}

TEST(Darts, PathsAndChoices) {
  Formula const back(surface, "a@[0,1]@[1,0] == a", "cube.obj");
  back.expect_everywhere<bool>([](Dart) { return true; });
  Formula const across(surface, "(if a@2 == a then a else a@[2,1])@0.position", "grid.ply");
  across.expect_everywhere<Point3>([&](Dart d) {
    Dart const to = across.map.target(d, 2);
    return position(across.map, across.map.target(to == d ? d : across.map.target(to, 1), 0));
  });
  Formula const orbit_of(surface, "mean(<0,1>(a@2).position)", "cube.obj");
  Formula const orbit_at(surface, "mean(<0,1>(a).position)", "cube.obj");
  orbit_of.expect_everywhere<Point3>([&](Dart d) { return orbit_at.at<Point3>(orbit_at.map.target(d, 2)); });
}

// Every vertex moves at once, to where the vertices stood before.
TEST(Comprehension, SeesTheMapBefore) {
  std::string const smooth = "mean(mean(<0,1>(f).position) for f in <1,2>(a) by <1>)";
  ir::RuleScheme const rule =
      tests::program_of(surface + "rule r on S { left { hook a <0,1,2>; } right { a { position = " + smooth + "; } } }").rules.at(0);
  analysis::Verdict const verdict = analysis::analyze(rule);
  ASSERT_TRUE(verdict.accepted());
  for (Counts const& s : surfaces) {
    Formula const before(surface, smooth, s.file);
    Map map = before.map;
    rewrite::Workspace workspace;
    ASSERT_TRUE(interpreter::apply(rule, verdict.plan, map, {0}, {}, workspace));
    EXPECT_FALSE(find_violation(map));
    for (Dart const d : map.darts()) {
      // One value for each vertex, computed at some dart of it: the order of the sum may differ.
      EXPECT_LT(distance(position(map, d), before.at<Point3>(d)), 1e-15) << d;
    }
  }
}

// A dart that a `let` holds is the hook's, whatever pattern dart the value is for.
TEST(Darts, ALetHoldsTheHooksDart) {
  ir::RuleScheme const rule = tests::program_of("modeler S on gmap(2) { embedding at_hook : <> -> Bool; embedding far : <> -> Int; }\n"
                                                "rule r on S { left { hook a <0,1>; let start = a; let next = start@[0,1]; }"
                                                " right { a { at_hook = a == start; far = if a == next then 1 else 0; } } }")
                                  .rules.at(0);
  analysis::Verdict const verdict = analysis::analyze(rule);
  ASSERT_TRUE(verdict.accepted()) << tests::codes(verdict);
  Map map(rule.model(), rule.modeler->embeddings);
  map.add_darts(6);
  for (Dart k = 0; k < 3; ++k) {
    map.link(2 * k, 0, 2 * k + 1);
    map.link(2 * k + 1, 1, (2 * k + 2) % 6);
  }
  for (std::size_t e : {0U, 1U}) {
    Handle const h = map.embedding(e).add(e == 0 ? Value{false} : Value{std::int64_t{-1}});
    for (Dart const d : map.darts()) map.embedding(e).set_handle(d, h);
  }
  rewrite::Workspace workspace;
  ASSERT_TRUE(interpreter::apply(rule, verdict.plan, map, {2}, {}, workspace));
  for (Dart const d : map.darts()) {
    EXPECT_EQ(std::get<bool>(map.embedding(0).value(map.embedding(0).handle(d))), d == 2) << d;
    EXPECT_EQ(std::get<std::int64_t>(map.embedding(1).value(map.embedding(1).handle(d))), d == 4 ? 1 : 0) << d;
  }
}

}  // namespace
}  // namespace jrule
