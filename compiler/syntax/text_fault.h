// Is it text? The lexer takes well-formed UTF-8 only.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace jrule::syntax {

struct TextFault {
  std::size_t offset = 0;
  bool is_control = false;  ///< a control character, as binary files have them; else a byte that breaks UTF-8
};

/// The first place that is not UTF-8 text. White space is no fault: tab, line feed, carriage return, form feed.
std::optional<TextFault> find_text_fault(std::string_view text);

}  // namespace jrule::syntax
