#include "compiler/syntax/item_parser.h"

#include <algorithm>
#include <exception>
#include <memory>
#include <string>

namespace jrule::syntax {

namespace {

/// Ends a run of the generated parser; nothing outside this file sees it.
struct Stop {};

/// Stops at the first error and keeps what the parser knew there.
class StopAtError : public antlr4::DefaultErrorStrategy {
 public:
  explicit StopAtError(SyntaxFailure& failure) : failure_(failure) {}

  void reportError(antlr4::Parser*, antlr4::RecognitionException const&) override {}

  void recover(antlr4::Parser* parser, std::exception_ptr error) override {
    auto* token = parser->getCurrentToken();
    bool expectation_is_known = true;
    try {
      std::rethrow_exception(error);
    } catch (antlr4::NoViableAltException const& e) {
      // Found while looking ahead: the parser itself still stands before the start token.
      token = e.getOffendingToken();
      expectation_is_known = e.getStartToken() == token;
    } catch (antlr4::RecognitionException const&) {  // the current token is the wrong one
    }
    stop(parser, token, expectation_is_known);
  }

  antlr4::Token* recoverInline(antlr4::Parser* parser) override { stop(parser, parser->getCurrentToken(), true); }

  /// Before an optional or repeated part: what may begin it is still in the expected set here, but lost further on.
  void sync(antlr4::Parser* parser) override {
    auto const& atn = parser->getATN();
    auto const next = atn.nextTokens(atn.states[parser->getState()]);
    auto const found = parser->getTokenStream()->LA(1);
    if (next.contains(antlr4::Token::EPSILON) || next.contains(found)) return;
    stop(parser, parser->getCurrentToken(), true);
  }

 private:
  [[noreturn]] void stop(antlr4::Parser* parser, antlr4::Token* token, bool expectation_is_known) {
    failure_.token = token;
    failure_.expected.clear();
    if (expectation_is_known) {
      for (auto kind : parser->getExpectedTokens().toList()) failure_.expected.insert(static_cast<std::size_t>(kind));
    }
    failure_.context = parser->getContext();
    throw Stop();
  }

  SyntaxFailure& failure_;
};

}  // namespace

ItemParser::ItemParser() : lexer_(&input_), stream_(&lexer_), parser_(&stream_) {
  lexer_.removeErrorListeners();
  parser_.removeErrorListeners();
}

void ItemParser::load(source::FileId file, std::string_view text, std::uint32_t begin, std::uint32_t end) {
  file_ = file;
  begin_ = begin;
  end_ = end;
  auto const piece = text.substr(begin, end - begin);
  bytes_.clear();
  auto const is_ascii = [](char c) { return static_cast<unsigned char>(c) < 0x80U; };
  if (!std::all_of(piece.begin(), piece.end(), is_ascii)) {
    for (std::size_t i = 0; i < piece.size(); ++i) {
      bool const starts_code_point = (static_cast<unsigned char>(piece[i]) & 0xC0U) != 0x80U;
      if (starts_code_point) bytes_.push_back(static_cast<std::uint32_t>(i));
    }
  }
  input_.load(std::string(piece));
  lexer_.setInputStream(&input_);
  stream_.setTokenSource(&lexer_);
  stream_.fill();
  tokens_ = stream_.getTokens();
}

JRuleParser::ItemContext* ItemParser::parse() {
  using antlr4::atn::PredictionMode;
  auto* simulator = parser_.getInterpreter<antlr4::atn::ParserATNSimulator>();

  // The fast way first. It takes every right text, and refuses a few right ones that need the context of the callers.
  stream_.seek(0);
  parser_.setTokenStream(&stream_);
  simulator->setPredictionMode(PredictionMode::SLL);
  parser_.setErrorHandler(std::make_shared<antlr4::BailErrorStrategy>());
  try {
    return parser_.item();
  } catch (antlr4::ParseCancellationException const&) {  // parse it again, the exact way
  }

  stream_.seek(0);
  parser_.setTokenStream(&stream_);
  simulator->setPredictionMode(PredictionMode::LL);
  parser_.setErrorHandler(std::make_shared<StopAtError>(failure_));
  try {
    return parser_.item();
  } catch (Stop const&) {
    return nullptr;
  }
}

bool ItemParser::is_visible(std::size_t index) const {
  return tokens_[index]->getChannel() == antlr4::Token::DEFAULT_CHANNEL;
}

antlr4::Token* ItemParser::previous(antlr4::Token const* token) const {
  for (auto i = token->getTokenIndex(); i-- > 0;) {
    if (is_visible(i)) return tokens_[i];
  }
  return nullptr;
}

std::string ItemParser::text(antlr4::Token const* first, antlr4::Token const* last) const {
  std::string result = first->getText();
  std::size_t end = first->getStopIndex() + 1;
  for (std::size_t i = first->getTokenIndex() + 1; i <= last->getTokenIndex(); ++i) {
    if (!is_visible(i)) continue;
    if (tokens_[i]->getStartIndex() != end) result += ' ';
    result += tokens_[i]->getText();
    end = tokens_[i]->getStopIndex() + 1;
  }
  return result;
}

bool ItemParser::drop_failed_statement() {
  auto const type = [this](std::size_t index) { return is_visible(index) ? tokens_[index]->getType() : 0; };
  std::size_t const wrong = failure_.token->getTokenIndex();
  std::size_t const end_of_input = tokens_.size() - 1;
  if (wrong == end_of_input) return false;

  // Directly in its braces a rule has no statements but `expect`, else only in those of its sides.
  std::size_t first_kind = 0;
  for (std::size_t i = 0; first_kind == 0; ++i) first_kind = type(i);
  int depth = 0;
  for (std::size_t i = 0; i < wrong; ++i) {
    if (type(i) == JRuleParser::LBRACE) ++depth;
    if (type(i) == JRuleParser::RBRACE) --depth;
  }
  auto const is_boundary = [&](std::size_t i) {
    return type(i) == JRuleParser::SEMICOLON || type(i) == JRuleParser::LBRACE || type(i) == JRuleParser::RBRACE;
  };
  auto begin = wrong;
  while (begin > 0 && !is_boundary(begin - 1)) --begin;
  bool const may_expect = depth == 1 && std::any_of(tokens_.begin() + static_cast<std::ptrdiff_t>(begin), tokens_.begin() + static_cast<std::ptrdiff_t>(wrong), [](auto* token) { return token->getType() == JRuleParser::KW_EXPECT; });
  if (depth < (first_kind == JRuleParser::KW_RULE && !may_expect ? 2 : 1)) return false;

  // To the `;` or the `}` that ends the statement, with an `else` and its block, or a `;` that may follow the `}`.
  auto const next_visible = [&](std::size_t i) {
    while (i < end_of_input && !is_visible(i)) ++i;
    return i;
  };
  auto end = wrong;
  for (depth = 0; end < end_of_input; ++end) {
    if (type(end) == JRuleParser::LBRACE) ++depth;
    if (type(end) == JRuleParser::SEMICOLON && depth == 0) {
      ++end;
      break;
    }
    if (type(end) != JRuleParser::RBRACE) continue;
    if (depth == 0) break;
    if (--depth > 0) continue;
    auto const following = next_visible(end + 1);
    if (type(following) == JRuleParser::KW_ELSE) continue;
    end = type(following) == JRuleParser::SEMICOLON ? following + 1 : end + 1;
    break;
  }
  if (begin == end) return false;

  for (auto i = begin; i < end; ++i) {
    dynamic_cast<antlr4::WritableToken&>(*tokens_[i]).setChannel(antlr4::Token::HIDDEN_CHANNEL);
  }
  return true;
}

std::string ItemParser::spelling(std::size_t kind) const {
  auto const literal = lexer_.getVocabulary().getLiteralName(kind);  // in single quotes
  return literal.size() < 2 ? std::string() : literal.substr(1, literal.size() - 2);
}

std::uint32_t ItemParser::byte_of(std::size_t code_point) const {
  if (bytes_.empty()) return std::min(begin_ + static_cast<std::uint32_t>(code_point), end_);
  return code_point < bytes_.size() ? begin_ + bytes_[code_point] : end_;
}

source::Span ItemParser::span(antlr4::Token const* first, antlr4::Token const* last) const {
  if (last->getType() == antlr4::Token::EOF) return {file_, byte_of(first->getStartIndex()), end_};
  return {file_, byte_of(first->getStartIndex()), byte_of(last->getStopIndex() + 1)};
}

source::Span ItemParser::after(antlr4::Token const* token) const {
  auto const end = span(token).end;
  return {file_, end, end};
}

}  // namespace jrule::syntax
