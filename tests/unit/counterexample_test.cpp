// Counterexamples hold: the reference engine, which shares nothing with the search, breaks the same maps. And sound
// rules have none.
#include "compiler/analysis/counterexample/counterexample.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

#include "compiler/analysis/counterexample/sample_maps.h"
#include "compiler/backend/draw/draw.h"
#include "jrule/io.h"
#include "tests/reference/engine.h"
#include "tests/unit/rule_fixture.h"

namespace jrule {
namespace {

using analysis::Counterexample;
using analysis::find_counterexample;
using tests::codes;
using tests::program_of;

std::set<std::string> code_set(analysis::Verdict const& verdict) {
  std::set<std::string> numbers;
  for (analysis::Refusal const& refusal : verdict.refusals)
    numbers.emplace(source::info(refusal.diagnostic.code).number);
  return numbers;
}

std::size_t arc_count(analysis::Graph const& graph) {
  std::size_t count = 0;
  for (Dart const d : graph.darts) {
    for (auto const& to : graph.targets[d]) count += to.size();
  }
  return count;
}
std::size_t arc_count(reference::PlainMap const& map) {
  std::size_t count = 0;
  for (auto const& [d, arcs] : map.targets) {
    for (auto const& [i, to] : arcs) count += to.size();
  }
  return count;
}

/// The map before is one, the rule matches it there, and what the reference engine makes of it breaks the model.
void expect_confirmed(ir::RuleScheme const& rule, Counterexample const& example, std::set<std::string> const& numbers) {
  EXPECT_EQ(example.before.model(), rule.model());
  auto const before = find_violation(example.before);
  EXPECT_FALSE(before) << before->text;
  EXPECT_EQ(example.hooks.size(), rule.hooks.size());
  auto const derivation = reference::derive(rule, reference::plain(example.before), example.hooks);
  if (!derivation) {
    // The rule matches, but leaves arcs dangling: there is no double pushout.
    EXPECT_TRUE(numbers.contains("J0303") && derivation.error().find("deleted dart") != std::string::npos)
        << derivation.error();
    EXPECT_EQ(example.violation.kind, Violation::Kind::incident_arcs);
    return;
  }
  EXPECT_TRUE(reference::violation(derivation->result, rule.model()));
  EXPECT_EQ(derivation->result.targets.size(), example.after.darts.size());
  EXPECT_EQ(arc_count(derivation->result), arc_count(example.after));
  for (ir::NodeId id = 0; id < rule.nodes.size(); ++id) {
    std::set<Dart> expected, copies(example.copies[id].begin(), example.copies[id].end());
    for (auto const& [copy, dart] : derivation->copies) {
      if (copy.second == id) expected.insert(dart);
    }
    if (rule.nodes[id].preserved()) {
      EXPECT_EQ(copies, expected);
    } else if (rule.nodes[id].added()) {
      EXPECT_EQ(copies.size(), expected.size());
    }
  }
}

struct Refused {
  char const* model;
  char const* sides;
  char const* codes;
};

// Each kind of refusal, on each kind of model: one hook, several, none; deleted and added nodes; words.
std::vector<Refused> const refused{
    {"gmap(2)", "left { hook a <0,1>; a -2- a; } right { a <0,1>; b <0,1>; a -2- b; b -1- b; }", "J0301"},
    {"gmap(2)", "left { } right { a; b; a -0- b; a -1- a; b -1- b; a -2- a; }", "J0302"},
    {"gmap(2)", "left { hook a <0,1>; } right { }", "J0303"},
    {"omap(2)", "left { hook a <>; b; a -1-> b; a -2- a; } right { b; }", "J0303 J0305"},
    {"gmap(2)", "left { hook a <0>; hook b <0>; b -2- b; } right { a; b; a -2- b; }", "J0304"},
    {"gmap(2)", "left { hook a <0>; b <0>; a -2- b; } right { a; b; }", "J0305 J0305"},
    {"omap(3)", "left { hook a <1>; a -2- a; } right { a; }", "J0305"},
    {"gmap(2)", "left { hook a <0,1>; a -2- a; } right { a; b <0,1>; c <0,1>; a -2-> b; b -2-> c; c -2-> a; }",
     "J0311 J0311 J0311"},
    {"gmap(2)", "left { hook a <>; b; c; a -1-> b; b -2- c; } right { a; b; c; a -1-> b; b -2- b; c -2- c; }",
     "J0324 J0323 J0323"},
    {"omap(2)", "left { hook a <1>; b <~1>; a -2-> b; } right { a; b; a -2[1]-> b; }", "J0312 J0311"},
    {"omap(2)", "left { hook a <1>; b <~1>; a -2- b; } right { a; b; a -2-> a; b -2[1]-> b; }", "J0313"},
    {"gmap(2)", "left { hook a <0,1,2>; } right { a <0,1,2>; b <1,0,2>; }", "J0321"},
    {"dual_omap(3)", "left { hook a <1,2,3>; } right { a <1,2,3>; b <2,1,3>; }", "J0321"},
    {"gmap(3)", "left { hook a <0,1,3>; a -2- a; } right { a; b <0,3,1>; a -2- b; }", "J0321"},
    {"gmap(3)", "left { hook e <0,2,3>; a; e -1- a; } right { a; a -1[2]- a; }", "J0321"},
    {"gmap(2)", "left { hook a <>; c; a -2- c; } right { a; c; a -2- a; c -2- c; }", "J0324 J0323 J0323"},
    {"gmap(2)", "left { hook a <>; hook b <>; a -2- a; b -2- b; } right { a; b; a -2- b; }", "J0324 J0324 J0323"},
    {"omap(3)", "left { hook a <>; hook b <>; a -3- a; b -3- b; } right { a; b; a -3- b; }", "J0324 J0324 J0323 J0323"},
    {"closed_gmap(2)", "left { hook a <0>; b <0>; a -2- b; } right { a; b; a -2- a; b -2- b; }", "J0333 J0333"},
    {"closed_gmap(2)", "left { hook e <0,2>; a; e -1- a; } right { a; a -1[0,2]- a; }", "J0341"},
    {"squares(2)", "left { hook a <1>; a -2- a; } right { a; b <1>; a -2- b; b -0[1]- b; a -0- a; }", "J0304"},
    {"squares(2)", "left { hook a <0,1,2>; } right { a; b <0,1,_>; b -2[0,1,0]- b; }", "J0321"},
    {"spheres", "left { hook a <0>; a -3- a; } right { a; b; a -3- b; b -1-> b; b -0- b; }", "J0321 J0324 J0323"},
    {"spheres", "left { hook a <0,1,3>; } right { a; b <0,1,_>; b -3- b; }", "J0321"},
    {"gmap(9)", "left { hook a <0>; a -9- a; } right { a; }", "J0305"},
};

std::string const user_models =
    "model squares(n) { dimensions 0..n; exchange (1,2); }\n"
    "model spheres { dimensions 0..1, 3; oriented 1; exchange (0,3), (1,3); }\n";

ir::RuleScheme rule_on(std::string const& model, std::string const& sides) {
  return program_of(user_models + "modeler M on " + model + ";\nrule r on M { " + sides + " }").rules.at(0);
}

TEST(Counterexample, IsConfirmedByTheReferenceEngine) {
  for (Refused const& r : refused) {
    SCOPED_TRACE(std::string(r.model) + ": " + r.sides);
    ir::RuleScheme const rule = rule_on(r.model, r.sides);
    analysis::Verdict const verdict = analysis::analyze(rule);
    EXPECT_EQ(codes(verdict), r.codes);
    auto const example = find_counterexample(rule);
    ASSERT_TRUE(example);
    EXPECT_LE(example->before.dart_count(), 8U);
    expect_confirmed(rule, *example, code_set(verdict));
  }
}

// The rules of the golden tests: those that are refused have counterexamples unless no map matches them, the others
// none.
TEST(Counterexample, AgreesWithTheVerdictsOnTheGoldenRules) {
  namespace fs = std::filesystem;
  std::set<fs::path> files;
  for (auto const& entry : fs::directory_iterator(JRULE_SOURCE_DIR "/tests/golden/topology")) {
    // That one file has errors before the analysis too.
    if (entry.path().extension() == ".jrule" && entry.path().stem() != "several-errors-fail")
      files.insert(entry.path());
  }
  std::size_t accepted = 0, refuted = 0;
  std::set<std::string> seen;
  for (fs::path const& path : files) {
    SCOPED_TRACE(path.string());
    std::ifstream in(path);
    ir::Program const program = program_of(std::string(std::istreambuf_iterator<char>(in), {}));
    for (ir::RuleScheme const& rule : program.rules) {
      SCOPED_TRACE(rule.name);
      analysis::Verdict const verdict = analysis::analyze(rule);
      std::set<std::string> const numbers = code_set(verdict);
      analysis::Search const search = analysis::search_counterexample(rule, verdict.accepted() ? 1500 : 20000);
      if (verdict.accepted()) {
        EXPECT_FALSE(search.counterexample) << search.counterexample->violation.text;
        EXPECT_GT(search.applications, 0U);
        ++accepted;
      } else if (std::any_of(verdict.refusals.begin(), verdict.refusals.end(), analysis::is_dead_left)) {
        EXPECT_EQ(search.applications, 0U);
      } else if (search.applications > 0) {
        ASSERT_TRUE(search.counterexample);
        expect_confirmed(rule, *search.counterexample, numbers);
        seen.insert(numbers.begin(), numbers.end());
        ++refuted;
      } else {
        EXPECT_TRUE(numbers.contains("J0301"));  // the left side gives a node two arcs
      }
    }
  }
  EXPECT_GE(accepted, 20U);
  EXPECT_GE(refuted, 25U);
  EXPECT_EQ(seen, (std::set<std::string>{"J0301", "J0302", "J0303", "J0304", "J0305", "J0311", "J0312", "J0313",
                                         "J0321", "J0323", "J0324", "J0333", "J0341"}));
}

TEST(Counterexample, IsTheSameEachTime) {
  ir::RuleScheme const rule = rule_on("gmap(2)", "left { hook a <>; c; a -2- c; } right { a; c; a -2- a; c -2- c; }");
  auto const a = find_counterexample(rule), b = find_counterexample(rule);
  ASSERT_TRUE(a && b);
  EXPECT_EQ(print_jmap(a->before), print_jmap(b->before));
  EXPECT_EQ(a->hooks, b->hooks);
  EXPECT_EQ(draw::graph_svg(rule, *a), draw::graph_svg(rule, *b));
}

TEST(Counterexample, IsAsSmallAsCanBe) {
  // An edge sewn along one end only: its two darts, and their neighbours along 0.
  auto const example =
      find_counterexample(rule_on("gmap(2)", "left { hook a <>; c; a -2- c; } right { a; c; a -2- a; c -2- c; }"));
  ASSERT_TRUE(example);
  EXPECT_EQ(example->before.dart_count(), 4U);
  EXPECT_EQ(example->violation.kind, Violation::Kind::cycle);
  EXPECT_EQ(example->violation.text, "dart 0: the path 0202 does not return (it ends at dart 1)");
}

TEST(Counterexample, OfALeftSideThatNothingMatchesThereIsNone) {
  analysis::Search const search =
      analysis::search_counterexample(rule_on("gmap(2)", "left { hook a <0,1,2>; a -2- a; } right { a; }"));
  EXPECT_FALSE(search.counterexample);
  EXPECT_EQ(search.applications, 0U);
}

// ---- Graphs ----

TEST(Graph, SaysWhatIsWrong) {
  Model const model = gmap(1);
  auto const violation = [&](std::vector<Dart> darts, std::vector<std::vector<std::vector<Dart>>> targets) {
    auto const found = analysis::find_violation({std::move(targets), std::move(darts)}, model);
    return found ? found->text : "";
  };
  EXPECT_EQ(violation({0, 1}, {{{1}, {0}}, {{0}, {1}}}), "");
  EXPECT_EQ(violation({0, 1}, {{{1}, {0}}, {{0}, {}}}), "dart 1 has no 1-arc");
  EXPECT_EQ(violation({0, 1}, {{{0, 1}, {0}}, {{0}, {1}}}), "dart 0 has two 0-arcs, to darts 0 and 1");
  EXPECT_EQ(violation({0, 1}, {{{1, 1}, {0}}, {{0}, {1}}}), "dart 0 has two 0-arcs, both to dart 1");
  EXPECT_EQ(violation({0, 1}, {{{0, 1, 1}, {0}}, {{0}, {1}}}), "dart 0 has 3 0-arcs, to darts 0, 1, 1");
  EXPECT_EQ(violation({0, 1}, {{{1}, {0}}, {{1}, {1}}}), "dart 1: two 0-arcs lead to it, from darts 0 and 1");
  EXPECT_EQ(violation({0}, {{{1}, {0}}, {{}, {}}}), "dart 0: its 0-arc leads to dart 1, which is deleted");
  EXPECT_EQ(violation({0}, {{{0}, {0}}, {{}, {1}}}), "dart 1 is deleted, but its 1-arc is not");
  EXPECT_EQ(violation({0, 1, 2}, {{{1}, {0}}, {{2}, {1}}, {{0}, {2}}}),
            "dart 0: its 0-arc leads to dart 1, whose 0-arc leads to dart 2");
}

// A graph that is a map is judged and printed as the map is.
TEST(Graph, AgreesWithMaps) {
  for (Model const& model : {gmap(2), omap(2), closed_gmap(2)}) {
    for (analysis::PartialMap const& partial : analysis::connected_maps(model, 4, 30)) {
      Map const map = partial.to_map();
      EXPECT_FALSE(analysis::find_violation(analysis::graph_of(map), model));
      EXPECT_EQ(analysis::print_graph(analysis::graph_of(map), model), print_jmap(map));
    }
  }
}

TEST(Graph, IsDrawnWithEveryDart) {
  ir::RuleScheme const rule = rule_on("gmap(2)", "left { hook a <0,1,2>; } right { a <0,1,2>; b <1,0,2>; }");
  auto const example = find_counterexample(rule);
  ASSERT_TRUE(example);
  std::string const svg = draw::graph_svg(rule, *example);
  auto const count = [&](std::string const& part) {
    std::size_t n = 0;
    for (std::size_t at = svg.find(part); at != std::string::npos; at = svg.find(part, at + 1)) ++n;
    return n;
  };
  EXPECT_EQ(count("<text class=\"n\""), example->before.dart_count() + example->after.darts.size());
  EXPECT_EQ(count("<text class=\"d\""), count("stroke-width=\"1.8\"") - rule.model().dimensions.size());
  EXPECT_EQ(count("stroke-width=\"8\""), 4U);  // the four steps of the path that does not return, one of them a loop
  EXPECT_EQ(count(example->violation.text), 1U);
}

// ---- Sample maps ----

// The subgroups of index n of Z, of the infinite dihedral group, and of Z/2.
TEST(SampleMaps, AreAsManyAsTheGroupHasSubgroups) {
  auto const count = [](Model const& model, Dart darts) { return analysis::connected_maps(model, darts, 1000).size(); };
  for (Dart n = 1; n <= 9; ++n) {
    EXPECT_EQ(count(omap(1), n), 1U);
    EXPECT_EQ(count(gmap(1), n), n % 2 == 0 ? n + 1 : n);
    EXPECT_EQ(count(gmap(0), n), n <= 2 ? 1U : 0U);
  }
}

TEST(SampleMaps, AreMapsOfTheirModel) {
  analysis::Choices choices;
  for (Model const& model : {gmap(2), gmap(4), omap(3), dual_omap(3), closed_gmap(3)}) {
    std::size_t completed = 0;
    for (int k = 0; k < 60; ++k) {
      analysis::PartialMap map(model);
      map.add_dart();
      if (!analysis::complete(map, 20, analysis::draw_manner(choices), choices)) continue;
      ++completed;
      EXPECT_TRUE(map.complete());
      EXPECT_LE(map.size(), 20U);
      auto const violation = find_violation(map.to_map());
      EXPECT_FALSE(violation) << violation->text;
    }
    EXPECT_GE(completed, 30U);
  }
}

}  // namespace
}  // namespace jrule
