#include "compiler/source/place.h"

#include <algorithm>

namespace jrule::source {

File const* file_of(Sources const& sources, Span span) {
  bool const known = span.file >= 0 && static_cast<std::size_t>(span.file) < sources.size();
  return known ? &sources.file(span.file) : nullptr;
}

std::optional<Range> range_of(Sources const& sources, Span span) {
  auto const* file = file_of(sources, span);
  if (file == nullptr || file->text.empty()) return std::nullopt;
  return Range{sources.position(span.file, span.begin), sources.position(span.file, std::max(span.begin, span.end))};
}

std::string_view word(Severity severity) {
  switch (severity) {
    case Severity::error: return "error";
    case Severity::warning: return "warning";
    case Severity::note: return "note";
  }
  return "error";
}

}  // namespace jrule::source
