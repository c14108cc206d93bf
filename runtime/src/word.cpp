#include "jrule/word.h"

namespace jrule {

namespace {

void append(std::string& text, Letter letter) {
  if (letter.conjugate) text += '~';
  text += std::to_string(letter.dimension);
}

}  // namespace

std::string to_string(Word const& word) {
  if (word.empty()) return "ε";
  std::string text;
  if (word.size() == 1) {
    append(text, word.front());
    return text;
  }
  for (Letter letter : word) {
    text += text.empty() ? '[' : ',';
    append(text, letter);
  }
  return text + ']';
}

std::string to_string(OrbitType const& orbit) {
  std::string text = "<";
  for (Word const& word : orbit.words) {
    if (text.size() > 1) text += ',';
    text += to_string(word);
  }
  return text + '>';
}

OrbitType orbit_of_dimensions(std::vector<int> const& dimensions) {
  OrbitType orbit;
  orbit.words.reserve(dimensions.size());
  for (int d : dimensions) orbit.words.push_back({Letter{static_cast<std::uint8_t>(d), false}});
  return orbit;
}

}  // namespace jrule
