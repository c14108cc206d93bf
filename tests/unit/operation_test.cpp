// Operations run by the interpreter: what they compute, counted by hand, and that those that fail leave the map bit for bit as it was.
#include <gtest/gtest.h>

#include "jrule/io.h"
#include "tests/process/process.h"
#include "tests/unit/operation_fixture.h"

namespace jrule {
namespace {

using ir::Evaluated;
using tests::bits;
using tests::Operations;

std::string const surface = tests::read(JRULE_SOURCE_DIR "/tests/data/polygons.jrule");

std::int64_t number(Map const& map, Dart d) { return std::get<std::int64_t>(map.embedding(1).value(map.embedding(1).handle(d))); }

std::int64_t integer(Result<std::optional<Evaluated>> const& result) { return std::get<std::int64_t>(std::get<Value>(result.value().value())); }

TEST(Operation, RunsItsStatementsInTheirOrder) {
  Operations s(surface + R"(
    operation fan(k: Int) on S -> Int {
      let first = triangle();
      let last = first.a;
      let i = 1;
      while i < k {
        let next = triangle(x: i);
        sew(last, next.a);
        last = next.c;
        i = i + 1;
      }
      if i == k { touch(last, k: i); } else { fail "never"; }
      return i * 10;
    })");
  Map map = s.empty();
  auto const result = s.run("fan", map, {Value{std::int64_t{4}}});
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_EQ(integer(result), 40);
  EXPECT_EQ(map.dart_count(), 24U);                // four triangles
  EXPECT_EQ(summarize(map).components, 1U);
  EXPECT_EQ(summarize(map).boundary_darts, 12U);   // 12 edges, 3 of them sewn with another: 6 stay free, of 2 darts each
  EXPECT_EQ(number(map, 18), 4);                   // the last triangle
  EXPECT_EQ(number(map, 0), 0);
  EXPECT_FALSE(find_violation(map));
}

TEST(Operation, ALoopTakesADartOfEachOrbitAsItWasBefore) {
  Operations s(surface + R"(
    operation double_corners() on S -> Int {
      let t = triangle();
      let rounds = 0;
      for e in face(t.a) by <0> { split(e); rounds = rounds + 1; }
      return rounds + 100 * count(<0,1>(t.a) by <0>);
    })");
  Map map = s.empty();
  EXPECT_EQ(integer(s.run("double_corners", map)), 3 + 600);  // three edges are split, so that there are six
}

TEST(Operation, DartsThatAreDeletedMeanwhileAreLeftOutOfALoop) {
  Operations s(surface + R"(
    operation eat(d: Dart) on S -> Int {
      let rounds = 0;
      for x in <0,1>(d) { remove_face(x); rounds = rounds + 1; }
      return rounds;
    }
    operation eat_triangle() on S -> Int { let t = triangle(); let n = eat(t.a); return n; })");
  Map map = s.empty();
  EXPECT_EQ(integer(s.run("eat_triangle", map)), 1);
  EXPECT_EQ(map.dart_count(), 0U);
}

TEST(Operation, ReadingADeletedDartFails) {
  Operations s(surface + R"(
    operation read() on S -> Int { let t = triangle(); let d = t.a; remove_face(d); return d.n; }
    operation compare() on S -> Bool { let t = triangle(); remove_face(t.a); return t.a == t.b; }
    operation tried() on S -> Int { let t = triangle(); remove_face(t.a); try { let n = count(<0>(t.a)); return n; } else { return 7; } })");
  Map map = s.empty();
  auto const failed = s.run("read", map);
  ASSERT_FALSE(failed);
  EXPECT_EQ(failed.error().message, "`read` failed: it reads a dart that is not in the map any more");
  EXPECT_EQ(failed.error().kind, Error::Kind::not_applicable);
  EXPECT_EQ(bits(map), bits(s.empty()));
  EXPECT_TRUE(s.run("compare", map));
  EXPECT_EQ(integer(s.run("tried", map)), 7);
}

TEST(Operation, ResultsHaveACopyForEachPatternDart) {
  Operations s(surface + R"(
    operation copies() on S -> Bool {
      let t = triangle();
      let r = split(t.a);
      let own = r.b == t.a@0 and r.b[t.a] == r.b;
      let other = r.b[t.b] == t.b@0;
      return own and other and r.a == t.a;
    }
    operation none() on S -> Dart {
      let t = triangle();
      let r = split(t.a);
      return r.b[t.d];
    })");
  Map map = s.empty();
  auto const result = s.run("copies", map);
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_EQ(*result, Evaluated(Value{true}));
  auto const none = s.run("none", map);
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().message, "`none` failed: there is no `r.b` for dart 11, which is not of the pattern");
}

TEST(Operation, ApplyAllStaysInItsOrbit) {
  Operations s(surface + R"(
    operation mark(d: Dart) on S { apply_all touch(k: 3) on connected(d); }
    operation two() on S { let a = triangle(); let b = triangle(); let c = triangle(); sew(b.a, c.a); mark(c.d); }
    operation nowhere(d: Dart) on S { apply_all remove_face() on connected(d); })");
  Map map = s.empty();
  ASSERT_TRUE(s.run("two", map));
  EXPECT_EQ(number(map, 0), 0);
  EXPECT_EQ(number(map, 6), 3);
  EXPECT_EQ(number(map, 12), 3);
  std::string const before = bits(map);
  auto const nowhere = s.run("nowhere", map, {Dart{12}});
  ASSERT_FALSE(nowhere);
  EXPECT_EQ(nowhere.error().message, "`remove_face` is not applicable: the 2-arc of `a` has to be a loop, but from dart 6 it leads to dart 12");
  EXPECT_EQ(bits(map), before);
  ASSERT_TRUE(s.run("nowhere", map, {Dart{0}}));
  EXPECT_EQ(map.dart_count(), 12U);
}

// ---- Transactions ----

struct Fails : testing::TestWithParam<char const*> {};

// Each operation `f(d)` changes the map and fails.
TEST_P(Fails, AndLeavesTheMapBitForBitAsItWas) {
  Operations s(surface + R"(
    operation start() on S { let a = triangle(); let b = triangle(2); remove_face(a.a); sew_up(b.a); }
    operation sew_up(d: Dart) on S { let c = triangle(5); sew(d, c.a); touch(d); })" + GetParam());
  Map map = s.empty();
  ASSERT_TRUE(s.run("start", map));
  std::string const before = bits(map);
  Dart const d = map.darts().back();
  auto const result = s.run("f", map, {d});
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().kind, Error::Kind::not_applicable);
  EXPECT_EQ(bits(map), before);
  // What was put back is a map like any other.
  Map copy = map;
  ASSERT_TRUE(s.run("start", map));
  ASSERT_TRUE(s.run("start", copy));
  EXPECT_EQ(bits(map), bits(copy));
}

INSTANTIATE_TEST_SUITE_P(
    Operation, Fails,
    testing::Values(
        R"(operation f(d: Dart) on S { let t = triangle(); split(t.a); touch(d); fail "at the end"; })",
        R"(operation f(d: Dart) on S { let t = triangle(); touch(d); remove_face(d); remove_face(d@2); })",
        R"(operation f(d: Dart) on S { for e in face(d) by <0> { split(e); let n = count(face(e) by <0>); if n == 5 { fail "enough"; } } })",
        R"(operation f(d: Dart) on S { let t = triangle(); g(t.a); } operation g(d: Dart) on S { split(d); h(d); } operation h(d: Dart) on S { split(d); fail "deep"; })",
        R"(operation f(d: Dart) on S { try { split(d); fail "a"; } else { split(d); fail "b"; } })",
        R"(operation f(d: Dart) on S { split(d); try { split(d); try { split(d); fail "a"; } else { touch(d); } split(d); } else { } let x = triangle(); remove_face(x.a); touch(x.a); })",
        R"(operation f(d: Dart) on S { let i = 0; while i < 5 { triangle(i); i = i + 1; } apply_all touch() on connected(d); apply_all remove_face() on connected(d); })",
        R"(operation f(d: Dart) on S { let t = triangle(); let r = split(t.a); let x = r.b[d]; })",
        R"(operation f(d: Dart) on S { g(d, 3); } operation g(d: Dart, n: Int) on S { split(d); if n > 0 { g(d, n - 1); } else { fail "at the bottom"; } })"));

TEST(Operation, TryUndoesItsBlockAndNothingElse) {
  Operations s(surface + R"(
    operation f() on S -> Int {
      let t = triangle();
      let tried = 0;
      let last = t.a;
      split(t.a);
      try {
        tried = 1;
        let r = split(t.a);
        last = r.b;
        split(t.a);
        try { split(t.a); fail "inner"; } else { touch(t.a); }
        fail "outer";
      } else {
        touch(last, k: 10);
      }
      return 1000 * tried + 100 * count(face(last) by <0>) + last.n;
    }
    operation g() on S -> Int {
      let t = triangle();
      let i = 0;
      for e in face(t.a) by <0> {
        try { touch(t.a); i = i + 1; if i == 2 { fail "the second"; } split(e); } else { i = i + 1; }
      }
      return 100 * i + 10 * t.a.n + count(face(t.a) by <0>);
    }
    operation h() on S -> Int {
      let t = triangle();
      try { once(t.a); } else { touch(t.a, k: 5); }
      try { twice(t.a); } else { touch(t.a, k: 50); }
      return t.a.n;
    }
    operation once(d: Dart) on S { touch(d); }
    operation twice(d: Dart) on S { touch(d); fail "after it"; })");
  Map map = s.empty();
  EXPECT_EQ(integer(s.run("f", map)), 4 * 100 + 10);     // only the split before `try` and the touch of its else are left
  Map other = s.empty();
  EXPECT_EQ(integer(s.run("g", other)), 300 + 20 + 5);   // the second round is undone, with its variables
  Map third = s.empty();
  EXPECT_EQ(integer(s.run("h", third)), 51);
}

TEST(Operation, RecursionHasALimitThatTryDoesNotHide) {
  Operations s(surface + R"(
    operation down(n: Int) on S -> Int {
      triangle(n);
      if n == 0 { return 0; }
      let below = down(n - 1);
      return below + 1;
    }
    operation tries() on S { triangle(); try { tries(); } else { triangle(); } })");
  Map map = s.empty();
  EXPECT_EQ(integer(s.run("down", map, {Value{std::int64_t{255}}})), 255);
  EXPECT_EQ(map.dart_count(), 6U * 256U);
  std::string const before = bits(map);
  for (auto const& [name, arguments] : {std::pair{"down", std::vector<Evaluated>{Value{std::int64_t{256}}}}, std::pair{"tries", std::vector<Evaluated>{}}}) {
    auto const deep = s.run(name, map, arguments);
    ASSERT_FALSE(deep);
    EXPECT_EQ(deep.error().message, std::string("operations call each other more than 256 deep, from `") + name + "` down to `" + name + "`");
    EXPECT_EQ(deep.error().kind, Error::Kind::limit);
    EXPECT_EQ(bits(map), before);
  }
}

TEST(Operation, TheCallerCancelsBetweenApplications) {
  Operations s(surface + R"(
    operation grow() on S { let i = 0; while i < 100 { triangle(); i = i + 1; } }
    operation tries() on S { try { grow(); } else { } }
    operation endless() on S { while true { } })");
  Map map = s.empty();
  std::vector<std::size_t> seen;
  auto const result = s.run("grow", map, {}, [&](std::size_t applications) {
    seen.push_back(applications);
    return applications < 3;
  });
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().message, "`grow` was cancelled: the map is as it was");
  EXPECT_EQ(result.error().kind, Error::Kind::cancelled);
  EXPECT_EQ(seen, (std::vector<std::size_t>{0, 0, 1, 1, 2, 2, 3}));  // before each round and each application
  EXPECT_EQ(bits(map), bits(s.empty()));
  EXPECT_FALSE(s.run("tries", map, {}, [](std::size_t applications) { return applications < 3; }));
  EXPECT_EQ(bits(map), bits(s.empty()));
  int asked = 0;
  EXPECT_FALSE(s.run("endless", map, {}, [&](std::size_t) { return ++asked < 50; }));
}

TEST(Operation, ArgumentsHaveToFit) {
  Operations s(surface + "operation f(d: Dart, n: Int) on S { touch(d, n); }");
  Map map = s.empty();
  for (std::vector<Evaluated> const& wrong : {std::vector<Evaluated>{}, {Dart{0}, Dart{1}}, {Value{1.0}, Value{1.0}}, {Dart{0}, Value{1.0}}}) {
    auto const result = s.run("f", map, wrong);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().kind, Error::Kind::bad_input);
  }
  auto const missing = s.run("f", map, {Dart{3}, Value{std::int64_t{1}}});
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().message, "`touch` is not applicable: the map has no dart 3 to be matched by the hook `f`");
  Map other(gmap(3));
  EXPECT_FALSE(s.run("f", other, {Dart{0}, Value{std::int64_t{1}}}));
}

// Is the map copied at the beginning of the body?
TEST(Operation, TheMapIsCopiedOnlyWhereSomethingMayFailAfterAChange) {
  Operations s(surface + R"(
    operation one(d: Dart) on S -> Dart { let n = d.n + 1; touch(d, n); return d; }
    operation either(d: Dart) on S { if d.n == 0 { touch(d); } else { split(d); } }
    operation early(d: Dart) on S { if d.n == 0 { touch(d); return; } split(d); }
    operation alternative(d: Dart) on S { try { touch(d); } else { split(d); } }
    operation last(d: Dart) on S -> Dart { let r = split(d); return r.b; }
    operation counted(d: Dart, n: Int) on S -> Int { touch(d); n = n + 1; return if n < 3 then n else 3; }
    operation two(d: Dart) on S { touch(d); touch(d); }
    operation read(d: Dart) on S -> Int { touch(d); return d.n; }
    operation chosen(d: Dart) on S -> Dart { let r = split(d); return r.b[d]; }
    operation loop(d: Dart) on S { for e in face(d) { touch(e); } }
    operation rounds(d: Dart) on S { let i = 0; while i < 3 { i = i + 1; touch(d); } }
    operation after(d: Dart) on S { try { touch(d); } else { } touch(d); }
    operation fails(d: Dart) on S { touch(d); fail "x"; })");
  for (char const* const name : {"one", "either", "early", "alternative", "last", "counted"}) {
    EXPECT_FALSE(analysis::may_fail_after_change(s.program.operations[s.index(name)].body)) << name;
  }
  for (char const* const name : {"two", "read", "chosen", "loop", "rounds", "after", "fails"}) {
    EXPECT_TRUE(analysis::may_fail_after_change(s.program.operations[s.index(name)].body)) << name;
  }
}

}  // namespace
}  // namespace jrule
