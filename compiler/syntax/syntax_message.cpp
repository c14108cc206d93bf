#include "compiler/syntax/syntax_message.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string_view>
#include <vector>

namespace jrule::syntax {

namespace {

using P = JRuleParser;
using Kinds = std::set<std::size_t>;

/// A construct by the names that a user knows it by, and the tokens that begin it.
struct Group {
  std::vector<std::string_view> names;
  Kinds marks;      ///< all of these are expected only where the construct is
  Kinds also = {};  ///< more tokens that may begin it
};

Kinds const cell_words{P::KW_VERTEX, P::KW_EDGE, P::KW_FACE, P::KW_VOLUME, P::KW_CONNECTED, P::KW_CELL};
Kinds const expression_starts{P::INT,     P::REAL,    P::STRING,    P::NAME,         P::LPAREN, P::LESS,
                              P::MINUS,   P::KW_NOT,  P::KW_TRUE,   P::KW_FALSE,     P::KW_IF,  P::KW_VERTEX,
                              P::KW_EDGE, P::KW_FACE, P::KW_VOLUME, P::KW_CONNECTED, P::KW_CELL};
Kinds const statement_starts{P::KW_LET,    P::KW_IF,   P::KW_FOR, P::KW_WHILE,
                             P::KW_RETURN, P::KW_FAIL, P::KW_TRY, P::KW_APPLY_ALL};

/// Larger constructs first: each takes its tokens out of the expected ones.
std::vector<Group> const groups{
    {{"a statement"}, statement_starts, expression_starts},
    {{"an expression"}, {P::INT, P::REAL, P::STRING, P::NAME, P::LPAREN}, expression_starts},
    {{"a node", "an arc"}, {P::KW_HOOK, P::KW_LET, P::KW_REQUIRE}, {P::NAME}},
    {{"an orbit type"}, {P::LESS, P::KW_VERTEX, P::KW_CELL}, cell_words},
    {{"the name of a module"}, {P::NAME, P::KW_VERTEX, P::KW_CELL}, cell_words},
    {{"a dimension", "`_`", "a word"}, {P::REMOVED, P::INT, P::NAME}, {P::TILDE, P::LBRACKET}},
    {{"a dimension", "a word"}, {P::INT, P::NAME, P::TILDE, P::LBRACKET}},
    {{"a dimension"}, {P::INT, P::NAME}, {P::TILDE, P::LPAREN}},
    {{"a type"}, {P::NAME, P::LBRACKET}},
    {{"a name"}, {P::NAME}},
    {{"a number of cells such as `V'`"}, {P::COUNT}},
    {{"a number"}, {P::INT}},
    {{"a string"}, {P::STRING}},
};

std::string quoted(std::string const& text) { return fmt::format("`{}`", text); }

/// "a name", "`,` or `>`", "a node, an arc or `}`".
std::string list_expected(ItemParser const& parser, Kinds expected) {
  std::vector<std::string> names;
  for (auto const& group : groups) {
    if (!std::includes(expected.begin(), expected.end(), group.marks.begin(), group.marks.end())) continue;
    names.insert(names.end(), group.names.begin(), group.names.end());
    for (auto kind : group.marks) expected.erase(kind);
    for (auto kind : group.also) expected.erase(kind);
  }
  for (auto kind : expected) {
    if (auto const text = parser.spelling(kind); !text.empty()) names.push_back(quoted(text));
  }
  std::string list;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) list += i + 1 == names.size() ? " or " : ", ";
    list += names[i];
  }
  return list;
}

bool is_keyword(std::size_t kind) { return kind >= P::KW_IMPORT && kind <= P::KW_CELL; }

std::string found(antlr4::Token const& token, std::string const& following) {
  if (token.getType() == antlr4::Token::EOF) return following;
  auto const text = token.getText();
  if (is_keyword(token.getType())) return fmt::format("the keyword `{}`", text);
  if (token.getType() == P::STRING && text.size() > 30) return "a string";
  if (text.size() > 60) return "a long word";
  return quoted(text);
}

/// The construct that a `;` should end, in the user's words.
std::string unfinished(antlr4::ParserRuleContext* context) {
  auto const named = [](std::string_view what, JRuleParser::NameContext* name) {
    return name == nullptr ? std::string(what) : fmt::format("{} `{}`", what, name->getText());
  };
  switch (context->getRuleIndex()) {
    case P::RuleImportItem: return "the name of the module";
    case P::RuleModelStatement: return quoted(context->getStart()->getText());
    case P::RuleModelerItem: return named("the modeler", dynamic_cast<P::ModelerItemContext&>(*context).name());
    case P::RuleEmbedding: return named("the embedding", dynamic_cast<P::EmbeddingContext&>(*context).name());
    case P::RulePolicy: return fmt::format("the value of `{}`", context->getStart()->getText());
    case P::RuleNode: return named("the node", dynamic_cast<P::SideItemContext&>(*context->parent).name());
    case P::RuleClause: return named("the value of", dynamic_cast<P::ClauseContext&>(*context).name());
    case P::RuleLet: return named("the value of", dynamic_cast<P::LetContext&>(*context).name());
    case P::RuleExternItem: return "the C++ name";
    case P::RuleExpectation: return "the number of cells";
    case P::RuleSideItem: {
      auto& item = dynamic_cast<P::SideItemContext&>(*context);
      if (!item.arc().empty()) return "the arc";
      return item.KW_REQUIRE() != nullptr ? "the condition" : named("the node", item.name());
    }
    default: return "the statement";
  }
}

/// Is the `;` just forgotten? Certain if the next token starts a new line, closes the block, or is a keyword; a name on
/// the same line may also be a slip in an expression, so it counts after nodes and arcs only.
bool is_forgotten(antlr4::Token const& previous, antlr4::Token const& token, antlr4::ParserRuleContext* context) {
  auto const kind = token.getType();
  if (kind == antlr4::Token::EOF || kind == P::RBRACE || is_keyword(kind)) return true;
  if (token.getLine() > previous.getLine()) return true;
  bool const in_pattern = context->getRuleIndex() == P::RuleNode || context->getRuleIndex() == P::RuleSideItem;
  return kind == P::NAME && in_pattern;
}

bool compares(std::size_t kind) {
  return kind == P::LESS || kind == P::LESS_EQUAL || kind == P::GREATER || kind == P::GREATER_EQUAL ||
         kind == P::EQUAL || kind == P::NOT_EQUAL;
}

}  // namespace

source::Diagnostic describe(ItemParser const& parser, std::string const& following) {
  auto const& [token, expected, context] = parser.failure();
  auto const* previous = parser.previous(token);
  bool const at_end = token->getType() == antlr4::Token::EOF;
  source::Diagnostic result{
      .code = source::Code::syntax_error, .span = at_end ? parser.after(previous) : parser.span(token), .message = {}};

  // The end of a statement: what else could still go on here (another arc, a clause) would only distract.
  bool const ends_statement = expected.count(P::SEMICOLON) != 0 && expected.count(P::INT) == 0;
  if (ends_statement) {
    auto const rule = context->getRuleIndex();
    bool const may_have_block = rule == P::RuleModelerItem || rule == P::RuleEmbedding;
    result.message = fmt::format("expected {} after {}", may_have_block ? "`;` or `{`" : "`;`", unfinished(context));
    if (is_forgotten(*previous, *token, context)) {
      result.span = parser.after(previous);
      if (!may_have_block) result.fixits.push_back({result.span, ";", "add `;`"});
    }
    if (compares(token->getType())) result.notes.emplace_back("comparisons do not chain: write `a < b and b < c`");
  } else if (auto const list = list_expected(parser, expected); !list.empty()) {
    result.message = "expected " + list;
    auto const before = previous == nullptr ? 0 : previous->getType();
    bool const tells_nothing = before == 0 || before == P::SEMICOLON || before == P::LBRACE || before == P::RBRACE;
    if (!tells_nothing && previous->getText().size() <= 60)
      result.message += fmt::format(" after `{}`", previous->getText());
  } else {
    // The one place where two tokens of lookahead are needed: `a <`.
    result.message = "expected an orbit type such as `<0,1>` or an arc such as `<-0-` after the node";
  }
  result.message += fmt::format(", found {}", found(*token, following));

  if (context->getRuleIndex() == P::RuleRuleItem && expected.count(P::KW_LEFT) + expected.count(P::KW_RIGHT) != 0) {
    result.notes.emplace_back("a rule has a left and a right side, in this order; either may be empty: `left { }`");
  }
  return result;
}

}  // namespace jrule::syntax
