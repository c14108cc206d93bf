// Streams, against the loops that define them: of every length about that of registers, from every place in memory.
#include "jrule/stream.h"

#include <gtest/gtest.h>

#include <vector>

namespace jrule {

namespace {

constexpr std::uint32_t untouched = 77;

}  // namespace

TEST(Stream, CountsUp) {
  for (std::size_t end = 0; end < 100; ++end) {
    for (std::size_t begin = 0; begin <= end; ++begin) {
      std::vector<std::uint32_t> column(100, untouched), expected = column;
      stream::count_up(column.data(), begin, end, 5);
      for (std::size_t k = begin; k < end; ++k) expected[k] = static_cast<std::uint32_t>(5 + k);
      ASSERT_EQ(column, expected) << begin << " to " << end;
    }
  }
}

TEST(Stream, ShiftsAnotherColumnOrItself) {
  std::vector<std::uint32_t> from(100);
  for (std::size_t k = 0; k < from.size(); ++k) from[k] = static_cast<std::uint32_t>(k * k % 31);
  for (std::size_t end = 0; end < 100; ++end) {
    for (std::size_t begin = 0; begin <= end; ++begin) {
      std::vector<std::uint32_t> column(100, untouched), expected = column, in_place = from, expected_in_place = from;
      stream::shift(column.data(), from.data(), begin, end, 1000);
      stream::shift(in_place.data(), in_place.data(), begin, end, 1000);
      for (std::size_t k = begin; k < end; ++k) expected[k] = expected_in_place[k] = 1000 + from[k];
      ASSERT_EQ(column, expected) << begin << " to " << end;
      ASSERT_EQ(in_place, expected_in_place) << begin << " to " << end;
    }
  }
}

// Darts up to the last one that a map can have.
TEST(Stream, ReachesTheLastDart) {
  std::vector<std::uint32_t> column(64), from(64, 60);
  stream::count_up(column.data(), 0, 64, 0xffffffffU - 64);
  EXPECT_EQ(column.front(), 0xffffffffU - 64);
  EXPECT_EQ(column.back(), 0xfffffffeU);
  stream::shift(column.data(), from.data(), 0, 64, 0xffffffffU - 64);
  EXPECT_EQ(column.back(), 0xfffffffbU);
}

}  // namespace jrule
