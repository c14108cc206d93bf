// What an accepted rule promises, and what a refusal is worth, on random rules and random maps.
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "compiler/analysis/analyze.h"
#include "tests/property/application.h"
#include "tests/property/cases.h"
#include "tests/property/models.h"
#include "tests/reference/engine.h"

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

using Examine = Examined (*)(ir::RuleScheme const&, analysis::Plan const&, Site const&);

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
      Examined const examined = examine(rule, verdict.plan, site);
      if (examined.fault) RC_FAIL(*examined.fault + "\n" + describe(rule, site));
      ++(examined.applied ? tally.applied : tally.not_applied);
    }
  });
  EXPECT_TRUE(holds);
  if (holds) expect_telling(tally);
}

/// The verdicts that say that applications may break the model. Rules that give a node two arcs or leave arcs dangling are
/// left out: they have no double-pushout derivation that could break anything. So are dead left sides.
bool claims_a_broken_map(analysis::Verdict const& verdict) {
  for (auto const& refusal : verdict.refusals) {
    std::string const number(source::info(refusal.diagnostic.code).number);
    if (number == "J0301" || number == "J0303" || (number.starts_with("J033") && number != "J0333")) return false;
  }
  return !verdict.accepted();
}

std::string codes(analysis::Verdict const& verdict) {
  std::set<std::string> numbers;
  for (auto const& refusal : verdict.refusals) numbers.emplace(source::info(refusal.diagnostic.code).number);
  std::string text;
  for (std::string const& number : numbers) text += (text.empty() ? "" : " ") + number;
  return text;
}

bool breaks(ir::RuleScheme const& rule, Site const& site) {
  auto const derivation = reference::derive(rule, reference::plain(site.map), site.hooks);
  return derivation && reference::violation(derivation->result, rule.model());
}

}  // namespace

TEST(AcceptedRule, GivesMapsOfTheModelAndWhatTheReferenceEngineGives) {
  check_accepted("an accepted rule gives maps of the model, those of the reference engine", bare, examine);
}

TEST(AcceptedRule, GivesEachOrbitOneValue) {
  check_accepted("an accepted rule gives each orbit one value", embedded, examine_values);
}

// The analysis may refuse a sound rule. How often it does is not known, but how often a counterexample is found is; the share
// and the kinds without one are recorded.
TEST(RefusedRule, MostlyHasACounterexample) {
  std::map<std::string, std::pair<int, int>> kinds;  // refuted, not refuted
  int refuted = 0, refused = 0;
  bool const holds = rc::check("a refused rule mostly has a counterexample", [&] {
    Case c = *cases();
    ir::RuleScheme const rule = make_rule(c, bare);
    analysis::Verdict const verdict = analysis::analyze(rule);
    if (!claims_a_broken_map(verdict)) return;
    ++refused;
    bool found = false;
    for (int attempt = 0; attempt < 4 && !found; ++attempt, ++c.maps) {
      for (Site const& site : make_sites(c, rule)) {
        found = breaks(rule, site);
        if (found) break;
      }
    }
    auto& [yes, no] = kinds[codes(verdict)];
    ++(found ? yes : no);
    refuted += found;
  });
  EXPECT_TRUE(holds);
  RecordProperty("refused", refused);
  RecordProperty("refuted", refuted);
  for (auto const& [kind, counts] : kinds)
    RecordProperty("refuted of " + kind,
                   std::to_string(counts.first) + " of " + std::to_string(counts.first + counts.second));
  EXPECT_GE(refused, case_count() / 10);
  EXPECT_GE(refuted, refused * 3 / 4);
}

}  // namespace jrule::property
