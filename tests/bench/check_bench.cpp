// What `jrule check` does for a file of 1000 rules, stage by stage: the three rules of the demo, renamed.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <string>

#include "compiler/analysis/analyze.h"
#include "compiler/sema/elaborate.h"
#include "compiler/syntax/parse.h"

namespace {

using namespace jrule;

std::string demo_module() {
  std::ifstream in(JRULE_SOURCE_DIR "/examples/demo/surface.jrule");
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

std::string many_rules(int count) {
  std::string const demo = demo_module();
  std::size_t const first = demo.find("/// Splits");
  std::string text = demo.substr(0, first);
  std::string const rules = demo.substr(first);
  for (int made = 0; made < count;) {
    std::string copy = rules;
    for (std::size_t at = copy.find("\nrule "); at != std::string::npos && made < count; at = copy.find("\nrule ", at + 1), ++made) {
      copy.insert(copy.find_first_of(" (", at + 6), fmt::format("_{}", made));
    }
    text += copy;
  }
  return text;
}

sema::Modules parse_all(std::string const& text, source::Sources& sources, source::Diagnostics& diagnostics) {
  sema::Modules modules;
  modules.all.push_back({"many", syntax::parse(sources, sources.add("many.jrule", text), diagnostics)});
  return modules;
}

void parse(benchmark::State& state) {
  std::string const text = many_rules(static_cast<int>(state.range(0)));
  for (auto _ : state) {
    source::Sources sources;
    source::Diagnostics diagnostics;
    benchmark::DoNotOptimize(parse_all(text, sources, diagnostics));
  }
}
BENCHMARK(parse)->Arg(1000)->Unit(benchmark::kMillisecond);

void elaborate(benchmark::State& state) {
  source::Sources sources;
  source::Diagnostics diagnostics;
  sema::Modules const modules = parse_all(many_rules(static_cast<int>(state.range(0))), sources, diagnostics);
  for (auto _ : state) benchmark::DoNotOptimize(sema::elaborate(modules, diagnostics));
}
BENCHMARK(elaborate)->Arg(1000)->Unit(benchmark::kMillisecond);

void analyze(benchmark::State& state) {
  source::Sources sources;
  source::Diagnostics diagnostics;
  ir::Program const program = sema::elaborate(parse_all(many_rules(static_cast<int>(state.range(0))), sources, diagnostics), diagnostics);
  if (program.rules.empty() || diagnostics.has_errors()) state.SkipWithError("the rules are not accepted");
  for (auto _ : state) {
    for (ir::RuleScheme const& rule : program.rules) benchmark::DoNotOptimize(analysis::analyze(rule));
  }
}
BENCHMARK(analyze)->Arg(1000)->Unit(benchmark::kMillisecond);

// The whole: compare with the sum of the above, and with one second.
void check(benchmark::State& state) {
  std::string const text = many_rules(static_cast<int>(state.range(0)));
  for (auto _ : state) {
    source::Sources sources;
    source::Diagnostics diagnostics;
    ir::Program const program = sema::elaborate(parse_all(text, sources, diagnostics), diagnostics);
    for (ir::RuleScheme const& rule : program.rules) benchmark::DoNotOptimize(analysis::analyze(rule));
  }
}
BENCHMARK(check)->Arg(1000)->Unit(benchmark::kMillisecond);

}  // namespace
