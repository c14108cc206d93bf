#include "compiler/syntax/format.h"

#include <algorithm>
#include <string>
#include <vector>

#include "compiler/syntax/format_tokens.h"
#include "compiler/syntax/text_fault.h"

namespace jrule::syntax {

namespace {

using Kind = FormatToken::Kind;

/// Writes tokens one after the other. The author decides which statements share a line, and whether a short block
/// stands on one line; everything else follows from the tokens.
class Layout {
 public:
  explicit Layout(std::vector<FormatToken> tokens) : tokens_(std::move(tokens)), ends_(inline_ends(tokens_)) {}

  std::string run() {
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      separate(i);
      write(i);
    }
    if (!out_.empty()) out_ += '\n';
    return std::move(out_);
  }

 private:
  struct Block {
    bool on_one_line = false;
    bool is_split = false;  ///< stood on one line in the source, but is too wide for it
  };

  bool on_one_line() const { return !blocks_.empty() && blocks_.back().on_one_line; }

  std::size_t indent() const {
    auto const is_indented = [](Block block) { return !block.on_one_line; };
    return 2 * static_cast<std::size_t>(std::count_if(blocks_.begin(), blocks_.end(), is_indented));
  }

  void new_line(bool with_blank, std::size_t indent) {
    out_ += with_blank ? "\n\n" : "\n";
    out_.append(indent, ' ');
    column_ = indent;
  }

  void space(std::size_t count) {
    out_.append(count, ' ');
    column_ += count;
  }

  /// The width of the tokens from `first` to `last` on one line.
  std::size_t width(std::size_t first, std::size_t last) const {
    return ends_[last] - ends_[first] + tokens_[first].width;
  }

  /// The `;` of a statement, or the `{` of the first block in it.
  std::size_t header_end(std::size_t i) const {
    auto const ends = [](Kind kind) {
      return kind == Kind::semicolon || kind == Kind::open_brace || kind == Kind::close_brace;
    };
    while (i + 1 < tokens_.size() && !ends(tokens_[i].kind)) ++i;
    return i;
  }

  /// Does a statement, with its block if that is on one line, fit into the rest of this line?
  bool fits(std::size_t i) const {
    auto last = header_end(i);
    if (tokens_[last].kind == Kind::open_brace && !tokens_[last].has_newline_inside) last = tokens_[last].partner;
    return column_ + tokens_[i].spaces + width(i, last) <= line_width;
  }

  /// A statement of several lines becomes one line if it fits and has no comment that needs its line end.
  bool must_keep_line_ends(std::size_t i) const {
    auto const end = header_end(i);
    for (auto t = i + 1; t <= end; ++t) {
      auto const& token = tokens_[t];
      if (token.kind == Kind::line_comment || (token.is_comment() && token.newlines > 0)) return true;
      if (tokens_[t - 1].is_comment() && token.newlines > 0) return true;
    }
    return column_ + width(i, end) > line_width;
  }

  void separate(std::size_t i) {
    auto const& token = tokens_[i];
    bool const goes_on = token.kind == Kind::keyword_else || token.kind == Kind::semicolon;
    bool const at_boundary = in_no_statement_ && !goes_on;
    if (i == 0) {
      start_statement(i);
      return;
    }
    auto const& previous = tokens_[i - 1];
    bool const blank = token.newlines > 1 && at_boundary && previous.kind != Kind::open_brace;
    auto const continued = indent() + (at_boundary ? 0 : 4);

    if (token.kind == Kind::close_brace) {
      bool const was_on_one_line = on_one_line();
      blocks_.pop_back();
      if (was_on_one_line) {
        space(1);
      } else {
        new_line(false, indent());
      }
      return;
    }
    if (previous.kind == Kind::line_comment) {
      new_line(blank, continued);
    } else if (token.is_comment()) {
      if (token.newlines > 0) {
        new_line(blank, continued);
      } else {
        space(token.spaces);
      }
    } else if (!at_boundary) {
      if (token.newlines > 0 && keeps_line_ends_) {
        new_line(false, continued);
      } else {
        space(token.spaces);
      }
    } else if (blocks_.empty()) {
      new_line(blank, 0);
    } else if (on_one_line()) {
      space(token.spaces);
    } else if (previous.kind == Kind::open_brace || token.newlines > 0 || blocks_.back().is_split || !fits(i)) {
      new_line(blank, indent());
    } else {
      space(token.spaces);
    }
    if (at_boundary || token.kind == Kind::keyword_else) start_statement(i);
  }

  void start_statement(std::size_t i) {
    if (!tokens_[i].is_comment()) keeps_line_ends_ = must_keep_line_ends(i);
  }

  void write(std::size_t i) {
    auto const& token = tokens_[i];
    out_ += token.text;
    auto const line_end = token.text.rfind('\n');
    column_ = line_end == std::string::npos ? column_ + token.width : token.text.size() - line_end - 1;
    if (token.kind == Kind::open_brace) {
      bool const is_empty = token.partner == i + 1;
      bool const fits_here = column_ + ends_[token.partner] - ends_[i] <= line_width;
      bool const one_line = is_empty || on_one_line() || (!token.has_newline_inside && fits_here);
      blocks_.push_back({one_line, !one_line && !token.has_newline_inside});
    }
    if (token.is_comment()) return;
    in_no_statement_ =
        token.kind == Kind::open_brace || token.kind == Kind::close_brace || token.kind == Kind::semicolon;
    if (in_no_statement_) keeps_line_ends_ = false;
  }

  std::vector<FormatToken> tokens_;
  std::vector<std::size_t> ends_;
  std::string out_;
  std::size_t column_ = 0;
  std::vector<Block> blocks_;
  bool in_no_statement_ = true;
  bool keeps_line_ends_ = false;
};

/// Without byte-order mark, each line end one \n.
std::string normal_text(std::string_view text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  std::string result;
  result.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    bool const is_crlf = text[i] == '\r' && i + 1 < text.size() && text[i + 1] == '\n';
    if (!is_crlf) result += text[i] == '\r' ? '\n' : text[i];
  }
  return result;
}

}  // namespace

std::string format(std::string_view text) {
  if (find_text_fault(text)) return std::string(text);
  auto tokens = format_tokens(normal_text(text));
  return tokens ? Layout(std::move(*tokens)).run() : std::string(text);
}

}  // namespace jrule::syntax
