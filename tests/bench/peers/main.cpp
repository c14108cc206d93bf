// All benchmarks. The contest with other libraries is written as one table, the others by Google Benchmark; with
// --benchmark_format=json or csv it writes all of them.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <exception>
#include <iostream>
#include <string_view>

#include "tests/bench/peers/table.h"

namespace {

using namespace jrule::bench;

Contest contest() {
  Contest contest(rows());
  enter_generated(contest);
  enter_generated_solid(contest);
  enter_interpreter(contest);
#ifdef JRULE_BENCH_CGAL
  enter_cgal_gmap(contest);
  enter_cgal_cmap(contest);
  enter_cgal_surface_mesh(contest);
#endif
#ifdef JRULE_BENCH_OPENMESH
  enter_openmesh(contest);
#endif
#ifdef JRULE_BENCH_OPENSUBDIV
  enter_opensubdiv(contest);
#endif
  enter_copy(contest);
  return contest;
}

bool is_console(int argc, char** argv) {
  for (int k = 1; k < argc; ++k) {
    std::string_view const word = argv[k];
    std::string_view const format = "--benchmark_format=";
    if (word.substr(0, format.size()) == format && word.substr(format.size()) != "console") return false;
  }
  return true;
}

}  // namespace

int main(int argc, char** argv) try {
  bool const console = is_console(argc, argv);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  Contest entered = contest();
  entered.register_benchmarks();
  TableReporter table(entered);
  benchmark::RunSpecifiedBenchmarks(console ? &table : nullptr);
  benchmark::Shutdown();
  bool const all_right = std::all_of(entered.entries().begin(), entered.entries().end(),
                                     [](auto const& entry) { return entry->fault.empty(); });
  return all_right ? 0 : 1;
} catch (std::exception const& error) {
  std::cerr << "jrule_bench: " << error.what() << '\n';
  return 1;
}
