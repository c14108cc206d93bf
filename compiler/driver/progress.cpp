#include "compiler/driver/progress.h"

#include <unistd.h>

#include <cstdio>
#include <utility>

namespace jrule::driver {

namespace {

constexpr auto patience = std::chrono::milliseconds(700), interval = std::chrono::milliseconds(100);
constexpr char const* clear_line = "\r\x1b[K";

}  // namespace

ProgressLine::ProgressLine(std::string name)
    : name_(std::move(name)), terminal_(isatty(STDERR_FILENO) != 0), begin_(Clock::now()), next_(begin_ + patience) {}

ProgressLine::~ProgressLine() {
  if (shown_) std::fputs(clear_line, stderr);
}

void ProgressLine::show(std::size_t applications) {
  if (!terminal_) return;
  Clock::time_point const now = Clock::now();
  if (now < next_) return;
  next_ = now + interval;
  shown_ = true;
  double const seconds = std::chrono::duration<double>(now - begin_).count();
  std::fprintf(stderr, "%s%s: %zu rules applied, %.1f s", clear_line, name_.c_str(), applications, seconds);
  std::fflush(stderr);
}

}  // namespace jrule::driver
