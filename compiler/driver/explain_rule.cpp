// `jrule explain FILE:RULE`: what a rule does to cells.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <filesystem>

#include "compiler/analysis/effects.h"
#include "compiler/analysis/wording.h"
#include "compiler/driver/compile.h"
#include "compiler/driver/reference.h"
#include "compiler/driver/report.h"

namespace jrule::driver {

namespace {

using analysis::CellClass;
using analysis::CellEffects;
using analysis::OrbitCount;

struct Kind {
  char const* title;
  char const* key;
  std::vector<CellClass> CellEffects::* classes;
};
constexpr std::array<Kind, 5> kinds{{{"new", "created", &CellEffects::created},
                                     {"deleted", "deleted", &CellEffects::deleted},
                                     {"may be split", "split", &CellEffects::split},
                                     {"may merge", "merged", &CellEffects::merged},
                                     {"kept", "kept", &CellEffects::kept}}};

std::vector<std::string> names(ir::RuleScheme const& rule, CellClass const& cells) {
  std::vector<std::string> found;
  for (ir::NodeId const id : cells.nodes) found.push_back(rule.nodes[id].name);
  return found;
}

// "one", "one for each vertex", "at most one for each dart".
std::string number(ir::RuleScheme const& rule, CellClass const& cells) {
  if (cells.single) return "one";
  return fmt::format("{}one for each {}", cells.reaches_out ? "at most " : "",
                     cells.per.words.empty() ? "dart" : analysis::orbit_name(rule.model(), cells.per));
}

std::string sum_text(OrbitCount const& count) {
  std::string text = to_string(count.count);
  if (!count.others.empty() && count.count == ir::Count{}) text.clear();
  for (OrbitType const& other : count.others) text += fmt::format("{}orbits {}", text.empty() ? "" : " + ", to_string(other));
  return text;
}

std::string count_line(std::optional<int> cell, OrbitCount const& count, analysis::OrbitCounter const& counter) {
  constexpr auto condition = "where there is no border";
  std::string text = fmt::format("  {}' = {}", ir::count_name(cell), sum_text(count));
  if (count.regular_only) return fmt::format("{}   {}\n", text, condition);
  // Cells are what a surface is known by, not darts.
  OrbitCount const in_cells{counter.readable(count.count), true, count.others};
  bool const shorter = cell && !count.count.darts.is_zero() && in_cells.count.darts.is_zero();
  return shorter ? fmt::format("{}, {} {}\n", text, sum_text(in_cells), condition) : text + "\n";
}

std::string text_of(ir::RuleScheme const& rule, analysis::Effects const& effects) {
  std::string type;
  for (Letter const letter : rule.hook_type) type += fmt::format("{}{}", type.empty() ? "" : ",", letter.dimension);
  std::string text = fmt::format("{} on {}: ", rule.name, rule.modeler->name);
  if (rule.hooks.empty()) {
    text += "creates\n";
  } else if (effects.whole) {
    text += "applied to whole components\n";
  } else {
    text += fmt::format("its pattern is the orbit <{}> of `{}`\n", type, rule.nodes[rule.hooks.front()].name);
  }
  std::string counts;
  algebra::Group const group(rule.model());
  analysis::OrbitCounter const counter(group);
  for (CellEffects const& cells : effects.cells) {
    std::string title = analysis::orbit_names(rule.model(), cells.orbit);
    if (title.starts_with("orbits")) title = fmt::format("{}-cells", cells.dimension);
    for (Kind const& kind : kinds) {
      for (CellClass const& c : cells.*kind.classes) {
        text += fmt::format("  {:<9} {:<13} {:<20} {}\n", title, kind.title, fmt::format("`{}`", fmt::join(names(rule, c), "`, `")), number(rule, c));
        title.clear();
      }
    }
    if (cells.count) counts += count_line(cells.dimension, *cells.count, counter);
  }
  if (effects.darts) counts += count_line({}, *effects.darts, counter);
  return text + counts;
}

std::string json_of(CellClass const& cells, ir::RuleScheme const& rule) {
  return fmt::format(R"({{"nodes":["{}"],"per":"{}","single":{},"reaches_out":{}}})", fmt::join(names(rule, cells), R"(",")"), to_string(cells.per),
                     cells.single, cells.reaches_out);
}

std::string json_of(std::optional<OrbitCount> const& count) {
  if (!count) return "null";
  std::vector<std::string> others;
  for (OrbitType const& other : count->others) others.push_back(fmt::format("\"{}\"", to_string(other)));
  return fmt::format(R"({{"sum":"{}","orbits":[{}],"without_border":{}}})", to_string(count->count), fmt::join(others, ","), count->regular_only);
}

std::string json_of(ir::RuleScheme const& rule, analysis::Effects const& effects) {
  std::vector<std::string> cells;
  for (CellEffects const& c : effects.cells) {
    std::string text = fmt::format(R"({{"dimension":{},"orbit":"{}")", c.dimension, to_string(c.orbit));
    for (Kind const& kind : kinds) {
      std::vector<std::string> classes;
      for (CellClass const& one : c.*kind.classes) classes.push_back(json_of(one, rule));
      text += fmt::format(R"(,"{}":[{}])", kind.key, fmt::join(classes, ","));
    }
    cells.push_back(text + fmt::format(R"(,"count":{}}})", json_of(c.count)));
  }
  return fmt::format(R"({{"rule":"{}","modeler":"{}","whole_component":{},"cells":[{}],"darts":{}}})", rule.name, rule.modeler->name, effects.whole,
                     fmt::join(cells, ","), json_of(effects.darts));
}

}  // namespace

int explain_rule(ExplainOptions const& options) {
  auto const reference = std::filesystem::exists(options.what) ? std::nullopt : parse_reference(options.what);
  auto const compilation = compile(reference ? reference->file : options.what, options.common);
  bool const found = compilation->read() && (!reference || keep_only(*reference, options.dimension, *compilation));
  print(compilation->sources, compilation->diagnostics, options.common);
  for (std::size_t i = 0; found && i < compilation->program.rules.size(); ++i) {
    if (!compilation->verdicts[i].accepted()) continue;  // what it does is not defined; the diagnostics say why
    ir::RuleScheme const& rule = compilation->program.rules[i];
    analysis::Effects const effects = analysis::analyze_effects(rule, compilation->verdicts[i].plan);
    fmt::print("{}\n", options.json ? json_of(rule, effects) : text_of(rule, effects));
  }
  return status(compilation->diagnostics);
}

}  // namespace jrule::driver
