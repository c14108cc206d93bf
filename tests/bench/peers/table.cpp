#include "tests/bench/peers/table.h"

#include <fmt/format.h>

#include <algorithm>

namespace jrule::bench {

namespace {

double median(std::vector<double> seconds) {
  auto const middle = seconds.begin() + static_cast<std::ptrdiff_t>(seconds.size() / 2);
  std::nth_element(seconds.begin(), middle, seconds.end());
  return *middle;
}

/// Three digits.
std::string milliseconds(double seconds) {
  double const ms = 1000 * seconds;
  return fmt::format("{:.{}f}", ms, ms >= 100 ? 0 : ms >= 10 ? 1 : ms >= 1 ? 2 : 3);
}

std::string ratio(double r) { return fmt::format("{:.{}f}×", r, r >= 10 ? 0 : r >= 1 ? 1 : 2); }

// {:<} of fmt counts bytes of some characters that take one column.
std::string padded(std::string const& text, std::size_t width, bool left = false) {
  auto const columns = static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
  std::string const space(width > columns ? width - columns : 0, ' ');
  return left ? text + space : space + text;
}

constexpr std::size_t label_width = 36, time_width = 9, ratio_width = 7;

}  // namespace

void TableReporter::ReportRuns(std::vector<Run> const& runs) {
  auto const entry = std::find_if(contest_.entries().begin(), contest_.entries().end(), [&](auto const& e) {
    Row const& row = contest_.rows()[e->row];
    return runs.front().run_name.function_name == fmt::format("{}/{}/{}", row.label, row.mesh, e->contender);
  });
  if (entry == contest_.entries().end()) return ConsoleReporter::ReportRuns(runs);
  for (Run const& run : runs) {
    if (run.error_occurred) faults_.push_back(run.benchmark_name() + ": " + run.error_message);
  }
  auto const index = static_cast<std::size_t>(entry - contest_.entries().begin());
  std::size_t const last = next_ == 0 ? (*entry)->row : contest_.entries()[next_ - 1]->row;
  if (next_ != 0 && last != (*entry)->row) write_row(last);
  next_ = index + 1;
}

void TableReporter::Finalize() {
  if (next_ != 0) write_row(contest_.entries()[next_ - 1]->row);
  for (std::string const& fault : faults_) GetErrorStream() << fault << '\n';
  ConsoleReporter::Finalize();
}

void TableReporter::write_row(std::size_t row) {
  std::ostream& out = GetOutputStream();
  if (!has_header_) {
    has_header_ = true;
    out << "\nMedian times in ms, and beside them the multiple of the column " << ours
        << " (generated code); beside the roofline, the multiple of it that " << ours << " takes.\n"
        << "x: the result is wrong. ·: not measured.\n\n"
        << padded("", label_width, true);
    for (std::string const& contender : contest_.contenders()) out << padded(contender, time_width + ratio_width);
    out << '\n';
  }
  auto const find = [&](std::string const& contender) -> Entry const* {
    for (auto const& entry : contest_.entries()) {
      if (entry->row == row && entry->contender == contender && !entry->seconds.empty()) return entry.get();
    }
    return nullptr;
  };
  Entry const* const own = find(ours);
  Row const& r = contest_.rows()[row];
  out << padded(r.label + ", " + r.mesh, label_width, true);
  for (std::string const& contender : contest_.contenders()) {
    Entry const* const entry = find(contender);
    if (entry == nullptr) {
      out << padded("·", time_width) << padded("", ratio_width);
      continue;
    }
    double const time = median(entry->seconds);
    std::string beside;
    if (own != nullptr && own != entry) {
      double const mine = median(own->seconds);
      beside = contender == roofline ? ratio(mine / time) : ratio(time / mine);
    }
    out << padded(milliseconds(time), time_width) << padded(beside, ratio_width);
  }
  out << '\n' << std::flush;
}

}  // namespace jrule::bench
