// A rule that is judged independent, at all orbits of its hook at once: held against the reference engine, which applies it at one
// orbit after the other.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "compiler/analysis/analyze.h"
#include "compiler/analysis/independence.h"
#include "jrule/io.h"
#include "tests/property/application.h"
#include "tests/property/cases.h"
#include "tests/property/clauses.h"
#include "tests/property/models.h"
#include "tests/reference/engine.h"
#include "tests/reference/values.h"

namespace jrule::property {

namespace {

struct Tally {
  int independent = 0, of_several_nodes = 0, dependent = 0;  // rules with one hook; several nodes on the left side
  int several = 0, left_out = 0, shared = 0, nowhere = 0;    // maps
  int merged = 0, given = 0;                                 // orbits
};

void record(Tally const& tally) {
  testing::Test::RecordProperty("independent", tally.independent);
  testing::Test::RecordProperty("of_several_nodes", tally.of_several_nodes);
  testing::Test::RecordProperty("dependent", tally.dependent);
  testing::Test::RecordProperty("maps_several_applications", tally.several);
  testing::Test::RecordProperty("maps_some_left_out", tally.left_out);
  testing::Test::RecordProperty("maps_shared_darts", tally.shared);
  testing::Test::RecordProperty("maps_nowhere", tally.nowhere);
  testing::Test::RecordProperty("merged", tally.merged);
  testing::Test::RecordProperty("given", tally.given);
}

OrbitType hook_orbit(ir::RuleScheme const& rule) {
  OrbitType type;
  for (Letter const letter : rule.hook_type) type.words.push_back({letter});
  return type;
}

Result<std::size_t> apply_all(ir::RuleScheme const& rule, analysis::Plan const& plan, Map& map) {
  rewrite::Workspace workspace;
  return interpreter::apply_all(rule, plan, map, {}, workspace);
}

struct Examination {
  ir::RuleScheme const& rule;
  analysis::Plan const& plan;
  Tally& tally;

  std::optional<std::string> examine(Map const& before, Random& random) const {
    auto const plain = reference::plain(before);
    std::vector<Dart> hooks;
    std::set<Dart> matched, matched_here;
    bool shared = false;
    std::size_t orbits = 0;
    for (Dart const d : number_orbits(before, hook_orbit(rule)).first) {
      ++orbits;
      auto const derived = reference::derive(rule, plain, {d});
      if (!derived) continue;
      hooks.push_back(d);
      matched_here.clear();
      for (auto const& [copy, dart] : derived->match) matched_here.insert(dart);
      for (Dart const dart : matched_here) shared |= !matched.insert(dart).second;
    }
    Map after = before;
    auto const applied = apply_all(rule, plan, after);
    if (hooks.empty()) {
      ++tally.nowhere;
      if (applied) return "it should apply nowhere";
      if (print_jmap(after) != print_jmap(before)) return "it applies nowhere, but the map is changed";
      return {};
    }
    if (!applied) return "it should apply: " + to_string(applied.error());
    if (*applied != hooks.size())
      return "it should apply at " + std::to_string(hooks.size()) + " orbits, not " + std::to_string(*applied);
    tally.several += hooks.size() > 1;
    tally.left_out += orbits > hooks.size();
    tally.shared += shared;
    if (auto const violation = find_violation(after)) return "the result is no map: " + violation->text;
    for (int order = 0; order < 2; ++order) {
      random.shuffle(hooks);
      if (auto fault = compare(before, hooks, after)) return fault;
    }
    return {};
  }

  /// One orbit after the other, in this order.
  std::optional<std::string> compare(Map const& before, std::vector<Dart> const& hooks, Map const& after) const {
    auto map = reference::plain(before);
    std::map<Dart, Dart> kept;
    for (Dart const d : before.darts()) kept[d] = d;
    for (Dart const d : hooks) {
      auto derived = reference::derive(rule, map, {d});
      if (!derived) return "it no longer applies at dart " + std::to_string(d) + ": " + derived.error();
      for (auto const& [copy, dart] : derived->match) {
        if (rule.nodes[copy.second].deleted()) kept.erase(dart);
      }
      map = std::move(derived->result);
    }
    if (!reference::isomorphic(map, reference::plain(after), kept, {}, {})) return "the results differ:\n" + print_jmap(after);
    return {};
  }
};

/// Calls `examine` for the rules with one hook that are judged independent.
template <class Examine>
void check_independent(std::string const& property, Tally& tally, ir::RuleScheme (*make)(Case const&), Examine examine) {
  bool const holds = rc::check(property, [&] {
    Case const c = *cases();
    ir::RuleScheme const rule = make(c);
    if (rule.hooks.size() != 1) return;
    analysis::Verdict const verdict = analysis::analyze(rule);
    if (!verdict.accepted()) return;
    if (!analysis::analyze_independence(rule, verdict.plan).independent()) {
      ++tally.dependent;
      return;
    }
    ++tally.independent;
    tally.of_several_nodes += verdict.plan.test_injectivity;
    Random random(c.maps);
    for (Site const& site : make_sites(c, rule)) {
      if (auto const fault = examine(rule, verdict.plan, site.map, random)) RC_FAIL(*fault + "\n" + describe(rule, site));
    }
  });
  record(tally);
  EXPECT_TRUE(holds);
}

Value value_of(Map const& map, std::size_t e, Dart d) { return map.embedding(e).value(map.embedding(e).handle(d)); }

/// What the policy makes of these values; any of them for `first`.
bool is_merged_from(Value const& value, std::vector<Value> const& parts, MergePolicy policy) {
  if (std::find(parts.begin(), parts.end(), value) != parts.end() && (parts.size() == 1 || policy == MergePolicy::first)) return true;
  std::vector<double> numbers;
  for (Value const& part : parts) numbers.push_back(component(part, 0));
  double const x = component(value, 0);
  switch (policy) {
    case MergePolicy::none:
    case MergePolicy::first: return false;
    case MergePolicy::mean: return std::abs(x - mean(std::span<double const>(numbers))) < 1e-9 * (1 + std::abs(x));
    case MergePolicy::min: return x == *std::min_element(numbers.begin(), numbers.end());
    case MergePolicy::max: return x == *std::max_element(numbers.begin(), numbers.end());
    case MergePolicy::function: return false;
  }
  return false;
}

}  // namespace

TEST(IndependentRule, AtAllOrbitsGivesWhatOneAfterTheOtherGives) {
  Tally tally;
  check_independent("at all orbits at once an independent rule gives what one application after the other gives", tally,
                    [](Case const& c) { return make_rule(c, bare); },
                    [&](ir::RuleScheme const& rule, analysis::Plan const& plan, Map const& map, Random& random) {
                      return Examination{rule, plan, tally}.examine(map, random);
                    });
  int const cases = case_count();
  EXPECT_GE(tally.independent, cases / 10);
  EXPECT_GE(tally.of_several_nodes, cases / 100);
  EXPECT_GE(tally.several, cases / 10);
  EXPECT_GE(tally.left_out, cases / 100);
  EXPECT_GE(tally.shared, cases / 1000);
}

// Each orbit of the result has the default if none of its darts was there before, else what the policy makes of the values that
// its darts had.
TEST(IndependentRule, AtAllOrbitsMergesAllValuesThatMeet) {
  Tally tally;
  auto const examine = [&](ir::RuleScheme const& rule, analysis::Plan const& plan, Map const& bare_map, Random&) -> std::optional<std::string> {
    Map const before = with_values(*rule.modeler, bare_map);
    Map after = before;
    if (!apply_all(rule, plan, after)) return {};
    if (auto const violation = find_violation(after)) return "the result is no map: " + violation->text;
    for (std::size_t e = 0; e < after.embedding_count(); ++e) {
      EmbeddingSpec const& spec = after.embedding(e).spec();
      auto const orbits = number_orbits(after, spec.orbit);
      std::vector<std::set<Handle>> brought(orbits.first.size());
      for (Dart const d : after.darts()) {
        if (before.contains(d)) brought[orbits.number[d]].insert(before.embedding(e).handle(d));
      }
      for (std::size_t o = 0; o < brought.size(); ++o) {
        Value const value = value_of(after, e, orbits.first[o]);
        std::vector<Value> parts;
        for (Handle const h : brought[o]) parts.push_back(before.embedding(e).value(h));
        tally.merged += parts.size() > 1;
        if (parts.empty() ? value != *spec.default_value : !is_merged_from(value, parts, spec.merge)) {
          return "the " + spec.name + "-orbit of dart " + std::to_string(orbits.first[o]) + " has the value " + to_string(value) + "\n" +
                 print_jmap(after);
        }
      }
    }
    return {};
  };
  check_independent("at all orbits at once an independent rule merges all values that meet", tally,
                    [](Case const& c) { return make_rule(c, merging); }, examine);
  EXPECT_GE(tally.independent, case_count() / 10);
  EXPECT_GE(tally.merged, case_count() / 10);
}

// Each clause gives its orbits what it gives them when its application is the only one: expressions see the map before.
TEST(IndependentRule, AtAllOrbitsGivesTheValuesOfEachApplication) {
  Tally tally;
  auto const make = [](Case const& c) {
    ir::RuleScheme rule = make_rule(c, merging);
    Random random(c.operation);
    return rule.hooks.size() == 1 && analysis::analyze(rule).accepted() ? with_clauses(std::move(rule), random) : rule;
  };
  auto const examine = [&](ir::RuleScheme const& rule, analysis::Plan const& plan, Map const& bare_map, Random&) -> std::optional<std::string> {
    Map const before = with_values(*rule.modeler, bare_map);
    Map after = before;
    if (!apply_all(rule, plan, after)) return {};
    if (auto const violation = find_violation(after)) return "the result is no map: " + violation->text;

    auto const plain = reference::plain(before);
    reference::PlainValues values(before.embedding_count());
    for (std::size_t e = 0; e < values.size(); ++e) {
      for (Dart const d : before.darts()) values[e].emplace(d, value_of(before, e, d));
    }
    std::vector<std::vector<Value>> allowed_new(values.size());  // of orbits all of whose darts are new
    std::vector<std::size_t> new_orbits(values.size(), 0);
    auto const is_one_of = [](Value const& value, std::vector<Value> const& allowed) {
      return std::find(allowed.begin(), allowed.end(), value) != allowed.end();
    };
    for (Dart const hook : number_orbits(before, hook_orbit(rule)).first) {
      auto const alone = reference::derive(rule, plain, {hook});
      if (!alone) continue;
      for (auto const& orbit : reference::orbit_values(rule, plain, values, *alone)) {
        using Source = reference::OrbitValues::Source;
        if (orbit.source != Source::clause && orbit.source != Source::fresh) continue;
        auto const old = std::find_if(orbit.darts.begin(), orbit.darts.end(), [&](Dart d) { return before.contains(d); });
        if (old == orbit.darts.end()) {
          ++new_orbits[orbit.embedding];
          allowed_new[orbit.embedding].insert(allowed_new[orbit.embedding].end(), orbit.allowed.begin(), orbit.allowed.end());
        } else if (Value const value = value_of(after, orbit.embedding, *old); !is_one_of(value, orbit.allowed)) {
          return "dart " + std::to_string(*old) + " has the value " + to_string(value) + " of " +
                 rule.modeler->embeddings[orbit.embedding].name + ", which its clause does not give\n" + print_jmap(after);
        }
        tally.given += orbit.source == Source::clause;
      }
    }
    for (std::size_t e = 0; e < values.size(); ++e) {
      auto const orbits = number_orbits(after, after.embedding(e).spec().orbit);
      std::set<std::uint32_t> with_old;
      for (Dart const d : after.darts()) {
        if (before.contains(d)) with_old.insert(orbits.number[d]);
      }
      if (orbits.first.size() - with_old.size() != new_orbits[e]) return "another number of new orbits\n" + print_jmap(after);
      for (std::uint32_t o = 0; o < orbits.first.size(); ++o) {
        if (!with_old.contains(o) && !is_one_of(value_of(after, e, orbits.first[o]), allowed_new[e]))
          return "a new orbit has a value that no clause gives it\n" + print_jmap(after);
      }
    }
    return {};
  };
  check_independent("at all orbits at once each clause of an independent rule gives what it gives alone", tally, make, examine);
  EXPECT_GE(tally.independent, case_count() / 10);
  EXPECT_GE(tally.given, case_count());
}

}  // namespace jrule::property
