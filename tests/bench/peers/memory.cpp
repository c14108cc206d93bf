// What memory allows: the roofline of each row, and the first touch of pages, which costs more than the work itself
// where a result is large.
#include <benchmark/benchmark.h>
#include <sys/mman.h>

#include <algorithm>
#include <cstring>
#include <set>
#include <vector>

#include "jrule/column.h"
#include "tests/bench/peers/contest.h"

namespace jrule::bench {

void enter_copy(Contest& contest) {
  struct Buffers {
    std::vector<char> from;
    ColumnOf<char> to;
    std::size_t result;
  };
  // Copying n bytes reads n and writes n. A large result, if there is any, lies in pages that are new, for every contender: so do
  // its bytes here.
  auto const buffers = [](Row const& row) {
    return Buffers{std::vector<char>(row.bytes / 2, 'x'), row.large && row.result_bytes != 0 ? ColumnOf<char>() : ColumnOf<char>(row.bytes / 2, 'y'), row.result_bytes};
  };
  auto const copy = [](Buffers& b) -> Buffers& {
    if (b.to.empty()) b.to.resize(b.result);
    for (std::size_t begin = 0; begin < b.to.size(); begin += b.from.size()) {
      std::memcpy(b.to.data() + begin, b.from.data(), std::min(b.from.size(), b.to.size() - begin));
    }
    benchmark::DoNotOptimize(b.to.data());
    benchmark::ClobberMemory();
    return b;
  };
  auto const count = [](Buffers&, Row const& row) { return Counts{row.darts_per_gmap, row.cells}; };
  std::set<Work> works;
  for (Row const& row : contest.rows()) {
    if (works.insert(row.work).second) contest.enter(roofline, 4, row.work, buffers, copy, count);
  }
}

namespace {

// Of the arcs, handles and values of the quad subdivision of a torus of 112² or 1000² quads.
void first_touch(benchmark::State& state, int advice) {
  auto const n = static_cast<std::size_t>(state.range(0));
  std::size_t const bytes = n * n * (32 * 16 + 4 * 24);
  constexpr std::size_t huge = std::size_t{2} << 20U;
  std::size_t const mapped = (bytes / huge + 2) * huge;
  for (auto _ : state) {
    void* const place = mmap(nullptr, mapped, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (place == MAP_FAILED) return state.SkipWithError("no memory");
    if (madvise(place, mapped, advice) != 0) state.SkipWithError("the system has no pages of that size");
    std::memset(place, 1, bytes);
    benchmark::ClobberMemory();
    state.PauseTiming();
    munmap(place, mapped);
    state.ResumeTiming();
  }
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(bytes));
}
BENCHMARK_CAPTURE(first_touch, 4_KiB_pages, MADV_NOHUGEPAGE)
    ->Arg(112)
    ->Arg(1000)
    ->Unit(benchmark::kMillisecond)
    ->MinTime(0.05)
    ->Repetitions(3)
    ->ReportAggregatesOnly(true);
BENCHMARK_CAPTURE(first_touch, 2_MiB_pages, MADV_HUGEPAGE)
    ->Arg(112)
    ->Arg(1000)
    ->Unit(benchmark::kMillisecond)
    ->MinTime(0.05)
    ->Repetitions(3)
    ->ReportAggregatesOnly(true);

// The same bytes again, in pages that are there.
void second_touch(benchmark::State& state) {
  auto const n = static_cast<std::size_t>(state.range(0));
  std::vector<char> place(n * n * (32 * 16 + 4 * 24), 'x');
  for (auto _ : state) {
    std::memset(place.data(), 1, place.size());
    benchmark::ClobberMemory();
  }
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(place.size()));
}
BENCHMARK(second_touch)
    ->Arg(112)
    ->Arg(1000)
    ->Unit(benchmark::kMillisecond)
    ->MinTime(0.05)
    ->Repetitions(3)
    ->ReportAggregatesOnly(true);

}  // namespace

}  // namespace jrule::bench
