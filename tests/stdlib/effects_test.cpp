// The numbers of cells that are derived from the rules of the library, against those of what they make of many shapes.
#include <algorithm>

#include "compiler/analysis/effects.h"
#include "compiler/backend/interpreter/interpreter.h"
#include "tests/stdlib/application.h"
#include "tests/stdlib/shapes.h"

namespace jrule::test {
namespace {

using analysis::Effects;
using analysis::OrbitCount;

struct Cells {
  std::vector<std::size_t> cells;
  std::size_t darts = 0;
};
Cells cells_of(Map const& map) {
  Summary const summary = summarize(map);
  return {summary.cells, summary.darts};
}

ir::Fraction value(ir::Count const& count, Cells const& was) {
  auto const times = [](ir::Fraction factor, std::size_t n) { return factor * ir::Fraction{static_cast<std::int64_t>(n), 1}; };
  ir::Fraction sum = count.constant + times(count.darts, was.darts);
  for (std::size_t i = 0; i < std::min(was.cells.size(), ir::Count::named_cells); ++i) sum = sum + times(count.cells[i], was.cells[i]);
  return sum;
}

/// How many counts were compared.
int expect_counts(Effects const& effects, Cells const& was, Cells const& is, bool border) {
  int compared = 0;
  auto const expect = [&](std::optional<OrbitCount> const& told, std::size_t found) {
    if (!told || !told->others.empty() || (border && told->regular_only)) return;
    ir::Fraction const expected = value(told->count, was);
    EXPECT_EQ(expected.under, 1);
    EXPECT_EQ(expected.over, static_cast<std::int64_t>(found)) << to_string(told->count);
    ++compared;
  };
  for (analysis::CellEffects const& cells : effects.cells) {
    auto const i = static_cast<std::size_t>(cells.dimension);
    SCOPED_TRACE(i);
    expect(cells.count, is.cells[i]);
  }
  expect(effects.darts, is.darts);
  return compared;
}

std::vector<Map> maps_for(ir::Modeler const& modeler) {
  std::vector<Map> maps;
  if (modeler.model.dimension == 3) {
    for (Solid const& solid : solids()) maps.push_back(build(modeler, solid));
    return maps;
  }
  for (Shape const& shape : closed_surfaces()) maps.push_back(build(modeler, shape.polygons));
  if (!modeler.model.is_oriented(1)) {
    for (Shape const& shape : {grid(2, 3), moebius(5)}) maps.push_back(build(modeler, shape.polygons));
  }
  return maps;
}

/// Of a rule with several hooks, any darts: few fit.
std::vector<std::vector<Dart>> places(ir::RuleScheme const& rule, Effects const& effects, Map const& map) {
  constexpr std::size_t most = 40;
  std::vector<Dart> const darts = map.darts();
  std::vector<std::vector<Dart>> found;
  for (std::size_t k = 0; k < std::min(effects.whole ? 1 : most, darts.size()); ++k) {
    std::vector<Dart> hooks;
    for (std::size_t h = 0; h < rule.hooks.size(); ++h) hooks.push_back(darts[(k + 5 * h * k + h) % darts.size()]);
    found.push_back(std::move(hooks));
  }
  return found;
}

class Library : public testing::TestWithParam<std::string> {};

TEST_P(Library, MakesAsManyCellsAsItsRulesSay) {
  Module const module(JRULE_SOURCE_DIR "/stdlib/std/" + GetParam() + ".jrule");
  for (Module::Rule const& rule : module.rules()) {
    SCOPED_TRACE(rule.scheme.name);
    Effects const effects = analysis::analyze_effects(rule.scheme, rule.plan);
    bool const has_defaults = std::all_of(rule.scheme.parameters.begin(), rule.scheme.parameters.end(), [](auto const& p) { return p.default_value.has_value(); });
    if (!has_defaults) continue;
    int applied = 0, compared = 0;
    for (Map const& map : maps_for(*rule.scheme.modeler)) {
      bool const border = summarize(map).boundary_darts != 0;
      Cells const was = cells_of(map);
      for (std::vector<Dart> const& hooks : places(rule.scheme, effects, map)) {
        Map changed = map;
        rewrite::Workspace workspace;
        if (!interpreter::apply(rule.scheme, rule.plan, changed, hooks, defaults(rule.scheme), workspace)) continue;
        ++applied;
        compared += expect_counts(effects, was, cells_of(changed), border);
      }
    }
    bool const tells = std::any_of(effects.cells.begin(), effects.cells.end(), [](auto const& c) { return c.count && c.count->others.empty(); });
    EXPECT_TRUE(!effects.whole || applied > 0);
    EXPECT_TRUE(!tells || applied == 0 || compared > 0);
    RecordProperty(rule.scheme.name, compared);
  }
}

INSTANTIATE_TEST_SUITE_P(Modules, Library, testing::Values("conway", "conway_halfedges", "subdivision", "surface", "surface_halfedges", "volume"),
                         [](auto const& module) { return module.param; });

// What a rule on whole components makes is a sum of what there was, for all of these.
TEST(Effects, OfRulesOnSurfacesAreKnown) {
  for (char const* const name : {"conway", "conway_halfedges", "subdivision"}) {
    Module const module(JRULE_SOURCE_DIR "/stdlib/std/" + std::string(name) + ".jrule");
    for (Module::Rule const& rule : module.rules()) {
      Effects const effects = analysis::analyze_effects(rule.scheme, rule.plan);
      EXPECT_TRUE(effects.whole) << rule.scheme.name;
      for (analysis::CellEffects const& cells : effects.cells) {
        EXPECT_TRUE(cells.count && cells.count->others.empty()) << rule.scheme.name << " " << cells.dimension;
      }
    }
  }
}

}  // namespace
}  // namespace jrule::test
