// Where a span is, for people and for programs; both renderers ask here so that they agree.
#pragma once

#include <optional>
#include <string_view>

#include "compiler/source/diagnostic.h"

namespace jrule::source {

/// The file of a span, nullptr if it has none.
File const* file_of(Sources const& sources, Span span);

struct Range {
  Position begin;
  Position end;  ///< just after the last character
};
/// Nothing for a span without a file, or in a file without text: one that could not be read has no lines to point at.
std::optional<Range> range_of(Sources const& sources, Span span);

/// "error", "warning" or "note".
std::string_view word(Severity severity);

}  // namespace jrule::source
