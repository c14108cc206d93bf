// OFF, as text: `OFF`, the numbers of vertices, faces and edges, a line for each vertex, a line for each face. Colours
// after a face are ignored. Variants with more numbers for a vertex (COFF, NOFF, STOFF, 4OFF, …) and binary OFF are
// refused.
#include <fmt/format.h>

#include "formats.h"
#include "text.h"

namespace jrule::io {
namespace {

/// The words of the next line that has any, without its comment; false at the end of the file.
bool next_words(Lines& lines, std::vector<std::string_view>& words) {
  while (auto line = lines.next()) {
    split(line->substr(0, line->find('#')), words);
    if (!words.empty()) return true;
  }
  return false;
}

}  // namespace

Result<Surface> parse_off(std::string_view text, std::string const& file) {
  Lines lines(text);
  std::vector<std::string_view> words;
  auto const error = [&](std::string message) { return bad_input(std::move(message), file, lines.number()); };

  // The counts may stand on the line of the keyword.
  if (!next_words(lines, words)) return error("the file is empty");
  if (words[0] != "OFF") return error(fmt::format("expected 'OFF', found {}; only plain OFF is read", quote(words[0])));
  words.erase(words.begin());
  if (words.empty() && !next_words(lines, words)) {
    return error("the file ends before the numbers of vertices and faces");
  }
  if (words.size() < 2 || words.size() > 3) return error("expected the numbers of vertices, faces and edges");
  std::int64_t counts[3] = {};
  for (std::size_t i = 0; i < words.size(); ++i) {
    auto const count = parse_integer(words[i]);
    if (!count || *count < 0) return error(quote(words[i]) + " is not a count");
    counts[i] = *count;
  }

  Surface surface;
  surface.first_index = 0;
  for (std::int64_t i = 0; i < counts[0]; ++i) {
    if (!next_words(lines, words)) return error(fmt::format("the file ends after {} of {} vertices", i, counts[0]));
    if (words.size() != 3) return error(fmt::format("a vertex needs 3 numbers, found {}", words.size()));
    double xyz[3] = {};
    for (std::size_t k = 0; k < 3; ++k) {
      auto const value = parse_real(words[k]);
      if (!value) return error(quote(words[k]) + " is not a finite number");
      xyz[k] = *value;
    }
    surface.points.push_back({xyz[0], xyz[1], xyz[2]});
  }
  for (std::int64_t i = 0; i < counts[1]; ++i) {
    if (!next_words(lines, words)) return error(fmt::format("the file ends after {} of {} faces", i, counts[1]));
    auto const size = parse_integer(words[0]);
    if (!size || *size < 0) return error(quote(words[0]) + " is not a number of corners");
    if (*size > static_cast<std::int64_t>(words.size()) - 1) {
      return error(fmt::format("a face of {} corners has {} on its line", *size, words.size() - 1));
    }
    for (std::size_t k = 1; k <= static_cast<std::size_t>(*size); ++k) {
      auto const vertex = parse_integer(words[k]);
      if (!vertex) return error(quote(words[k]) + " is not an integer");
      auto const corner = to_corner(*vertex);
      if (!corner) return error(fmt::format("there is no vertex {}", *vertex));
      surface.corners.push_back(*corner);
    }
    surface.end_face(lines.number());
  }
  if (next_words(lines, words)) return error("more lines than the counts at the top promise");
  surface.end = lines.number();
  return surface;
}

Result<std::string> print_off(Surface const& surface) {
  fmt::memory_buffer out;
  fmt::format_to(fmt::appender(out), "OFF\n{} {} 0\n", surface.points.size(), surface.face_count());
  for (Point3 const& p : surface.points) fmt::format_to(fmt::appender(out), "{} {} {}\n", p.x, p.y, p.z);
  for (std::size_t f = 0; f < surface.face_count(); ++f) {
    fmt::format_to(fmt::appender(out), "{}", surface.face(f).size());
    for (std::uint32_t corner : surface.face(f)) fmt::format_to(fmt::appender(out), " {}", corner);
    out.push_back('\n');
  }
  return fmt::to_string(out);
}

}  // namespace jrule::io
