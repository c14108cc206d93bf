// How the characters of a source line look on a terminal: tabs expanded, and nothing that could move the cursor.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace jrule::source {

struct Glyph {
  std::size_t bytes = 0;  ///< how many bytes of the text it stands for, at least 1
  std::size_t width = 0;  ///< how many columns it takes
  std::string shown;      ///< one code point of width 1, or `width` ASCII characters
};

/// The character at a byte offset inside the line, shown from a 0-based column on. A tab ends at a multiple of 8;
/// control characters, invalid UTF-8 and marks that reorder text are spelled out: `<1B>`, `<U+202E>`.
Glyph glyph_at(std::string_view line, std::size_t offset, std::size_t column);

/// The 0-based column at which the character at that byte offset is shown; offsets past the end mean the end.
std::size_t display_column(std::string_view line, std::size_t offset);

/// The text in one line of glyphs, safe to print.
std::string printable(std::string_view text);

/// The columns [begin, end) of the line.
std::string shown_columns(std::string_view line, std::size_t begin, std::size_t end);

}  // namespace jrule::source
