#include "tests/bench/peers/table.h"

#include <fmt/format.h>

#include <algorithm>

namespace jrule::bench {

namespace {

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
    return runs.front().run_name.function_name == benchmark_name(*e, contest_.rows()[e->row]);
  });
  if (entry == contest_.entries().end()) return ConsoleReporter::ReportRuns(runs);
  auto const index = static_cast<std::size_t>(entry - contest_.entries().begin());
  std::size_t const last = next_ == 0 ? (*entry)->row : contest_.entries()[next_ - 1]->row;
  if (next_ != 0 && last != (*entry)->row) write_row(last);
  next_ = index + 1;
}

void TableReporter::Finalize() {
  if (next_ != 0) write_row(contest_.entries()[next_ - 1]->row);
  for (auto const& entry : contest_.entries()) {
    if (!entry->fault.empty())
      GetErrorStream() << benchmark_name(*entry, contest_.rows()[entry->row]) << ": " << entry->fault << '\n';
  }
  write_memory();
  ConsoleReporter::Finalize();
}

void TableReporter::write_row(std::size_t row) {
  std::ostream& out = GetOutputStream();
  if (!has_header_) {
    has_header_ = true;
    out << "\nMedian times in ms, and beside them the multiple of the column " << ours
        << " (generated code); beside the roofline, the multiple of it that " << ours << " takes.\n"
        << "': measured once. ·: not measured. wrong: the result is not what it should be.\n\n"
        << padded("", label_width, true);
    for (std::string const& contender : contest_.contenders()) out << padded(contender, time_width + ratio_width);
    out << '\n';
  }
  Entry const* own = contest_.find(row, ours);
  if (own != nullptr && own->seconds.empty()) own = nullptr;
  Row const& r = contest_.rows()[row];
  out << padded(r.label + ", " + r.mesh, label_width, true);
  for (std::string const& contender : contest_.contenders()) {
    Entry const* const entry = contest_.find(row, contender);
    if (entry == nullptr || entry->seconds.empty()) {
      bool const is_wrong = entry != nullptr && !entry->fault.empty();
      out << padded(is_wrong ? "wrong" : "·", time_width) << padded("", ratio_width);
      continue;
    }
    double const time = median(entry->seconds);
    std::string beside;
    if (own != nullptr && own != entry) {
      double const mine = median(own->seconds);
      beside = contender == roofline ? ratio(mine / time) : ratio(time / mine);
    }
    out << padded(milliseconds(time) + (entry->seconds.size() == 1 ? "'" : ""), time_width)
        << padded(beside, ratio_width);
  }
  out << '\n' << std::flush;
}

/// What the largest subdivided mesh takes that was measured.
void TableReporter::write_memory() {
  auto const of_row = [&](std::size_t row, std::string const& contender) {
    Entry const* const entry = contest_.find(row, contender);
    return entry != nullptr && entry->bytes_per_dart > 0 ? entry : nullptr;
  };
  for (std::size_t row = contest_.rows().size(); row-- > 0;) {
    Row const& r = contest_.rows()[row];
    if (r.work != Work::quad_positions || of_row(row, ours) == nullptr) continue;
    std::ostream& out = GetOutputStream();
    out << "\nBytes on the heap of the result of " << r.label << ", " << r.mesh
        << ", of an edge and (of a dart or halfedge):\n"
        << padded("", label_width, true);
    for (std::string const& contender : contest_.contenders()) {
      Entry const* const entry = contender == roofline ? nullptr : of_row(row, contender);
      double const dart = entry == nullptr ? 0 : entry->bytes_per_dart;
      out << padded(entry == nullptr ? "·" : fmt::format("{:.0f}", dart * entry->darts_per_edge), time_width)
          << padded(entry == nullptr ? "" : fmt::format("({:.0f})", dart), ratio_width);
    }
    out << '\n';
    return;
  }
}

}  // namespace jrule::bench
