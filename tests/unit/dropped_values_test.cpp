// Values are dropped when no dart refers to them any more: soon enough for memory, seldom enough for time.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <new>
#include <random>
#include <vector>

#include "jrule/io.h"
#include "jrule/trial.h"
#include "jrule/typed.h"

namespace jrule::rewrite {
namespace {

// A value that tells from outside whether it is still there, and that cannot be assigned.
struct Owned {
  explicit Owned(int n) : number(std::make_shared<int>(n)) {}
  std::shared_ptr<int> const number;
};

EmbeddingSpec owned(OrbitType orbit) {
  EmbeddingSpec spec{"owned", std::move(orbit), Type::Extern};
  spec.extern_name = "Owned";
  spec.extern_parts.make_pool = &make_pool<Owned>;
  return spec;
}

EmbeddingSpec weight(OrbitType orbit, MergePolicy merge = MergePolicy::none) {
  return {"weight", std::move(orbit), Type::Real, std::nullopt, merge};
}

// Polygons of an O-map side by side.
Map polygons(std::uint32_t count, std::uint32_t sides, EmbeddingSpec spec) {
  Map map(omap(2), {std::move(spec)});
  map.add_darts(std::size_t{count} * sides);
  for (Dart d = 0; d < map.dart_limit(); ++d) map.set_target(d, 1, d % sides == sides - 1 ? d + 1 - sides : d + 1);
  return map;
}

// Every polygon gets its own value; a witness of each.
std::vector<std::weak_ptr<int>> give_owned(Map& map) {
  std::vector<std::weak_ptr<int>> witnesses;
  Workspace workspace;
  for (Dart const d : number_orbits(map, map.embedding(0).spec().orbit).first) {
    Owned value(static_cast<int>(d));
    witnesses.emplace_back(value.number);
    set_extern_value(map, 0, d, std::move(value), workspace);
  }
  return witnesses;
}

std::size_t alive(std::vector<std::weak_ptr<int>> const& witnesses) {
  std::size_t count = 0;
  for (std::weak_ptr<int> const& witness : witnesses) count += witness.expired() ? 0U : 1U;
  return count;
}

int number_at(Map const& map, Dart d) { return *Values<Owned>(map.embedding(0))[d].number; }

OrbitType const face = orbit_of_dimensions({1});

TEST(DroppedValues, OverwrittenOnesAreDestroyed) {
  Map map = polygons(10, 4, owned(face));
  std::vector<std::weak_ptr<int>> const witnesses = give_owned(map);
  EXPECT_EQ(alive(witnesses), 10U);
  Workspace workspace;
  // Ten values were added already; each change adds one more and overwrites four handles, until it is forty.
  for (Dart f = 0; f < 5; ++f) set_extern_value(map, 0, 4 * f, Owned(100 + static_cast<int>(f)), workspace);
  EXPECT_EQ(alive(witnesses), 10U);
  set_extern_value(map, 0, 20, Owned(105), workspace);
  EXPECT_EQ(alive(witnesses), 4U);
  EXPECT_EQ(map.embedding(0).value_count(), 10U);
  for (Dart f = 0; f < 10; ++f) EXPECT_EQ(number_at(map, 4 * f + 2), static_cast<int>(f < 6 ? 100 + f : 4 * f));
}

TEST(DroppedValues, ThoseOfErasedDartsAreDestroyed) {
  Map map = polygons(10, 4, owned(face));
  std::vector<std::weak_ptr<int>> const witnesses = give_owned(map);
  Workspace workspace;
  for (Dart d = 8; d < 40; ++d) map.erase(d);
  EXPECT_EQ(alive(witnesses), 10U) << "no application has ended";
  drop_unused_values(map, workspace);
  EXPECT_EQ(alive(witnesses), 2U);
  EXPECT_EQ(number_at(map, 1), 0);
  EXPECT_EQ(number_at(map, 5), 4);
  EXPECT_EQ(map.embedding(0).handle(8), no_handle);
}

TEST(DroppedValues, MergedOnesAreDestroyed) {
  EmbeddingSpec spec = owned(face);
  spec.merge = MergePolicy::first;
  Map map = polygons(8, 1, spec);
  std::vector<std::weak_ptr<int>> const witnesses = give_owned(map);
  for (Dart d = 0; d < 8; ++d) map.set_target(d, 1, (d + 1) % 8);
  Workspace workspace;
  workspace.reserve(8);
  workspace.clear_marks();
  merge_orbit(map, 0, 3, workspace);
  drop_unused_values(map, workspace);
  EXPECT_EQ(alive(witnesses), 1U);
  for (Dart d = 0; d < 8; ++d) EXPECT_EQ(number_at(map, d), 3);
}

// A split copies handles: the value goes with the last of its darts.
TEST(DroppedValues, SharedOnesStay) {
  Map map = polygons(2, 4, owned(face));
  Embedding& e = map.embedding(0);
  Handle const h = add<Owned>(e, Owned(7));
  std::weak_ptr<int> const witness = e.values<Owned>()[h].number;
  for (Dart d = 0; d < 8; ++d) e.set_handle(d, h);
  Workspace workspace;
  for (int i = 0; i < 10; ++i) set_extern_value(map, 0, 0, Owned(i), workspace);
  EXPECT_FALSE(witness.expired());
  EXPECT_EQ(number_at(map, 4), 7);
  for (int i = 0; i < 10; ++i) set_extern_value(map, 0, 4, Owned(i), workspace);
  EXPECT_TRUE(witness.expired());
}

// At most twice the values that darts refer to, and the one that was just added.
TEST(DroppedValues, ALongSeriesKeepsThePoolSmall) {
  Map map = polygons(50, 5, weight(face));
  Workspace workspace;
  std::vector<double> expected(50, -1);
  for (std::uint32_t f = 0; f < 50; ++f) set_value(map, 0, 5 * f, -1.0, workspace);
  std::minstd_rand random(3);
  std::size_t most = 0;
  int times = 0;
  for (int i = 0; i < 20000; ++i) {
    auto const f = static_cast<std::uint32_t>(random() % 50);
    std::size_t const before = map.embedding(0).value_count();
    set_value(map, 0, 5 * f, static_cast<double>(i), workspace);
    expected[f] = i;
    most = std::max(most, map.embedding(0).value_count());
    if (map.embedding(0).value_count() <= before) ++times;
  }
  EXPECT_LE(most, 101U);
  EXPECT_LE(times, 20000 / 40) << "it is put off until it pays: six changes of handles and values each, of 250 darts";
  EXPECT_FALSE(find_violation(map));
  for (Dart d = 0; d < 250; ++d) EXPECT_EQ(Values<double>(map.embedding(0))[d], expected[d / 5]);
}

// The rare sweep must also be rare where there are few values: here one, on a large map.
TEST(DroppedValues, AFewChangesOfALargeMapDropNothing) {
  Map map = polygons(1000, 4, weight(face));
  Workspace workspace;
  Embedding& e = map.embedding(0);
  Handle const h = e.add(0.5);
  for (Dart d = 0; d < 4000; ++d) e.set_handle(d, h);
  for (std::uint32_t i = 0; i < 799; ++i) {
    set_value(map, 0, 0, 1.0 * i, workspace);
    ASSERT_EQ(e.value_count(), 2 + i);
  }
  EXPECT_FALSE(e.is_compaction_due());
  set_value(map, 0, 0, 3.0, workspace);
  EXPECT_EQ(e.value_count(), 2U);
  EXPECT_EQ(e.values<double>(), (ColumnOf<double>{0.5, 3.0}));
  EXPECT_EQ(e.handle(3), 1U);
  EXPECT_EQ(e.handle(4), 0U);
}

TEST(DroppedValues, ThoseThatNoDartEverHadAreDroppedToo) {
  Map map = polygons(2, 4, weight(face));
  Workspace workspace;
  for (Dart const d : {0U, 4U}) set_value(map, 0, d, 1.0, workspace);
  for (int i = 0; i < 100; ++i) {
    map.embedding(0).add(0.0);
    drop_unused_values(map, workspace);
    ASSERT_LT(map.embedding(0).value_count(), 16U) << "two for each dart";
  }
  EXPECT_FALSE(find_violation(map));
}

TEST(DroppedValues, AnEmptyMapHasNothingToDrop) {
  Map map(omap(2), {weight(face)});
  EXPECT_FALSE(map.embedding(0).is_compaction_due());
  Workspace workspace;
  drop_unused_values(map, workspace);
  map.embedding(0).add(1.0);
  drop_unused_values(map, workspace);
  EXPECT_EQ(map.embedding(0).value_count(), 0U);
}

// A trial that is not kept leaves the values, and what is known of them, as they were.
TEST(DroppedValues, AnUndoneTrialDropsNothing) {
  EmbeddingSpec spec = owned(face);
  spec.merge = MergePolicy::function;
  spec.extern_parts.add_merged = [](Embedding& embedding, std::span<Handle const> parts) {
    if (parts.size() == 2) return add<Owned>(embedding, Owned(99));
    throw std::bad_alloc();
  };
  Map map = polygons(4, 1, spec);
  std::vector<std::weak_ptr<int>> const witnesses = give_owned(map);
  std::vector<Handle> const before(map.embedding(0).handles().begin(), map.embedding(0).handles().end());
  Workspace workspace;
  workspace.reserve(4);
  for (int i = 0; i < 20; ++i) {
    Trial trial(map, workspace, 4);
    trial.begin_merges(0);
    trial.set_target(0, 1, 1);
    trial.set_target(1, 1, 0);
    trial.merge(0);
    EXPECT_EQ(map.embedding(0).value_count(), 5U);
    trial.set_target(1, 1, 2);
    trial.set_target(2, 1, 0);
    trial.begin_merges(0);
    EXPECT_THROW(trial.merge(0), std::bad_alloc);
  }
  EXPECT_FALSE(map.embedding(0).is_compaction_due());
  drop_unused_values(map, workspace);
  EXPECT_EQ(alive(witnesses), 4U);
  EXPECT_EQ(std::vector<Handle>(map.embedding(0).handles().begin(), map.embedding(0).handles().end()), before);
}

// What of a map is written does not depend on when values were dropped.
TEST(DroppedValues, FilesAreTheSame) {
  Map map = polygons(20, 3, weight(face));
  Workspace workspace;
  for (std::uint32_t f = 0; f < 20; ++f) set_value(map, 0, 3 * f, 0.5 * f, workspace);
  for (std::uint32_t f = 0; f < 8; ++f) set_value(map, 0, 57 - 3 * f, 7.0 + f, workspace);
  std::size_t const values = map.embedding(0).value_count();
  std::string const text = print_jmap(map);
  map.embedding(0).compact();
  EXPECT_LT(map.embedding(0).value_count(), values);
  EXPECT_EQ(print_jmap(map), text);
}

}  // namespace
}  // namespace jrule::rewrite
