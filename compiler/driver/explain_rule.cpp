// `jrule explain FILE:RULE`: what a rule does to cells.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <filesystem>

#include "compiler/analysis/effects_wording.h"
#include "compiler/driver/compile.h"
#include "compiler/driver/reference.h"
#include "compiler/driver/report.h"

namespace jrule::driver {

namespace {

using analysis::CellClass;
using analysis::CellEffects;
using analysis::OrbitCount;

struct Kind {
  char const* key;
  std::vector<CellClass> CellEffects::* classes;
};
constexpr std::array<Kind, 5> kinds{{{"created", &CellEffects::created},
                                     {"deleted", &CellEffects::deleted},
                                     {"split", &CellEffects::split},
                                     {"merged", &CellEffects::merged},
                                     {"kept", &CellEffects::kept}}};

std::vector<std::string> names(ir::RuleScheme const& rule, CellClass const& cells) {
  std::vector<std::string> found;
  for (ir::NodeId const id : cells.nodes) found.push_back(rule.nodes[id].name);
  return found;
}

std::string text_of(ir::RuleScheme const& rule, analysis::Effects const& effects) {
  analysis::EffectsWording const wording = analysis::describe(rule, effects);
  std::string text = fmt::format("{} on {}: {}\n", rule.name, rule.modeler->name, wording.where);
  for (analysis::EffectLine const& line : wording.lines) {
    text += fmt::format("  {:<9} {:<13} {:<20} {}\n", line.cells, line.effect, fmt::format("`{}`", fmt::join(line.nodes, "`, `")), line.number);
  }
  for (std::string const& count : wording.counts) text += fmt::format("  {}\n", count);
  return text;
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
