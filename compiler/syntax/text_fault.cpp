#include "compiler/syntax/text_fault.h"

namespace jrule::syntax {

namespace {

/// The length of the UTF-8 sequence at the begin of a text; 0 if it is none (Unicode 15, table 3-7).
std::size_t utf8_length(std::string_view text) {
  auto const byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U; };
  auto const continues = [&](std::size_t i) { return (byte(i) & 0xC0U) == 0x80U; };
  auto const first = byte(0);
  if (first < 0x80U) return 1;
  if (first < 0xC2U) return 0;
  if (first < 0xE0U) return continues(1) ? 2 : 0;
  if (first < 0xF0U) {
    bool const overlong = first == 0xE0U && byte(1) < 0xA0U;
    bool const surrogate = first == 0xEDU && byte(1) >= 0xA0U;
    return continues(1) && continues(2) && !overlong && !surrogate ? 3 : 0;
  }
  if (first > 0xF4U) return 0;
  bool const overlong = first == 0xF0U && byte(1) < 0x90U;
  bool const too_large = first == 0xF4U && byte(1) >= 0x90U;
  return continues(1) && continues(2) && continues(3) && !overlong && !too_large ? 4 : 0;
}

bool is_control(char c) {
  auto const byte = static_cast<unsigned char>(c);
  return (byte < 0x20U && c != '\t' && c != '\n' && c != '\r' && c != '\f') || byte == 0x7FU;
}

}  // namespace

std::optional<TextFault> find_text_fault(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    auto const length = utf8_length(text.substr(i));
    if (length == 0) return TextFault{i, false};
    if (is_control(text[i])) return TextFault{i, true};
    i += length;
  }
  return std::nullopt;
}

}  // namespace jrule::syntax
