// What the analysis says of cells, on random rules and random maps: cells are followed by their darts through what the reference
// engine makes of a map.
#include <gtest/gtest.h>

#include "compiler/analysis/analyze.h"
#include "tests/property/cases.h"
#include "tests/property/models.h"
#include "tests/reference/examination.h"

namespace jrule::property {

namespace {

using reference::PlainMap;
using reference::Tally;

void check_sites(ir::RuleScheme const& rule, std::vector<Site> const& sites, Tally& tally) {
  analysis::Verdict const verdict = analysis::analyze(rule);
  if (!verdict.accepted()) return;
  analysis::Effects const effects = analysis::analyze_effects(rule, verdict.plan);
  for (Site const& site : sites) {
    PlainMap const before = reference::plain(site.map);
    auto const derivation = reference::derive(rule, before, site.hooks);
    if (!derivation) continue;
    ++tally.applications;
    if (auto const fault = reference::examine(rule, effects, before, *derivation, tally)) RC_FAIL(*fault + "\n" + describe(rule, site));
  }
}

}  // namespace

TEST(Effects, OfRandomRulesAreThoseOfTheirApplications) {
  Tally tally;
  bool const holds = rc::check("cells are created, deleted, split, merged and counted as it is said", [&] {
    Case const c = *cases();
    ir::RuleScheme const rule = make_rule(c, bare);
    check_sites(rule, make_sites(c, rule), tally);
  });
  EXPECT_TRUE(holds);
  for (auto const& [name, value] :
       {std::pair{"applications", tally.applications}, {"created", tally.created}, {"deleted", tally.deleted}, {"kept", tally.kept},
        {"never_split", tally.never_split}, {"never_merged", tally.never_merged}, {"counts", tally.counts},
        {"local_counts", tally.local_counts}}) {
    testing::Test::RecordProperty(name, value);
    EXPECT_GE(value, case_count() / 50) << name;
  }
  // Some hundred cases may have none.
  testing::Test::RecordProperty("regular_counts", tally.regular_counts);
  EXPECT_GE(tally.regular_counts, case_count() / 1000 * 20);
}

}  // namespace jrule::property
