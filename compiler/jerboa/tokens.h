// The tokens of Java, C++ and the language of Jerboa's scripts, as far as expressions need them.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace jrule::jerboa {

struct Token {
  enum class Kind { name, integer, real, string, sign, end } kind = Kind::end;
  std::string_view text;  ///< of strings without the quotes; `->` and `::` are `.`
  std::size_t begin = 0, end = 0;
};

/// Without comments, and ended by a token `end`. Anything unknown is a sign of one byte. Views into `code`.
std::vector<Token> tokens_of(std::string_view code);

}  // namespace jrule::jerboa
