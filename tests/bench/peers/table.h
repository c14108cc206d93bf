// The table of the contest, written row by row as the rows are measured; other benchmarks as Google Benchmark writes
// them.
#pragma once

#include <benchmark/benchmark.h>

#include <vector>

#include "tests/bench/peers/contest.h"

namespace jrule::bench {

class TableReporter : public benchmark::ConsoleReporter {
 public:
  explicit TableReporter(Contest const& contest) : ConsoleReporter(OO_None), contest_(contest) {}

  void ReportRuns(std::vector<Run> const& runs) override;
  void Finalize() override;

 private:
  void write_row(std::size_t row);
  void write_memory();

  Contest const& contest_;
  std::size_t next_ = 0;  ///< the entry that is measured next, or a later one if words of the command line leave it out
  bool has_header_ = false;
};

}  // namespace jrule::bench
