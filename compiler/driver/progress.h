// How far a long run has come, on a terminal.
#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace jrule::driver {

/// One line on standard error that is written over as the run goes on, and taken away at its end. Nothing is written where standard
/// error is no terminal, and nothing by runs that are over before anyone would ask.
class ProgressLine {
 public:
  explicit ProgressLine(std::string name);
  ~ProgressLine();
  ProgressLine(ProgressLine const&) = delete;
  ProgressLine& operator=(ProgressLine const&) = delete;

  void show(std::size_t applications);

 private:
  using Clock = std::chrono::steady_clock;
  std::string name_;
  bool terminal_;
  bool shown_ = false;
  Clock::time_point begin_, next_;
};

}  // namespace jrule::driver
