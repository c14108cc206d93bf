#include "compiler/source/source.h"

#include <algorithm>

namespace jrule::source {

namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

bool starts_code_point(char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U; }

/// The smallest of the offset and the length of the text: places outside it are taken to be its end.
std::uint32_t clamped(std::string_view text, std::uint32_t offset) {
  return static_cast<std::uint32_t>(std::min<std::size_t>(text.size(), offset));
}

}  // namespace

Span join(Span a, Span b) { return {a.file, a.begin, b.end}; }

FileId Sources::add(std::string path, std::string text) {
  if (text.starts_with(byte_order_mark)) text.erase(0, byte_order_mark.size());
  std::vector<std::uint32_t> line_starts{0};
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\n') line_starts.push_back(static_cast<std::uint32_t>(i + 1));
  }
  files_.push_back({std::move(path), std::move(text), std::move(line_starts)});
  return static_cast<FileId>(files_.size() - 1);
}

std::string_view Sources::text(Span span) const {
  if (span.file == no_file) return {};
  std::string_view const all = file(span.file).text;
  auto const begin = clamped(all, span.begin);
  return all.substr(begin, std::max(begin, clamped(all, span.end)) - begin);
}

Position Sources::position(FileId id, std::uint32_t offset) const {
  File const& in = file(id);
  offset = clamped(in.text, offset);
  auto const next = std::upper_bound(in.line_starts.begin(), in.line_starts.end(), offset);
  auto const start = *std::prev(next);
  auto const before = std::string_view(in.text).substr(start, offset - start);
  return {static_cast<std::size_t>(next - in.line_starts.begin()),
          1 + static_cast<std::size_t>(std::count_if(before.begin(), before.end(), starts_code_point))};
}

std::string_view Sources::line(FileId id, std::size_t line) const {
  File const& in = file(id);
  if (line == 0 || line > in.line_starts.size()) return {};
  auto const start = in.line_starts[line - 1];
  auto const end = line < in.line_starts.size() ? in.line_starts[line] : in.text.size();
  auto found = std::string_view(in.text).substr(start, end - start);
  if (found.ends_with('\n')) {
    found.remove_suffix(1);
    if (found.ends_with('\r')) found.remove_suffix(1);
  }
  return found;
}

}  // namespace jrule::source
