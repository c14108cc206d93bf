// Columns: against std::vector, and the large ones whose pages move.
#include "jrule/column.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <numeric>
#include <random>
#include <vector>

#include "jrule/parallel.h"

namespace jrule {
namespace {

struct Pair {
  double first;
  std::uint8_t second;
  bool operator==(Pair const&) const = default;
};

Pair pair_of(std::uint32_t k) { return {k / 8.0, static_cast<std::uint8_t>(k % 256)}; }
std::uint32_t number_of(std::uint32_t k) { return k; }

/// Some hundred changes, each to a column and to a vector.
template <class T, class Make>
void change_both(Make make) {
  std::mt19937 random(1);
  ColumnOf<T> column;
  std::vector<T> expected;
  auto const below = [&](std::size_t n) { return static_cast<std::size_t>(random() % n); };
  for (int step = 0; step < 2000; ++step) {
    T const value = make(static_cast<std::uint32_t>(random()));
    switch (below(9)) {
      case 0:
      case 1:
        column.push_back(value);
        expected.push_back(value);
        break;
      case 2:
        if (expected.empty()) break;
        // One of its own elements, which may have to move.
        column.push_back(column[below(column.size())]);
        expected.push_back(column[column.size() - 1]);
        break;
      case 3: {
        if (expected.empty()) break;
        column.pop_back();
        expected.pop_back();
        break;
      }
      case 4: {
        std::size_t const size = below(400);
        column.resize(size, value);
        expected.resize(size, value);
        break;
      }
      case 5: {
        // What is added is unset.
        std::size_t const before = column.size(), size = below(400);
        column.resize(size);
        for (std::size_t k = before; k < size; ++k) column[k] = make(static_cast<std::uint32_t>(k));
        expected.resize(size);
        for (std::size_t k = before; k < size; ++k) expected[k] = make(static_cast<std::uint32_t>(k));
        break;
      }
      case 6: {
        std::size_t const capacity = below(600);
        column.reserve(capacity, {static_cast<unsigned>(1 + below(3)), 1 + below(20)});
        EXPECT_GE(column.capacity(), capacity);
        break;
      }
      case 7: {
        ColumnOf<T> const copy = column;
        column.clear();
        EXPECT_TRUE(column.empty());
        column = copy;
        break;
      }
      case 8: {
        ColumnOf<T> moved = std::move(column);
        column = ColumnOf<T>(moved.begin(), moved.end());
        EXPECT_EQ(column, moved);
        break;
      }
    }
    ASSERT_EQ(std::vector<T>(column.begin(), column.end()), expected) << "after step " << step;
    ASSERT_GE(column.capacity(), column.size());
  }
}

TEST(Column, IsWhatAVectorIs) {
  change_both<std::uint32_t>(number_of);
  change_both<Pair>(pair_of);
}

TEST(Column, OfNothingTakesNothing) {
  ColumnOf<double> column;
  EXPECT_EQ(column.begin(), column.end());
  EXPECT_EQ(column, ColumnOf<double>(0));
  column.reserve(0);
  EXPECT_EQ(column.data(), nullptr);
  ColumnOf<double> const copy = column;
  EXPECT_EQ(copy.capacity(), 0U);
}

TEST(Column, RoomThatIsThereIsNotTakenAgain) {
  ColumnOf<std::uint32_t> column(3, 7U);
  column.reserve(1000);
  std::uint32_t const* const before = column.data();
  for (std::uint32_t k = 3; k < 1000; ++k) column.push_back(k);
  column.resize(20);
  column.resize(1000, 5U);
  column.clear();
  column.resize(1000);
  EXPECT_EQ(column.data(), before);
  EXPECT_EQ(column.capacity(), 1000U);
}

TEST(Column, WhatNoMemoryHoldsIsRefused) {
  ColumnOf<double> column{1.5, 2.5};
  EXPECT_THROW(column.reserve(std::numeric_limits<std::size_t>::max() / 4), std::bad_alloc);
  EXPECT_THROW(column.reserve(std::numeric_limits<std::size_t>::max() / sizeof(double)), std::bad_alloc);
  EXPECT_EQ(column, (ColumnOf<double>{1.5, 2.5}));
  EXPECT_EQ(column.capacity(), 2U);
}

/// 0, 1, 2, …
ColumnOf<std::uint32_t> counted(std::size_t size) {
  ColumnOf<std::uint32_t> column(size);
  std::iota(column.begin(), column.end(), 0U);
  return column;
}

/// Of four bytes each: not whole pages, and from the first size to the last they take their memory in all ways that there are.
constexpr std::size_t sizes[] = {1001, 300'007, 3'000'017, 9'000'011, 30'000'001};

TEST(Column, GrowsToAnySize) {
  for (unsigned const threads : {1U, 2U}) {
    ColumnOf<std::uint32_t> column;
    for (std::size_t const size : sizes) {
      std::size_t const before = column.size();
      column.reserve(size, {threads});
      EXPECT_EQ(column.capacity(), size);
      column.resize(size);
      std::iota(column.begin() + before, column.end(), static_cast<std::uint32_t>(before));
      for (std::size_t k = 0; k < size; ++k) ASSERT_EQ(column[k], k) << "of " << size << " by " << threads << " threads";
    }
  }
}

TEST(Column, LargePagesOfItsOwnMoveAndAreNotCopied) {
  constexpr std::size_t size = 9'000'011, more = 30'000'001;
  ASSERT_TRUE(memory::has_own_pages(size * sizeof(std::uint32_t)));
  ColumnOf<std::uint32_t> column = counted(size);
  ColumnOf<std::uint32_t> const copy = column;
  column.reserve(more);
  column.resize(more);
  column[more - 1] = 1;  // its pages are there up to the end
  column.resize(size);
  EXPECT_EQ(column, copy);
  EXPECT_THROW(column.reserve(std::numeric_limits<std::size_t>::max() / 16), std::bad_alloc);
  EXPECT_EQ(column, copy);
  EXPECT_EQ(column.capacity(), more);
}

}  // namespace
}  // namespace jrule
