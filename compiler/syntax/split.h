// Cuts a file into items before it is parsed, so that an error in one item never touches another, and so that neither
// deep nesting nor a very long file reaches the parser. Knows only comments, strings, brackets and the words that open
// items.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace jrule::syntax {

/// Brackets, and `if`s whose `else` is still to come, that may be open at one place.
inline constexpr std::size_t nesting_limit = 256;

/// A run of text that is one item, or that stands where an item should. Offsets are bytes of the file.
struct Piece {
  enum class Kind { item, stray } kind = Kind::item;
  std::uint32_t begin = 0;  ///< with the documentation before it
  std::uint32_t end = 0;    ///< after its last token
  std::uint32_t first_token = 0;
  std::optional<std::uint32_t> unclosed_brace{};  ///< the outermost `{` without a `}`
  std::optional<std::uint32_t> too_deep{};        ///< the bracket or `if` that passes the limit
  std::optional<std::uint32_t> open_comment{};    ///< a `/*` without `*/`; the rest of the file is in it
};

/// The pieces of a text in order; comments between items belong to none.
class Splitter {
 public:
  /// The text must outlive the splitter.
  explicit Splitter(std::string_view text) : text_(text) {}
  /// The next piece; at the end of the file, none. An open comment outside every item is a stray piece of its own.
  std::optional<Piece> next();

 private:
  struct Bracket {
    char kind;  ///< one of ( [ { and i for `if`
    std::uint32_t at;
  };
  enum class Gap { none, end_of_file, open_comment };

  Gap skip_gap();
  void skip_string();
  std::string_view take_word();
  bool may_start_item(Piece const& piece, bool first_token) const;
  void open(char kind, std::uint32_t at, Piece& piece);
  void close(char closing);
  void drop_pending_ifs();
  void finish(Piece& piece) const;

  std::string_view text_;
  std::size_t at_ = 0;
  std::vector<Bracket> brackets_;
  std::optional<std::size_t> doc_begin_;  ///< of the documentation since the last token
  bool first_on_line_ = true;             ///< no token stands before `at_` on its line
  std::string_view previous_;             ///< the last token of the piece: a word, or one character
};

}  // namespace jrule::syntax
