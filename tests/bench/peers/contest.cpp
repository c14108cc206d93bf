#include "tests/bench/peers/contest.h"

#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <malloc.h>

#include <algorithm>
#include <fstream>
#include <sstream>

namespace jrule::bench {

namespace {

/// Memory that was asked of the system itself, by malloc too: what may be written, and is no file, heap or stack.
std::size_t mapped_bytes() {
  std::ifstream maps("/proc/self/maps");
  std::size_t bytes = 0;
  for (std::string line; std::getline(maps, line);) {
    // 7f5e3c000000-7f5e3c021000 rw-p 00000000 00:00 0    [name]
    std::istringstream words(line);
    std::size_t begin = 0, end = 0;
    char dash = 0;
    std::string access, offset, device, file, name;
    words >> std::hex >> begin >> dash >> end >> access >> offset >> device >> file >> name;
    if (access == "rw-p" && file == "0" && name.empty()) bytes += end - begin;
  }
  return bytes;
}

}  // namespace

std::size_t heap_bytes() { return mallinfo2().uordblks + mapped_bytes(); }

double median(std::vector<double> seconds) {
  auto const middle = seconds.begin() + static_cast<std::ptrdiff_t>(seconds.size() / 2);
  std::nth_element(seconds.begin(), middle, seconds.end());
  return *middle;
}

std::string benchmark_name(Entry const& entry, Row const& row) {
  return fmt::format("{}/{}/{}", row.label, row.mesh, entry.contender);
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

// A cell of the table takes this many seconds, with the making of inputs, if its first repetitions do not take longer. Large results take
// pages that are new each time; the first ones may be slow, where a virtual machine hands out memory that nobody has had before, and
// another time for its second processor: they must not be the median.
constexpr double short_enough = 0.2, short_enough_if_large = 1.5, long_enough = 4;
constexpr std::size_t few = 5, many = 200;

/// Repeats until the median is steady, or it takes too long.
void run(benchmark::State& state, Entry& entry, Row const& row) {
  for (auto _ : state) {
    auto const start = std::chrono::steady_clock::now();
    std::vector<double> seconds;
    for (double spent = 0; spent < (row.large ? short_enough_if_large : short_enough) || (seconds.size() < few && spent < long_enough);) {
      bool const is_first = entry.seconds.empty() && seconds.empty();
      Sample const sample = entry.repeat(is_first);
      if (is_first) {
        entry.fault = fault(entry, row, sample.counts);
        if (!entry.fault.empty()) return state.SkipWithError(entry.fault.c_str());
        entry.bytes_per_dart = static_cast<double>(sample.heap_bytes) / static_cast<double>(sample.counts.darts);
      }
      seconds.push_back(sample.seconds);
      if (seconds.size() == many) break;
      spent = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    }
    state.SetIterationTime(median(seconds));
    entry.seconds.insert(entry.seconds.end(), seconds.begin(), seconds.end());
  }
  state.counters["bytes_per_dart"] = entry.bytes_per_dart;
  state.counters["roofline_bytes"] = static_cast<double>(row.bytes);
}

}  // namespace

void Contest::add(std::string const& contender, int darts_per_edge, std::size_t row,
                  std::function<Sample(bool)> repeat) {
  if (std::find(contenders_.begin(), contenders_.end(), contender) == contenders_.end())
    contenders_.push_back(contender);
  auto entry = std::make_unique<Entry>(Entry{contender, row, darts_per_edge, std::move(repeat)});
  auto const behind = std::upper_bound(entries_.begin(), entries_.end(), row,
                                       [](std::size_t r, auto const& other) { return r < other->row; });
  entries_.insert(behind, std::move(entry));
}

Entry const* Contest::find(std::size_t row, std::string const& contender) const {
  for (auto const& entry : entries_) {
    if (entry->row == row && entry->contender == contender) return entry.get();
  }
  return nullptr;
}

void Contest::register_benchmarks() {
  for (auto const& entry : entries_) {
    Row const& row = rows_[entry->row];
    auto const run_entry = [&entry = *entry, &row](benchmark::State& s) { run(s, entry, row); };
    benchmark::RegisterBenchmark(benchmark_name(*entry, row).c_str(), run_entry)
        ->UseManualTime()
        ->Iterations(1)
        ->Unit(benchmark::kMillisecond);
  }
}

}  // namespace jrule::bench
