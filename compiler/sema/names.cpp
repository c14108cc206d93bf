#include "compiler/sema/names.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace jrule::sema {

namespace {

std::size_t edit_distance(std::string const& a, std::string const& b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      std::size_t const substituted = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, substituted});
    }
  }
  return row[b.size()];
}

}  // namespace

std::optional<std::string> nearest(std::string const& name, std::vector<std::string> const& candidates) {
  std::optional<std::string> best;
  std::size_t best_distance = 3;
  for (std::string const& candidate : candidates) {
    std::size_t const distance = edit_distance(name, candidate);
    if (distance < best_distance && distance < name.size()) {
      best = candidate;
      best_distance = distance;
    }
  }
  return best;
}

void report_not_found(source::Diagnostics& diagnostics, source::Code code, ast::Name const& name, std::string message,
                      std::vector<std::string> const& known) {
  source::Diagnostic d{.code = code, .span = name.span, .message = std::move(message)};
  if (auto const close = nearest(name.text, known)) {
    d.fixits.push_back({name.span, *close, fmt::format("did you mean `{}`", *close)});
  } else if (!known.empty() && known.size() <= 12) {
    d.notes.push_back(fmt::format("known here: `{}`", fmt::join(known, "`, `")));
  }
  diagnostics.add(std::move(d));
}

void report_unknown(source::Diagnostics& diagnostics, source::Code code, ast::Name const& name, std::string const& what,
                    std::vector<std::string> const& known) {
  report_not_found(diagnostics, code, name, fmt::format("unknown {} `{}`", what, name.text), known);
}

}  // namespace jrule::sema
