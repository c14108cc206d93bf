// A local application stays local: after the first ones it takes no memory, and it never reads what lies far from its darts.
#include <sys/mman.h>
#include <unistd.h>

#include <cstdlib>
#include <set>

#include "changes.h"
#include "tests/integration/allocations.h"
#include "tests/integration/torus.h"

namespace {

using changes::Field;
using jrule::Dart;
using jrule::Map;
using jrule::test::allocation_count;
using jrule::test::torus;
using jrule::test::torus_dart;

constexpr std::uint32_t size = 20;

// The i-th of all sides of squares, in no simple order.
Dart place(std::uint32_t i) { return torus_dart(size, 7 * i, 3 * i + i / size, 2 * i); }

// How many allocations there are in `count` calls of `apply` for the places from the first one on; each must succeed. It
// gives whether its rules were applicable.
template <class Apply>
std::size_t allocations(std::uint32_t first, std::uint32_t count, Apply const& apply) {
  std::size_t const before = allocation_count();
  std::uint32_t applied = 0;
  for (std::uint32_t i = first; i < first + count; ++i) applied += apply(place(i)) ? 1U : 0U;
  std::size_t const after = allocation_count();
  EXPECT_EQ(applied, count);
  return after - before;
}

// A rule and its inverse: its darts are taken from those that the inverse erased.
bool there_and_back(Field& field, Dart d) {
  auto const inserted = changes::insert_vertex(field, d);
  return inserted && changes::remove_vertex(field, inserted->b);
}

TEST(NoMemory, OnceEveryPoolHasBeenCompacted) {
  Field field = torus<Field>(size);
  auto const apply = [&](Dart d) { return there_and_back(field, d); };
  EXPECT_GT(allocations(0, 1, apply), 0U);
  // Values that no dart has any more are dropped when they are as many as darts: so large do pools become.
  (void)allocations(1, field.map().dart_limit(), apply);
  EXPECT_EQ(allocations(2, 1000, apply), 0U);
  EXPECT_FALSE(find_violation(field.map()));
}

TEST(NoMemory, AfterTheFirstIfThereIsRoomForValues) {
  Field field = torus<Field>(size);
  field.map().reserve(0, 2 * field.map().dart_limit());
  auto const apply = [&](Dart d) { return there_and_back(field, d); };
  EXPECT_GT(allocations(0, 3, apply), 0U);
  EXPECT_EQ(allocations(3, 1000, apply), 0U);
}

TEST(NoMemory, WhereTheMapGrowsIntoRoomForIt) {
  Field field = torus<Field>(size);
  auto const apply = [&](Dart d) { return changes::insert_vertex(field, d).has_value(); };
  EXPECT_GT(allocations(0, 3, apply), 0U);
  Dart const limit = field.map().dart_limit();
  field.map().reserve(1000 * 4, 1000);
  field.workspace().reserve(limit + 1000 * 4);
  EXPECT_EQ(allocations(3, 1000, apply), 0U);
  EXPECT_EQ(field.map().dart_limit(), limit + 1000 * 4);
  EXPECT_FALSE(find_violation(field.map()));
}

// ---- Far away ----

// All darts that some steps lead to.
std::set<Dart> around(Map const& map, Dart d, int steps) {
  std::set<Dart> all{d};
  for (int step = 0; step < steps; ++step) {
    for (Dart const at : std::set<Dart>(all)) {
      for (int const i : map.model().dimensions) all.insert(map.target(at, i));
    }
  }
  return all;
}

// Nothing of the array can be read or written any more, except the pages of these elements and the last page.
template <class T>
void close_far_pages(std::span<T const> array, std::set<Dart> const& near) {
  auto const page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  auto const address = [&](std::size_t k) { return reinterpret_cast<std::uintptr_t>(array.data() + k); };
  std::set<std::uintptr_t> open{address(array.size() - 1) / page};
  for (Dart const d : near) open.insert(address(d) / page);
  for (std::uintptr_t p = address(0) / page + 1; p <= address(array.size() - 1) / page; ++p) {
    if (open.count(p) == 0 && mprotect(reinterpret_cast<void*>(p * page), page, PROT_NONE) != 0) std::abort();
  }
}

// In a process of its own: ends with 0 if `apply` is true and stays near the dart.
template <class Apply>
[[noreturn]] void apply_fenced(Field field, Dart d, Apply const& apply) {
  Map const& map = field.map();
  field.map().reserve(100, 100);  // the arrays stay where they are
  field.workspace().reserve(map.dart_limit() + 100);
  std::set<Dart> const near = around(map, d, 6);
  for (int const i : map.model().dimensions) close_far_pages(map.targets(i), near);
  for (std::size_t e = 0; e < map.embedding_count(); ++e) close_far_pages(map.embedding(e).handles(), near);
  _exit(apply(field) ? 0 : 1);
}

TEST(FarAway, NothingIsTouched) {
  constexpr std::uint32_t n = 200;
  Field const field = torus<Field>(n);
  Dart const d = torus_dart(n, n / 2, n / 2, 2);
  auto const expect_local = [&](std::string const& what, auto const& apply) {
    EXPECT_EXIT(apply_fenced(field, d, apply), testing::ExitedWithCode(0), "") << what;
  };
  expect_local("growth", [d](Field& f) { return changes::insert_vertex(f, d).has_value(); });
  expect_local("deletion", [d](Field& f) { return there_and_back(f, d); });
  expect_local("a face", [d](Field& f) { return changes::triangulate_face(f, d).has_value(); });
  // Not `sew`: of what it connects it has to find all darts, for the value that they share.
  expect_local("split", [d](Field& f) { return changes::unsew(f, d).has_value(); });
  expect_local("refusal", [d](Field& f) { return !changes::remove_dart(f, d); });
  // The fence holds.
  EXPECT_DEATH(apply_fenced(field, d, [](Field& f) { return !cells(f.map(), 0).empty(); }), "");
  EXPECT_DEATH(apply_fenced(field, d, [](Field& f) { return changes::insert_vertex_everywhere(f).has_value(); }), "");
}

}  // namespace
