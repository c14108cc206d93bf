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

template <class Walk>
void expect_same_walk(Map const& map, OrbitType const& type, OrbitType const& by, Walk const& walk) {
  for (Dart const d : map.darts()) {
    std::vector<Dart> visited;
    walk(d, [&](Dart at) { visited.push_back(at); });
    ASSERT_EQ(visited, rewrite::representatives(map, type, by, d)) << to_string(type) << " by " << to_string(by) << " from dart " << d;
    ASSERT_EQ(rewrite::count(walk, d), static_cast<std::int64_t>(visited.size()));
  }
}

// By its shape, as generated code has it, and as any type.
void expect_same_walks(Map const& map, OrbitType const& type, OrbitType const& by) {
  expect_same_walk(map, type, by, rewrite::OrbitWalk(map, type, by));
  auto const column = [&](Letter letter) {
    return (letter.conjugate ? map.sources(letter.dimension) : map.targets(letter.dimension)).data();
  };
  auto const turns = [&](Word const& word) { return word.size() == 1 && !map.model().is_oriented(word.front().dimension); };
  if (type.words.empty() || type == by) return expect_same_walk(map, type, by, rewrite::DartWalk{});
  Word const& first = type.words[0];
  if (type.words.size() == 1 && by.words.empty()) {
    if (turns(first)) return expect_same_walk(map, type, by, rewrite::EdgeWalk(column(first[0])));
    if (first.size() == 1) return expect_same_walk(map, type, by, rewrite::CycleWalk<1>({column(first[0])}));
    ASSERT_EQ(first.size(), 2U);
    return expect_same_walk(map, type, by, rewrite::CycleWalk<2>({column(first[0]), column(first[1])}));
  }
  if (type.words.size() != 2 || !turns(first) || !turns(type.words[1])) return;
  Dart const *const one = column(first[0]), *const two = column(type.words[1][0]);
  using rewrite::By;
  if (by.words.empty()) expect_same_walk(map, type, by, rewrite::DihedralWalk<By::dart>(one, two));
  if (by == OrbitType{{first}}) expect_same_walk(map, type, by, rewrite::DihedralWalk<By::first>(one, two));
  if (by == OrbitType{{type.words[1]}}) expect_same_walk(map, type, by, rewrite::DihedralWalk<By::second>(one, two));
}

void expect_same_walks(Map const& map, std::vector<Walked> const& all) {
  for (Walked const& walked : all) {
    for (OrbitType const& by : walked.by) expect_same_walks(map, walked.type, by);
  }
}

// The orbits of all darts under columns: fill() gives each the number of one of its darts, and no other.
template <class Orbits>
void expect_same_orbits(Map const& map, OrbitType const& type, Orbits const& orbits) {
  std::size_t const n = map.dart_limit();
  rewrite::Workspace workspace;
  workspace.begin();
  rewrite::Index const* const first = rewrite::first_of_orbits(orbits, n, workspace);
  OrbitNumbers const expected = number_orbits(map, type);
  for (Dart d = 0; d < n; ++d) ASSERT_EQ(first[d], expected.first[expected.number[d]]) << to_string(type) << " at dart " << d;
  for (Dart d = 0; d < n; ++d) {
    std::vector<rewrite::Index> numbers(n, rewrite::unset);
    orbits.fill(numbers.data(), d, 7);
    for (Dart e = 0; e < n; ++e) {
      ASSERT_EQ(numbers[e], expected.number[e] == expected.number[d] ? 7U : rewrite::unset) << to_string(type) << " from dart " << d;
    }
  }
}

void expect_same_orbits(Map const& map, int one, int two) {
  rewrite::Index const *const first = map.targets(one).data(), *const second = map.targets(two).data();
  rewrite::Index const* const columns[] = {first, second};
  rewrite::Workspace workspace;
  workspace.begin();
  OrbitType const type = orbit_of_dimensions({one, two});
  expect_same_orbits(map, type, rewrite::PatternOrbits(map.dart_limit(), columns, workspace));
  expect_same_orbits(map, orbit_of_dimensions({one}), rewrite::CycleOrbits(first));
  if (map.model().is_oriented(one)) return;
  expect_same_orbits(map, type, rewrite::DihedralOrbits(first, second));
  expect_same_orbits(map, type, rewrite::DihedralOrbits(second, first));
}

}  // namespace

TEST(OrbitWalk, VisitsTheRepresentativesInTheirOrder) {
  for (char const* file : {"cube.obj", "tetrahedron.off", "grid.ply", "moebius.obj", "patch.obj"}) {
    SCOPED_TRACE(file);
    auto const map = read_map(data + file, gmap(2), {});
    ASSERT_TRUE(map);
    expect_same_walks(*map, of_gmaps());
    for (int k = 0; k < 3; ++k) expect_same_orbits(*map, k, (k + 1) % 3);
  }
  for (char const* file : {"cube.obj", "tetrahedron.off", "grid.ply"}) {
    SCOPED_TRACE(file);
    auto const map = read_map(data + file, omap(2), {});
    ASSERT_TRUE(map);
    expect_same_walks(*map, of_omaps());
    expect_same_orbits(*map, 1, 2);
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
    for (int one = 0; one < 3; ++one) expect_same_orbits(map, one, (one + 1) % 3);
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
