// Wavefront OBJ: `v` and `f` statements. All others (vt, vn, o, g, s, usemtl, l, …) say nothing about the surface.
#include <fmt/format.h>

#include "formats.h"
#include "text.h"

namespace jrule::io {
namespace {

/// Joins lines that end in a backslash with those that follow. A comment is one line, whatever it ends in.
std::string_view join_continued(std::string_view line, Lines& lines, std::string& joined) {
  auto const continued = [](std::string_view s) { return !s.empty() && s.back() == '\\'; };
  std::size_t const start = line.find_first_not_of(" \t");
  if (!continued(line) || line[start] == '#') return line;
  joined.assign(line.substr(0, line.size() - 1));
  while (auto next = lines.next()) {
    bool const more = continued(*next);
    joined += ' ';
    joined += next->substr(0, next->size() - (more ? 1 : 0));
    if (!more) break;
  }
  return joined;
}

/// The vertex of a corner a, a/b, a//c or a/b/c; none if it is not so written. The texture and normal indices are not
/// used, but they must be integers.
std::optional<std::int64_t> corner_vertex(std::string_view word) {
  std::size_t const slash = std::min(word.find('/'), word.size());
  for (std::size_t at = slash, parts = 1; at < word.size(); ++parts) {
    std::size_t const next = std::min(word.find('/', at + 1), word.size());
    std::string_view const part = word.substr(at + 1, next - at - 1);
    if (parts > 2 || (!part.empty() && !parse_integer(part))) return std::nullopt;
    at = next;
  }
  return parse_integer(word.substr(0, slash));
}

}  // namespace

Result<Surface> parse_obj(std::string_view text, std::string const& file) {
  Surface surface;
  surface.first_index = 1;
  Lines lines(text);
  std::string joined;
  std::vector<std::string_view> words;
  while (auto line = lines.next()) {
    std::size_t const number = lines.number();
    std::string_view const statement = join_continued(*line, lines, joined);
    split(statement.substr(0, statement.find('#')), words);
    if (words.empty()) continue;

    if (words[0] == "v") {
      if (words.size() < 4) {
        return bad_input(fmt::format("a vertex needs 3 numbers, found {}", words.size() - 1), file, number);
      }
      double xyz[3] = {};
      for (std::size_t i = 1; i < words.size(); ++i) {  // the fourth and further ones: a weight or a colour
        auto const value = parse_real(words[i]);
        if (!value) return bad_input(quote(words[i]) + " is not a finite number", file, number);
        if (i <= 3) xyz[i - 1] = *value;
      }
      surface.points.push_back({xyz[0], xyz[1], xyz[2]});
    } else if (words[0] == "f") {
      for (std::size_t i = 1; i < words.size(); ++i) {
        auto const vertex = corner_vertex(words[i]);
        if (!vertex) return bad_input(quote(words[i]) + " is not a corner of a face", file, number);
        // Negative ones count back from the vertex read last.
        std::int64_t const seen = static_cast<std::int64_t>(surface.points.size());
        auto const corner =
            *vertex == 0 || *vertex < -seen ? std::nullopt : to_corner(*vertex > 0 ? *vertex - 1 : seen + *vertex);
        if (!corner) return bad_input(fmt::format("there is no vertex {}", *vertex), file, number);
        surface.corners.push_back(*corner);
      }
      surface.end_face(number);
    }
  }
  surface.end = lines.number();
  return surface;
}

Result<std::string> print_obj(Surface const& surface) {
  fmt::memory_buffer out;
  for (Point3 const& p : surface.points) fmt::format_to(fmt::appender(out), "v {} {} {}\n", p.x, p.y, p.z);
  for (std::size_t f = 0; f < surface.face_count(); ++f) {
    out.push_back('f');
    for (std::uint32_t corner : surface.face(f)) fmt::format_to(fmt::appender(out), " {}", std::size_t{corner} + 1);
    out.push_back('\n');
  }
  return fmt::to_string(out);
}

}  // namespace jrule::io
