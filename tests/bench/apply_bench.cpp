// Applying a rule to a whole surface with the interpreter, beside the bandwidth of copying what the result holds.
#include <benchmark/benchmark.h>

#include <cstring>
#include <stdexcept>
#include <string>

#include "compiler/analysis/analyze.h"
#include "compiler/analysis/independence.h"
#include "compiler/backend/interpreter/interpreter.h"
#include "compiler/sema/elaborate.h"

namespace {

using namespace jrule;

ir::RuleScheme first_rule(std::string const& path) {
  source::Sources sources;
  source::Diagnostics diagnostics;
  sema::Modules const modules = sema::load(path, {}, sources, diagnostics);
  ir::Program const program = sema::elaborate(modules, diagnostics);
  if (program.rules.empty()) throw std::runtime_error(path + " is not accepted");
  return program.rules.front();
}

ir::RuleScheme quad_subdivision() { return first_rule(JRULE_SOURCE_DIR "/examples/demo/surface.jrule"); }

// A torus of n × n quads with positions: 8 n² darts.
Map torus(ir::RuleScheme const& rule, std::uint32_t n) {
  Map map(rule.model(), rule.modeler->embeddings);
  map.add_darts(std::size_t{8} * n * n);
  auto const dart = [n](std::uint32_t x, std::uint32_t y, std::uint32_t k) { return 8 * ((y % n) * n + x % n) + k % 8; };
  for (std::uint32_t y = 0; y < n; ++y) {
    for (std::uint32_t x = 0; x < n; ++x) {
      // Corner k of the square is its k-th in cyclic order; darts 2k and 2k + 1 are the ends of side k.
      for (std::uint32_t k = 0; k < 4; ++k) {
        map.link(dart(x, y, 2 * k), 0, dart(x, y, 2 * k + 1));
        map.link(dart(x, y, 2 * k + 1), 1, dart(x, y, 2 * k + 2));
      }
      map.link(dart(x, y, 2), 2, dart(x + 1, y, 7));
      map.link(dart(x, y, 3), 2, dart(x + 1, y, 6));
      map.link(dart(x, y, 4), 2, dart(x, y + 1, 1));
      map.link(dart(x, y, 5), 2, dart(x, y + 1, 0));
    }
  }
  for (std::size_t e = 0; e < map.embedding_count(); ++e) {
    Embedding& embedding = map.embedding(e);
    OrbitNumbers const orbits = number_orbits(map, embedding.spec().orbit);
    for (std::size_t i = 0; i < orbits.first.size(); ++i) {
      auto const x = static_cast<double>(i);
      embedding.add(embedding.spec().type == Type::Point3 ? Value(Point3{x, -x, 1}) : Value(Color{0.5, 0.5, 0.5}));
    }
    for (Dart d = 0; d < map.dart_limit(); ++d) embedding.set_handle(d, orbits.number[d]);
  }
  return map;
}

/// A rule that makes four darts of each, on a torus of n² quads.
void interpret(benchmark::State& state, ir::RuleScheme const& rule) {
  analysis::Plan const plan = analysis::analyze(rule).plan;
  Map const original = torus(rule, static_cast<std::uint32_t>(state.range(0)));
  rewrite::Workspace workspace;
  for (auto _ : state) {
    state.PauseTiming();
    Map map = original;
    state.ResumeTiming();
    auto const applied = interpreter::apply(rule, plan, map, {0}, {}, workspace);
    if (!applied) state.SkipWithError(applied.error().message.c_str());
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(4 * original.dart_count()));
}

void quad_subdivision_interpreted(benchmark::State& state) { interpret(state, quad_subdivision()); }
BENCHMARK(quad_subdivision_interpreted)->Arg(112)->Unit(benchmark::kMillisecond);

/// A rule at each orbit of its hook, of a torus of n² quads, in turn or all at once.
void interpret_everywhere(benchmark::State& state, ir::RuleScheme const& rule, decltype(interpreter::apply_everywhere)* everywhere) {
  analysis::Plan const plan = analysis::analyze(rule).plan;
  if (!analysis::analyze_independence(rule, plan).independent()) return state.SkipWithError("the rule is not proved independent");
  Map const original = torus(rule, static_cast<std::uint32_t>(state.range(0)));
  rewrite::Workspace workspace;
  for (auto _ : state) {
    state.PauseTiming();
    Map map = original;
    state.ResumeTiming();
    auto const applied = everywhere(rule, plan, map, {}, workspace);
    if (!applied) state.SkipWithError(applied.error().message.c_str());
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(original.dart_count()));
}

template <unsigned threads>
Result<std::size_t> at_once(ir::RuleScheme const& rule, analysis::Plan const& plan, Map& map, std::vector<Value> const& arguments,
                            rewrite::Workspace& workspace) {
  return interpreter::apply_all(rule, plan, map, arguments, workspace, {threads});
}

void quad_subdivision_at_once(benchmark::State& state) { interpret_everywhere(state, quad_subdivision(), at_once<1>); }
void quad_subdivision_two_threads(benchmark::State& state) { interpret_everywhere(state, quad_subdivision(), at_once<2>); }
BENCHMARK(quad_subdivision_at_once)->Arg(112)->Unit(benchmark::kMillisecond);
BENCHMARK(quad_subdivision_two_threads)->Arg(112)->Unit(benchmark::kMillisecond);

ir::RuleScheme triangulate() { return first_rule(JRULE_SOURCE_DIR "/tests/bench/data/triangulate.jrule"); }
void triangulate_in_turn(benchmark::State& state) { interpret_everywhere(state, triangulate(), interpreter::apply_everywhere); }
BENCHMARK(triangulate_in_turn)->Arg(112)->Unit(benchmark::kMillisecond);
void triangulate_at_once(benchmark::State& state) { interpret_everywhere(state, triangulate(), at_once<1>); }
BENCHMARK(triangulate_at_once)->Arg(112)->Unit(benchmark::kMillisecond);

// Nested comprehensions at every vertex: the rate must not fall as the surface grows.
void catmull_clark_interpreted(benchmark::State& state) {
  interpret(state, first_rule(JRULE_SOURCE_DIR "/tests/integration/rules/smoothing.jrule"));
}
BENCHMARK(catmull_clark_interpreted)->Arg(28)->Arg(56)->Arg(112)->Unit(benchmark::kMillisecond);

// One dart for each vertex of the whole surface: as one orbit of 8 n² darts.
void representatives_of_vertices(benchmark::State& state) {
  Map const map = torus(quad_subdivision(), static_cast<std::uint32_t>(state.range(0)));
  OrbitType const all = orbit_of_dimensions({0, 1, 2}), vertex = orbit_of_dimensions({1, 2});
  for (auto _ : state) benchmark::DoNotOptimize(rewrite::representatives(map, all, vertex, 0));
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(map.dart_count()));
}
BENCHMARK(representatives_of_vertices)->Arg(28)->Arg(112)->Arg(448)->Unit(benchmark::kMillisecond);

// The roofline: as many bytes as the result's arcs and handles, copied.
void copy_result(benchmark::State& state) {
  auto const n = static_cast<std::size_t>(state.range(0));
  std::vector<char> const from(4 * 8 * n * n * 5 * sizeof(Dart), 'x');
  std::vector<char> to(from.size());
  for (auto _ : state) {
    std::memcpy(to.data(), from.data(), from.size());
    benchmark::ClobberMemory();
  }
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(from.size()));
}
BENCHMARK(copy_result)->Arg(112)->Unit(benchmark::kMillisecond);

void validity_check(benchmark::State& state) {
  Map const map = torus(quad_subdivision(), static_cast<std::uint32_t>(state.range(0)));
  if (auto const violation = find_violation(map)) state.SkipWithError(violation->text.c_str());
  for (auto _ : state) benchmark::DoNotOptimize(find_violation(map));
}
BENCHMARK(validity_check)->Arg(112)->Unit(benchmark::kMillisecond);

}  // namespace
