#include "compiler/jerboa/tokens.h"

#include <algorithm>
#include <cctype>

namespace jrule::jerboa {

namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_'; }
bool is_suffix(char c) { return c == 'f' || c == 'F' || c == 'd' || c == 'D'; }  // of floating numbers

class Lexer {
 public:
  explicit Lexer(std::string_view code) : code_(code) {}

  std::vector<Token> run() {
    while (skip_blanks(), at_ < code_.size()) next();
    tokens_.push_back({Token::Kind::end, {}, code_.size(), code_.size()});
    return std::move(tokens_);
  }

 private:
  char peek(std::size_t ahead = 0) const { return at_ + ahead < code_.size() ? code_[at_ + ahead] : '\0'; }

  void skip_blanks() {
    while (at_ < code_.size()) {
      if (std::isspace(static_cast<unsigned char>(code_[at_])) != 0) {
        ++at_;
      } else if (code_.substr(at_).starts_with("//")) {
        at_ = std::min(code_.find_first_of("\r\n", at_), code_.size());
      } else if (code_.substr(at_).starts_with("/*")) {
        std::size_t const end = code_.find("*/", at_ + 2);
        at_ = end == std::string_view::npos ? code_.size() : end + 2;
      } else {
        return;
      }
    }
  }

  void add(Token::Kind kind, std::size_t begin) { tokens_.push_back({kind, code_.substr(begin, at_ - begin), begin, at_}); }

  void next() {
    std::size_t const begin = at_;
    if (is_letter(peek())) {
      while (is_letter(peek()) || is_digit(peek())) ++at_;
      add(Token::Kind::name, begin);
    } else if (is_digit(peek()) || (peek() == '.' && is_digit(peek(1)))) {
      number(begin);
    } else if (peek() == '"') {
      ++at_;
      while (at_ < code_.size() && peek() != '"') ++at_;
      tokens_.push_back({Token::Kind::string, code_.substr(begin + 1, at_ - begin - 1), begin, std::min(at_ + 1, code_.size())});
      at_ = tokens_.back().end;
    } else {
      sign(begin);
    }
  }

  void number(std::size_t begin) {
    auto kind = Token::Kind::integer;
    while (is_digit(peek())) ++at_;
    if (!tokens_.empty() && tokens_.back().text == "@") return add(kind, begin);  // a dimension: `n0@1.f` is an embedding at `n0@1`
    if (peek() == '.' && is_digit(peek(1))) {
      kind = Token::Kind::real;
      ++at_;
      while (is_digit(peek())) ++at_;
    } else if (peek() == '.' && (!is_letter(peek(1)) || (is_suffix(peek(1)) && !is_letter(peek(2))))) {  // `1.`, `1.f`
      kind = Token::Kind::real;
      ++at_;
    }
    bool const exponent = (peek() == 'e' || peek() == 'E') && (is_digit(peek(1)) || ((peek(1) == '-' || peek(1) == '+') && is_digit(peek(2))));
    if (exponent) {
      kind = Token::Kind::real;
      at_ += 2;
      while (is_digit(peek())) ++at_;
    }
    std::size_t const end = at_;
    if (is_suffix(peek())) {
      kind = Token::Kind::real;
      ++at_;
    } else if (peek() == 'L' || peek() == 'l') {
      ++at_;
    }
    tokens_.push_back({kind, code_.substr(begin, end - begin), begin, at_});
  }

  void sign(std::size_t begin) {
    for (std::string_view const two : {"->", "::", "==", "!=", "<=", ">=", "&&", "||", "+=", "-=", "*=", "/=", "++", "--"}) {
      if (!code_.substr(at_).starts_with(two)) continue;
      at_ += 2;
      tokens_.push_back({Token::Kind::sign, two == "->" || two == "::" ? std::string_view(".") : two, begin, at_});
      return;
    }
    ++at_;
    add(Token::Kind::sign, begin);
  }

  std::string_view code_;
  std::size_t at_ = 0;
  std::vector<Token> tokens_;
};

}  // namespace

std::vector<Token> tokens_of(std::string_view code) { return Lexer(code).run(); }

}  // namespace jrule::jerboa
