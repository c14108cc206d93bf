#include <gtest/gtest.h>

#include <atomic>
#include <new>
#include <stdexcept>
#include <vector>

#include "jrule/orbit_walk.h"
#include "jrule/parallel.h"

namespace jrule {

namespace {

TEST(Loop, CallsItsBodyOnceForEachIndex) {
  for (std::size_t const n : {0U, 1U, 2U, 7U, 64U, 1000U}) {
    for (Threads const threads : {Threads{}, Threads{0}, Threads{2, 1}, Threads{2, 0}, Threads{3, 5}, Threads{8, 1}, Threads{64, 400}}) {
      std::vector<int> calls(n, 0);
      parallel::for_each(n, threads, [&](std::size_t k) { ++calls[k]; });
      EXPECT_EQ(calls, std::vector<int>(n, 1)) << n << " on " << threads.count;
    }
  }
}

TEST(Loop, GivesEachThreadAtLeastAGrain) {
  std::vector<std::size_t> begins(100, 0), ends(100, 0);
  parallel::for_ranges(100, {2, 20}, [&](std::size_t begin, std::size_t end) {
    begins[begin] = 1;
    ends[begin] = end;
  });
  for (std::size_t begin = 0; begin < 100; ++begin) {
    if (begins[begin] == 1 && ends[begin] < 100) {
      EXPECT_GE(ends[begin] - begin, 20U);
    }
  }
  // Shorter loops stay in one piece.
  std::size_t pieces = 0;
  parallel::for_ranges(39, {2, 20}, [&](std::size_t, std::size_t) { ++pieces; });
  EXPECT_EQ(pieces, 1U);
  parallel::for_streams(159, {2, 20}, [&](std::size_t, std::size_t) { ++pieces; });
  EXPECT_EQ(pieces, 2U);
  std::atomic<std::size_t> indices = 0;
  parallel::for_streams(160, {2, 20}, [&](std::size_t begin, std::size_t end) {
    EXPECT_EQ(end - begin, 80U);
    indices += end - begin;
  });
  EXPECT_EQ(indices, 160U);
}

TEST(Loop, SeesWhatWasWrittenBeforeAndIsSeenAfter) {
  std::vector<std::size_t> column(10000, 1), sums(column.size());
  for (std::size_t round = 0; round < 20; ++round) {
    parallel::for_each(column.size(), {4, 16}, [&](std::size_t k) { sums[k] = column[k] + column[column.size() - 1 - k]; });
    for (std::size_t k = 0; k < column.size(); ++k) ASSERT_EQ(sums[k], 2 * (round + 1));
    parallel::for_each(column.size(), {3, 7}, [&](std::size_t k) { column[k] += 1; });
  }
}

TEST(Loop, PassesOnWhatABodyThrows) {
  for (int round = 0; round < 20; ++round) {
    EXPECT_THROW(parallel::for_each(1000, {4, 1},
                                    [](std::size_t k) {
                                      if (k % 100 == 99) throw std::bad_alloc();
                                    }),
                 std::bad_alloc);
  }
}

TEST(Loop, FindsAnyIndexThatFailsATest) {
  for (std::size_t const bad : {0U, 1U, 500U, 998U, 999U}) {
    EXPECT_FALSE(parallel::all_of(1000, {3, 10}, [&](std::size_t k) { return k != bad; }));
  }
  EXPECT_TRUE(parallel::all_of(1000, {3, 10}, [](std::size_t) { return true; }));
  EXPECT_TRUE(parallel::all_of(0, {3, 10}, [](std::size_t) { return false; }));
}

TEST(Loop, MayTakeAllThreadsOfTheMachine) { EXPECT_GE(Threads::all().count, 1U); }

TEST(Orbits, KnowTheirFirstIndex) {
  using rewrite::Index;
  // A circle of three, one of a single index, one of two: and the same indices as a circle and two paths of two involutions.
  std::vector<Index> const column{2, 1, 4, 5, 0, 3};
  std::vector<Index> const one{2, 1, 0, 5, 4, 3}, two{4, 1, 2, 5, 0, 3};
  std::vector<bool> const first{true, true, false, true, false, false};
  for (Index k = 0; k < column.size(); ++k) {
    EXPECT_EQ(rewrite::CycleOrbits(column.data()).is_first(k), first[k]) << k;
    EXPECT_EQ(rewrite::DihedralOrbits(one.data(), two.data()).is_first(k), first[k]) << k;
    EXPECT_EQ(rewrite::DihedralOrbits(two.data(), one.data()).is_first(k), first[k]) << k;
  }
}

// Not inlined: g++ 12 warns of an index past the end of columns whose length it knows.
[[gnu::noinline]] std::vector<rewrite::Index> make_column(rewrite::Index n, rewrite::Index (*to)(rewrite::Index k, rewrite::Index n)) {
  std::vector<rewrite::Index> column;
  for (rewrite::Index k = 0; k < n; ++k) column.push_back(to(k, n));
  return column;
}

TEST(Orbits, AreNotWalkedFarForTheirFirstIndex) {
  using rewrite::Index;
  std::vector<Index> const ring = make_column(1000, [](Index k, Index n) { return (k + 1) % n; });
  EXPECT_EQ(rewrite::CycleOrbits(ring.data()).is_first(0), std::nullopt);
  EXPECT_EQ(rewrite::CycleOrbits(ring.data()).is_first(999), false);
  // 0 1 | 2 3 | … and 1 2 | 3 4 | …: one long path.
  std::vector<Index> const one = make_column(1000, [](Index k, Index) { return k ^ 1U; });
  std::vector<Index> const two = make_column(1000, [](Index k, Index n) { return k == 0 || k == n - 1 ? k : ((k - 1) ^ 1U) + 1; });
  EXPECT_EQ(rewrite::DihedralOrbits(one.data(), two.data()).is_first(0), std::nullopt);
  EXPECT_EQ(rewrite::DihedralOrbits(two.data(), one.data()).is_first(999), false);
}

}  // namespace

}  // namespace jrule
