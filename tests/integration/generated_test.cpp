// Generated code against the interpreter: equal results, errors and maps, byte for byte.
#include "base.h"
#include "changes.h"
#include "halfedges.h"
#include "imports.h"
#include "names.h"
#include "numbers.h"
#include "ops.h"
#include "paper/surface.h"
#include "smoothing.h"
#include "tests/integration/both.h"
#include "values.h"

namespace {

using jrule::Dart;
using jrule::Map;
using jrule::test::generated;
using jrule::test::generated_everywhere;
using jrule::test::interpret;
using jrule::test::interpret_everywhere;
using jrule::test::Module;
using jrule::test::Outcome;

std::string const rules = JRULE_RULES_DIR;
std::string const data = JRULE_SOURCE_DIR "/tests/data/";

template <class Class>
Map read(std::string const& file) {
  auto modeler = Class::read(data + file);
  EXPECT_TRUE(modeler) << to_string(modeler.error());
  Map map = std::move(modeler->map());
  jrule::test::number_values(map);
  return map;
}

// The columns of a result, by the names of its nodes.
#define COPIES(...)                                     \
  [](auto const& result) {                              \
    auto const& c = result.copies;                      \
    return jrule::test::lists({__VA_ARGS__});           \
  }
auto const none = [](auto const&) { return std::vector<std::vector<Dart>>{}; };

void expect_valid(Outcome const& outcome) {
  auto const map = jrule::parse_jmap(outcome.map, "result");
  ASSERT_TRUE(map) << to_string(map.error());
  EXPECT_FALSE(find_violation(*map));
}

// ---- The paper's rules ----

using Surface = paper::rules::Surface;

class Paper : public testing::Test {
 protected:
  Module module{JRULE_SOURCE_DIR "/examples/cmake-consumer/surface.jrule"};
};

TEST_F(Paper, QuadSubdivision) {
  for (char const* file : {"cube.obj", "tetrahedron.off", "moebius.obj", "grid.ply"}) {
    Map const start = read<Surface>(file);
    Outcome const expected = interpret(module.rule("quad_subdivision"), start, {0}, {});
    EXPECT_EQ(expected.error, "");
    EXPECT_EQ(generated<Surface>(
                  start, [](Surface& s) { return paper::rules::quad_subdivision(s, 0); }, COPIES(c.a, c.b, c.c, c.d)),
              expected);
    expect_valid(expected);
  }
}

TEST_F(Paper, QuadSubdivisionOfALargeMesh) {
  auto modeler = Surface::read(data + "cube.obj");
  ASSERT_TRUE(modeler);
  for (int i = 0; i < 4; ++i) ASSERT_TRUE(paper::rules::quad_subdivision(*modeler, 0));
  Map const start = modeler->map();
  EXPECT_EQ(start.dart_count(), 48U * 256U);
  EXPECT_EQ(generated<Surface>(
                start, [](Surface& s) { return paper::rules::quad_subdivision(s, 5); }, COPIES(c.a, c.b, c.c, c.d)),
            interpret(module.rule("quad_subdivision"), start, {5}, {}));
}

TEST_F(Paper, QuadSubdivisionEverywhere) {
  Map const start = read<Surface>("grid.ply");
  Outcome const expected = interpret_everywhere(module.rule("quad_subdivision"), start, {});
  EXPECT_EQ(expected.count, summarize(start).components);
  EXPECT_EQ(
      generated_everywhere<Surface>(start, [](Surface& s) { return paper::rules::quad_subdivision_everywhere(s); }),
      expected);
}

TEST_F(Paper, ResultsAreNamedByNodes) {
  auto modeler = Surface::from_map(read<Surface>("cube.obj"));
  ASSERT_TRUE(modeler);
  auto const r = paper::rules::quad_subdivision(*modeler, 3);
  ASSERT_TRUE(r);
  EXPECT_EQ(r->a, 3U);
  EXPECT_EQ(modeler->map().target(r->a, 0), r->b);
  EXPECT_EQ(modeler->map().target(r->c, 0), r->d);
  EXPECT_EQ(r->copies.d.front(), r->d);
  EXPECT_EQ(r->copies.d.size(), 48U);
}

TEST_F(Paper, ConeIsRefusedOnAClosedSurface) {
  Map const start = read<Surface>("cube.obj");
  Outcome const expected = interpret(module.rule("cone"), start, {0}, {jrule::Point3{1, 2, 3}});
  EXPECT_NE(expected.error, "");
  EXPECT_EQ(expected.map, print_jmap(start));
  EXPECT_EQ(generated<Surface>(
                start,
                [](Surface& s) {
                  return paper::rules::cone(s, 0, {1, 2, 3});
                },
                none),
            expected);
}

// Six squares: those of the cube, each alone.
Map squares() {
  auto modeler = changes::Field();
  for (int i = 0; i < 6; ++i) EXPECT_TRUE(changes::square(modeler, 1.0 + i));
  return modeler.map();
}

TEST_F(Paper, ConeOnSquares) {
  Map const field = squares();
  Map start(Surface::model(), Surface::embeddings());
  start.add_darts(field.dart_count());
  for (Dart const d : field.darts()) {
    for (int const dimension : {0, 1, 2}) start.set_target(d, dimension, field.target(d, dimension));
  }
  jrule::test::number_values(start);
  for (Dart const d : {0U, 13U, 47U}) {
    Outcome const expected = interpret(module.rule("cone"), start, {d}, {jrule::Point3{1, 2, 3}});
    EXPECT_EQ(expected.error, "");
    EXPECT_EQ(generated<Surface>(
                  start,
                  [&](Surface& s) {
                    return paper::rules::cone(s, d, {1, 2, 3});
                  },
                  COPIES(c.a, c.b, c.c, c.d)),
              expected);
    expect_valid(expected);
  }
  Outcome const expected = interpret_everywhere(module.rule("cone"), start, {jrule::Point3{1, 2, 3}});
  EXPECT_EQ(expected.count, 6U);
  EXPECT_EQ(generated_everywhere<Surface>(start,
                                          [](Surface& s) {
                                            return paper::rules::cone_everywhere(s, {1, 2, 3});
                                          }),
            expected);
}

// Every pair of darts as hooks, also one that is no dart.
TEST_F(Paper, SewOfEveryPair) {
  Map const start = read<Surface>("grid.ply");
  std::size_t applied = 0;
  for (Dart a = 0; a <= start.dart_limit(); ++a) {
    for (Dart b = 0; b <= start.dart_limit(); b += 3) {
      Outcome const expected = interpret(module.rule("sew2"), start, {a, b}, {});
      applied += expected.error.empty() ? 1U : 0U;
      ASSERT_EQ(generated<Surface>(
                    start, [&](Surface& s) { return paper::rules::sew2(s, a, b); }, COPIES(c.a, c.b)),
                expected);
    }
  }
  EXPECT_GT(applied, 10U);
}

// ---- O-maps ----

TEST(Halfedges, AgreesWithTheInterpreter) {
  Module const module(rules + "/halfedges.jrule");
  using halfedges::Halfedges;
  for (char const* file : {"cube.obj", "tetrahedron.off", "grid.ply"}) {
    Map const start = read<Halfedges>(file);
    Outcome const subdivided = interpret(module.rule("quad_subdivision"), start, {2}, {});
    EXPECT_EQ(subdivided.error, "");
    expect_valid(subdivided);
    EXPECT_EQ(generated<Halfedges>(
                  start, [](Halfedges& h) { return halfedges::quad_subdivision(h, 2); }, COPIES(c.a, c.b, c.c, c.d)),
              subdivided);
    Outcome const reversed = interpret(module.rule("reverse"), start, {0}, {});
    EXPECT_EQ(reversed.error, "");
    EXPECT_NE(reversed.map, print_jmap(start));
    expect_valid(reversed);
    EXPECT_EQ(generated<Halfedges>(
                  start, [](Halfedges& h) { return halfedges::reverse(h, 0); }, COPIES(c.a)),
              reversed);
  }
}

// ---- Creation, deletion, merges ----

class Changes : public testing::Test {
 protected:
  using Field = changes::Field;
  Module module{rules + "/changes.jrule"};

  // Each rule of one hook at every dart; how often it was applied.
  template <class Rule, class Copies>
  std::size_t at_every_dart(std::string const& name, Map const& start, Rule rule, Copies copies) {
    std::size_t applied = 0;
    for (Dart a = 0; a < start.dart_limit(); ++a) {
      Outcome const expected = interpret(module.rule(name), start, {a}, {});
      if (expected.error.empty()) {
        ++applied;
        expect_valid(expected);
      }
      Outcome const found = generated<Field>(
          start, [&](Field& f) { return rule(f, a); }, copies);
      EXPECT_EQ(found, expected) << name << " at " << a;
      if (found != expected) return applied;
    }
    return applied;
  }
};

TEST_F(Changes, Creation) {
  Map const start = squares();
  Outcome const expected = interpret(module.rule("square"), start, {}, {0.25});
  expect_valid(expected);
  Outcome found = generated<Field>(
      start, [](Field& f) { return changes::square(f, 0.25); },
      [](changes::SquareResult const& r) {
        return std::vector<std::vector<Dart>>{{r.a}, {r.b}, {r.c}, {r.d}, {r.e}, {r.f}, {r.g}, {r.h}};
      });
  EXPECT_EQ(found, expected);
  EXPECT_EQ(generated<Field>(
                start, [](Field& f) { return changes::square(f); }, none)
                .map,
            interpret(module.rule("square"), start, {}, {2.0}).map);
}

TEST_F(Changes, MergesByEveryPolicy) {
  Map start = squares();
  jrule::test::number_values(start);
  auto modeler = Field::from_map(start);
  // A strip, then a ring; the last one is refused: its edges are not free any more.
  std::pair<Dart, Dart> const pairs[] = {{0, 8}, {12, 21}, {16, 24}, {30, 7}, {0, 8}, {1, 1}};
  std::vector<bool> applied;
  for (auto const& pair : pairs) {
    Dart const a = pair.first, b = pair.second;
    Outcome const expected = interpret(module.rule("sew"), modeler->map(), {a, b}, {});
    EXPECT_EQ(generated<Field>(
                  modeler->map(), [a, b](Field& f) { return changes::sew(f, a, b); }, COPIES(c.a, c.b)),
              expected);
    expect_valid(expected);
    applied.push_back(changes::sew(*modeler, a, b).has_value());
  }
  EXPECT_EQ(applied, (std::vector<bool>{true, true, true, true, false, false}));
  EXPECT_EQ(at_every_dart(
                "unsew", modeler->map(), [](Field& f, Dart a) { return changes::unsew(f, a); }, COPIES(c.a, c.b)),
            16U);
}

TEST_F(Changes, AtEveryDart) {
  for (char const* file : {"cube.obj", "grid.ply"}) {
    Map const start = read<Field>(file);
    EXPECT_GT(
        at_every_dart(
            "insert_vertex", start, [](Field& f, Dart a) { return changes::insert_vertex(f, a); }, COPIES(c.a, c.b)),
        0U);
    EXPECT_GT(at_every_dart(
                  "triangulate_face", start, [](Field& f, Dart a) { return changes::triangulate_face(f, a); },
                  COPIES(c.a, c.b, c.c)),
              0U);
    EXPECT_GT(at_every_dart(
                  "unsew", start, [](Field& f, Dart a) { return changes::unsew(f, a); }, COPIES(c.a, c.b)),
              0U);
    EXPECT_GT(at_every_dart(
                  "remove_component", start, [](Field& f, Dart a) { return changes::remove_component(f, a); }, none),
              0U);
    EXPECT_EQ(at_every_dart(
                  "remove_dart", start, [](Field& f, Dart a) { return changes::remove_dart(f, a); }, none),
              0U);
    at_every_dart(
        "is_edge_free", start, [](Field& f, Dart a) { return changes::is_edge_free(f, a); }, COPIES(c.a));
  }
}

TEST_F(Changes, DeletionReusesDarts) {
  Map const start = read<Field>("cube.obj");
  auto modeler = Field::from_map(start);
  ASSERT_TRUE(changes::insert_vertex_everywhere(*modeler));
  EXPECT_EQ(modeler->map().dart_count(), 96U);
  EXPECT_GT(at_every_dart(
                "remove_vertex", modeler->map(), [](Field& f, Dart b) { return changes::remove_vertex(f, b); },
                COPIES(c.a, c.d)),
            0U);
  Outcome const expected = interpret_everywhere(module.rule("remove_vertex"), modeler->map(), {});
  EXPECT_EQ(generated_everywhere<Field>(modeler->map(), [](Field& f) { return changes::remove_vertex_everywhere(f); }),
            expected);
  // What was deleted is used again, in the same order by both.
  ASSERT_TRUE(changes::remove_vertex_everywhere(*modeler));
  EXPECT_LT(modeler->map().dart_count(), modeler->map().dart_limit());
  EXPECT_GT(at_every_dart(
                "triangulate_face", start, [](Field& f, Dart a) { return changes::triangulate_face(f, a); },
                COPIES(c.a, c.b, c.c)),
            0U);
}

TEST_F(Changes, DeletesALoneDart) {
  Map start(Field::model(), Field::embeddings());
  start.add_darts(3);
  jrule::test::number_values(start);
  EXPECT_EQ(at_every_dart(
                "remove_dart", start, [](Field& f, Dart a) { return changes::remove_dart(f, a); }, none),
            3U);
}

// ---- Values ----

class Values : public testing::Test {
 protected:
  using All = values::All;
  Module module{rules + "/values.jrule"};
  Map start = read<All>("grid.ply");
};

TEST_F(Values, Shuffle) {
  for (double const t : {0.0, 0.3, 0.999, -0.5, 2.0}) {
    for (bool const strict : {true, false}) {
      jrule::Vec3 const shift{0.25, t, -1};
      Outcome const expected =
          interpret(module.rule("shuffle"), start, {4}, {t, shift, std::int64_t{3}, strict, jrule::Point2{t, 1}});
      EXPECT_EQ(expected.error.empty(), !strict || (t >= 0 && t < 1)) << expected.error;
      EXPECT_EQ(generated<All>(
                    start,
                    [&](All& all) {
                      return values::shuffle(all, 4, t, shift, 3, strict, {t, 1});
                    },
                    COPIES(c.a)),
                expected);
    }
  }
  Outcome const expected = interpret_everywhere(module.rule("shuffle"), start,
                                                {0.4, jrule::Vec3{0, 0.1, 0}, std::int64_t{2}, true, jrule::Point2{}});
  EXPECT_EQ(expected.count, summarize(start).cells[0]);
  EXPECT_EQ(generated_everywhere<All>(start, [](All& all) { return values::shuffle_everywhere(all, 0.4); }), expected);
  EXPECT_NE(
      interpret(module.rule("shuffle"), start, {4}, {0.5, jrule::Vec3{}, std::int64_t{100}, true, jrule::Point2{}})
          .error,
      "");
}

TEST_F(Values, PaintIntegersAndComparisons) {
  EXPECT_EQ(generated_everywhere<All>(start, [](All& all) { return values::paint_everywhere(all); }),
            interpret_everywhere(module.rule("paint"), start, {}));
  for (std::int64_t const big :
       {std::int64_t{3}, std::numeric_limits<std::int64_t>::max(), std::numeric_limits<std::int64_t>::min()}) {
    EXPECT_EQ(generated_everywhere<All>(start, [&](All& all) { return values::wrap_everywhere(all, big); }),
              interpret_everywhere(module.rule("wrap"), start, {big}));
  }
  Outcome const never = interpret(module.rule("never"), start, {0}, {});
  EXPECT_NE(never.error, "");
  EXPECT_EQ(generated<All>(
                start, [](All& all) { return values::never(all, 0); }, none),
            never);
  auto const all = All::from_map(start);
  std::size_t holds = 0;
  for (Dart const d : start.darts()) {
    jrule::Vec3 const v = all->normal(d % 2 == 0 ? d : 0);
    jrule::Point3 const p = all->position(d % 3 == 0 ? d : 0);
    jrule::Color const color = all->color(d % 5 == 0 ? d : 0);
    Outcome const expected = interpret(module.rule("compare"), start, {d}, {v, p, color});
    holds += expected.error.empty() ? 1U : 0U;
    EXPECT_EQ(generated<All>(
                  start, [&](All& a) { return values::compare(a, d, v, p, color); }, COPIES(c.a)),
              expected);
  }
  EXPECT_GT(holds, 0U);
  EXPECT_LT(holds, start.dart_count());
}

TEST(Numbers, EdgesAgree) {
  Module const module(rules + "/numbers.jrule");
  auto modeler = numbers::Numbers();
  ASSERT_TRUE(numbers::dart(modeler));
  Map const start = modeler.map();
  using Reals = std::numeric_limits<double>;
  for (double const x : {0.0, -0.0, 1.0, -2.5, 0.1, 1e200, -1e-200, Reals::denorm_min(), Reals::max(), Reals::infinity(),
                         -Reals::infinity(), Reals::quiet_NaN(), 0.7, 123456.789}) {
    for (double const y : {0.0, -0.0, 1.0, -0.1, 3.0, -1e200, Reals::max(), Reals::infinity(), Reals::quiet_NaN()}) {
      Outcome const expected = interpret(module.rule("of_reals"), start, {0}, {x, y});
      ASSERT_EQ(expected.error, "");
      ASSERT_EQ(generated<numbers::Numbers>(
                    start, [&](numbers::Numbers& m) { return numbers::of_reals(m, 0, x, y); }, COPIES(c.a)),
                expected)
          << x << ' ' << y;
    }
  }
  using Ints = std::numeric_limits<std::int64_t>;
  for (std::int64_t const n : {std::int64_t{0}, std::int64_t{1}, std::int64_t{-7}, std::int64_t{9007199254740993}, Ints::max(), Ints::min()}) {
    for (std::int64_t const m : {std::int64_t{0}, std::int64_t{-1}, std::int64_t{2}, std::int64_t{3037000500}, Ints::max(), Ints::min()}) {
      Outcome const expected = interpret(module.rule("of_ints"), start, {0}, {n, m});
      ASSERT_EQ(expected.error, "");
      ASSERT_EQ(generated<numbers::Numbers>(
                    start, [&](numbers::Numbers& k) { return numbers::of_ints(k, 0, n, m); }, COPIES(c.a)),
                expected)
          << n << ' ' << m;
    }
  }
}

// ---- Imported rules ----

class Imports : public testing::Test {
 protected:
  Module module{rules + "/imports.jrule"};
};

// The library's rule, with the values of this modeler.
TEST_F(Imports, AreOnTheModelersOfTheFileThatImportsThem) {
  using imports::Terrain;
  for (char const* file : {"cube.obj", "grid.ply", "moebius.obj"}) {
    Map const start = read<Terrain>(file);
    Outcome const expected = interpret(module.rule("catmull_clark"), start, {0}, {});
    EXPECT_EQ(expected.error, "");
    expect_valid(expected);
    EXPECT_EQ(generated<Terrain>(start, [](Terrain& t) { return imports::catmull_clark(t, 0); }, COPIES(c.a, c.b, c.c, c.d)), expected)
        << file;
  }
  auto terrain = Terrain::read(data + "cube.obj");
  ASSERT_TRUE(terrain);
  Dart const corner = 0;
  auto const set = [&](std::string const& embedding, jrule::Value value) {
    jrule::rewrite::Workspace workspace;
    jrule::rewrite::set_value(terrain->map(), *terrain->map().find_embedding(embedding), corner, value, workspace);
  };
  set("soil", std::int64_t{5});
  set("crease", 0.5);
  ASSERT_TRUE(imports::catmull_clark(*terrain, 0));
  auto const count = [&](std::string const& embedding, jrule::Value const& value) {
    jrule::Embedding const& values = terrain->map().embedding(*terrain->map().find_embedding(embedding));
    std::size_t darts = 0;
    for (Dart const d : terrain->map().darts()) darts += values.value(values.handle(d)) == value ? 1 : 0;
    return darts;
  };
  EXPECT_EQ(count("soil", std::int64_t{5}), 4U * 8U);  // the four quads of the face
  EXPECT_EQ(count("crease", 0.5), 2U * 4U);            // the halves of the edge; the edges inside are new
}

// A rule that several modelers take has the modeler's name before its own.
TEST_F(Imports, OfSeveralModelersAreToldApart) {
  imports::Block block;
  imports::Brick brick;
  Map const blocks(block.map()), bricks(brick.map());
  auto const corner = [](auto const& r) { return std::vector<std::vector<Dart>>{{r.a}, {r.b}}; };
  EXPECT_EQ(generated<imports::Block>(blocks, [](imports::Block& b) { return imports::block_polygon_corner(b); }, corner),
            interpret(module.rule("Block.polygon_corner"), blocks, {}, {}));
  EXPECT_EQ(generated<imports::Brick>(bricks, [](imports::Brick& b) { return imports::brick_polygon_corner(b); }, corner),
            interpret(module.rule("Brick.polygon_corner"), bricks, {}, {}));
}

// ---- Comprehensions ----

class Smoothing : public testing::Test {
 protected:
  using Surface = smoothing::Surface;
  Module module{rules + "/smoothing.jrule"};
};

TEST_F(Smoothing, CatmullClark) {
  for (char const* file : {"cube.obj", "tetrahedron.off", "grid.ply", "moebius.obj"}) {
    Map const start = read<Surface>(file);
    Outcome const expected = interpret(module.rule("catmull_clark"), start, {0}, {});
    EXPECT_EQ(expected.error, "");
    expect_valid(expected);
    EXPECT_EQ(generated<Surface>(
                  start, [](Surface& s) { return smoothing::catmull_clark(s, 0); }, COPIES(c.a, c.b, c.c, c.d)),
              expected)
        << file;
  }
}

void expect_near(jrule::Point3 found, jrule::Point3 expected) { EXPECT_LT(distance(found, expected), 1e-12); }

// By the formula of the books, with the cells of the map before.
TEST_F(Smoothing, CatmullClarkIsTheOneOfTheBooks) {
  using jrule::Point3, jrule::Vec3, jrule::orbit, jrule::orbit_of_dimensions;
  for (char const* file : {"cube.obj", "tetrahedron.off", "grid.ply"}) {
    auto const before = Surface::read(data + file);
    auto after = Surface::read(data + file);
    ASSERT_TRUE(before && after);
    auto const result = smoothing::catmull_clark(*after, 0);
    ASSERT_TRUE(result);
    Map const& map = before->map();
    auto const at = [&](Dart d) { return before->position(d) - Point3{}; };
    auto const middle = [&](Dart d) { return 0.5 * (at(d) + at(map.target(d, 0))); };
    auto const face_point = [&](Dart d) {
      Vec3 sum;
      auto const darts = orbit(map, orbit_of_dimensions({0, 1}), d);
      for (Dart const corner : darts) sum = sum + at(corner);  // each corner twice
      return sum / static_cast<double>(darts.size());
    };
    for (std::size_t k = 0; k < result->copies.a.size(); ++k) {
      Dart const d = result->copies.a[k];  // preserved: the same dart of the map before
      auto const around = orbit(map, orbit_of_dimensions({1, 2}), d);
      Vec3 q, r;
      double border = 0;
      Vec3 border_middles;
      for (Dart const e : around) {
        q = q + face_point(e);
        r = r + middle(e);
        if (map.target(e, 2) == e) border_middles = border_middles + middle(e), border += 1;
      }
      Vec3 const s = at(d);
      Vec3 expected = 0.5 * s + border_middles / 4;  // on a border
      if (border == 0) {
        auto const twice = static_cast<double>(around.size());  // every face corner, and every edge, has two darts
        double const n = twice / 2;
        expected = (q / twice + 2 * (r / twice) + (n - 3) * s) / n;
      } else {
        EXPECT_EQ(border, 2);
      }
      expect_near(after->position(d), Point3{} + expected);
      Dart const across = map.target(d, 2);
      expect_near(after->position(result->copies.b[k]),
                  Point3{} + (across == d ? middle(d) : 0.25 * (2 * middle(d) + face_point(d) + face_point(across))));
      expect_near(after->position(result->copies.d[k]), Point3{} + face_point(d));
    }
  }
  // A corner of the cube goes from (0, 0, 0) to (2/9, 2/9, 2/9).
  auto cube = Surface::read(data + "cube.obj");
  ASSERT_TRUE(smoothing::catmull_clark(*cube, 0));
  bool found = false;
  for (Dart const d : cube->map().darts()) found = found || distance(cube->position(d), {2. / 9, 2. / 9, 2. / 9}) < 1e-12;
  EXPECT_TRUE(found);
}

TEST_F(Smoothing, NestedComprehensionsLetsAndChoices) {
  for (char const* file : {"cube.obj", "tetrahedron.off", "grid.ply"}) {
    Map const start = read<Surface>(file);
    for (Dart d = 0; d < start.dart_limit(); d += 5) {
      Outcome const expected = interpret(module.rule("relax"), start, {d}, {0.25});
      EXPECT_EQ(expected.error.empty(), std::string(file) != "tetrahedron.off") << expected.error;
      EXPECT_EQ(generated<Surface>(
                    start, [&](Surface& s) { return smoothing::relax(s, d, 0.25); }, COPIES(c.delete_)),
                expected);
    }
    EXPECT_EQ(generated_everywhere<Surface>(start, [](Surface& s) { return smoothing::relax_everywhere(s); }),
              interpret_everywhere(module.rule("relax"), start, {0.5}));
  }
}

// Where all orbits allow it, it is done at all darts in place; where some do not, only the others change.
TEST_F(Smoothing, RequirementsOfEachDart) {
  auto const of = [](std::vector<char const*> const& files) {
    Map all(Surface::model(), Surface::embeddings());
    for (char const* file : files) {
      Map const part = read<Surface>(file);
      std::vector<Dart> const darts = all.add_darts(part.dart_count());
      for (int const i : part.model().dimensions) {
        for (Dart d = 0; d < part.dart_limit(); ++d) all.set_target(darts[d], i, darts[part.target(d, i)]);
      }
    }
    jrule::test::number_values(all);
    return all;
  };
  for (auto const& files : std::vector<std::vector<char const*>>{
           {"cube.obj"}, {"cube.obj", "tetrahedron.off"}, {"grid.ply", "cube.obj"}, {"tetrahedron.off", "patch.obj", "tetrahedron.off"}, {"patch.obj"}}) {
    SCOPED_TRACE(files.front());
    Map const start = of(files);
    for (double const limit : {1e9, 3.0, -1e9}) {
      Outcome const expected = interpret_everywhere(module.rule("dual"), start, {limit});
      EXPECT_EQ(generated_everywhere<Surface>(start, [&](Surface& s) { return smoothing::dual_everywhere(s, limit); }), expected);
      EXPECT_TRUE(limit > 0 || !expected.error.empty());
    }
    EXPECT_EQ(generated_everywhere<Surface>(start, [](Surface& s) { return smoothing::split_triangles_everywhere(s); }),
              interpret_everywhere(module.rule("split_triangles"), start, {}));
    EXPECT_EQ(generated_everywhere<Surface>(start, [](Surface& s) { return smoothing::lift_everywhere(s); }),
              interpret_everywhere(module.rule("lift"), start, {}));
  }
}

TEST_F(Smoothing, OrientedMaps) {
  using smoothing::Halfedges;
  for (char const* file : {"cube.obj", "tetrahedron.off", "grid.ply"}) {
    Map const start = read<Halfedges>(file);
    Outcome const expected = interpret(module.rule("relax_halfedges"), start, {1}, {0.3});
    EXPECT_EQ(expected.error, "");
    EXPECT_NE(expected.map, print_jmap(start));
    expect_valid(expected);
    EXPECT_EQ(generated<Halfedges>(
                  start, [](Halfedges& h) { return smoothing::relax_halfedges(h, 1, 0.3); }, COPIES(c.a)),
              expected);
  }
}

// ---- Names, imported modelers, bare models ----

TEST(Names, WorkAsWritten) {
  Module const module(rules + "/names.jrule");
  using names::Workspace;
  Map start(Workspace::model(), Workspace::embeddings());
  Map const field = squares();
  start.add_darts(field.dart_count());
  for (Dart const d : field.darts()) {
    for (int const dimension : {0, 1, 2}) start.set_target(d, dimension, field.target(d, dimension));
  }
  jrule::test::number_values(start);
  std::vector<jrule::Value> const arguments{1.5, jrule::Point3{1, 2, 3}, std::int64_t{4}, true, 0.0, jrule::Vec3{}};
  EXPECT_EQ(generated<Workspace>(
                start, [](Workspace& w) { return names::k(w, 9); }, COPIES(c.delete_, c.std, c.copies_, c.KResult_)),
            interpret(module.rule("k"), start, {9}, arguments));
  EXPECT_EQ(generated<Workspace>(
                start, [](Workspace& w) { return names::commit(w, 0, 8, 1, 2); }, COPIES(c.class_, c.int_)),
            interpret(module.rule("commit"), start, {0, 8}, {std::int64_t{1}, std::int64_t{2}}));
}

TEST(Modules, ImportedModelersAndBareModels) {
  Module const ops_module(rules + "/ops.jrule"), base_module(rules + "/base.jrule");
  base::Solid solid;
  ASSERT_TRUE(base::polygon_corner(solid));
  EXPECT_EQ(generated<base::Solid>(
                base::Solid().map(), [](base::Solid& s) { return base::polygon_corner(s); }, none)
                .map,
            interpret(base_module.rule("polygon_corner"), base::Solid().map(), {}, {}).map);
  EXPECT_EQ(generated<base::Solid>(
                solid.map(),
                [](base::Solid& s) {
                  return ops::extrude(s, 0, {0, 0, 1});
                },
                COPIES(c.a, c.b, c.c, c.d, c.e, c.f)),
            interpret(ops_module.rule("extrude"), solid.map(), {0}, {jrule::Vec3{0, 0, 1}}));
  ops::Gmap3 bare;
  ASSERT_TRUE(ops::beam(bare));
  ASSERT_TRUE(ops::beam(bare));
  EXPECT_EQ(generated<ops::Gmap3>(
                bare.map(), [](ops::Gmap3& m) { return ops::sew3(m, 0, 2); }, COPIES(c.a, c.b)),
            interpret(ops_module.rule("sew3"), bare.map(), {0, 2}, {}));
}

// ---- The generated class ----

TEST(Class, ReadsWritesAndChangesValues) {
  auto surface = Surface::from_map(read<Surface>("cube.obj"));
  ASSERT_TRUE(surface);
  EXPECT_EQ(surface->cells(0).size(), 8U);
  EXPECT_EQ(surface->cells(2).size(), 6U);
  jrule::Point3 const before = surface->position(0);
  surface->set_position(0, {9, 9, 9});
  for (Dart const d : orbit(surface->map(), jrule::orbit_of_dimensions({1, 2}), 0))
    EXPECT_EQ(surface->position(d), (jrule::Point3{9, 9, 9}));
  EXPECT_NE(surface->position(surface->map().target(0, 0)), (jrule::Point3{9, 9, 9}));
  EXPECT_NE(before, surface->position(0));
  surface->set_color(0, {0, 0, 1});
  EXPECT_EQ(surface->color(surface->map().target(0, 1)), (jrule::Color{0, 0, 1}));
  EXPECT_FALSE(find_violation(surface->map()));

  std::string const path = testing::TempDir() + "generated_class.jmap";
  ASSERT_TRUE(surface->write(path));
  auto const again = Surface::read(path);
  ASSERT_TRUE(again);
  EXPECT_EQ(print_jmap(again->map()), print_jmap(surface->map()));
}

TEST(Class, RefusesMapsOfOtherModelers) {
  EXPECT_FALSE(Surface::from_map(Map(jrule::gmap(2))));
  EXPECT_FALSE(Surface::from_map(Map(jrule::gmap(3), Surface::embeddings())));
  EXPECT_FALSE(ops::Gmap3::from_map(base::Solid().map()));
  EXPECT_TRUE(Surface::from_map(Map(jrule::gmap(2), Surface::embeddings())));
  EXPECT_FALSE(Surface::read(data + "missing.obj"));
}

}  // namespace
