// What an accepted rule promises, on random rules and random maps.
#include <gtest/gtest.h>

#include "compiler/analysis/analyze.h"
#include "tests/property/application.h"
#include "tests/property/cases.h"
#include "tests/property/models.h"
#include "tests/property/mutation.h"

namespace jrule::property {

namespace {

/// How many cases a property really said something about.
struct Tally {
  int accepted = 0, accepted_mutated = 0, refused = 0;
  int applied = 0, not_applied = 0;  // at hooks
};

/// Properties hold vacuously where nothing is accepted, refused or applied.
void expect_telling(Tally const& tally) {
  int const cases = case_count();
  testing::Test::RecordProperty("accepted", tally.accepted);
  testing::Test::RecordProperty("accepted_mutated", tally.accepted_mutated);
  testing::Test::RecordProperty("refused", tally.refused);
  testing::Test::RecordProperty("applied", tally.applied);
  testing::Test::RecordProperty("not_applied", tally.not_applied);
  EXPECT_GE(tally.accepted_mutated, cases / 6);
  EXPECT_GE(tally.refused, cases / 6);
  EXPECT_GE(tally.applied, cases);
  EXPECT_GE(tally.not_applied, cases / 6);
}

using Examine = Examined (*)(ir::RuleScheme const&, Site const&, Application const&);

/// Applies the accepted ones of the random rules at random places.
void check_accepted(std::string const& property, std::shared_ptr<ir::Modeler const> (*modeler_of)(Model const&),
                    Examine examine) {
  Tally tally;
  bool const holds = rc::check(property, [&] {
    Case const c = *cases();
    ir::RuleScheme const rule = make_rule(c, modeler_of);
    auto const fault = ir::verify(rule);
    if (fault) RC_FAIL(*fault);
    analysis::Verdict const verdict = analysis::analyze(rule);
    if (!verdict.accepted()) {
      ++tally.refused;
      return;
    }
    ++tally.accepted;
    if (!c.mutations.empty()) ++tally.accepted_mutated;
    for (Site const& site : make_sites(c, rule)) {
      Examined const examined = examine(rule, site, interpreted(rule, verdict.plan));
      if (examined.fault) RC_FAIL(*examined.fault + "\n" + describe(rule, site));
      ++(examined.applied ? tally.applied : tally.not_applied);
    }
  });
  EXPECT_TRUE(holds);
  if (holds) expect_telling(tally);
}

}  // namespace

TEST(AcceptedRule, GivesMapsOfTheModelAndWhatTheReferenceEngineGives) {
  check_accepted("an accepted rule gives maps of the model, those of the reference engine", bare, examine);
}

TEST(AcceptedRule, GivesEachOrbitOneValue) {
  check_accepted("an accepted rule gives each orbit one value", embedded, examine_values);
}

// Whether a copy is called (u, s) or (u·g, s) is nothing that a verdict may depend on.
TEST(AcceptedRule, StaysAcceptedWithTheCopiesOfAddedNodesMoved) {
  int accepted = 0;
  bool const holds = rc::check("a rule is accepted iff it is with the copies of added nodes moved", [&] {
    Case const c = *cases();
    ir::RuleScheme const rule = make_rule(c, bare);
    Random random(c.maps);
    ir::RuleScheme const moved = move_added_copies(rule, random);
    auto const fault = ir::verify(moved);
    if (fault) RC_FAIL(*fault);
    bool const is_accepted = analysis::analyze(rule).accepted();
    if (is_accepted != analysis::analyze(moved).accepted()) RC_FAIL(ir::print(rule) + ir::print(moved));
    accepted += is_accepted;
  });
  EXPECT_TRUE(holds);
  EXPECT_GE(accepted, case_count() / 6);
}

}  // namespace jrule::property
