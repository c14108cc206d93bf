// Lines of C++ at their indent: generated code needs no formatter afterwards.
#pragma once

#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

namespace jrule::cpp {

class Writer {
 public:
  void line() { text_ += '\n'; }
  void line(std::string_view text) {
    if (!text.empty()) text_.append(2 * depth_, ' ').append(text);
    text_ += '\n';
  }
  template <class First, class... Rest>
  void line(fmt::format_string<First, Rest...> format, First&& first, Rest&&... rest) {
    line(std::string_view(fmt::format(format, std::forward<First>(first), std::forward<Rest>(rest)...)));
  }
  /// A line that the following ones stand inside.
  template <class... Args>
  void open(fmt::format_string<Args...> format, Args&&... args) {
    line(std::string_view(fmt::format(format, std::forward<Args>(args)...)));
    ++depth_;
  }
  void close(std::string_view text = "}") {
    --depth_;
    line(text);
  }
  std::string const& text() const { return text_; }

 private:
  std::string text_;
  std::size_t depth_ = 0;
};

}  // namespace jrule::cpp
