// The text of source files and positions in it.
#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

namespace jrule::source {

using FileId = std::int32_t;
inline constexpr FileId no_file = -1;

/// A half-open range of bytes in one file. An empty range marks a place between characters.
struct Span {
  FileId file = no_file;
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
  auto operator<=>(Span const&) const = default;
};

/// From the begin of `a` to the end of `b`, both in the same file.
Span join(Span a, Span b);

/// 1-based line; 1-based column in code points.
struct Position {
  std::size_t line = 1;
  std::size_t column = 1;
};

struct File {
  std::string path;  ///< as the user gave it
  std::string text;  ///< UTF-8 without byte-order mark, line ends as in the file
  std::vector<std::uint32_t> line_starts;
};

/// The files of one compilation. A File's address stays valid as more are added.
class Sources {
 public:
  /// Leaves a byte-order mark out of the text.
  FileId add(std::string path, std::string text);
  File const& file(FileId id) const { return files_[static_cast<std::size_t>(id)]; }
  std::size_t size() const { return files_.size(); }
  std::string_view text(Span span) const;
  Position position(FileId file, std::uint32_t offset) const;
  /// The line (1-based) without its end-of-line characters.
  std::string_view line(FileId file, std::size_t line) const;

 private:
  std::deque<File> files_;
};

}  // namespace jrule::source
