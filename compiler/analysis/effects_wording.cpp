#include "compiler/analysis/effects_wording.h"

#include <fmt/format.h>

#include <array>

#include "compiler/analysis/wording.h"

namespace jrule::analysis {

namespace {

struct Kind {
  char const* title;
  std::vector<CellClass> CellEffects::* classes;
};
constexpr std::array<Kind, 5> kinds{{{"new", &CellEffects::created},
                                     {"deleted", &CellEffects::deleted},
                                     {"may be split", &CellEffects::split},
                                     {"may merge", &CellEffects::merged},
                                     {"kept", &CellEffects::kept}}};

std::string number(ir::RuleScheme const& rule, CellClass const& cells) {
  if (cells.single) return "one";
  return fmt::format("{}one for each {}", cells.reaches_out ? "at most " : "",
                     cells.per.words.empty() ? "dart" : orbit_name(rule.model(), cells.per));
}

std::string sum_text(OrbitCount const& count) {
  std::string text = to_string(count.count);
  if (!count.others.empty() && count.count == ir::Count{}) text.clear();
  for (OrbitType const& other : count.others) text += fmt::format("{}orbits {}", text.empty() ? "" : " + ", to_string(other));
  return text;
}

// Cells of higher dimensions have no letter, so no `expect` clause, but their number may be known.
std::string counted(std::optional<int> cell) {
  if (cell && *cell >= static_cast<int>(ir::Count::named_cells)) return fmt::format("{}-cells", *cell);
  return {ir::count_name(cell)};
}

std::string count_text(std::optional<int> cell, OrbitCount const& count, OrbitCounter const& counter) {
  constexpr auto condition = "without a border or a folded edge";
  std::string text = fmt::format("{}' = {}", counted(cell), sum_text(count));
  if (count.regular_only) return fmt::format("{}   {}", text, condition);
  // Cells are what a surface is known by, not darts.
  OrbitCount const in_cells{counter.readable(count.count), true, count.others};
  bool const shorter = cell && !count.count.darts.is_zero() && in_cells.count.darts.is_zero();
  return shorter ? fmt::format("{}, {} {}", text, sum_text(in_cells), condition) : text;
}

std::string where(ir::RuleScheme const& rule, Effects const& effects) {
  if (rule.hooks.empty()) return "creates";
  if (effects.whole) return "applied to whole components";
  return fmt::format("its pattern is the orbit {} of `{}`", to_string(rule.hook_orbit()), rule.nodes[rule.hooks.front()].name);
}

}  // namespace

EffectsWording describe(ir::RuleScheme const& rule, Effects const& effects) {
  EffectsWording wording{where(rule, effects), {}, {}};
  algebra::Group const group(rule.model());
  OrbitCounter const counter(group);
  for (CellEffects const& cells : effects.cells) {
    std::string title = orbit_names(rule.model(), cells.orbit);
    if (title.starts_with("orbits")) title = fmt::format("{}-cells", cells.dimension);
    for (Kind const& kind : kinds) {
      for (CellClass const& c : cells.*kind.classes) {
        std::vector<std::string> nodes;
        for (ir::NodeId const id : c.nodes) nodes.push_back(rule.nodes[id].name);
        wording.lines.push_back({title, kind.title, std::move(nodes), number(rule, c)});
        title.clear();
      }
    }
    if (cells.count) wording.counts.push_back(count_text(cells.dimension, *cells.count, counter));
  }
  if (effects.darts) wording.counts.push_back(count_text({}, *effects.darts, counter));
  return wording;
}

}  // namespace jrule::analysis
