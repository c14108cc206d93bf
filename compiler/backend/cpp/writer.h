// Lines of C++ at their indent: generated code needs no formatter afterwards.
#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <utility>

namespace jrule::cpp {

class Writer {
 public:
  Writer() = default;
  /// Begins inside as many blocks.
  explicit Writer(std::size_t depth) : depth_(depth) {}
  std::size_t depth() const { return depth_; }
  void line() { text_ += '\n'; }
  template <class... Args>
  void line(fmt::format_string<Args...> format, Args&&... args) {
    text(fmt::format(format, std::forward<Args>(args)...));
  }
  /// A line as it is.
  void text(std::string_view line) {
    if (!line.empty()) text_.append(2 * depth_, ' ').append(line);
    text_ += '\n';
  }
  /// A line that the following ones stand inside.
  template <class... Args>
  void open(fmt::format_string<Args...> format, Args&&... args) {
    line(format, std::forward<Args>(args)...);
    ++depth_;
  }
  void close(std::string_view line = "}") {
    --depth_;
    text(line);
  }
  /// Closes and opens again in one line: "} else {".
  template <class... Args>
  void reopen(fmt::format_string<Args...> format, Args&&... args) {
    --depth_;
    open(format, std::forward<Args>(args)...);
  }
  /// Lines that are indented already.
  void lines(std::string_view text) { text_ += text; }
  std::string const& all() const { return text_; }

 private:
  std::string text_;
  std::size_t depth_ = 0;
};

}  // namespace jrule::cpp
