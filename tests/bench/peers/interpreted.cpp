// The interpreter, which needs no C++ compiler: the same rules.
#include "compiler/analysis/analyze.h"
#include "compiler/backend/interpreter/interpreter.h"
#include "compiler/sema/elaborate.h"
#include "tests/bench/peers/own.h"

namespace jrule::bench {

namespace {

struct AcceptedRule {
  ir::RuleScheme scheme;
  analysis::Plan plan;
};

std::shared_ptr<AcceptedRule const> load(std::string const& path, std::string const& name) {
  source::Sources sources;
  source::Diagnostics diagnostics;
  sema::Modules const modules =
      sema::load(JRULE_SOURCE_DIR + path, {JRULE_SOURCE_DIR "/stdlib", {}}, sources, diagnostics);
  ir::Program program = sema::elaborate(modules, diagnostics);
  for (ir::RuleScheme& scheme : program.rules) {
    if (scheme.name != name) continue;
    analysis::Verdict verdict = analysis::analyze(scheme);
    if (!verdict.accepted()) throw std::runtime_error(name + " is not accepted");
    return std::make_shared<AcceptedRule const>(std::move(scheme), std::move(verdict.plan));
  }
  throw std::runtime_error(path + " has no rule " + name);
}

struct Input {
  Map map;
  rewrite::Workspace workspace;
};

void enter_rule(Contest& contest, Work work, std::string const& column, std::string const& path,
                std::string const& name, Originals<Map> const& originals) {
  auto const rule = load(path, name);
  bool const halfedges = rule->scheme.model().is_oriented(1);
  contest.enter(
      column, halfedges ? 2 : 4, work,
      [originals, rule](Row const& row) {
        auto const make = [&] { return map_of(*row.surface, rule->scheme.model(), rule->scheme.modeler->embeddings); };
        return Input{originals(row.mesh, make), {}};
      },
      [rule](Input& input) -> Input& {
        expect(interpreter::apply(rule->scheme, rule->plan, input.map, {0}, {}, input.workspace));
        return input;
      },
      [](Input const& input, Row const& row) { return count_cells(input.map, row); }, Size::small);
}

}  // namespace

void enter_interpreter(Contest& contest) {
  std::string const topology = "/tests/bench/rules/topology.jrule", surface = "/tests/bench/rules/surface.jrule",
                    library = "/stdlib/std/subdivision.jrule";
  auto const enter_all = [&](std::string const& column, std::string const& suffix) {
    Originals<Map> const bare, positions;
    enter_rule(contest, Work::quad, column, topology, "quad" + suffix, bare);
    enter_rule(contest, Work::quad_positions, column, surface, "quad" + suffix, positions);
    enter_rule(contest, Work::catmull_clark, column, library, "catmull_clark" + suffix, positions);
    enter_rule(contest, Work::triangulate, column, surface, "triangulate" + suffix, positions);
    enter_rule(contest, Work::edge_vertices, column, surface, "edge_vertices" + suffix, positions);
    enter_rule(contest, Work::dual, column, surface, "dual" + suffix, positions);
  };
  enter_all("G interpreted", "");
  enter_all("O interpreted", "_halfedges");
}

}  // namespace jrule::bench
