#include "tests/bench/peers/contest.h"

#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <malloc.h>

#include <algorithm>

namespace jrule::bench {

std::size_t heap_bytes() {
  struct mallinfo2 const info = mallinfo2();
  return info.uordblks + info.hblkhd;
}

namespace {

/// What is wrong with a result; empty if nothing is.
std::string fault(Entry const& entry, Row const& row, Counts const& counts) {
  std::size_t const darts = row.darts_per_gmap * static_cast<std::size_t>(entry.darts_per_edge) / 4;
  if (counts.darts != darts) return fmt::format("the result has {} darts, not {}", counts.darts, darts);
  if (row.count_cells && !counts.cells) return "the cells of the result are not counted";
  if (!row.count_cells || *counts.cells == row.cells) return "";
  return fmt::format("the result has {} cells, not {}", fmt::join(*counts.cells, " "), fmt::join(row.cells, " "));
}

void run(benchmark::State& state, Entry& entry, Row const& row) {
  bool const counted = entry.seconds.empty();
  for (auto _ : state) {
    Sample const sample = entry.repeat(counted && entry.seconds.empty());
    if (counted && entry.seconds.empty()) {
      std::string const wrong = fault(entry, row, sample.counts);
      if (!wrong.empty()) return state.SkipWithError((entry.contender + ": " + wrong).c_str());
      entry.bytes_per_dart = static_cast<double>(sample.heap_bytes) / static_cast<double>(sample.counts.darts);
    }
    entry.seconds.push_back(sample.seconds);
    state.SetIterationTime(sample.seconds);
  }
  state.counters["bytes_per_dart"] = entry.bytes_per_dart;
  state.counters["roofline_bytes"] = static_cast<double>(row.bytes);
}

}  // namespace

void Contest::add(std::string const& contender, int darts_per_edge, std::size_t row,
                  std::function<Sample(bool)> repeat) {
  if (std::find(contenders_.begin(), contenders_.end(), contender) == contenders_.end()) contenders_.push_back(contender);
  auto entry = std::make_unique<Entry>(Entry{contender, row, darts_per_edge, std::move(repeat)});
  auto const behind = std::upper_bound(entries_.begin(), entries_.end(), row,
                                       [](std::size_t r, auto const& other) { return r < other->row; });
  entries_.insert(behind, std::move(entry));
}

void Contest::register_benchmarks() {
  for (auto const& entry : entries_) {
    Row const& row = rows_[entry->row];
    std::string const name = fmt::format("{}/{}/{}", row.label, row.mesh, entry->contender);
    auto* const registered =
        benchmark::RegisterBenchmark(name.c_str(), [&entry = *entry, &row](benchmark::State& s) { run(s, entry, row); });
    // Short works are repeated until their median is steady; a long one is measured three times.
    registered->UseManualTime()->Unit(benchmark::kMillisecond)->MinTime(row.large ? 0.01 : 0.1)->Repetitions(row.large ? 3 : 1);
  }
}

}  // namespace jrule::bench
