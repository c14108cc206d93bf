// The tokens of a file with what the layout needs to know of each: the spaces before it, taken from the parse tree.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace jrule::syntax {

/// Columns that the layout fills at most.
inline constexpr std::size_t line_width = 100;

struct FormatToken {
  enum class Kind { word, line_comment, block_comment, open_brace, close_brace, semicolon, keyword_else };
  Kind kind = Kind::word;  ///< `word`: every token that is none of the others
  std::string text;
  std::size_t width = 0;            ///< in code points
  std::size_t newlines = 0;         ///< in the source, between the token before and this one
  std::size_t spaces = 1;           ///< before it where both stand on one line
  std::size_t partner = 0;          ///< of a brace: the index of the other one
  bool has_newline_inside = false;  ///< of an open brace: the source has a line end between it and its partner

  bool is_comment() const { return kind == Kind::line_comment || kind == Kind::block_comment; }
};

/// The tokens and comments of a text whose lines end with \n; none if it has a syntax error.
std::optional<std::vector<FormatToken>> format_tokens(std::string_view text);

/// Column at which each token ends if all stand on one line.
std::vector<std::size_t> inline_ends(std::vector<FormatToken> const& tokens);

}  // namespace jrule::syntax
