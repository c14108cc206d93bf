// Rules for G-maps and for O-maps that are called alike make as many cells of one shape.
#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "compiler/analysis/effects.h"
#include "compiler/backend/interpreter/interpreter.h"
#include "tests/stdlib/library.h"

namespace jrule::test {
namespace {

using Hooks = std::vector<Dart>;

constexpr std::size_t enough = 5;  // shapes, for every rule: none is excepted

/// Rules that fit other places of a closed G-map than of the O-map.
std::map<std::string, std::string> const other_conditions{
    {"quadrangulate_face",
     "on O-maps, an edge and the next one of a face beside are matched; at a corner of two edges that is matched too"},
    {"extrude_face_solid",
     "what it makes of a G-map lies outside, where a face is free; what it makes of an O-map, in the volume outside"},
};

/// The cells that a rule makes of a map there, holes and the outside counted; none where it does not fit.
std::optional<std::vector<std::size_t>> cells_made(Module::Rule const& rule, Map const& map, Hooks const& hooks) {
  Map changed = map;
  rewrite::Workspace workspace;
  if (!interpreter::apply(rule.scheme, rule.plan, changed, hooks, some_arguments(rule.scheme), workspace)) return {};
  return closed_cells(changed);
}

/// Of one hook, at three darts where both fit; of two, at all where the first is dart 0. How often they were compared;
/// and whether there is a place of a closed shape where one fits and the other does not.
int compare_kinds(Module::Rule const& of_gmap, Module::Rule const& of_omap, Subject const& g, Subject const& o,
                  bool& other_places) {
  EXPECT_EQ(closed_cells(g.map), closed_cells(o.map));
  int compared = 0;
  if (of_gmap.scheme.hooks.size() == 2) {
    if (!g.closed) return 0;
    std::set<std::vector<std::size_t>> made[2];
    for (Dart const d : g.map.darts()) {
      if (auto const cells = cells_made(of_gmap, g.map, {0, d})) made[0].insert(*cells);
    }
    for (Dart const d : o.map.darts()) {
      if (auto const cells = cells_made(of_omap, o.map, {0, d})) made[1].insert(*cells);
    }
    EXPECT_EQ(made[0], made[1]);
    return made[0].empty() ? 0 : 1;
  }
  bool const hooked = !of_gmap.scheme.hooks.empty();
  for (Dart const d : hooked ? spread(o.map) : std::vector<Dart>{0}) {
    if (2 * d >= g.map.dart_count()) continue;  // of a hole, or the outside
    auto const by_g = cells_made(of_gmap, g.map, hooked ? Hooks{2 * d} : Hooks{});
    auto const by_o = cells_made(of_omap, o.map, hooked ? Hooks{d} : Hooks{});
    if (g.closed && by_g.has_value() != by_o.has_value()) other_places = true;
    if (!by_g || !by_o) continue;
    EXPECT_EQ(*by_g, *by_o) << "dart " << d;
    if (++compared == 3) break;
  }
  return compared;
}

class BothKinds : public testing::TestWithParam<std::string> {};

TEST_P(BothKinds, MakeAsManyCells) {
  std::string const suffix = "_halfedges";
  for (Module::Rule const& of_omap : rules_of(GetParam()).rules) {
    std::string const& name = of_omap.scheme.name;
    if (!name.ends_with(suffix)) continue;
    SCOPED_TRACE(name);
    auto const of_gmap = std::find_if(all_rules().begin(), all_rules().end(),
                                      [&](Module::Rule const& rule) { return rule.scheme.name + suffix == name; });
    ASSERT_NE(of_gmap, all_rules().end());
    bool const whole = !of_omap.scheme.hooks.empty() && analysis::analyze_effects(of_omap.scheme, of_omap.plan).whole;
    std::set<std::string> agreed;
    bool other_places = false;
    for (Subject const& o : subjects_for(of_omap.scheme)) {
      SCOPED_TRACE(o.name);
      for (Subject const& g : subjects_for(of_gmap->scheme)) {
        // A hole of an O-map is refined with its component, one of a G-map is not.
        if (g.name == o.name && (!whole || g.closed) && compare_kinds(*of_gmap, of_omap, g, o, other_places) > 0) {
          agreed.insert(o.shape);
        }
      }
    }
    EXPECT_GE(agreed.size(), enough);
    EXPECT_EQ(other_places, other_conditions.contains(of_gmap->scheme.name));
  }
}

TEST(OtherConditions, AreOfRulesThatThereAre) {
  for (auto const& [name, reason] : other_conditions) {
    EXPECT_TRUE(std::any_of(all_rules().begin(), all_rules().end(), [&](auto const& rule) {
      return rule.scheme.name == name + "_halfedges";
    })) << name;
  }
}

INSTANTIATE_TEST_SUITE_P(Modules, BothKinds, testing::ValuesIn(modules()),
                         [](auto const& module) { return module.param; });

}  // namespace
}  // namespace jrule::test
