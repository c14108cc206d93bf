#include "compiler/source/glyph.h"

#include <fmt/format.h>

#include <cstdint>

namespace jrule::source {

namespace {

constexpr std::size_t tab_width = 8;

struct CodePoint {
  std::uint32_t value = 0;
  std::size_t bytes = 0;  ///< 0: not valid UTF-8
};

CodePoint decode(std::string_view text) {
  auto const byte = [text](std::size_t i) { return std::uint32_t{static_cast<unsigned char>(text[i])}; };
  auto const lead = byte(0);
  if (lead < 0x80) return {lead, 1};
  std::size_t const length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  if (lead < 0xC2 || lead > 0xF4 || text.size() < length) return {};
  std::uint32_t value = lead & (0x7FU >> length);
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0U) != 0x80U) return {};
    value = (value << 6U) | (byte(i) & 0x3FU);
  }
  bool const overlong = (length == 3 && value < 0x800) || (length == 4 && value < 0x10000);
  bool const surrogate = value >= 0xD800 && value <= 0xDFFF;
  return overlong || surrogate || value > 0x10FFFF ? CodePoint{} : CodePoint{value, length};
}

bool is_control(std::uint32_t c) { return c < 0x20 || (c >= 0x7F && c < 0xA0); }

/// Marks without a shape of their own, among them those that make text read in another order than it is written.
bool is_invisible(std::uint32_t c) {
  return (c >= 0x200B && c <= 0x200F) || (c >= 0x2028 && c <= 0x202E) || (c >= 0x2060 && c <= 0x206F) || c == 0xFEFF;
}

Glyph spelled_out(std::size_t bytes, std::string ascii) {
  auto const width = ascii.size();
  return {bytes, width, std::move(ascii)};
}

}  // namespace

Glyph glyph_at(std::string_view line, std::size_t offset, std::size_t column) {
  auto const point = decode(line.substr(offset));
  if (point.bytes == 0) return spelled_out(1, fmt::format("<{:02X}>", static_cast<unsigned char>(line[offset])));
  if (point.value == '\t') return spelled_out(1, std::string(tab_width - column % tab_width, ' '));
  if (is_control(point.value)) return spelled_out(point.bytes, fmt::format("<{:02X}>", point.value));
  if (is_invisible(point.value)) return spelled_out(point.bytes, fmt::format("<U+{:04X}>", point.value));
  return {point.bytes, 1, std::string(line.substr(offset, point.bytes))};
}

std::size_t display_column(std::string_view line, std::size_t offset) {
  std::size_t column = 0;
  for (std::size_t at = 0; at < line.size();) {
    auto const glyph = glyph_at(line, at, column);
    if (at + glyph.bytes > offset) break;
    at += glyph.bytes;
    column += glyph.width;
  }
  return column;
}

std::string shown_columns(std::string_view line, std::size_t begin, std::size_t end) {
  std::string result;
  std::size_t column = 0;
  for (std::size_t at = 0; at < line.size() && column < end;) {
    auto const glyph = glyph_at(line, at, column);
    for (std::size_t i = 0; i < glyph.width; ++i) {
      if (column + i < begin || column + i >= end) continue;
      result += glyph.width == 1 ? glyph.shown : glyph.shown.substr(i, 1);
    }
    at += glyph.bytes;
    column += glyph.width;
  }
  return result;
}

std::string printable(std::string_view text) {
  std::string result;
  std::size_t column = 0;
  for (std::size_t at = 0; at < text.size();) {
    auto const glyph = glyph_at(text, at, column);
    result += glyph.shown;
    at += glyph.bytes;
    column += glyph.width;
  }
  return result;
}

}  // namespace jrule::source
