// Walks that need no set of darts, against those that do.
#include "jrule/orbit_walk.h"

#include <gtest/gtest.h>

#include "jrule/io.h"
#include "jrule/typed.h"

namespace jrule {

namespace {

std::string const data = JRULE_SOURCE_DIR "/tests/data/";

OrbitType words(std::vector<Word> list) { return {std::move(list)}; }

// The types with what one dart may stand for in them: subgroups.
struct Walked {
  OrbitType type;
  std::vector<OrbitType> by;
};

std::vector<Walked> of_gmaps() {
  auto const dims = [](std::vector<int> const& d) { return orbit_of_dimensions(d); };
  return {{dims({}), {dims({})}},
          {dims({0}), {dims({}), dims({0})}},
          {dims({0, 1}), {dims({}), dims({0}), dims({1}), dims({0, 1})}},
          {dims({1, 0}), {dims({}), dims({0}), dims({1})}},
          {dims({1, 2}), {dims({}), dims({1}), dims({2})}},
          {dims({0, 2}), {dims({}), dims({0}), dims({2}), words({{{0, false}, {2, false}}})}},
          {words({{{1, false}, {2, false}}}), {dims({})}},
          {dims({0, 1, 2}), {dims({}), dims({1, 2}), dims({0})}}};
}

std::vector<Walked> of_omaps() {
  OrbitType const vertex = words({{{2, false}, {1, false}}}), face = orbit_of_dimensions({1}), edge = orbit_of_dimensions({2}),
                  backwards = words({{{1, true}}});
  return {{vertex, {{}, vertex}}, {face, {{}, face}}, {backwards, {{}}}, {edge, {{}}}, {orbit_of_dimensions({1, 2}), {{}, vertex, face, edge}}};
}

void expect_same_walks(Map const& map, std::vector<Walked> const& all) {
  for (Walked const& walked : all) {
    for (OrbitType const& by : walked.by) {
      rewrite::OrbitWalk const walk(map.model(), walked.type, by);
      for (Dart const d : map.darts()) {
        std::vector<Dart> visited;
        walk(map, d, [&](Dart at) { visited.push_back(at); });
        ASSERT_EQ(visited, rewrite::representatives(map, walked.type, by, d))
            << to_string(walked.type) << " by " << to_string(by) << " from dart " << d;
        ASSERT_EQ(rewrite::count(walk, map, d), static_cast<std::int64_t>(visited.size()));
      }
    }
  }
}

}  // namespace

TEST(OrbitWalk, VisitsTheRepresentativesInTheirOrder) {
  for (char const* file : {"cube.obj", "tetrahedron.off", "grid.ply", "moebius.obj", "patch.obj"}) {
    SCOPED_TRACE(file);
    auto const map = read_map(data + file, gmap(2), {});
    ASSERT_TRUE(map);
    expect_same_walks(*map, of_gmaps());
  }
  for (char const* file : {"cube.obj", "tetrahedron.off", "grid.ply"}) {
    SCOPED_TRACE(file);
    auto const map = read_map(data + file, omap(2), {});
    ASSERT_TRUE(map);
    expect_same_walks(*map, of_omaps());
  }
}

// Circles of one and two darts, paths of one: where the two ends of a walk meet.
TEST(OrbitWalk, VisitsTheSmallestOrbits) {
  for (int k = 0; k < 4; ++k) {
    Map map(gmap(2), {});
    map.add_darts(4);
    if ((k & 1) != 0) map.link(0, 0, 1);
    if ((k & 2) != 0) map.link(0, 1, 1);
    map.link(2, 2, 3);
    map.link(2, 0, 3);
    expect_same_walks(map, of_gmaps());
  }
}

// Sums of a walk are those of its list, to the last bit.
TEST(OrbitWalk, TotalsAreThoseOfLists) {
  std::vector<double> const reals{0.1, 1e17, -0.3, -1e17, 0.7};
  std::vector<Point3> points;
  std::vector<std::int64_t> ints;
  rewrite::Total<double> real_total;
  rewrite::Total<Point3> point_total;
  rewrite::Total<std::int64_t> int_total;
  for (double const x : reals) {
    points.push_back({x, -x, 3 * x});
    ints.push_back(static_cast<std::int64_t>(x) + INT64_MAX / 2);
    real_total.add(x);
    point_total.add(points.back());
    int_total.add(ints.back());
  }
  EXPECT_EQ(real_total.sum(), sum(reals));
  EXPECT_EQ(real_total.mean(), mean(reals));
  EXPECT_EQ(point_total.mean(), mean(points));
  EXPECT_EQ(int_total.sum(), sum(ints));
  EXPECT_EQ(int_total.mean(), mean(ints));
}

}  // namespace jrule
