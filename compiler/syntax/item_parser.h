// One run of the generated lexer and parser over one piece of a file.
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "JRuleLexer.h"
#include "JRuleParser.h"
#include "compiler/source/source.h"

namespace jrule::syntax {

using grammar::JRuleLexer;
using grammar::JRuleParser;

/// Where the generated parser stopped. Contexts and tokens live until the next run.
struct SyntaxFailure {
  antlr4::Token* token = nullptr;                ///< the first that does not fit
  std::set<std::size_t> expected{};              ///< the kinds that would fit; empty if not known
  antlr4::ParserRuleContext* context = nullptr;  ///< the innermost construct under way
};

/// Tokens of one piece of a file, and their tree. Load a piece, then parse it, if need be more than once.
class ItemParser {
 public:
  ItemParser();
  ItemParser(ItemParser const&) = delete;
  ItemParser& operator=(ItemParser const&) = delete;

  /// Lexes the bytes from `begin` to `end` of the file with this whole text.
  void load(source::FileId file, std::string_view text, std::uint32_t begin, std::uint32_t end);

  /// All tokens, those on the hidden channel (comments) and the end-of-input token too.
  std::vector<antlr4::Token*> const& tokens() const { return tokens_; }

  /// The tree, or null: then failure() says why.
  JRuleParser::ItemContext* parse();
  SyntaxFailure const& failure() const { return failure_; }

  /// Takes the statement round the failure out of the token stream, so that the next parse() finds later errors.
  /// False if the failure is in no statement, and the item is better left alone.
  bool drop_failed_statement();

  /// From the begin of `first` to the end of `last`.
  source::Span span(antlr4::Token const* first, antlr4::Token const* last) const;
  source::Span span(antlr4::Token const* token) const { return span(token, token); }
  /// The empty range just after a token.
  source::Span after(antlr4::Token const* token) const;
  /// A keyword or a sign as it is written, `rule`; empty for kinds of many spellings.
  std::string spelling(std::size_t kind) const;
  /// From `first` to `last` as written, white space and comments between two tokens as one space.
  std::string text(antlr4::Token const* first, antlr4::Token const* last) const;
  /// The visible token before, or null.
  antlr4::Token* previous(antlr4::Token const* token) const;

 private:
  bool is_visible(std::size_t index) const;
  std::uint32_t byte_of(std::size_t code_point) const;

  source::FileId file_ = source::no_file;
  std::uint32_t begin_ = 0;
  std::uint32_t end_ = 0;
  std::vector<std::uint32_t> bytes_;  ///< of each code point of the piece; empty if all of them are one byte long
  antlr4::ANTLRInputStream input_;
  JRuleLexer lexer_;
  antlr4::CommonTokenStream stream_;
  JRuleParser parser_;
  std::vector<antlr4::Token*> tokens_;
  SyntaxFailure failure_;
};

}  // namespace jrule::syntax
