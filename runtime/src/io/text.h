// Reading text as lines, words and numbers, the same in every locale.
#pragma once

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "jrule/result.h"

namespace jrule::io {

/// The lines of a text, counted from 1; a line's end (LF or CR LF) is no part of it.
class Lines {
 public:
  explicit Lines(std::string_view text) : rest_(text) {}

  /// The next line; none at the end of the text.
  std::optional<std::string_view> next() {
    if (rest_.empty()) return std::nullopt;
    std::size_t const end = std::min(rest_.find('\n'), rest_.size());
    std::string_view line = rest_.substr(0, end);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    ++number_;
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    return line;
  }
  /// The number of the line that next() gave last; 1 before that, so that every message has a line.
  std::size_t number() const noexcept { return std::max<std::size_t>(number_, 1); }
  /// What is still to be read.
  std::string_view rest() const noexcept { return rest_; }

 private:
  std::string_view rest_;
  std::size_t number_ = 0;
};

/// The words of a line: what blanks separate. `words` is the caller's, so that its memory serves line after line.
inline void split(std::string_view line, std::vector<std::string_view>& words) {
  constexpr std::string_view blanks = " \t\v\f\r";
  words.clear();
  for (std::size_t begin = line.find_first_not_of(blanks); begin != std::string_view::npos;) {
    std::size_t const end = std::min(line.find_first_of(blanks, begin), line.size());
    words.push_back(line.substr(begin, end - begin));
    begin = line.find_first_not_of(blanks, end);
  }
}

/// The whole word as a number of type T; a leading + is allowed. None if it is none, or beyond the range of T.
template <class T>
std::optional<T> parse_number(std::string_view word) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  T value{};
  auto const [end, code] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (code != std::errc{} || end != word.data() + word.size()) return std::nullopt;
  return value;
}

inline std::optional<std::int64_t> parse_integer(std::string_view word) { return parse_number<std::int64_t>(word); }

/// A finite real number; none for anything else.
inline std::optional<double> parse_real(std::string_view word) {
  std::optional<double> const value = parse_number<double>(word);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

/// A word of the file as a message shows it: short, and with nothing in it that a terminal would obey.
inline std::string quote(std::string_view word) {
  constexpr std::size_t longest = 40;
  std::string text = "'";
  for (char c : word.substr(0, longest)) text += c >= ' ' && c <= '~' ? c : '?';
  return text + (word.size() > longest ? "…'" : "'");
}

inline tl::unexpected<Error> bad_input(std::string message, std::string const& file, std::size_t line) {
  return fail(Error::Kind::bad_input, std::move(message), file, line);
}

}  // namespace jrule::io
