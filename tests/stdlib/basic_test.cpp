// The families of every dimension, on paths and polygons, surfaces, and solids.
#include "tests/reference/plain_map.h"
#include "tests/stdlib/application.h"
#include "tests/stdlib/measure.h"
#include "tests/stdlib/subjects.h"

namespace jrule::test {
namespace {

std::vector<Map> maps(int n) {
  std::vector<Map> all;
  if (n == 1) {
    for (Dart const k : {1U, 2U, 5U}) all.push_back(path(k, false));
    for (Dart const k : {2U, 3U, 6U}) all.push_back(path(k, true));
  } else if (n == 2) {
    static Module const module(JRULE_SOURCE_DIR "/stdlib/std/surface.jrule");
    ir::Modeler const& mesh = *module.rule("sew_edges").scheme.modeler;
    for (Shape const& shape : closed_surfaces()) {
      if (shape.name != "bunny") all.push_back(bare(build(mesh, shape.polygons)));
    }
    all.push_back(bare(build(mesh, grid(3, 2).polygons)));
    all.push_back(bare(build(mesh, moebius(4).polygons)));
  } else {
    static Module const module(JRULE_SOURCE_DIR "/stdlib/std/volume.jrule");
    for (Solid const& solid : solids()) {
      if (solid.points.size() < 40) all.push_back(bare(build(*module.rule("sew_volumes").scheme.modeler, solid)));
    }
  }
  return all;
}

bool same(Map const& a, Map const& b) {
  return reference::isomorphic(reference::plain(a), reference::plain(b), {}, {}, {});
}

/// About thirty darts of a map.
std::vector<Dart> some(Map const& map) {
  std::vector<Dart> darts;
  for (Dart const d : map.darts()) {
    if (d % (map.dart_count() / 30 + 1) == 0) darts.push_back(d);
  }
  return darts;
}

std::vector<long long> cell_counts(Map const& map) {
  auto const cells = summarize(map).cells;
  return {cells.begin(), cells.end()};
}
std::vector<long long> plus(std::vector<long long> counts, int dimension, long long by) {
  counts[static_cast<std::size_t>(dimension)] += by;
  return counts;
}

class Basic : public testing::TestWithParam<int> {
 protected:
  int n() const { return GetParam(); }
  OrbitType cell(int i) const;
};

TEST_P(Basic, SewClosesWhatUnsewOpened) {
  for (int i = 1; i <= n(); ++i) {
    auto const sew = instance("sew", {i}, n()), unsew = instance("unsew", {i}, n());
    int applied = 0;
    for (Map const& start : maps(n())) {
      for (Dart const d : some(start)) {
        if (!refusal(unsew, start, {d}).empty()) continue;
        ++applied;
        Dart const across = start.target(d, i);
        Map map = start;
        apply(unsew, map, {d});
        EXPECT_EQ(map.target(d, i), d);
        EXPECT_EQ(refusal(unsew, map, {d}).empty(), false);
        apply(sew, map, {d, across});
        EXPECT_TRUE(same(map, start));
      }
    }
    EXPECT_GT(applied, 5);
  }
}

TEST_P(Basic, SplitEdgeIsUndoneByJoinEdges) {
  auto const split = instance("split_edge", {}, n()), join = instance("join_edges", {}, n());
  for (Map const& start : maps(n())) {
    for (Dart const d : some(start)) {
      Map map = start;
      auto const copies = apply(split, map, {d});
      EXPECT_EQ(cell_counts(map), plus(plus(cell_counts(start), 0, 1), 1, 1));
      apply(join, map, {copies[2].front()});  // the node c
      EXPECT_TRUE(same(map, start));
    }
  }
}

TEST_P(Basic, ComponentsAreDoubledAndDeleted) {
  auto const twice = instance("duplicate_component", {}, n()), none = instance("delete_component", {}, n());
  for (Map const& start : maps(n())) {
    Map map = start;
    auto const copies = apply(twice, map, {0});
    EXPECT_EQ(summarize(map).components, 2U);
    std::vector<long long> doubled = cell_counts(start);
    for (long long& c : doubled) c *= 2;
    EXPECT_EQ(cell_counts(map), doubled);
    apply(none, map, {0});
    EXPECT_FALSE(map.contains(0));
    EXPECT_TRUE(same(map, start));
    apply(none, map, {copies[1].front()});
    EXPECT_EQ(map.dart_count(), 0U);
  }
}

TEST_P(Basic, CloseTakesTheBorderOfOneCellAway) {
  auto const close = instance("close", {}, n());
  int closed = 0;
  for (Map const& start : maps(n())) {
    Summary const was = summarize(start);
    bool const alone = was.cells.back() == 1 && was.boundary_darts == was.darts;
    EXPECT_EQ(refusal(close, start, {0}).empty(), alone);
    if (!alone) continue;
    ++closed;
    Map map = start;
    apply(close, map, {0});
    EXPECT_EQ(cell_counts(map), plus(cell_counts(start), n(), 1));
    EXPECT_EQ(summarize(map).boundary_darts, 0U);
  }
  EXPECT_EQ(closed, n() == 1 ? 1 : n() == 2 ? 0 : 6);
  if (n() != 2) return;
  for (Dart const sides : {3U, 4U, 7U}) {
    Map face(gmap(2));
    face.add_darts(2 * sides);
    Map const round = path(sides, true);
    for (Dart const d : round.darts()) {
      for (int const i : {0, 1}) face.set_target(d, i, round.target(d, i));
    }
    apply(close, face, {0});
    EXPECT_EQ(cell_counts(face), (std::vector<long long>{sides, sides, 2}));
    EXPECT_EQ(summarize(face).euler, 2);
  }
}

TEST_P(Basic, DeleteCellLeavesABorder) {
  auto const rule = instance("delete_cell", {}, n());
  int applied = 0;
  for (Map const& start : maps(n())) {
    for (Dart const d : some(start)) {
      if (!refusal(rule, start, {d}).empty()) continue;
      ++applied;
      Map map = start;
      apply(rule, map, {d});
      EXPECT_EQ(cell_counts(map).back(), cell_counts(start).back() - 1);
      EXPECT_GT(summarize(map).boundary_darts, summarize(start).boundary_darts);
    }
  }
  EXPECT_GE(applied, 5);
}

/// Of generalized maps: the orbit of all dimensions but one.
OrbitType Basic::cell(int i) const {
  std::vector<int> dimensions;
  for (int d = 0; d <= n(); ++d) {
    if (d != i) dimensions.push_back(d);
  }
  return orbit_of_dimensions(dimensions);
}

TEST_P(Basic, RemovedCellsJoinTheirNeighbours) {
  for (int i = 1; i < n(); ++i) {
    auto const rule = instance("remove_cell", {i}, n());
    int applied = 0;
    for (Map const& start : maps(n())) {
      auto const above = number_orbits(start, cell(i + 1)).number;
      for (Dart const d : some(start)) {
        if (above[d] == above[start.target(d, i + 1)] || !refusal(rule, start, {d}).empty()) continue;
        ++applied;
        Map map = start;
        apply(rule, map, {d});
        EXPECT_EQ(cell_counts(map), plus(plus(cell_counts(start), i, -1), i + 1, -1));
      }
    }
    EXPECT_GE(applied, 5) << "dimension " << i;
  }
}

TEST_P(Basic, ContractedCellsJoinTheirSides) {
  for (int i = 1; i < n(); ++i) {
    auto const rule = instance("contract_cell", {i}, n()), edge = instance("contract_cell", {1}, n());
    int applied = 0;
    for (Map start : maps(n())) {
      if (i == 2) {  // the faces of the edge of a tetrahedron become digons
        if (start.dart_count() != 24) continue;
        apply(edge, start, {0});
      }
      for (Dart const d : some(start)) {
        if (!refusal(rule, start, {d}).empty()) continue;
        if (i == 1 && summarize(start).boundary_darts != 0 && n() == 2) continue;
        ++applied;
        Map map = start;
        apply(rule, map, {d});
        EXPECT_EQ(cell_counts(map), plus(plus(cell_counts(start), i, -1), i - 1, -1));
      }
    }
    EXPECT_GE(applied, i == 2 ? 1 : 5) << "dimension " << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Dimension, Basic, testing::Range(1, 4));

}  // namespace
}  // namespace jrule::test
