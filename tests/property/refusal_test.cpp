// What a refusal is worth, on random rules: a map that the rule breaks.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <map>
#include <set>

#include "compiler/analysis/analyze.h"
#include "compiler/analysis/counterexample/counterexample.h"
#include "compiler/analysis/incident_arcs.h"
#include "tests/property/cases.h"
#include "tests/property/models.h"
#include "tests/reference/engine.h"

namespace jrule::property {

namespace {

using Codes = std::set<std::string>;

Codes codes_of(analysis::Verdict const& verdict) {
  Codes codes;
  for (auto const& refusal : verdict.refusals) codes.emplace(source::info(refusal.diagnostic.code).number);
  return codes;
}

/// Refused because no map matches it: it breaks none.
bool dead_left(ir::RuleScheme const& rule, analysis::Verdict const& verdict) {
  return analysis::gives_two_arcs(rule.left) || std::any_of(verdict.refusals.begin(), verdict.refusals.end(), analysis::is_dead_left);
}

std::string joined(Codes const& codes) {
  std::string text;
  for (std::string const& code : codes) text += (text.empty() ? "" : " ") + code;
  return text;
}

/// What speaks against a counterexample; the judge is the reference engine.
std::optional<std::string> fault(ir::RuleScheme const& rule, analysis::Counterexample const& example) {
  if (example.before.model() != rule.model()) return "it is of another model";
  if (auto const violation = find_violation(example.before)) return "it is no map: " + violation->text;
  auto const derivation = reference::derive(rule, reference::plain(example.before), example.hooks);
  if (!derivation) {
    // The rule matches, but leaves arcs dangling: there is no double pushout.
    bool const dangling = derivation.error().find("deleted dart") != std::string::npos;
    return dangling ? std::nullopt : std::optional("the rule does not apply: " + derivation.error());
  }
  if (!reference::violation(derivation->result, rule.model())) return "the rule does not break it";
  return {};
}

}  // namespace

// The analysis may refuse a sound rule, and the search gives up. How often either happens is recorded: at most one refusal in a
// hundred has no counterexample, and three have a left side that no map was found to match.
TEST(RefusedRule, HasACounterexample) {
  struct Count { int refuted = 0, unproved = 0, unmatched = 0; };
  std::map<std::string, Count> kinds;
  Count all;
  int drawn = 0;
  bool const holds = rc::check("the counterexamples of refused rules are right", [&] {
    Case const c = *cases();
    if (++drawn > case_count() / 4) return;  // a search takes as long as many applications
    ir::RuleScheme const rule = make_rule(c, bare);
    analysis::Verdict const verdict = analysis::analyze(rule);
    Codes const codes = codes_of(verdict);
    if (verdict.accepted() || dead_left(rule, verdict)) return;
    analysis::Search const search = analysis::search_counterexample(rule);
    if (search.counterexample) {
      if (auto const found = fault(rule, *search.counterexample)) RC_FAIL(*found + "\n" + ir::print(rule));
    }
    auto const count = search.counterexample ? &Count::refuted : search.applications > 0 ? &Count::unproved : &Count::unmatched;
    ++(all.*count);
    ++(kinds[joined(codes)].*count);
    if (!search.counterexample && std::getenv("JRULE_SHOW_UNPROVED")) std::cout << "no counterexample: " << joined(codes) << "\n" << ir::print(rule) << std::endl;
  });
  EXPECT_TRUE(holds);
  auto const record = [&](std::string const& name, Count const& count) {
    RecordProperty(name, std::to_string(count.refuted) + " refuted, " + std::to_string(count.unproved) + " not, " + std::to_string(count.unmatched) + " never matched");
  };
  record("all", all);
  for (auto const& [kind, count] : kinds) record(kind, count);
  EXPECT_GE(all.refuted, case_count() / 32);
  EXPECT_LE(all.unproved, all.refuted / 100);
  EXPECT_LE(all.unmatched, all.refuted * 3 / 100);
}

}  // namespace jrule::property
