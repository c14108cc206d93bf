// The analysis of one large rule: 20 nodes in dimension 4. It has to take less than 5 ms.
#include <benchmark/benchmark.h>

#include <stdexcept>

#include "compiler/analysis/analyze.h"
#include "compiler/analysis/counterexample/counterexample.h"
#include "compiler/sema/elaborate.h"
#include "compiler/syntax/parse.h"
#include "tests/bench/stars.h"

namespace {

using namespace jrule;

enum Which { cells, oriented_cells };

ir::RuleScheme rule_of(std::string const& text, std::int64_t which) {
  source::Sources sources;
  source::Diagnostics diagnostics;
  sema::Modules modules;
  modules.all.push_back({"stars", syntax::parse(sources, sources.add("stars.jrule", text), diagnostics)});
  ir::Program const program = sema::elaborate(modules, diagnostics);
  if (diagnostics.has_errors()) throw std::runtime_error("the benchmark's rules have errors");
  return program.rules.at(static_cast<std::size_t>(which));
}

void analyze_large_rule(benchmark::State& state) {
  ir::RuleScheme const rule = rule_of(bench::stars(), state.range(0));
  if (!analysis::analyze(rule).accepted()) state.SkipWithError("the rule is refused");
  for (auto _ : state) benchmark::DoNotOptimize(analysis::analyze(rule));
}
BENCHMARK(analyze_large_rule)->ArgName("omap")->Arg(cells)->Arg(oriented_cells)->Unit(benchmark::kMillisecond);

// With a mistake: the verdict, and, on its own, the search for a map that the rule breaks.
void refuse_large_rule(benchmark::State& state) {
  ir::RuleScheme const rule = rule_of(bench::wrong_stars(), state.range(0));
  if (analysis::analyze(rule).accepted()) state.SkipWithError("the rule is accepted");
  for (auto _ : state) benchmark::DoNotOptimize(analysis::analyze(rule));
}
BENCHMARK(refuse_large_rule)->ArgName("omap")->Arg(cells)->Arg(oriented_cells)->Unit(benchmark::kMillisecond);

void refute_large_rule(benchmark::State& state) {
  ir::RuleScheme const rule = rule_of(bench::wrong_stars(), state.range(0));
  if (!analysis::find_counterexample(rule)) state.SkipWithError("there is no counterexample");
  for (auto _ : state) benchmark::DoNotOptimize(analysis::find_counterexample(rule));
}
BENCHMARK(refute_large_rule)->ArgName("omap")->Arg(cells)->Arg(oriented_cells)->Unit(benchmark::kMillisecond);

}  // namespace
