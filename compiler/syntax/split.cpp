#include "compiler/syntax/split.h"

#include <algorithm>
#include <array>

namespace jrule::syntax {

namespace {

bool is_word_start(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_word(char c) { return is_word_start(c) || (c >= '0' && c <= '9'); }
bool ends_line(char c) { return c == '\n' || c == '\r'; }
bool is_space(char c) { return c == ' ' || c == '\t' || c == '\f' || ends_line(c); }

bool opens_item(std::string_view word) {
  constexpr std::array<std::string_view, 6> words{"import", "model", "modeler", "rule", "operation", "extern"};
  return std::find(words.begin(), words.end(), word) != words.end();
}

std::uint32_t narrow(std::size_t offset) { return static_cast<std::uint32_t>(offset); }

}  // namespace

/// White space and comments.
Splitter::Gap Splitter::skip_gap() {
  while (at_ < text_.size()) {
    auto const rest = text_.substr(at_);
    if (is_space(rest[0])) {
      if (ends_line(rest[0])) first_on_line_ = true;
      ++at_;
    } else if (rest.starts_with("//")) {
      bool const is_doc = rest.starts_with("///") && !rest.starts_with("////");
      if (is_doc && !doc_begin_) doc_begin_ = at_;
      at_ += std::min(rest.find_first_of("\r\n"), rest.size());
    } else if (rest.starts_with("/*")) {
      auto const end = rest.find("*/", 2);
      if (end == std::string_view::npos) return Gap::open_comment;
      at_ += end + 2;
    } else {
      return Gap::none;
    }
  }
  return Gap::end_of_file;
}

void Splitter::skip_string() {
  for (++at_; at_ < text_.size() && !ends_line(text_[at_]); ++at_) {
    if (text_[at_] == '"') {
      ++at_;
      return;
    }
    bool const escapes = text_[at_] == '\\' && at_ + 1 < text_.size() && !ends_line(text_[at_ + 1]);
    if (escapes) ++at_;
  }
}

std::string_view Splitter::take_word() {
  auto const begin = at_;
  while (at_ < text_.size() && is_word(text_[at_])) ++at_;
  return text_.substr(begin, at_ - begin);
}

/// May a word that opens items open one here? At the begin of a line always, so that a missing `}` costs one item only;
/// within a line where the item before could not go on with it (`import a rule b`), but not as a name (`rule rule`).
bool Splitter::may_start_item(Piece const& piece, bool first_token) const {
  if (first_token || piece.kind == Piece::Kind::stray || first_on_line_) return true;
  return brackets_.empty() && previous_ != "." && !opens_item(previous_);
}

void Splitter::open(char kind, std::uint32_t at, Piece& piece) {
  if (piece.too_deep) return;
  if (brackets_.size() == nesting_limit) {
    piece.too_deep = at;
  } else {
    brackets_.push_back({kind, at});
  }
}

/// Closes back to the matching bracket. A `)` or `]` never closes a `{`, a `}` closes what stands open inside its
/// braces.
void Splitter::close(char closing) {
  char const opening = closing == ')' ? '(' : closing == ']' ? '[' : '{';
  for (auto i = brackets_.size(); i-- > 0;) {
    if (brackets_[i].kind == opening) {
      brackets_.resize(i);
      return;
    }
    if (brackets_[i].kind == '{') return;
  }
}

/// An `if` without `else` is a statement: it is over at its block or at a `;`.
void Splitter::drop_pending_ifs() {
  while (!brackets_.empty() && brackets_.back().kind == 'i') brackets_.pop_back();
}

void Splitter::finish(Piece& piece) const {
  auto const brace = std::find_if(brackets_.begin(), brackets_.end(), [](Bracket b) { return b.kind == '{'; });
  if (brace != brackets_.end()) piece.unclosed_brace = brace->at;
}

std::optional<Piece> Splitter::next() {
  Piece piece;
  bool first_token = true;
  brackets_.clear();
  previous_ = {};
  while (true) {
    auto const gap = skip_gap();
    if (gap != Gap::none) {
      if (gap == Gap::open_comment) {
        if (first_token) {
          piece = {.kind = Piece::Kind::stray, .begin = narrow(at_), .end = narrow(at_), .first_token = narrow(at_)};
        }
        piece.open_comment = narrow(at_);
        at_ = text_.size();
      } else if (first_token) {
        return std::nullopt;
      }
      finish(piece);
      return piece;
    }

    auto const token = at_;
    char const c = text_[at_];
    if (is_word_start(c)) {
      auto const word = take_word();
      if (opens_item(word) && may_start_item(piece, first_token)) {
        if (!first_token) {
          at_ = token;  // the next piece begins with this word, and with the documentation before it
          finish(piece);
          return piece;
        }
        piece.kind = Piece::Kind::item;
      } else if (first_token) {
        piece.kind = Piece::Kind::stray;
      }
      if (word == "if") {
        open('i', narrow(token), piece);
      } else if (word == "else" && !brackets_.empty() && brackets_.back().kind == 'i') {
        brackets_.pop_back();
      }
      previous_ = word;
    } else {
      if (first_token) piece.kind = Piece::Kind::stray;
      if (c == '"') {
        skip_string();
      } else {
        ++at_;
      }
      if (c == '{' || c == ';') drop_pending_ifs();
      if (c == '(' || c == '[' || c == '{') open(c, narrow(token), piece);
      if (c == ')' || c == ']' || c == '}') close(c);
      previous_ = text_.substr(token, 1);
    }
    if (first_token) {
      piece.begin = narrow(doc_begin_.value_or(token));
      piece.first_token = narrow(token);
      first_token = false;
    }
    piece.end = narrow(at_);
    doc_begin_.reset();
    first_on_line_ = false;

    bool const is_over = (c == ';' || c == '}') && brackets_.empty() && !piece.too_deep;
    if (piece.kind == Piece::Kind::item && is_over) return piece;
  }
}

}  // namespace jrule::syntax
