#include "compiler/backend/draw/style.h"

namespace jrule::draw {

char const* color_of(int dimension) {
  static constexpr char const* colors[] = {"#212121", "#c62828", "#1565c0", "#2e7d32", "#ef6c00",
                                           "#6a1b9a", "#00838f", "#ad1457", "#5d4037", "#827717"};
  return colors[dimension];
}

std::string escape(std::string_view text) {
  std::string result;
  for (char const c : text) {
    if (c == '&') {
      result += "&amp;";
    } else if (c == '<') {
      result += "&lt;";
    } else if (c == '>') {
      result += "&gt;";
    } else if (c == '"') {
      result += "&quot;";
    } else if (static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t') {
      result += c == '\r' ? "" : "\xEF\xBF\xBD";
    } else {
      result += c;
    }
  }
  return result;
}

}  // namespace jrule::draw
