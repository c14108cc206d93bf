// How libFuzzer changes texts: whole words and signs of them, mostly, because changed bytes rarely parse.
#include <algorithm>
#include <cctype>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <random>
#include <string>
#include <string_view>
#include <vector>

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);

namespace {

using Tokens = std::vector<std::string_view>;

/// Words, runs of blanks, and single signs, in order: together they are the text.
Tokens split(std::string_view text) {
  auto const kind = [](char c) {
    auto const byte = static_cast<unsigned char>(c);
    return std::isalnum(byte) != 0 || c == '_' ? 1 : std::isspace(byte) != 0 ? 2 : 0;
  };
  Tokens tokens;
  while (!text.empty()) {
    std::size_t length = 1;
    while (kind(text[0]) != 0 && length < text.size() && kind(text[length]) == kind(text[0])) ++length;
    tokens.push_back(text.substr(0, length));
    text.remove_prefix(length);
  }
  return tokens;
}

std::string_view text_of(std::uint8_t const* data, std::size_t size) { return {reinterpret_cast<char const*>(data), size}; }

std::size_t below(std::size_t limit, std::minstd_rand& random) { return std::uniform_int_distribution<std::size_t>(0, limit - 1)(random); }

/// A few tokens of these, more often few than many.
std::string piece(Tokens const& tokens, std::minstd_rand& random) {
  std::size_t const begin = below(tokens.size(), random);
  std::size_t const length = std::min(tokens.size() - begin, below(2, random) == 0 ? std::size_t{1} : 1 + below(40, random));
  std::string text;
  for (std::size_t i = begin; i < begin + length; ++i) text += tokens[i];
  return text;
}

/// `text` with a piece of it replaced by one of `other`, moved there, or left out.
std::string change(std::string_view text, std::string_view other, std::minstd_rand& random) {
  Tokens const tokens = split(text), others = split(other);
  std::size_t const begin = below(tokens.size() + 1, random);
  std::size_t const gone = std::min(tokens.size() - begin, below(3, random) == 0 ? 1 + below(40, random) : below(2, random));
  std::string changed;
  for (std::size_t i = 0; i < begin; ++i) changed += tokens[i];
  if (!others.empty() && below(4, random) != 0) changed += piece(others, random);
  for (std::size_t i = begin + gone; i < tokens.size(); ++i) changed += tokens[i];
  return changed;
}

std::size_t put(std::string const& text, std::uint8_t* data, std::size_t max_size) {
  std::size_t const size = std::min(text.size(), max_size);
  std::memcpy(data, text.data(), size);
  return size;
}

}  // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size, unsigned seed) {
  std::minstd_rand random(seed);
  if (size == 0 || below(4, random) == 0) return LLVMFuzzerMutate(data, size, max_size);
  std::string_view const text = text_of(data, size);
  return put(change(text, text, random), data, max_size);
}

extern "C" std::size_t LLVMFuzzerCustomCrossOver(std::uint8_t const* first, std::size_t first_size, std::uint8_t const* second, std::size_t second_size,
                                                 std::uint8_t* out, std::size_t max_size, unsigned seed) {
  std::minstd_rand random(seed);
  return put(change(text_of(first, first_size), text_of(second, second_size), random), out, max_size);
}
