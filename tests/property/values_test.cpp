// The values of the orbits, after random rules with random clauses, held against those that the reference allows; and what the
// analysis says of clauses whose value depends on the dart that it is computed at.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "compiler/analysis/analyze.h"
#include "jrule/io.h"
#include "tests/property/application.h"
#include "tests/property/cases.h"
#include "tests/property/clauses.h"
#include "tests/property/models.h"
#include "tests/reference/values.h"

namespace jrule::property {

namespace {

using reference::OrbitValues;

struct Tally {
  int accepted = 0, with_clauses = 0, with_warnings = 0, warned_and_shown = 0;  // rules
  int clauses = 0, warned_clauses = 0, shown_clauses = 0;
  int applied = 0, not_applied = 0;
  std::map<OrbitValues::Source, int> orbits;
  int parts_of_several = 0;      // of unwarned clauses: computed at several darts, and the same at all
  int differing_beyond_rule = 0;  // orbits of unwarned clauses whose parts meet beyond the rule with different values
};

/// The map with values that differ from orbit to orbit.
Map with_random_values(ir::Modeler const& modeler, Map const& bare, Random& random) {
  Map map = with_values(modeler, bare);
  for (std::size_t e = 0; e < map.embedding_count(); ++e) {
    Embedding& embedding = map.embedding(e);
    std::vector<Handle> fresh;
    std::set<std::size_t> drawn;
    for (std::size_t v = embedding.value_count(); v > 0; --v) {
      std::size_t number = random.below(100000);
      while (!drawn.insert(number).second) number = random.below(100000);
      double const components[] = {static_cast<double>(number)};
      fresh.push_back(embedding.add(from_components(embedding.spec().type, components)));
    }
    for (Dart d = 0; d < map.dart_limit(); ++d) embedding.set_handle(d, fresh.at(embedding.handle(d)));
  }
  return map;
}

Value value_of(Map const& map, std::size_t e, Dart d) {
  return map.embedding(e).value(map.embedding(e).handle(d));
}

reference::PlainValues plain_values(Map const& map) {
  reference::PlainValues values(map.embedding_count());
  for (std::size_t e = 0; e < values.size(); ++e) {
    for (Dart const d : map.darts()) values[e].emplace(d, value_of(map, e, d));
  }
  return values;
}

/// Up to rounding.
bool agree(Value const& a, Value const& b) {
  if (!std::holds_alternative<double>(a) || !std::holds_alternative<double>(b)) return a == b;
  double const x = std::get<double>(a), y = std::get<double>(b);
  return std::abs(x - y) <= 1e-9 * std::max({1.0, std::abs(x), std::abs(y)});
}

/// Where the darts of the reference's result lie in the interpreter's. The interpreter's pattern darts have no names when it is
/// done: those of the map are found again in the order that the plan walks them, and all copies and arcs are compared.
std::optional<std::map<Dart, Dart>> find_renaming(ir::RuleScheme const& rule, analysis::Plan const& plan,
                                                  Map const& before, std::vector<Dart> const& hooks,
                                                  reference::Derivation const& expected, Map const& after,
                                                  interpreter::Applied const& applied) {
  rewrite::Workspace workspace;
  std::vector<Dart> const pattern =
      hooks.empty() ? std::vector<Dart>{0} : rewrite::close_pattern(before, hooks[0], plan.generators, workspace);
  std::map<Dart, Dart> renamed;
  for (auto const& [d, arcs] : expected.result.targets) {
    if (before.contains(d)) renamed[d] = d;
  }
  for (ir::NodeId s = 0; s < rule.nodes.size(); ++s) {
    if (rule.nodes[s].deleted()) continue;
    for (std::size_t k = 0; k < pattern.size(); ++k) {
      auto const [known, is_new] = renamed.emplace(expected.copies.at({pattern[k], s}), applied.copies[s].at(k));
      if (known->second != applied.copies[s][k]) return {};
    }
  }
  if (renamed.size() != after.dart_count()) return {};
  for (auto const& [d, arcs] : expected.result.targets) {
    for (auto const& [i, to] : arcs) {
      if (to.size() != 1 || !after.contains(renamed.at(d)) || after.target(renamed.at(d), i) != renamed.at(to[0]))
        return {};
    }
  }
  return renamed;
}

struct Examination {
  ir::RuleScheme const& rule;
  analysis::Verdict const& verdict;
  Tally& tally;
  std::set<std::size_t> warned{};  // clauses
  std::set<std::size_t> shown{};   // those of them that really have different values somewhere

  std::string told(OrbitValues const& orbit) const {
    std::string text = rule.modeler->embeddings[orbit.embedding].name + "-orbit of";
    for (Dart const d : orbit.darts) text += ' ' + std::to_string(d);
    return text;
  }

  std::optional<std::string> compare(OrbitValues const& orbit, Map const& after, std::map<Dart, Dart> const& renamed) {
    ++tally.orbits[orbit.source];
    Value const value = value_of(after, orbit.embedding, renamed.at(orbit.darts.front()));
    for (Dart const d : orbit.darts) {
      if (value_of(after, orbit.embedding, renamed.at(d)) != value) return "two values in the " + told(orbit);
    }
    // A mean of several orbits is rounded, in which order is not said.
    bool const allowed = std::any_of(orbit.allowed.begin(), orbit.allowed.end(), [&](Value const& v) {
      return orbit.source == OrbitValues::Source::merged ? agree(v, value) : v == value;
    });
    if (!allowed) {
      std::string text = "the " + told(orbit) + " has the value " + to_string(value) + ", not one of";
      for (Value const& v : orbit.allowed) text += ' ' + to_string(v);
      return text;
    }
    return representatives(orbit);
  }

  /// Clauses without a warning have one value wherever they are computed.
  std::optional<std::string> representatives(OrbitValues const& orbit) {
    bool any_warned = false;
    for (OrbitValues::Part const& part : orbit.parts) {
      bool const one = std::all_of(part.values.begin(), part.values.end(),
                                   [&](Value const& v) { return agree(v, part.values.front()); });
      if (warned.contains(part.clause)) {
        any_warned = true;
        if (!one) shown.insert(part.clause);
        continue;
      }
      if (!one) {
        std::string text = "clause " + std::to_string(part.clause) + " has no warning, but in the " + told(orbit) + " the values";
        for (Value const& v : part.values) text += ' ' + to_string(v);
        return text;
      }
      tally.parts_of_several += part.values.size() > 1;
    }
    bool const differ = std::any_of(orbit.parts.begin(), orbit.parts.end(), [&](OrbitValues::Part const& part) {
      return !agree(part.values.front(), orbit.parts.front().values.front());
    });
    tally.differing_beyond_rule += !any_warned && differ;
    return {};
  }

  std::optional<std::string> examine(Map const& before, std::vector<Dart> const& hooks) {
    auto const plain = reference::plain(before);
    auto const expected = reference::derive(rule, plain, hooks);
    Map after = before;
    auto const applied = interpreted(rule, verdict.plan)(after, hooks);
    if (applied.has_value() != expected.has_value())
      return applied ? "it should not apply: " + expected.error() : "it should apply: " + to_string(applied.error());
    if (!applied) {
      ++tally.not_applied;
      return {};
    }
    ++tally.applied;
    if (auto const violation = find_violation(after)) return "the result is no map: " + violation->text;
    auto const renamed = find_renaming(rule, verdict.plan, before, hooks, *expected, after, *applied);
    if (!renamed) return "the results differ:\n" + print_jmap(after);
    for (OrbitValues const& orbit : reference::orbit_values(rule, plain, plain_values(before), *expected)) {
      if (auto fault = compare(orbit, after, *renamed)) return *fault + "\nafter:\n" + print_jmap(after);
    }
    return {};
  }

  void count() {
    ++tally.accepted;
    tally.clauses += static_cast<int>(rule.clauses.size());
    tally.warned_clauses += static_cast<int>(warned.size());
    tally.shown_clauses += static_cast<int>(shown.size());
    tally.with_clauses += !rule.clauses.empty();
    tally.with_warnings += !warned.empty();
    tally.warned_and_shown += !shown.empty();
  }
};

void record(Tally tally) {
  using testing::Test;
  using Source = OrbitValues::Source;
  Test::RecordProperty("cases", case_count());
  Test::RecordProperty("accepted", tally.accepted);
  Test::RecordProperty("with_clauses", tally.with_clauses);
  Test::RecordProperty("with_warnings", tally.with_warnings);
  Test::RecordProperty("warned_and_shown", tally.warned_and_shown);
  Test::RecordProperty("clauses", tally.clauses);
  Test::RecordProperty("warned_clauses", tally.warned_clauses);
  Test::RecordProperty("shown_clauses", tally.shown_clauses);
  Test::RecordProperty("applied", tally.applied);
  Test::RecordProperty("not_applied", tally.not_applied);
  Test::RecordProperty("orbits_of_clauses", tally.orbits[Source::clause]);
  Test::RecordProperty("orbits_kept", tally.orbits[Source::kept]);
  Test::RecordProperty("orbits_merged", tally.orbits[Source::merged]);
  Test::RecordProperty("orbits_by_default", tally.orbits[Source::fresh]);
  Test::RecordProperty("parts_of_several", tally.parts_of_several);
  Test::RecordProperty("differing_beyond_rule", tally.differing_beyond_rule);
}

}  // namespace

TEST(AcceptedRule, GivesEachOrbitAValueThatTheReferenceAllows) {
  Tally tally;
  bool const holds = rc::check("each orbit has one value, one that the reference allows", [&] {
    Case const c = *cases();
    ir::RuleScheme rule = make_rule(c, merging);
    if (!analysis::analyze(rule).accepted()) return;
    Random random(c.operation ^ c.maps);
    rule = with_clauses(std::move(rule), random);
    auto const fault = ir::verify(rule);
    if (fault) RC_FAIL(*fault);
    analysis::Verdict const verdict = analysis::analyze(rule);
    Examination examination{rule, verdict, tally};
    for (auto const& warning : verdict.warnings) {
      if (warning.code == source::Code::representative_dependence) examination.warned.insert(warning.span.begin);
    }
    for (Site const& site : make_sites(c, rule)) {
      Site const valued{with_random_values(*rule.modeler, site.map, random), site.hooks};
      if (auto const wrong = examination.examine(valued.map, valued.hooks)) RC_FAIL(*wrong + "\n" + describe(rule, valued));
    }
    examination.count();
  });
  record(tally);
  EXPECT_TRUE(holds);
  if (!holds) return;
  // The property holds vacuously where nothing is accepted, merged, computed or warned of.
  int const cases = case_count();
  EXPECT_GE(tally.with_clauses, cases / 6);
  EXPECT_GE(tally.clauses - tally.warned_clauses, cases / 3);
  EXPECT_GE(tally.warned_and_shown, cases / 20);
  EXPECT_GE(tally.applied, cases);
  EXPECT_GE(tally.parts_of_several, cases);
  EXPECT_GE(tally.orbits[OrbitValues::Source::clause], cases);
  EXPECT_GE(tally.orbits[OrbitValues::Source::merged], cases / 2);
}

}  // namespace jrule::property
