// Generated C++ for random rules, held against the reference engine and the interpreter on random maps.
#include <gtest/gtest.h>

#include <algorithm>

#include "compiler/analysis/analyze.h"
#include "compiler/analysis/independence.h"
#include "jrule/io.h"
#include "tests/property/cases.h"
#include "tests/property/clauses.h"
#include "tests/property/generated_code.h"
#include "tests/property/models.h"
#include "tests/property/mutation.h"
#include "tests/threads/bits.h"

namespace jrule::property {

namespace {

struct Drawn {
  Case which;
  AcceptedRule rule;
};

using Make = ir::RuleScheme (*)(Case const&);

/// Mostly with more words than rules have that somebody wrote.
ir::RuleScheme make_worded(Case const& c, std::shared_ptr<ir::Modeler const> (*modeler_of)(Model const&)) {
  ir::RuleScheme rule = make_rule(c, modeler_of);
  Random random(c.maps);
  return random.chance(75) ? move_added_copies(rule, random) : rule;
}
ir::RuleScheme make_bare(Case const& c) { return make_worded(c, bare); }
ir::RuleScheme make_embedded(Case const& c) { return make_worded(c, embedded); }
ir::RuleScheme make_with_clauses(Case const& c) {
  ir::RuleScheme rule = make_embedded(c);
  Random random(c.operation);
  return analysis::analyze(rule).accepted() ? with_clauses(std::move(rule), random) : rule;
}

/// The first so many of the random rules that are accepted.
std::vector<Drawn> draw_accepted(std::size_t count, Make make) {
  std::vector<Drawn> drawn;
  rc::Random random(case_seed());
  while (drawn.size() < count) {
    Case const c = cases()(random.split(), rc::kNominalSize).value();
    ir::RuleScheme scheme = make(c);
    analysis::Verdict verdict = analysis::analyze(scheme);
    if (!verdict.accepted()) continue;
    // The names of C++ functions and members.
    scheme.name = "rule_" + std::to_string(drawn.size());
    for (std::size_t s = 0; s < scheme.nodes.size(); ++s) scheme.nodes[s].name = "n" + std::to_string(s);
    drawn.push_back({c, {std::move(scheme), std::move(verdict.plan)}});
  }
  return drawn;
}

std::optional<std::string> difference_everywhere(AcceptedRule const& rule, GeneratedRule const& generated,
                                                 Map const& start) {
  Map expected = start, map = start;
  rewrite::Workspace workspace;
  bool const at_once = analysis::analyze_independence(rule.scheme, rule.plan).independent();
  auto const expected_result = at_once ? interpreter::apply_all(rule.scheme, rule.plan, expected, {}, workspace)
                                       : interpreter::apply_everywhere(rule.scheme, rule.plan, expected, {}, workspace);
  auto const result = generated.everywhere(map, {});
  auto const told = [](auto const& applied) { return applied ? std::string("yes") : to_string(applied.error()); };
  if (told(result) != told(expected_result))
    return "applied everywhere: " + told(result) + ", and by the interpreter: " + told(expected_result);
  if (map.darts() != expected.darts() || print_jmap(map) != print_jmap(expected))
    return "applied everywhere: the maps differ:\n" + print_jmap(map) + print_jmap(expected);
  if (!at_once) return {};
  for (Threads const threads : tests::several) {
    Map other = start, other_expected = start;
    bool const applied = generated.everywhere(other, threads).has_value();
    bool const interpreted = interpreter::apply_all(rule.scheme, rule.plan, other_expected, {}, workspace, threads).has_value();
    if (applied != result.has_value() || interpreted != result.has_value()) return "on several threads it applies elsewhere";
    if (auto const fault = tests::difference_in_bits(map, other)) return "on several threads: " + *fault + " differ";
    if (auto const fault = tests::difference_in_bits(expected, other_expected))
      return "interpreted on several threads: " + *fault + " differ";
  }
  return {};
}

/// Of the values that clauses give, the reference engine knows nothing: that they are the interpreter's is tested for
/// every rule.
Examined examine_result(ir::RuleScheme const& rule, Site const& site, Application const& apply) {
  Map map = with_values(*rule.modeler, site.map);
  if (!apply(map, site.hooks)) return {false, {}};
  auto const violation = find_violation(map);
  return {true, violation ? std::optional("the result is no map: " + violation->text) : std::nullopt};
}

class GeneratedRules : public testing::Test {
 protected:
  /// Compiling takes its time: fewer rules than other properties have cases, but each at many places.
  std::size_t const count = static_cast<std::size_t>(std::max(40, case_count() / 125));
  static constexpr std::size_t batch = 100;  // compiled at a time
  static constexpr int rounds = 4;
  std::size_t mutated = 0, clauses = 0, applied = 0, not_applied = 0, everywhere = 0, at_once = 0;

  using Examine = Examined (*)(ir::RuleScheme const&, Site const&, Application const&);

  /// The first fault of the rule, if any.
  void check(Drawn const& drawn, GeneratedRule const& generated, Examine examine) {
    ir::RuleScheme const& rule = drawn.rule.scheme;
    mutated += drawn.which.mutations.empty() ? 0U : 1U;
    clauses += rule.clauses.size();
    Case c = drawn.which;
    for (int round = 0; round < rounds; ++round, ++c.maps) {
      for (Site const& site : make_sites(c, rule)) {
        Examined examined = examine(rule, site, generated.apply);
        Map const start = with_values(*rule.modeler, site.map);
        if (!examined.fault)
          examined.fault = difference(start, site.hooks, generated.apply, interpreted(rule, drawn.rule.plan));
        if (!examined.fault && generated.everywhere) {
          examined.fault = difference_everywhere(drawn.rule, generated, start);
          ++(analysis::analyze_independence(rule, drawn.rule.plan).independent() ? at_once : everywhere);
        }
        ASSERT_FALSE(examined.fault) << *examined.fault << '\n' << describe(rule, site);
        ++(examined.applied ? applied : not_applied);
      }
    }
  }

  void check_all(std::string const& name, Make make, Examine examine) {
    std::vector<Drawn> const drawn = draw_accepted(count, make);
    for (std::size_t begin = 0; begin < count && !HasFailure(); begin += batch) {
      std::size_t const end = std::min(count, begin + batch);
      std::vector<AcceptedRule> rules;
      for (std::size_t i = begin; i < end; ++i) rules.push_back(drawn[i].rule);
      auto const generated = compile_rules(rules, name + '_' + std::to_string(begin / batch));
      for (std::size_t i = begin; i < end; ++i) {
        check(drawn[i], generated[i - begin], examine);
      }
    }
    RecordProperty("rules", std::to_string(count));
    RecordProperty("mutated", std::to_string(mutated));
    RecordProperty("clauses", std::to_string(clauses));
    RecordProperty("applied", std::to_string(applied));
    RecordProperty("not_applied", std::to_string(not_applied));
    RecordProperty("everywhere", std::to_string(everywhere));
    EXPECT_GE(mutated, count / 4);
    EXPECT_GE(applied, count * 4);
    EXPECT_GE(not_applied, count);
    RecordProperty("at_once", std::to_string(at_once));
    EXPECT_GE(everywhere, count);
    EXPECT_GE(at_once, count);
  }
};

}  // namespace

TEST_F(GeneratedRules, GiveWhatTheReferenceEngineGives) { check_all("bare", make_bare, examine); }

TEST_F(GeneratedRules, GiveEachOrbitOneValue) { check_all("embedded", make_embedded, examine_values); }

TEST_F(GeneratedRules, ComputeTheValuesOfClauses) {
  check_all("clauses", make_with_clauses, examine_result);
  EXPECT_GE(clauses, count);
}

}  // namespace jrule::property
