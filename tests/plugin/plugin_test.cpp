// What a plugin offers, and what it does where it is used rightly.
#include <algorithm>
#include <cstring>

#include "tests/plugin/fixture.h"

namespace jrule::tests {
namespace {

using Plugins = WithPlugin;

TEST_F(Plugins, NothingElseIsExported) {
  Outcome const symbols = run(folder(), {JRULE_NM, "-D", "--defined-only", JRULE_PLUGIN});
  ASSERT_EQ(symbols.exit_status, 0) << symbols.output;
  EXPECT_EQ(std::count(symbols.output.begin(), symbols.output.end(), '\n'), 1) << symbols.output;
  EXPECT_TRUE(symbols.output.ends_with(" jrule_plugin_entry\n")) << symbols.output;
}

TEST_F(Plugins, ListsModelers) {
  ASSERT_EQ(plugin_->modeler_count, 2U);
  jrule_modeler const& surface = plugin_->modelers[0];
  EXPECT_STREQ(surface.name, "Surface");
  EXPECT_STREQ(surface.module, "shapes");
  EXPECT_STREQ(surface.doc, "Surfaces whose faces are counted, marked and painted.");
  EXPECT_STREQ(surface.model, "gmap");
  EXPECT_EQ(surface.dimension, 2);
  ASSERT_EQ(surface.embedding_count, 4U);
  EXPECT_STREQ(surface.embeddings[0].name, "position");
  EXPECT_STREQ(surface.embeddings[0].doc, "Where a \"corner\" lies.");
  EXPECT_STREQ(surface.embeddings[0].orbit, "<1,2>");
  EXPECT_EQ(surface.embeddings[0].type, JRULE_POINT3);
  EXPECT_EQ(surface.embeddings[0].default_kind, JRULE_NO_DEFAULT);
  EXPECT_EQ(surface.embeddings[1].default_kind, JRULE_VALUE_DEFAULT);
  EXPECT_EQ(surface.embeddings[1].default_value.type, JRULE_COLOR);
  EXPECT_EQ(surface.embeddings[1].default_value.numbers[2], 0.8);
  jrule_modeler const& sky = plugin_->modelers[1];
  EXPECT_STREQ(sky.name, "Sky");
  EXPECT_STREQ(sky.module, "outside");
  EXPECT_STREQ(sky.model, "omap");
  EXPECT_EQ(sky.embeddings[0].type, JRULE_EXTERN);
  EXPECT_EQ(sky.embeddings[0].default_kind, JRULE_COMPUTED_DEFAULT);
}

TEST_F(Plugins, ListsRules) {
  ASSERT_EQ(plugin_->rule_count, 11U);
  EXPECT_STREQ(plugin_->name, "shapes");
  jrule_rule const& square = rule(find("square"));
  EXPECT_STREQ(square.doc, "A square\nthat lies \\ stands alone.");
  EXPECT_EQ(square.hook_count, 0U);
  ASSERT_EQ(square.parameter_count, 1U);
  EXPECT_STREQ(square.parameters[0].name, "size");
  EXPECT_STREQ(square.parameters[0].unit, "m");
  EXPECT_STREQ(square.parameters[0].doc, "of its sides");
  EXPECT_EQ(square.parameters[0].type, JRULE_REAL);
  EXPECT_EQ(square.parameters[0].default_value.numbers[0], 0.5);
  ASSERT_EQ(square.node_count, 8U);
  EXPECT_STREQ(square.nodes[0].doc, "where it begins");

  jrule_rule const& cone = rule(find("cone"));
  ASSERT_EQ(cone.hook_count, 1U);
  EXPECT_STREQ(cone.hooks[0].name, "a");
  EXPECT_STREQ(cone.hooks[0].orbit, "<0,1>");
  EXPECT_STREQ(cone.hooks[0].doc, "any dart of the face");
  EXPECT_EQ(cone.not_callable, nullptr);

  jrule_rule const& paint = rule(find("paint"));
  ASSERT_EQ(paint.parameter_count, 4U);
  EXPECT_EQ(paint.parameters[0].default_kind, JRULE_NO_DEFAULT);
  EXPECT_EQ(paint.parameters[1].default_value.integer, 3);
  EXPECT_EQ(paint.parameters[2].default_value.integer, 1);
  EXPECT_EQ(paint.parameters[2].type, JRULE_BOOL);

  jrule_rule const& zip = rule(find("zip"));
  ASSERT_EQ(zip.hook_count, 2U);
  EXPECT_STREQ(zip.hooks[0].orbit, "<0>");
  EXPECT_STREQ(zip.hooks[1].orbit, "<2>");  // its own, walked in step with the first

  jrule_rule const& soak = rule(find("outside", "soak"));
  EXPECT_EQ(soak.modeler, 0U);
  EXPECT_EQ(soak.parameters[0].default_kind, JRULE_COMPUTED_DEFAULT);
  jrule_rule const& cover = rule(find("outside", "cover"));
  EXPECT_STREQ(cover.not_callable, "its parameter `cloud` is of the C++ type `Cloud`");
}

TEST_F(Plugins, CreatesAndAsks) {
  MapPtr const map = empty();
  jrule_value const size = real(2);
  jrule_dart darts[8] = {};
  ASSERT_EQ(plugin_->apply(map.get(), find("square"), nullptr, 0, &size, 1, darts, 8, &error_), JRULE_OK) << message();
  EXPECT_EQ(message(), "");
  std::uint32_t count = 0, limit = 0, modeler = 9;
  ASSERT_EQ(plugin_->count_darts(map.get(), &count, &limit, &error_), JRULE_OK);
  EXPECT_EQ(count, 8U);
  EXPECT_EQ(limit, 8U);
  ASSERT_EQ(plugin_->modeler_of(map.get(), &modeler, &error_), JRULE_OK);
  EXPECT_EQ(modeler, 0U);
  jrule_dart to = JRULE_NO_DART, from = JRULE_NO_DART;
  ASSERT_EQ(plugin_->target(map.get(), darts[1], 1, &to, &error_), JRULE_OK);
  EXPECT_EQ(to, darts[2]);  // b -1- c
  ASSERT_EQ(plugin_->source(map.get(), darts[1], 1, &from, &error_), JRULE_OK);
  EXPECT_EQ(from, darts[2]);
  jrule_value value{};
  ASSERT_EQ(plugin_->value(map.get(), 0, darts[4], &value, &error_), JRULE_OK);
  EXPECT_EQ(value.type, JRULE_POINT3);
  EXPECT_EQ(value.numbers[0], 2);
  EXPECT_EQ(value.numbers[1], 2);
  ASSERT_EQ(plugin_->value(map.get(), 3, darts[4], &value, &error_), JRULE_OK);
  EXPECT_EQ(value.type, JRULE_BOOL);
  EXPECT_EQ(value.integer, 0);

  std::uint32_t vertices = 0;
  ASSERT_EQ(plugin_->cells(map.get(), 0, nullptr, 0, &vertices, &error_), JRULE_OK);
  ASSERT_EQ(vertices, 4U);
  std::vector<jrule_dart> first(2, JRULE_NO_DART);
  ASSERT_EQ(plugin_->cells(map.get(), 0, first.data(), 2, &vertices, &error_), JRULE_OK);
  EXPECT_EQ(vertices, 4U);  // two of which were written
  EXPECT_LT(first[0], first[1]);
  std::int32_t const face[] = {0, 1};
  std::vector<jrule_dart> corners(8);
  ASSERT_EQ(plugin_->orbit(map.get(), darts[0], face, 2, corners.data(), 8, &count, &error_), JRULE_OK);
  EXPECT_EQ(count, 8U);
  EXPECT_EQ(corners, std::vector<jrule_dart>(darts, darts + 8));  // along the boundary

  jrule_summary summary{};
  ASSERT_EQ(plugin_->summarize(map.get(), &summary, &error_), JRULE_OK);
  EXPECT_EQ(summary.darts, 8U);
  EXPECT_EQ(summary.cells[0], 4U);
  EXPECT_EQ(summary.cells[2], 1U);
  EXPECT_EQ(summary.cells[3], 0U);
  EXPECT_EQ(summary.euler, 1);
  EXPECT_EQ(summary.boundary_darts, 8U);
  EXPECT_EQ(summary.valid, 1);
  EXPECT_EQ(summary.orientable, 1);
}

TEST_F(Plugins, SetsValuesAndCopies) {
  MapPtr const map = cube();
  jrule_map* raw = nullptr;
  ASSERT_EQ(plugin_->copy(map.get(), &raw, &error_), JRULE_OK);
  MapPtr const other(raw, plugin_->destroy);
  std::string const before = text(map);
  EXPECT_EQ(text(other), before);
  jrule_value const moved = triple(JRULE_POINT3, 7, 8, 9);
  ASSERT_EQ(plugin_->set_value(other.get(), 0, 0, &moved, &error_), JRULE_OK) << message();
  jrule_value value{};
  ASSERT_EQ(plugin_->value(other.get(), 0, 0, &value, &error_), JRULE_OK);
  EXPECT_EQ(value.numbers[2], 9);
  EXPECT_EQ(text(map), before);
  EXPECT_NE(text(other), before);
}

// As `jrule apply` on the source, byte for byte.
TEST_F(Plugins, DoesWhatTheInterpreterDoes) {
  struct Case {
    std::string mesh, rule, at;
    std::vector<jrule_dart> hooks;  // none: everywhere
    std::vector<jrule_value> arguments;
    std::vector<std::string> words;
  };
  std::string const data = JRULE_SOURCE_DIR "/tests/data/";
  std::vector<Case> const cases{
      {"cube.obj", "quad_subdivision", "all", {}, {}, {}},
      {"patch.obj", "quad_subdivision", "dart:3", {3}, {}, {}},
      {"cube.obj", "open_edge", "all", {}, {}, {}},
      {"patch.obj", "open_edge", "all", {}, {}, {}},
      {"patch.obj", "mark_alone", "all", {}, {}, {}},
      {"patch.obj", "zip", "dart:0,dart:4", {0, 4}, {}, {}},
      {"cube.obj",
       "paint",
       "dart:9",
       {9},
       {triple(JRULE_COLOR, 0.25, 0.5, 1), integer(-2), boolean(false), by_default()},
       {"paint=0.25,0.5,1", "more=-2", "mark=false"}},
      {"cube.obj",
       "paint",
       "all",
       {},
       {triple(JRULE_COLOR, 0, 0, 0.1), by_default(), by_default(), triple(JRULE_VEC3, 0, 3, 4)},
       {"paint=0,0,0.1", "shift=0,3,4"}},
  };
  int compared = 0;
  for (Case const& c : cases) {
    SCOPED_TRACE(c.rule + " on " + c.mesh + " at " + c.at);
    MapPtr const map = read(data + c.mesh);
    std::int32_t const code =
        c.hooks.empty() ? everywhere(map, find(c.rule), c.arguments) : apply(map, find(c.rule), c.hooks, c.arguments);
    std::vector<std::string> words{"apply", JRULE_SOURCE_DIR "/tests/plugin/rules/shapes.jrule:" + c.rule,
                                   "--in",  data + c.mesh,
                                   "--out", "a.jmap",
                                   "--at",  c.at};
    words.insert(words.end(), c.words.begin(), c.words.end());
    Outcome const outcome = jrule(words);
    ASSERT_EQ(code == JRULE_OK, outcome.exit_status == 0) << message() << '\n' << outcome.output;
    if (code != JRULE_OK) {
      EXPECT_EQ(outcome.output, "jrule: error: " + message() + "\n");
      continue;
    }
    ++compared;
    EXPECT_EQ(text(map), content("a.jmap"));
  }
  EXPECT_GE(compared, 6);
}

TEST_F(Plugins, DefaultsThatCppComputes) {
  MapPtr const map = cube();
  ASSERT_EQ(apply(map, find("outside", "soak"), {0}, {by_default(), by_default()}), JRULE_OK) << message();
  jrule_value value{};
  ASSERT_EQ(plugin_->value(map.get(), 1, 0, &value, &error_), JRULE_OK);
  EXPECT_EQ(value.numbers[0], 0.75);  // least(2, 1.5) times 0.5
  EXPECT_EQ(value.numbers[2], 1.5);
}

// ---- Progress ----

struct Watch {
  std::vector<double> seen;
  std::size_t cancel_at = 1000;  // which call
};
std::int32_t watch(void* user, double done) {
  Watch& w = *static_cast<Watch*>(user);
  w.seen.push_back(done);
  return w.seen.size() > w.cancel_at ? 1 : 0;
}

TEST_F(Plugins, ReportsProgress) {
  MapPtr const map = cube();
  Watch turn, once;
  jrule_progress const in_turn{watch, &turn}, at_once{watch, &once};
  ASSERT_EQ(everywhere(map, find("open_edge"), {}, &in_turn), JRULE_OK);
  EXPECT_GT(turn.seen.size(), 8U);
  EXPECT_TRUE(std::is_sorted(turn.seen.begin(), turn.seen.end()));
  EXPECT_EQ(turn.seen.front(), 0);
  EXPECT_LT(turn.seen[turn.seen.size() - 2], 1);
  EXPECT_EQ(turn.seen.back(), 1);
  ASSERT_EQ(everywhere(map, find("quad_subdivision"), {}, &at_once), JRULE_OK);
  EXPECT_EQ(once.seen, (std::vector<double>{0, 1}));
}

TEST_F(Plugins, CancelledLeavesTheMapAsItWas) {
  for (std::string const name : {"open_edge", "quad_subdivision"}) {
    MapPtr const map = cube();
    std::string const before = text(map);
    Watch cancels;
    cancels.cancel_at = name == "open_edge" ? 4 : 0;
    jrule_progress const progress{watch, &cancels};
    EXPECT_EQ(everywhere(map, find(name), {}, &progress), JRULE_CANCELLED);
    EXPECT_EQ(message(), "`" + name + "` was cancelled: the map is as it was");
    EXPECT_EQ(cancels.seen.size(), cancels.cancel_at + 1);
    EXPECT_EQ(text(map), before);
    // It can go on.
    EXPECT_EQ(everywhere(map, find(name), {}), JRULE_OK);
    EXPECT_NE(text(map), before);
  }
}

TEST_F(Plugins, CancelsTooLate) {
  MapPtr const map = cube();
  Watch late;
  late.cancel_at = 1;
  jrule_progress const progress{watch, &late};
  EXPECT_EQ(everywhere(map, find("quad_subdivision"), {}, &progress), JRULE_OK);
  jrule_summary summary{};
  ASSERT_EQ(plugin_->summarize(map.get(), &summary, &error_), JRULE_OK);
  EXPECT_EQ(summary.cells[2], 24U);
}

}  // namespace
}  // namespace jrule::tests
