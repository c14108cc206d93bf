#include "compiler/driver/refutation.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>

#include "compiler/analysis/counterexample/counterexample.h"
#include "compiler/backend/draw/draw.h"
#include "jrule/io.h"

namespace jrule::driver {

namespace {

/// Maps of at most that many darts are told arc by arc.
constexpr std::size_t told_darts = 8;

bool is_topological(analysis::Refusal const& refusal) {
  return source::info(refusal.diagnostic.code).number.starts_with("J03");
}

/// "0: 0-1 2-2": a loop leads from a dart to itself; "1: 0>1>2>0" for an oriented dimension.
std::string arcs_of(Map const& map, int dimension) {
  std::vector<std::string> arcs;
  std::vector<bool> seen(map.dart_limit(), false);
  bool const oriented = map.model().is_oriented(dimension);
  for (Dart const d : map.darts()) {
    if (seen[d]) continue;
    std::string text = std::to_string(d);
    Dart at = d;
    do {
      seen[at] = true;
      at = map.target(at, dimension);
      seen[at] = true;
      text += (oriented ? ">" : "-") + std::to_string(at);
    } while (oriented && at != d);
    arcs.push_back(std::move(text));
  }
  return fmt::format("{}: {}", dimension, fmt::join(arcs, " "));
}

std::string copy_of(ir::RuleScheme const& rule, analysis::Counterexample const& example, Dart d) {
  for (ir::NodeId id = 0; id < rule.nodes.size(); ++id) {
    auto const& copies = example.copies[id];
    if (std::find(copies.begin(), copies.end(), d) != copies.end())
      return fmt::format("; dart {} is a copy of `{}`", d, rule.nodes[id].name);
  }
  return {};
}

std::string place(ir::RuleScheme const& rule, analysis::Counterexample const& example) {
  if (rule.hooks.empty()) return "applied to the empty map";
  std::vector<std::string> hooks;
  for (std::size_t h = 0; h < rule.hooks.size(); ++h)
    hooks.push_back(fmt::format("dart {} (hook `{}`)", example.hooks[h], rule.nodes[rule.hooks[h]].name));
  std::size_t const darts = example.before.dart_count();
  return fmt::format("in this map of {} dart{}, applied at {}", darts, darts == 1 ? "" : "s",
                     fmt::join(hooks, " and "));
}

std::vector<std::string> tell(ir::RuleScheme const& rule, analysis::Counterexample const& example) {
  std::vector<std::string> notes{fmt::format("counterexample: {}, the rule leaves no {}: {}{}", place(rule, example),
                                             ir::map_name(rule.model()), example.violation.text,
                                             copy_of(rule, example, example.violation.dart))};
  std::size_t const darts = example.before.dart_count();
  if (darts == 0 || darts > told_darts) return notes;
  for (int const d : rule.model().dimensions) notes.push_back(arcs_of(example.before, d));
  return notes;
}

std::string file_name(std::string rule) {
  std::replace_if(
      rule.begin(), rule.end(), [](char c) { return c == '[' || c == ']' || c == ','; }, '_');
  return rule;
}

}  // namespace

void refute(ir::RuleScheme const& rule, analysis::Verdict& verdict, CounterexampleFiles* files) {
  auto const first = std::find_if(verdict.refusals.begin(), verdict.refusals.end(), is_topological);
  if (first == verdict.refusals.end() || std::any_of(verdict.refusals.begin(), verdict.refusals.end(), analysis::is_dead_left))
    return;
  auto& notes = first->diagnostic.notes;
  analysis::Search const search = analysis::search_counterexample(rule);
  if (!search.counterexample) {
    notes.push_back(search.applications == 0 ? "no counterexample was found, nor any map that the left side matches"
                                             : "no counterexample was found: the verdict is \"unproved\"");
    return;
  }
  analysis::Counterexample const& example = *search.counterexample;
  for (std::string& note : tell(rule, example)) notes.push_back(std::move(note));
  if (!files) return;
  std::string const stem = (std::filesystem::path(files->directory) / file_name(rule.name)).string();
  files->files.push_back({stem + "-before.jmap", print_jmap(example.before)});
  files->files.push_back({stem + "-after.jmap", analysis::print_graph(example.after, rule.model())});
  files->files.push_back({stem + ".svg", draw::graph_svg(rule, example)});
  notes.push_back(fmt::format("written to {0}-before.jmap, {0}-after.jmap and {0}.svg", stem));
}

}  // namespace jrule::driver
