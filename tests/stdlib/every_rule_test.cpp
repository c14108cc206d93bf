// Every rule of the library, and every rule that one of std.basic stands for, on at least five shapes: the result is a
// map of its model, as the reference engine says; and cells are new, deleted, split, merged and counted as the analysis
// and the rule's comment say.
#include <algorithm>
#include <map>
#include <set>

#include "compiler/backend/interpreter/interpreter.h"
#include "tests/reference/examination.h"
#include "tests/stdlib/library.h"
#include "tests/stdlib/stated.h"

namespace jrule::test {
namespace {

using analysis::CellEffects;
using analysis::Effects;
using Hooks = std::vector<Dart>;

constexpr std::size_t enough = 5;  // shapes, for every rule: none is excepted

// ---- What stays open, and why ----

/// Rules, and those of std.basic for all dimensions, that split or merge cells: which ones, the analysis says, but how
/// many, it depends on the map. Of which dimensions, by their letters, or of all for which the analysis has no number.
struct Open {
  std::string cells, reason;
};
std::map<std::string, Open> const open_counts{
    {"sew_edges", {"V", "vertices may be one already"}},
    {"unsew_edge", {"V", "a vertex becomes two if it is on a border"}},
    {"join_sides", {"VF", "vertices and faces may be one already"}},
    {"sew_volumes", {"VE", "vertices and edges may be one already"}},
    {"unsew_volumes", {"VE", "vertices and edges become two if they are on a border there"}},
    {"sew", {"", "cells may be one already"}},
    {"unsew", {"", "cells become two unless they are joined elsewhere"}},
    {"remove_cell", {"", "its two neighbours may be one, which may become two"}},
    {"contract_cell", {"", "its two sides may be one"}},
    {"delete_cell", {"", "cells of its border become two if they are on a border already"}},
};

// ---- One rule on its shapes ----

/// Where it may fit. Of two hooks, the first is at few darts.
std::vector<Hooks> sites(ir::RuleScheme const& rule, Map const& map) {
  if (rule.hooks.empty()) return {{}};
  std::vector<Dart> const darts = spread(map);
  std::vector<Hooks> found;
  for (std::size_t k = 0; k < darts.size(); ++k) {
    if (rule.hooks.size() == 1) found.push_back({darts[k]});
    for (std::size_t l = 0; rule.hooks.size() == 2 && k < 6 && l < darts.size(); ++l)
      found.push_back({darts[k], darts[l]});
  }
  return found;
}

char letter(CellEffects const& cells) { return "VEFC"[cells.dimension]; }

struct Audit {
  explicit Audit(Module::Rule const& its_rule) : rule(its_rule) {}

  Module::Rule const& rule;
  Effects const effects = analysis::analyze_effects(rule.scheme, rule.plan);
  std::vector<Stated> const stated = stated_counts(rule.scheme.doc);
  std::vector<Value> const arguments = some_arguments(rule.scheme);
  std::set<std::string> applied{};               ///< the shapes
  std::map<char, std::set<long long>> deltas{};  ///< of cells whose number is open, how many more or less there were
  reference::Tally tally{};

  /// Does the analysis say how many there are?
  static bool is_known(CellEffects const& cells) {
    return cells.count.has_value() || (cells.split.empty() && cells.merged.empty());
  }
  bool is_open(CellEffects const& cells) const {
    auto const found = open_counts.find(family_of(rule.scheme.name));
    if (found == open_counts.end()) return false;
    std::string const& listed = found->second.cells;
    return listed.empty() ? !is_known(cells) : listed.find(letter(cells)) != std::string::npos;
  }

  void run() {
    run(subjects_for(rule.scheme));
    if (applied.empty()) run(unfinished_subjects(*rule.scheme.modeler));
  }

  void run(std::vector<Subject> const& subjects) {
    for (Subject const& subject : subjects) {
      SCOPED_TRACE(subject.name);
      std::size_t const most = effects.whole ? 1 : 3;
      std::size_t times = 0;
      Map changed = subject.map;
      rewrite::Workspace workspace;
      for (Hooks const& hooks : sites(rule.scheme, subject.map)) {
        if (!interpreter::apply(rule.scheme, rule.plan, changed, hooks, arguments, workspace)) continue;
        applied.insert(subject.shape);
        compare(subject.map, hooks, changed);
        changed = subject.map;
        if (++times == most) break;
      }
    }
  }

  void compare(Map const& was, Hooks const& hooks, Map const& is) {
    auto const violation = find_violation(is);
    EXPECT_FALSE(violation) << violation->text;
    reference::PlainMap const before = reference::plain(was);
    auto const derivation = reference::derive(rule.scheme, before, hooks);
    ASSERT_TRUE(derivation) << derivation.error();
    auto const fault = reference::examine(rule.scheme, effects, before, *derivation, tally);
    EXPECT_FALSE(fault) << *fault;
    std::set<Dart> deleted;
    for (auto const& [copy, dart] : derivation->match) {
      if (rule.scheme.nodes[copy.second].deleted()) deleted.insert(dart);
    }
    std::map<Dart, Dart> kept;
    for (Dart const d : was.darts()) {
      if (!deleted.contains(d)) kept[d] = d;
    }
    EXPECT_TRUE(reference::isomorphic(reference::plain(is), derivation->result, kept, {}, {}));
    compare_with_comment(was, hooks, is);
  }

  void compare_with_comment(Map const& was, Hooks const& hooks, Map const& is) {
    std::vector<std::size_t> const before = summarize(was).cells, after = summarize(is).cells;
    bool const border = summarize(was).boundary_darts > 0;
    Sum const letters = effects.whole ? letters_of(was) : letters_of(was, rule.scheme.hook_orbit(), hooks.front());
    for (CellEffects const& cells : effects.cells) {
      auto const i = static_cast<std::size_t>(cells.dimension);
      long long const delta = static_cast<long long>(after[i]) - static_cast<long long>(before[i]);
      auto const said =
          std::find_if(stated.begin(), stated.end(), [&](Stated const& s) { return s.cell == cells.dimension; });
      if (is_open(cells)) {
        deltas[letter(cells)].insert(delta);
      } else if (said == stated.end()) {
        EXPECT_TRUE(delta == 0 || stated.empty() || effects.whole) << letter(cells) << " is not in the comment";
      } else if (!said->total || !border) {  // what there is at a border, the analysis tells
        EXPECT_EQ(said->total ? static_cast<long long>(after[i]) : delta, value(said->sum, letters)) << letter(cells);
      }
    }
  }
};

class EveryRule : public testing::TestWithParam<std::string> {};

TEST_P(EveryRule, DoesToFiveShapesWhatItSays) {
  Rules const found = rules_of(GetParam());
  std::set<std::string> families;
  std::map<std::string, std::map<char, std::set<long long>>> open;
  for (Module::Rule const& rule : found.rules) {
    std::string const& name = rule.scheme.name;
    SCOPED_TRACE(name);
    families.insert(family_of(name));
    Audit audit(rule);
    audit.run();
    EXPECT_GE(audit.applied.size(), enough);
    RecordProperty(name, static_cast<int>(audit.applied.size()));
    bool const counts = std::any_of(audit.effects.cells.begin(), audit.effects.cells.end(),
                                    [](CellEffects const& cells) { return cells.count.has_value(); });
    EXPECT_TRUE(!counts || audit.tally.counts + audit.tally.regular_counts + audit.tally.local_counts > 0);
    for (CellEffects const& cells : audit.effects.cells) {
      EXPECT_TRUE(Audit::is_known(cells) || !audit.stated.empty() || audit.is_open(cells))
          << "nothing says how many " << letter(cells);
    }
    for (auto const& [cell, deltas] : audit.deltas) open[family_of(name)][cell].insert(deltas.begin(), deltas.end());
  }
  EXPECT_EQ(families.size(), found.declared);
  for (auto const& [family, deltas] : open) {
    bool const listed = !open_counts.at(family).cells.empty();
    auto const differ = [](auto const& of_cell) { return of_cell.second.size() > 1; };
    EXPECT_TRUE(listed ? std::all_of(deltas.begin(), deltas.end(), differ)
                       : std::any_of(deltas.begin(), deltas.end(), differ))
        << "no exception is needed of " << family;
  }
}

bool changes_arcs(ir::RuleScheme const& rule) {
  auto const some = [&](ir::Side const& side, ir::Side const& other) {
    return std::any_of(side.arcs.begin(), side.arcs.end(),
                       [&](ir::Arc const& arc) { return !ir::find_same(other, arc); });
  };
  return some(rule.left, rule.right) || some(rule.right, rule.left);
}

/// Every count that is proved of a rule which changes more than values is written down, as `expect`.
TEST_P(EveryRule, StatesTheCountsThatAreProved) {
  struct Proved {
    bool always = true, stated = true;
    std::optional<ir::Count> count{};
  };
  std::map<std::string, std::map<int, Proved>> of_family;
  for (Module::Rule const& rule : rules_of(GetParam()).rules) {
    if (!changes_arcs(rule.scheme)) continue;
    auto& proved = of_family[family_of(rule.scheme.name)];
    for (CellEffects const& cells : analysis::analyze_effects(rule.scheme, rule.plan).cells) {
      Proved& known = proved[cells.dimension];
      bool const is_new = !known.count;
      if (!cells.count || !cells.count->others.empty() || (!is_new && !(*known.count == cells.count->count))) {
        known.always = false;
        continue;
      }
      known.count = cells.count->count;
      known.stated = known.stated && std::any_of(rule.scheme.expectations.begin(), rule.scheme.expectations.end(),
                                                 [&](ir::Expectation const& e) { return e.cell == cells.dimension; });
    }
  }
  for (auto const& [family, proved] : of_family) {
    for (auto const& [dimension, known] : proved) {
      bool const everywhere = GetParam() != "basic" || dimension <= 1;  // in every dimension there are V and E
      if (!known.always || !known.count || !everywhere) continue;
      EXPECT_TRUE(known.stated) << family << ": expect "
                                << "VEFC"[dimension] << "' = " << to_string(*known.count) << ";";
    }
  }
}

// ---- What the above rests on ----

TEST(Exceptions, AreOfRulesThatThereAre) {
  std::set<std::string> names;
  for (Module::Rule const& rule : all_rules()) names.insert(family_of(rule.scheme.name));
  for (auto const& [name, open] : open_counts) EXPECT_TRUE(names.contains(name)) << name;
}

TEST(Families, HaveARuleInEachDimension) {
  for (ast::Rule const& family : declared_rules("basic")) {
    bool const of_cells = !family.dimension_parameters.empty();
    for (int n = 1; n <= 6; ++n) {
      for (int i = of_cells ? 1 : 0; i < (of_cells ? n : 1); ++i) {
        auto const dimensions = std::vector<int>(family.dimension_parameters.size(), i);
        EXPECT_TRUE(find_instance(family.name.text, dimensions, n))
            << family.name.text << " " << i << " on gmap(" << n << ")";
      }
    }
  }
}

TEST(Subjects, AreAllDifferent) {
  std::set<std::string> models;
  for (Module::Rule const& rule : all_rules()) {
    ir::Modeler const& modeler = *rule.scheme.modeler;
    if (modeler.embeddings.empty() || !models.insert(modeler.name).second) continue;
    std::map<std::string, reference::PlainMap> shapes;
    for (Subject const& subject : subjects_for(rule.scheme)) {
      reference::PlainMap const map = reference::plain(subject.map);
      for (auto const& [name, other] : shapes) {
        EXPECT_EQ(name == subject.shape, reference::isomorphic(map, other, {}, {}, {})) << name << ", " << subject.name;
      }
      shapes.emplace(subject.shape, map);
    }
    EXPECT_GT(shapes.size(), 2 * enough);
  }
  EXPECT_EQ(models.size(), 4U);
}

INSTANTIATE_TEST_SUITE_P(Modules, EveryRule, testing::ValuesIn(modules()),
                         [](auto const& module) { return module.param; });

}  // namespace
}  // namespace jrule::test
