// The papers' corpus: every figure and example of the three papers that defines a rule, as <paper>/<figure>.jrule, with
// the verdict that the paper gives, the maps that its operations make, and maps that the refused rules would break.
//   2022    Topological consistency preservation with graph transformation schemes
//   2008    Graph transformation for topology modelling
//   jerboa  Instantiation of Jerboa rule schemes, a set-based explanation
// Not here, since the text does not say enough: Fig. 12b of 2022 (what becomes of the face's 2-arcs). Its Figs. 2, 20 and
// 22 to 25 belong to the rule of Fig. 21a, Fig. 27 to those of Fig. 26; Figs. 3 and 5 of 2008 to its Fig. 4.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <set>
#include <sstream>

#include "compiler/backend/interpreter/interpreter.h"
#include "jrule/io.h"
#include "tests/paper/starts.h"
#include "tests/property/application.h"
#include "tests/reference/engine.h"
#include "tests/unit/rule_fixture.h"

namespace jrule::paper {
namespace {

namespace fs = std::filesystem;

// ---- The files ----

struct File {
  std::string errors;  ///< the codes of what is wrong before the analysis; then there are no rules to look at
  std::vector<ir::RuleScheme> rules;
};

/// "J0305 J0304*2"
std::string counted(std::vector<std::string_view> const& numbers) {
  std::map<std::string_view, int> counts;
  for (auto const number : numbers) ++counts[number];
  std::string text;
  for (auto const& [number, count] : counts) {
    text += (text.empty() ? "" : " ") + std::string(number) + (count == 1 ? "" : "*" + std::to_string(count));
  }
  return text;
}

File load(std::string const& file) {
  std::ifstream stream(fs::path(JRULE_PAPER_DIR) / file);
  std::stringstream text;
  text << stream.rdbuf();
  if (!stream) throw std::runtime_error("cannot read " + file);
  source::Sources sources;
  source::Diagnostics diagnostics;
  sema::Modules modules;
  modules.all.push_back({"paper", syntax::parse(sources, sources.add(file, text.str()), diagnostics)});
  ir::Program program = sema::elaborate(modules, diagnostics);
  std::vector<std::string_view> errors;
  for (auto const& diagnostic : diagnostics.sorted()) errors.push_back(source::info(diagnostic.code).number);
  return {counted(errors), std::move(program.rules)};
}

ir::RuleScheme load(std::string const& file, std::string const& rule) {
  File loaded = load(file);
  auto const is_wanted = [&](ir::RuleScheme const& r) { return r.name == rule; };
  auto const found = std::find_if(loaded.rules.begin(), loaded.rules.end(), is_wanted);
  if (!loaded.errors.empty() || found == loaded.rules.end()) throw std::runtime_error(file + ": no rule " + rule);
  return *found;
}

std::string verdict_on(ir::RuleScheme const& rule) {
  std::vector<std::string_view> numbers;
  analysis::Verdict const verdict = analysis::analyze(rule);
  for (auto const& refusal : verdict.refusals) numbers.push_back(source::info(refusal.diagnostic.code).number);
  return numbers.empty() ? "accepted" : counted(numbers);
}

/// Test names are letters, digits and underscores.
std::string test_name(std::string const& file, std::string const& more) {
  std::string name = fs::path(file).parent_path().string() + "_" + fs::path(file).stem().string() + "__" + more;
  auto const is_other = [](unsigned char c) { return std::isalnum(c) == 0; };
  std::replace_if(name.begin(), name.end(), is_other, '_');
  return name;
}

// ---- Verdicts ----

struct Verdict {
  std::string file, rule, expected;  ///< "accepted", or the codes and how often
};
void PrintTo(Verdict const& v, std::ostream* out) { *out << v.file << ":" << v.rule; }

std::vector<Verdict> const verdicts{
    {"2022/fig01-relabel-arc.jrule", "relabel", "J0304*2 J0305*2"},
    {"2022/fig03-delete-arcs.jrule", "delete_arcs", "J0305"},
    {"2022/fig04-relabel-arcs.jrule", "relabel", "J0301 J0305"},
    {"2022/fig11-quad-subdivision-of-a-square.jrule", "four_edges", "J0323*8 J0324*4"},
    {"2022/fig11-quad-subdivision-of-a-square.jrule", "face_without_surroundings", "J0323*8 J0324*4"},
    {"2022/fig11-quad-subdivision-of-a-square.jrule", "isolated_face", "accepted"},
    {"2022/fig14-incident-arcs.jrule", "lengthen", "accepted"},
    {"2022/fig16-completion.jrule", "exchange_places", "accepted"},
    {"2022/fig16-completion.jrule", "exchange_places_completed", "accepted"},
    {"2022/fig17-exchange-in-cycles.jrule", "exchange_places", "accepted"},
    {"2022/fig18-cycle-condition.jrule", "join_cycles", "accepted"},
    {"2022/fig18-cycle-condition.jrule", "replace_paths", "accepted"},
    {"2022/fig21-rule-scheme.jrule", "sprout", "accepted"},
    {"2022/fig21-rule-scheme.jrule", "sprout_without_3", "J0302"},
    {"2022/fig26b-words-along-paths.jrule", "exchange_middles", "J0323 J0324"},
    {"2022/fig26d-words-along-paths.jrule", "exchange_middles", "accepted"},
    {"2022/fig28-cycle-in-scheme.jrule", "change_middle", "accepted"},
    {"2022/fig29-quad-subdivision-gmap.jrule", "quad_subdivision", "accepted"},
    {"2022/fig30-quad-subdivision-omap.jrule", "quad_subdivision", "accepted"},
    {"2022/fig32a-cone-gmap.jrule", "cone", "accepted"},
    {"2022/fig32b-cone-on-a-hexagon-gmap.jrule", "cone_on_hexagon", "accepted"},
    {"2022/fig33a-cone-omap.jrule", "cone", "accepted"},
    {"2022/fig33b-cone-on-a-hexagon-omap.jrule", "cone_on_hexagon", "accepted"},
    {"2022/fig34a-edge-rounding-gmap.jrule", "edge_rounding", "accepted"},
    {"2022/fig34b-edge-rounding-omap.jrule", "edge_rounding", "accepted"},
    {"2022/fig36a-face-extrusion-gmap.jrule", "face_extrusion", "accepted"},
    {"2022/fig37-face-extrusion-omap.jrule", "face_extrusion", "accepted"},
    {"2022/fig38-face-by-face.jrule", "subdivide_face", "accepted"},
    {"2008/fig02a-sew3.jrule", "sew3", "accepted"},
    {"2008/fig02b-sew3-triangles.jrule", "sew3_triangles", "accepted"},
    {"2008/fig04a-cone.jrule", "cone", "accepted"},
    {"2008/fig04b-cone-on-a-corner.jrule", "cone_on_corner", "J0302*4"},
    {"jerboa/fig04-vertex-insertion.jrule", "insert_in_free_edge", "accepted"},
    {"jerboa/fig04-vertex-insertion.jrule", "insert_in_sewn_edge", "accepted"},
    {"jerboa/fig05a-vertex-insertion-folded-along-2.jrule", "insert_vertex", "accepted"},
    {"jerboa/fig05b-vertex-insertion-folded-along-0-and-2.jrule", "insert_vertex", "accepted"},
    {"jerboa/fig06-relabelling.jrule", "relabel", "J0304 J0305"},
    {"jerboa/fig06-relabelling.jrule", "remove", "J0305"},
    {"jerboa/fig07-discrete-scheme.jrule", "unlinked_copies", "J0302 J0305"},
    {"jerboa/def41-not-injective.jrule", "relabel_twice", "J0301 J0305"},
    {"jerboa/def42-size-condition.jrule", "insert_vertex", "J0210"},
    {"jerboa/sec53-hook-not-full.jrule", "insert_vertex", "J0212"},
};

class PaperVerdict : public testing::TestWithParam<Verdict> {};

TEST_P(PaperVerdict, is_as_expected) {
  File const loaded = load(GetParam().file);
  if (!loaded.errors.empty()) {
    EXPECT_EQ(loaded.errors, GetParam().expected);
    return;
  }
  EXPECT_EQ(verdict_on(load(GetParam().file, GetParam().rule)), GetParam().expected);
}

INSTANTIATE_TEST_SUITE_P(Figures, PaperVerdict, testing::ValuesIn(verdicts),
                         [](auto const& v) { return test_name(v.param.file, v.param.rule); });

TEST(PaperFiles, each_rule_has_its_verdict) {
  std::set<std::string> listed, found;
  for (Verdict const& v : verdicts) listed.insert(v.file + ":" + v.rule);
  for (auto const& entry : fs::recursive_directory_iterator(JRULE_PAPER_DIR)) {
    if (entry.path().extension() != ".jrule") continue;
    std::string const file = fs::relative(entry.path(), JRULE_PAPER_DIR).string();
    File const loaded = load(file);
    for (auto const& rule : loaded.rules) found.insert(file + ":" + rule.name);
    if (loaded.errors.empty()) continue;  // a rule with an error is not among them
    for (Verdict const& v : verdicts) {
      if (v.file == file) found.insert(file + ":" + v.rule);
    }
  }
  EXPECT_EQ(found, listed);
}

// ---- Operations ----

using Start = std::function<Map(Model const&)>;

Start from_polygon(Dart sides) {
  return [=](Model const& model) { return polygon(model, sides); };
}
Start from_flat_volume(Dart sides) {
  return [=](Model const& model) { return flat_volume(model, sides); };
}
Start from_mesh(std::string const& file) {
  return [=](Model const& model) { return mesh(model, file); };
}
Start from_cycles(Dart darts, std::vector<Cycles> const& dimensions) {
  return [=](Model const& model) { return permutations(model, darts, dimensions); };
}

Map two_tetrahedra(Model const& model) { return twice(mesh(model, "tetrahedron.off")); }
Map pyramid_in_external_volume(Model const&) { return in_external_volume(mesh(omap(2), "pyramid.off")); }
/// A triangle whose first edge is glued to itself end to end.
Map triangle_with_folded_edge(Model const& model) {
  Map map = polygon(model, 3);
  map.link(0, 2, 1);
  return map;
}

Start const one_cycle = from_cycles(4, {{1, {{0, 1}, {2, 3}}}, {2, {{1, 2}, {3, 0}}}});

/// Fig. 17: a, b, c, d, e, f, g, h are the darts 0 to 7; g closes the cycle of f, e and h.
Start const two_cycles_joined_by_3 =
    from_cycles(8, {{1, {{0, 3}, {1, 2}, {4, 5}, {6, 7}}}, {2, {{2, 3}, {0, 1}, {4, 7}, {5, 6}}}, {3, {{2, 4}}}});

/// Figs. 26c and 27: a pattern of three darts, here at a (0, 8, 16) and d (4, 12, 20) in step; with b, c, e and f beside
/// them, and the darts that close the cycles of a·b·c (3, 11, 19) and d·e·f (7, 15, 23).
Start const three_pairs_of_cycles = from_cycles(
    24, {{0, {{0, 8, 16}, {4, 12, 20}}},
         {1, {{0, 1}, {8, 9}, {16, 17}, {3, 10}, {11, 18}, {19, 2}, {4, 13}, {12, 21}, {20, 5}, {7, 14}, {15, 22}, {23, 6}}},
         {2, {{1, 10}, {9, 18}, {17, 2}, {3, 0}, {11, 8}, {19, 16}, {13, 14}, {21, 22}, {5, 6}, {7, 4}, {15, 12}, {23, 20}}}});

/// Fig. 28: a pattern of two darts that the word 21 exchanges, here at b (0, 5); with c, a and d beside them (1 to 3, 6 to 8), and
/// the darts between d and b along 1, between b and c along 2 (4, 9).
Start const oriented_squares = from_cycles(10, {{1, {{0, 6, 7, 3, 4, 5, 1, 2, 8, 9}}}, {2, {{0, 4, 6, 2, 8}, {5, 9, 1, 7, 3}}}});

using Cells = std::vector<std::size_t>;

struct Operation {
  std::string file, rule, on;  ///< `on` names the start
  Start start;
  std::vector<Dart> hooks;
  Cells cells;  ///< of dimension 0, 1, …; 0 where the model has no such cells
  std::size_t darts;
};
void PrintTo(Operation const& o, std::ostream* out) { *out << o.file << ":" << o.rule << " on " << o.on; }

std::vector<Operation> const operations{
    {"2022/fig11-quad-subdivision-of-a-square.jrule", "isolated_face", "square", from_polygon(4), {0}, {9, 12, 4}, 32},
    {"2022/fig14-incident-arcs.jrule", "lengthen", "two_threads",
     from_cycles(4, {{2, {{0, 1}, {2, 3}}}, {3, {{0, 2}, {1, 3}}}}), {0}, {0, 0, 3, 2}, 5},
    {"2022/fig16-completion.jrule", "exchange_places", "cycle", one_cycle, {0}, {0, 2, 2}, 4},
    {"2022/fig16-completion.jrule", "exchange_places_completed", "cycle", one_cycle, {0}, {0, 2, 2}, 4},
    {"2022/fig17-exchange-in-cycles.jrule", "exchange_places", "two_cycles",
     two_cycles_joined_by_3, {0}, {0, 4, 4, 2}, 8},
    {"2022/fig18-cycle-condition.jrule", "join_cycles", "two_cycles",
     from_cycles(4, {{1, {{0, 1}, {2, 3}}}}), {0, 2}, {0, 2, 2}, 4},
    {"2022/fig18-cycle-condition.jrule", "replace_paths", "two_cycles",
     from_cycles(8, {{1, {{0, 1}, {2, 3}, {4, 5}, {6, 7}}}, {2, {{1, 2}, {3, 0}, {5, 6}, {7, 4}}}}), {0, 4},
     {0, 6, 6}, 12},
    {"2022/fig21-rule-scheme.jrule", "sprout", "ring", from_cycles(4, {{2, {{0, 1, 2, 3}}}}), {0}, {2, 4, 2}, 8},
    {"2022/fig26d-words-along-paths.jrule", "exchange_middles", "three_pairs_of_cycles",
     three_pairs_of_cycles, {0, 4}, {6, 8, 8}, 24},
    {"2022/fig28-cycle-in-scheme.jrule", "change_middle", "oriented_squares", oriented_squares, {0}, {0, 1, 2}, 10},
    {"2022/fig29-quad-subdivision-gmap.jrule", "quad_subdivision", "square", from_polygon(4), {0}, {9, 12, 4}, 32},
    {"2022/fig29-quad-subdivision-gmap.jrule", "quad_subdivision", "cube",
     from_mesh("cube.obj"), {0}, {26, 48, 24}, 192},
    {"2022/fig30-quad-subdivision-omap.jrule", "quad_subdivision", "cube",
     from_mesh("cube.obj"), {0}, {26, 48, 24}, 96},
    {"2022/fig32a-cone-gmap.jrule", "cone", "square", from_polygon(4), {0}, {5, 8, 5}, 32},
    {"2022/fig32a-cone-gmap.jrule", "cone", "hexagon", from_polygon(6), {0}, {7, 12, 7}, 48},
    {"2022/fig32b-cone-on-a-hexagon-gmap.jrule", "cone_on_hexagon", "hexagon", from_polygon(6), {0}, {7, 12, 7}, 48},
    {"2022/fig33a-cone-omap.jrule", "cone", "square", from_flat_volume(4), {0}, {5, 8, 5}, 16},
    {"2022/fig33a-cone-omap.jrule", "cone", "hexagon", from_flat_volume(6), {0}, {7, 12, 7}, 24},
    {"2022/fig33b-cone-on-a-hexagon-omap.jrule", "cone_on_hexagon", "hexagon",
     from_flat_volume(6), {0}, {7, 12, 7}, 24},
    {"2022/fig34a-edge-rounding-gmap.jrule", "edge_rounding", "pyramid",
     from_mesh("pyramid.off"), {0}, {16, 32, 18}, 128},
    {"2022/fig34b-edge-rounding-omap.jrule", "edge_rounding", "pyramid",
     from_mesh("pyramid.off"), {0}, {16, 32, 18}, 64},
    {"2022/fig36a-face-extrusion-gmap.jrule", "face_extrusion", "pyramid",
     from_mesh("pyramid.off"), {0}, {9, 16, 10, 2}, 80},
    {"2022/fig37-face-extrusion-omap.jrule", "face_extrusion", "pyramid",
     pyramid_in_external_volume, {0}, {9, 16, 10, 3}, 72},
    {"2022/fig38-face-by-face.jrule", "subdivide_face", "cube", from_mesh("cube.obj"), {0}, {13, 20, 9}, 80},
    {"2008/fig02a-sew3.jrule", "sew3", "two_tetrahedra", two_tetrahedra, {0, 24}, {5, 9, 7, 2}, 48},
    {"2008/fig02b-sew3-triangles.jrule", "sew3_triangles", "two_tetrahedra", two_tetrahedra, {0, 24}, {5, 9, 7, 2}, 48},
    {"2008/fig04a-cone.jrule", "cone", "triangle", from_polygon(3), {0}, {4, 6, 4}, 24},
    {"2008/fig04a-cone.jrule", "cone", "square", from_polygon(4), {0}, {5, 8, 5}, 32},
    {"jerboa/fig04-vertex-insertion.jrule", "insert_in_free_edge", "square", from_polygon(4), {0}, {5, 5, 1}, 10},
    {"jerboa/fig04-vertex-insertion.jrule", "insert_in_sewn_edge", "cube", from_mesh("cube.obj"), {0}, {9, 13, 6}, 52},
    {"jerboa/fig05a-vertex-insertion-folded-along-2.jrule", "insert_vertex", "free",
     from_polygon(4), {0}, {5, 5, 1}, 10},
    {"jerboa/fig05a-vertex-insertion-folded-along-2.jrule", "insert_vertex", "sewn",
     from_mesh("cube.obj"), {0}, {9, 13, 6}, 52},
    {"jerboa/fig05b-vertex-insertion-folded-along-0-and-2.jrule", "insert_vertex", "free",
     from_polygon(4), {0}, {5, 5, 1}, 10},
    {"jerboa/fig05b-vertex-insertion-folded-along-0-and-2.jrule", "insert_vertex", "sewn",
     from_mesh("cube.obj"), {0}, {9, 13, 6}, 52},
    {"jerboa/fig05b-vertex-insertion-folded-along-0-and-2.jrule", "insert_vertex", "folded",
     triangle_with_folded_edge, {0}, {3, 3, 1}, 8},
};

/// The map after; a failure of the test if the rule does not apply or the result is no map.
void apply(ir::RuleScheme const& rule, Map& map, std::vector<Dart> const& hooks) {
  analysis::Verdict const verdict = analysis::analyze(rule);
  ASSERT_TRUE(verdict.accepted()) << tests::codes(verdict);
  rewrite::Workspace workspace;
  auto const applied = interpreter::apply(rule, verdict.plan, map, hooks, {}, workspace);
  ASSERT_TRUE(applied) << to_string(applied.error());
  auto const violation = find_violation(map);
  EXPECT_FALSE(violation) << violation->text;
}

Cells cells_of(Map const& map) { return summarize(map).cells; }

class PaperOperation : public testing::TestWithParam<Operation> {};

TEST_P(PaperOperation, makes_the_expected_map) {
  Operation const& operation = GetParam();
  ir::RuleScheme const rule = load(operation.file, operation.rule);
  Map map = operation.start(rule.model());
  auto const violation = find_violation(map);
  ASSERT_FALSE(violation) << violation->text;

  analysis::Plan const plan = analysis::analyze(rule).plan;
  auto const examined = property::examine(rule, {map, operation.hooks}, property::interpreted(rule, plan));
  EXPECT_TRUE(examined.applied);
  EXPECT_FALSE(examined.fault) << *examined.fault;  // it is the map that the paper's construction gives

  ASSERT_NO_FATAL_FAILURE(apply(rule, map, operation.hooks));
  EXPECT_EQ(map.dart_count(), operation.darts);
  EXPECT_EQ(cells_of(map), operation.cells);
}

INSTANTIATE_TEST_SUITE_P(Figures, PaperOperation, testing::ValuesIn(operations),
                         [](auto const& o) { return test_name(o.param.file, o.param.rule + "_on_" + o.param.on); });

TEST(PaperFiles, each_accepted_rule_is_applied) {
  std::set<std::string> accepted, applied;
  for (Verdict const& v : verdicts) {
    if (v.expected == "accepted") accepted.insert(v.file + ":" + v.rule);
  }
  for (Operation const& o : operations) applied.insert(o.file + ":" + o.rule);
  EXPECT_EQ(applied, accepted);
}

// ---- Refused rules: what they would do ----

struct Breakage {
  std::string file, rule;
  Start start;
  std::vector<Dart> hooks;
};
void PrintTo(Breakage const& b, std::ostream* out) { *out << b.file << ":" << b.rule; }

std::vector<Breakage> const breakages{
    {"2022/fig01-relabel-arc.jrule", "relabel", from_cycles(2, {{1, {{0, 1}}}}), {0}},
    {"2022/fig03-delete-arcs.jrule", "delete_arcs", from_cycles(2, {{2, {{0, 1}}}}), {0}},
    {"2022/fig04-relabel-arcs.jrule", "relabel", from_cycles(2, {{2, {{0, 1}}}}), {0}},
    {"2022/fig11-quad-subdivision-of-a-square.jrule", "four_edges", from_mesh("cube.obj"), {0, 2, 4, 6}},
    {"2022/fig11-quad-subdivision-of-a-square.jrule", "face_without_surroundings", from_mesh("cube.obj"), {0}},
    {"2022/fig21-rule-scheme.jrule", "sprout_without_3", from_cycles(4, {{2, {{0, 1, 2, 3}}}}), {0}},
    {"2022/fig26b-words-along-paths.jrule", "exchange_middles", three_pairs_of_cycles, {0, 4}},
    {"2008/fig04b-cone-on-a-corner.jrule", "cone_on_corner", from_polygon(4), {0}},
    {"jerboa/fig06-relabelling.jrule", "relabel", from_mesh("cube.obj"), {0}},
    {"jerboa/fig06-relabelling.jrule", "remove", from_mesh("cube.obj"), {0}},
    {"jerboa/fig07-discrete-scheme.jrule", "unlinked_copies", from_mesh("cube.obj"), {0}},
    {"jerboa/def41-not-injective.jrule", "relabel_twice", from_mesh("cube.obj"), {0}},
};

class PaperRefusal : public testing::TestWithParam<Breakage> {};

/// The construction of the paper, carried out all the same, ends in a graph that is no map.
TEST_P(PaperRefusal, is_deserved) {
  ir::RuleScheme const rule = load(GetParam().file, GetParam().rule);
  Map const map = GetParam().start(rule.model());
  ASSERT_FALSE(find_violation(map));
  auto const derivation = reference::derive(rule, reference::plain(map), GetParam().hooks);
  ASSERT_TRUE(derivation) << derivation.error();
  EXPECT_TRUE(reference::violation(derivation->result, rule.model()));
}

INSTANTIATE_TEST_SUITE_P(Figures, PaperRefusal, testing::ValuesIn(breakages),
                         [](auto const& b) { return test_name(b.param.file, b.param.rule); });

// ---- What the texts say beyond one application ----

TEST(PaperText, Fig16TheCompletedRuleGivesTheSameGraph) {
  std::vector<std::string> results;
  for (std::string const rule_name : {"exchange_places", "exchange_places_completed"}) {
    ir::RuleScheme const rule = load("2022/fig16-completion.jrule", rule_name);
    Map map = one_cycle(rule.model());
    ASSERT_NO_FATAL_FAILURE(apply(rule, map, {0}));
    EXPECT_EQ(map.target(0, 1), 2U);
    results.push_back(print_jmap(map));
  }
  EXPECT_EQ(results[0], results[1]);
}

TEST(PaperText, Fig17TheUnmatchedPartOfTheCycleIsCompletedAgain) {
  ir::RuleScheme const rule = load("2022/fig17-exchange-in-cycles.jrule", "exchange_places");
  Map map = two_cycles_joined_by_3(rule.model());
  ASSERT_NO_FATAL_FAILURE(apply(rule, map, {0}));
  Dart const c = 2, e = 4, f = 5, g = 6, h = 7;
  EXPECT_EQ(map.target(f, 1), c);
  EXPECT_EQ(map.target(c, 2), h);
  EXPECT_EQ(map.target(h, 1), g);
  EXPECT_EQ(map.target(g, 2), f);
  EXPECT_EQ(orbit(map, orbit_of_dimensions({1, 2}), e).size(), 4U);  // e, b, a and d
}

/// Fig. 31: a cone on a square, all edges rounded, the base extruded.
TEST(PaperText, Fig31AHouse) {
  ir::RuleScheme const cone = load("2022/fig32a-cone-gmap.jrule", "cone");
  ir::RuleScheme const rounding = load("2022/fig34a-edge-rounding-gmap.jrule", "edge_rounding");
  ir::RuleScheme const extrusion = load("2022/fig36a-face-extrusion-gmap.jrule", "face_extrusion");
  Map surface = polygon(cone.model(), 4);
  ASSERT_NO_FATAL_FAILURE(apply(cone, surface, {0}));
  ASSERT_NO_FATAL_FAILURE(apply(rounding, surface, {0}));
  EXPECT_EQ(cells_of(surface), (Cells{16, 32, 18}));
  Map house = in_space(surface);
  ASSERT_NO_FATAL_FAILURE(apply(extrusion, house, {0}));
  EXPECT_EQ(cells_of(house), (Cells{20, 40, 23, 2}));
  EXPECT_EQ(house.dart_count(), 176U);
}

/// Fig. 32: an isolated face is matched only.
TEST(PaperText, Fig32AConeNeedsAnIsolatedFace) {
  ir::RuleScheme const cone = load("2022/fig32a-cone-gmap.jrule", "cone");
  Map cube = mesh(cone.model(), "cube.obj");
  rewrite::Workspace workspace;
  auto const applied = interpreter::apply(cone, analysis::analyze(cone).plan, cube, {0}, {}, workspace);
  ASSERT_FALSE(applied);
  EXPECT_EQ(applied.error().kind, Error::Kind::not_applicable);
}

/// Fig. 38 and Example 26: face by face, the edge between two faces gets three vertices; all at once, one.
TEST(PaperText, Fig38FaceByFaceSplitsAnEdgeTwice) {
  ir::RuleScheme const face = load("2022/fig38-face-by-face.jrule", "subdivide_face");
  ir::RuleScheme const surface = load("2022/fig29-quad-subdivision-gmap.jrule", "quad_subdivision");
  auto const sides_of = [](Map const& map, Dart d) { return orbit(map, orbit_of_dimensions({0, 1}), d).size() / 2; };

  Map cube = mesh(face.model(), "cube.obj");
  Dart const green = cube.target(0, 2);
  ASSERT_NO_FATAL_FAILURE(apply(face, cube, {0}));
  EXPECT_EQ(cells_of(cube), (Cells{13, 20, 9}));
  EXPECT_EQ(sides_of(cube, green), 5U);  // one new vertex on the edge between the two faces
  EXPECT_EQ(sides_of(cube, 0), 4U);
  ASSERT_NO_FATAL_FAILURE(apply(face, cube, {green}));
  EXPECT_EQ(cells_of(cube), (Cells{19, 30, 13}));
  EXPECT_EQ(sides_of(cube, 0), 5U);  // a quad no more: its half of the edge was split again
  // Two centres and the seven edges of the two faces make 9 new vertices; here are 11, two more on the edge between them.
  EXPECT_EQ(cells_of(cube)[0], 8U + 2 + 7 + 2);

  Map at_once = mesh(surface.model(), "cube.obj");
  ASSERT_NO_FATAL_FAILURE(apply(surface, at_once, {0}));
  EXPECT_EQ(cells_of(at_once), (Cells{26, 48, 24}));
  for (Dart const d : at_once.darts()) EXPECT_EQ(sides_of(at_once, d), 4U);
}

}  // namespace
}  // namespace jrule::paper
