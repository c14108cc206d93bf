// Memory runs out, or a function from outside throws, at each place of an application where that may be.
#include "terrain.h"
#include "tests/integration/faults.h"
#include "tests/integration/soils.h"

namespace {

using jrule::Dart;
using jrule::test::applied;
using jrule::test::Contents;
using jrule::test::contents;
using jrule::test::describe_soil;
using jrule::test::every_allocation_fails;
using jrule::test::Fail;
using terrain::Paths;
using terrain::Terrain;

/// Each call of a function from outside throws. Returns how many they are.
template <class Subject, class Apply>
int every_call_fails(Subject const& start, Apply const& apply) {
  Contents const before = contents(start.map(), describe_soil);
  Contents const after = contents(applied(start, apply).map(), describe_soil);
  for (int calls = 0;; ++calls) {
    SCOPED_TRACE("after " + std::to_string(calls) + " calls");
    Subject subject = start;
    geo::calls_left = calls;
    try {
      auto const result = apply(subject);
      geo::calls_left = -1;
      EXPECT_TRUE(result) << to_string(result.error());
      EXPECT_TRUE(contents(subject.map(), describe_soil) == after);
      return calls;
    } catch (geo::Rock const& rock) {
      geo::calls_left = -1;
      SCOPED_TRACE(rock.where);
      expect_unharmed(subject, apply, before, after, describe_soil);
    }
    if (testing::Test::HasFatalFailure()) return calls;
  }
}

template <class Subject, class Apply>
void everything_fails(Subject const& start, Apply const& apply) {
  for (Fail const how : {Fail::once, Fail::from_then_on}) {
    EXPECT_GT(every_allocation_fails(start, apply, how, describe_soil), 0U);
  }
  EXPECT_GT(every_call_fails(start, apply), 0);
}

// Names that a string keeps outside itself: their copies take memory.
geo::Soil clay() { return geo::Soil("clay that is older than the hills", 0.5); }
geo::Soil marl() { return geo::Soil("marl of which little more is known", 0.25); }

class ExternFaults : public testing::Test {
 protected:
  ExternFaults() {
    geo::calls_left = geo::mixes_left = -1;
    geo::total_fails = false;
    // Erased darts come first: what is added takes their places, and then those after the last.
    auto const lost = pasture(terrain_);
    first_ = field(terrain_, 0, clay()).value();
    second_ = field(terrain_, 1, marl()).value();
    for (Dart const d : {lost->a, lost->b}) {
      for (int const i : {0, 1, 2}) terrain_.map().link(terrain_.map().target(d, i), i, terrain_.map().target(d, i));
    }
    terrain_.map().erase(lost->a);
    terrain_.map().erase(lost->b);
  }

  Terrain neighbours() const {
    return applied(terrain_, [this](Terrain& t) { return sew(t, first_.c, second_.h); });
  }

  Terrain terrain_;
  terrain::FieldResult first_, second_;
};

TEST_F(ExternFaults, DefaultsAndParameters) {
  everything_fails(terrain_, [](Terrain& t) { return pasture(t); });
  geo::Soil const ground = clay();
  everything_fails(terrain_, [&](Terrain& t) { return field(t, 2, ground); });
}

TEST_F(ExternFaults, LetsRequirementsAndClauses) {
  Terrain const start = neighbours();
  everything_fails(start, [this](Terrain& t) { return plough(t, first_.a, 0.25); });
  everything_fails(start, [this](Terrain& t) { return harden(t, first_.a, 0.125); });
}

TEST_F(ExternFaults, ClausesAtAllOrbitsAtOnce) {
  everything_fails(neighbours(), [](Terrain& t) { return harden_everywhere(t, 0.125); });
}

TEST_F(ExternFaults, MergesOnTrial) {
  everything_fails(terrain_, [this](Terrain& t) { return sew(t, first_.c, second_.h); });
  everything_fails(neighbours(), [this](Terrain& t) { return unite(t, first_.c); });
}

TEST_F(ExternFaults, MergesAfterClauses) {
  everything_fails(terrain_, [this](Terrain& t) { return sew_twice(t, first_.c, second_.h, first_.e, second_.b); });
}

TEST_F(ExternFaults, AddedDarts) {
  everything_fails(terrain_, [this](Terrain& t) { return strip(t, first_.c, second_.h); });
  // No function is called: both parts have the one value.
  for (Fail const how : {Fail::once, Fail::from_then_on}) {
    auto const divide_field = [this](Terrain& t) { return divide(t, first_.a, first_.d); };
    EXPECT_GT(every_allocation_fails(neighbours(), divide_field, how, describe_soil), 0U);
  }
}

TEST_F(ExternFaults, OrientedArcs) {
  auto cube = Paths::read(JRULE_SOURCE_DIR "/tests/data/cube.obj");
  ASSERT_TRUE(cube);
  for (Dart const d : cube->cells(2)) cube->set_soil(d, clay());
  everything_fails(*cube, [](Paths& p) { return open_border(p, 0); });
}

}  // namespace
