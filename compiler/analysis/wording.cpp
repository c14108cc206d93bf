#include "compiler/analysis/wording.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

namespace jrule::analysis {

namespace {
std::string spelling(Word const& word) {
  std::string text = "[";
  for (std::size_t i = 0; i < word.size(); ++i) {
    if (i != 0) text += ',';
    if (word[i].conjugate) text += '~';
    text += static_cast<char>('0' + word[i].dimension);
  }
  return text + ']';
}

struct CellName {
  std::string_view one, several;
};
std::optional<CellName> cell_name(Model const& model, OrbitType const& orbit) {
  constexpr std::array names{CellName{"vertex", "vertices"}, CellName{"edge", "edges"}, CellName{"face", "faces"}, CellName{"volume", "volumes"}};
  auto const sorted = [](OrbitType type) {
    std::sort(type.words.begin(), type.words.end());
    return type.words;
  };
  for (std::size_t i = 0; i < names.size(); ++i) {
    auto const cell = cell_orbit(model, static_cast<int>(i));
    if (cell && sorted(*cell) == sorted(orbit)) return names[i];
  }
  return {};
}
}  // namespace

std::string describe(Word const& word) { return word.empty() ? "the empty word" : "the word " + spelling(word); }

std::string orbit_name(Model const& model, OrbitType const& orbit) {
  auto const cell = cell_name(model, orbit);
  return cell ? std::string(cell->one) : "orbit " + jrule::to_string(orbit);
}

std::string orbit_names(Model const& model, OrbitType const& orbit) {
  auto const cell = cell_name(model, orbit);
  return cell ? std::string(cell->several) : "orbits " + jrule::to_string(orbit);
}

std::string both_directions(ir::RuleScheme const& rule, ir::Arc const& arc) {
  return fmt::format("`{} -{}{}- {}`", rule.nodes[arc.source].name, arc.dimension, arc.word.empty() ? "" : spelling(arc.word), rule.nodes[arc.target].name);
}

std::string describe(ir::RuleScheme const& rule, ir::Arc const& arc) {
  std::string text = arc.source == arc.target
                         ? fmt::format("a {}-arc from `{}` to itself", arc.dimension, rule.nodes[arc.source].name)
                         : fmt::format("a {}-arc from `{}` to `{}`", arc.dimension, rule.nodes[arc.source].name, rule.nodes[arc.target].name);
  if (!arc.word.empty()) text += " with " + describe(arc.word);
  return text;
}

std::string incident_arcs_note(Model const& model, int d) {
  if (model.is_oriented(d)) {
    return fmt::format("in a {} exactly one {}-arc leaves every dart and exactly one enters it (incident arcs; paper, Def. 22)", map_name(model), d);
  }
  return fmt::format("in a {} every dart has exactly one {}-arc (incident arcs; paper, Def. 22)", map_name(model), d);
}

}  // namespace jrule::analysis
