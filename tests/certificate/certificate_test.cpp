// Every accepted rule has a certificate that the independent checker accepts; and the checker refuses what is no certificate.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <stdexcept>

#include "compiler/analysis/analyze.h"
#include "compiler/analysis/certify.h"
#include "tests/certificate/checker.h"
#include "tests/certificate/mutants.h"
#include "tests/property/cases.h"
#include "tests/property/models.h"
#include "tests/unit/rule_fixture.h"

namespace jrule::certificate {
namespace {

namespace fs = std::filesystem;

using analysis::Certificate;

/// What is seen in certificates: a kind of evidence that no rule needs is not tested.
struct Seen {
  int rules = 0, placements = 0, relations[4] = {}, closure[4] = {}, walks = 0, implied[3] = {}, steps = 0, added_cycles = 0, left_cycles = 0, paths = 0, no_loops = 0,
      mutants = 0;

  void note(Certificate const& c) {
    ++rules;
    placements += static_cast<int>(c.placements.size());
    for (auto const& r : c.relations) ++relations[static_cast<std::size_t>(r.evidence.kind)];
    for (auto const& e : c.closure) ++closure[e.relation ? 3 : static_cast<std::size_t>(e.generator.kind)];
    for (auto const& i : c.implied) {
      ++implied[static_cast<std::size_t>(i.evidence.kind)];
      walks += std::any_of(i.walk.steps.begin(), i.walk.steps.end(), [](auto const& step) { return !step.letter; });
    }
    for (auto const& r : c.reverses) steps += static_cast<int>(r.proof.steps.size());
    for (auto const& cycle : c.cycles) {
      ++(cycle.added ? added_cycles : left_cycles);
      if (cycle.proof) steps += static_cast<int>(cycle.proof->steps.size());
    }
    paths += static_cast<int>(c.paths.size());
    no_loops += static_cast<int>(c.no_loops.size());
  }
  void record() const {
    auto const put = [](std::string const& name, int count) { testing::Test::RecordProperty(name, count); };
    put("rules", rules), put("placements", placements), put("steps", steps), put("added_cycles", added_cycles), put("left_cycles", left_cycles);
    put("paths", paths), put("no_loops", no_loops), put("mutants", mutants);
    put("walks_along_words", walks);
    for (std::size_t k = 0; k < 3; ++k) put("implied_" + std::to_string(k), implied[k]);
    for (std::size_t k = 0; k < 4; ++k) put("relations_" + std::to_string(k), relations[k]), put("closure_" + std::to_string(k), closure[k]);
  }
};

std::vector<std::string> sources_in(std::vector<std::string> const& folders) {
  std::vector<std::string> paths;
  for (std::string const& folder : folders) {
    for (auto const& entry : fs::recursive_directory_iterator(fs::path(JRULE_SOURCE_DIR) / folder)) {
      if (entry.path().extension() == ".jrule") paths.push_back(entry.path().string());
    }
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

sema::Modules load(std::string const& path, source::Sources& sources, source::Diagnostics& diagnostics) {
  return sema::load(path, {JRULE_SOURCE_DIR "/stdlib", {}}, sources, diagnostics);
}

/// The accepted rules of all files, and some of the standard library's with dimensions given.
std::vector<ir::RuleScheme> accepted_rules() {
  std::vector<ir::RuleScheme> rules;
  for (std::string const& path : sources_in({"examples", "stdlib", "tests/golden", "tests/integration"})) {
    source::Sources sources;
    source::Diagnostics diagnostics;
    for (ir::RuleScheme& rule : sema::elaborate(load(path, sources, diagnostics), diagnostics).rules) rules.push_back(std::move(rule));
  }
  source::Sources sources;
  source::Diagnostics diagnostics;
  auto const basic = load(JRULE_SOURCE_DIR "/stdlib/std/basic.jrule", sources, diagnostics);
  for (std::string const name : {"sew", "unsew"}) {
    for (int n = 0; n <= 4; ++n) {
      for (int i = 0; i <= n; ++i) {
        auto rule = sema::instantiate(basic, name, {i}, n, diagnostics);
        if (rule) rules.push_back(*std::move(rule));
      }
    }
  }
  std::erase_if(rules, [](ir::RuleScheme const& rule) { return !analysis::analyze(rule).accepted(); });
  return rules;
}

TEST(Certificate, OfEveryAcceptedRuleIsRight) {
  Seen seen;
  for (ir::RuleScheme const& rule : accepted_rules()) {
    Certificate const certificate = analysis::certify(rule);
    EXPECT_EQ(fault(certificate, rule), std::nullopt) << ir::print(rule) << analysis::print(certificate, rule, {});
    seen.note(certificate);
  }
  seen.record();
  EXPECT_GE(seen.rules, 80);
  EXPECT_GT(std::min({seen.paths, seen.left_cycles, seen.added_cycles, seen.no_loops, seen.steps}), 0);
}

TEST(Checker, RefusesCertificatesWithOneThingWrong) {
  Seen seen;
  for (ir::RuleScheme const& rule : accepted_rules()) {
    for (Mutant const& mutant : mutants(analysis::certify(rule), rule.model())) {
      ++seen.mutants;
      EXPECT_NE(fault(mutant.certificate, rule), std::nullopt) << mutant.what << "\n" << ir::print(rule) << analysis::print(analysis::certify(rule), rule, {});
    }
  }
  EXPECT_GE(seen.mutants, 10000);
}

// A certificate proves its own rule, not one that is nearly the same.
TEST(Checker, RefusesTheCertificateOfAnotherRule) {
  std::string const head = "modeler M on gmap(2);\nrule r on M { left { hook a <0,1,2>; } right { a <_,1,2>; b <_,_,2>; c <2,_,_>; d <2,1,_>; ";
  ir::RuleScheme const right = tests::program_of(head + "a -0- b -1- c -0- d; } }").rules.at(0);
  Certificate const certificate = analysis::certify(right);
  EXPECT_EQ(fault(certificate, right), std::nullopt);
  for (std::size_t k = 0; k < right.right.arcs.size(); ++k) {
    ir::RuleScheme wrong = right;
    wrong.right.arcs[k].word.push_back({1, false});
    EXPECT_NE(fault(certificate, wrong), std::nullopt) << k;
    wrong = right;
    wrong.right.arcs.erase(wrong.right.arcs.begin() + static_cast<std::ptrdiff_t>(k));
    EXPECT_NE(fault(certificate, wrong), std::nullopt) << k;
  }
  ir::RuleScheme wrong = right;
  auto const more = std::make_shared<ir::Modeler>(*right.modeler);
  more->model = gmap(3);
  wrong.modeler = more;
  EXPECT_NE(fault(certificate, wrong), std::nullopt);
}

// Of each kind of evidence a rule that needs it.
TEST(Certificate, HasEachKindOfEvidence) {
  Seen seen;
  auto const certify = [&](std::string const& model, std::string const& sides) {
    ir::RuleScheme const rule = tests::program_of("modeler M on " + model + ";\nrule r on M { " + sides + " }").rules.at(0);
    EXPECT_EQ(tests::codes(analysis::analyze(rule)), "") << sides;
    Certificate const certificate = analysis::certify(rule);
    EXPECT_EQ(fault(certificate, rule), std::nullopt) << analysis::print(certificate, rule, {});
    for (Mutant const& mutant : mutants(certificate, rule.model())) {
      EXPECT_NE(fault(mutant.certificate, rule), std::nullopt) << mutant.what << "\n" << analysis::print(certificate, rule, {});
    }
    seen.note(certificate);
    return certificate;
  };
  // The hook's 2-arcs are loops, so 2 is ε on the pattern, and [0,2] is its own reverse with 0.
  Certificate const loop = certify("gmap(2)", "left { hook a <0,1>; a -2- a; } right { a; a -2- b; b <_,1>; b -0[0,2]- b; }");
  ASSERT_EQ(loop.relations.size(), 1U);
  EXPECT_EQ(to_string(loop.relations[0].word), "2");
  // b says that the pattern's 0 and 1 commute.
  Certificate const commute = certify("gmap(2)", "left { hook a <0,1>; hook b <0,2>; } right { a; b; c <0,2>; c -1- c; }");
  ASSERT_EQ(commute.relations.size(), 1U);
  EXPECT_EQ(to_string(commute.relations[0].word), "[0,1,0,1]");
  // The arc from c to d and its reverse say that 0·1 is ε on the pattern.
  Certificate const pair = certify("gmap(2)", "left { hook a <0,1>; hook c <0,1>; d; c -2[0]-> d; d -2[1]-> c; } right { a; c; d; c -2[1]-> d; d -2[0]-> c; }");
  ASSERT_EQ(pair.relations.size(), 1U);
  EXPECT_EQ(to_string(pair.relations[0].word), "[0,1]");
  // Completion in the first hook's component, in another one, and of single arcs.
  certify("gmap(2)", "left { hook a <>; b; c; d; a -0- b; a -2- c; b -2- d; } right { a; b; c; d; a -0- b; a -2- a; b -2- b; c -2- c; d -2- d; }");
  certify("gmap(2)", "left { hook a <>; hook b <>; c; d; e; b -0- c; c -2- d; d -0- e; } right { a; b; c; d; e; b -0- c; c -2- d; d -0- e; }");
  certify("omap(2)", "left { hook a <>; b; a -2-> b; } right { a; b; a -2-> b; }");
  // An implied arc from a node to itself, which the model makes its own reverse.
  Certificate const itself = certify("omap(4)", "left { hook a <2,3,4>; b <_,_,_>; a -1-> b; b -4-> b; } right { a; b; a -1-> b; b -4-> b; }");
  EXPECT_EQ(itself.implied.size(), 2U);
  // The words of the arcs 0[0,2] and 0[2] close the pattern under 0 and 2, so the map has a 2-arc wherever b is.
  certify("gmap(2)", "left { hook y <>; y -0- y; } right { y; y -0- y; n; n -0- n; n -1- n; n -2[2,0]- n; }");
  // The hook b lies beside one dart.
  Certificate const single = certify("omap(2)", "left { hook a <>; hook b <>; a -2- a; } right { a; b; a -2[1]-> a; }");
  ASSERT_FALSE(single.relations.empty());
  EXPECT_EQ(to_string(single.relations[0].word), "1");
  // 1·3 leads from the pattern into the pattern, though neither 1 nor 3 does.
  certify("omap(3)", "left { hook a <>; b; a -1-> b; } right { a; b; a -1[1,3]-> b; }");
  // The matched arc shows that 0·2 leads where 1 does, to another dart.
  certify("closed_gmap(2)", "left { hook a <0,2>; a -1[0,2]- a; } right { n; n -0[0,2]- n; n -1[0]- n; n -2[2]- n; }");
  // Closed maps: conjugates of letters move every dart.
  certify("closed_gmap(2)", "left { hook e <0,2>; a; e -1- a; } right { a; a -1[2]- a; }");
  EXPECT_GT(*std::min_element(std::begin(seen.relations), std::end(seen.relations)), 0);
  EXPECT_GT(*std::min_element(std::begin(seen.implied), std::end(seen.implied)), 0);
  seen.record();
}

/// The refusals that say that applications may break a map. Without the incident arcs the other conditions mean nothing, and of
/// dead left sides anything can be proved.
bool breaks_maps(analysis::Verdict const& verdict) {
  std::string const codes = tests::codes(verdict);
  bool const dead = std::any_of(verdict.refusals.begin(), verdict.refusals.end(), analysis::is_dead_left);
  return !verdict.accepted() && codes.find("J030") == std::string::npos && !dead;
}

/// An accepted rule has a certificate; of some, mutants are made, and refused.
void examine_accepted(ir::RuleScheme const& rule, std::uint64_t which, Seen& seen) {
  Certificate const certificate = analysis::certify(rule);
  auto const found = fault(certificate, rule);
  if (found) RC_FAIL(*found + "\n" + ir::print(rule) + analysis::print(certificate, rule, {}));
  seen.note(certificate);
  if (which % 8 != 0) return;
  auto const wrong = mutants(certificate, rule.model());
  for (std::size_t k = which / 8 % 3; k < wrong.size(); k += 3) {
    ++seen.mutants;
    if (!fault(wrong[k].certificate, rule)) RC_FAIL(wrong[k].what + " is not refused\n" + ir::print(rule) + analysis::print(certificate, rule, {}));
  }
}

/// Of a refused rule no certificate is made, or one that the checker refuses. Was one made?
bool examine_refused(ir::RuleScheme const& rule) {
  std::optional<Certificate> certificate;
  try {
    certificate = analysis::certify(rule);
  } catch (std::logic_error const&) {
    return false;
  }
  if (!fault(*certificate, rule)) RC_FAIL(ir::print(rule) + analysis::print(*certificate, rule, {}));
  return true;
}

TEST(Certificate, OfRandomRules) {
  Seen seen;
  int refused = 0, made_of_refused = 0;
  bool const holds = rc::check("exactly the accepted rules have certificates that the checker accepts", [&] {
    property::Case const c = *property::cases();
    ir::RuleScheme const rule = property::make_rule(c, property::bare);
    analysis::Verdict const verdict = analysis::analyze(rule);
    if (verdict.accepted()) {
      examine_accepted(rule, c.maps, seen);
    } else if (breaks_maps(verdict)) {
      ++refused;
      made_of_refused += examine_refused(rule);
    }
  });
  seen.record();
  RecordProperty("refused", refused);
  RecordProperty("made_of_refused", made_of_refused);
  EXPECT_TRUE(holds);
  EXPECT_GE(seen.rules, property::case_count() / 6);
  EXPECT_GE(seen.mutants, seen.rules);
  EXPECT_GE(refused, property::case_count() / 20);
  EXPECT_GT(made_of_refused, 0);
}

}  // namespace
}  // namespace jrule::certificate
