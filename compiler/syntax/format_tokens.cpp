#include "compiler/syntax/format_tokens.h"

#include <algorithm>
#include <set>

#include "compiler/syntax/item_parser.h"
#include "compiler/syntax/split.h"

namespace jrule::syntax {

namespace {

using P = JRuleParser;
using Tree = antlr4::tree::ParseTree;

/// Spaces that do not follow from the two tokens alone, by the index of the token after them.
class Spacing {
 public:
  explicit Spacing(std::size_t token_count) : spaces_(token_count, unknown) {}

  static constexpr std::size_t unknown = ~std::size_t{0};
  std::size_t operator[](std::size_t token) const { return spaces_[token]; }

  void visit(Tree* tree) {
    auto* context = dynamic_cast<antlr4::ParserRuleContext*>(tree);
    if (context == nullptr) return;
    switch (context->getRuleIndex()) {
      case P::RuleElementList:
      case P::RuleWord:
      case P::RuleDimension:
      case P::RuleDimensionRange: join(first(context), last(context)); break;
      case P::RuleModelStatement: model_statement(dynamic_cast<P::ModelStatementContext&>(*context)); break;
      case P::RuleArc: arc(dynamic_cast<P::ArcContext&>(*context)); break;
      // Brackets that belong to the word before them.
      case P::RuleModelItem:
      case P::RuleModelReference:
      case P::RuleOrbitType:
      case P::RuleParameters: glue(context, P::LPAREN); break;
      case P::RuleRuleItem: glue(context, P::LBRACKET); break;
      case P::RuleSuffix: set(first(context), 0); break;
      case P::RulePrimary:
        if (!dynamic_cast<P::PrimaryContext&>(*context).orbitType().empty()) glue(context, P::LPAREN);
        break;
      case P::RulePostfix: call_dimensions(dynamic_cast<P::PostfixContext&>(*context)); break;
      case P::RuleUnary:
        for (auto* minus : dynamic_cast<P::UnaryContext&>(*context).MINUS()) after(minus->getSymbol(), 0);
        break;
      case P::RuleEmbedding:
        set(dynamic_cast<P::EmbeddingContext&>(*context).COLON()->getSymbol()->getTokenIndex(), 1);
        break;
      default: break;
    }
    for (auto* child : context->children) visit(child);
  }

 private:
  static std::size_t first(antlr4::ParserRuleContext* tree) { return tree->getStart()->getTokenIndex(); }
  static std::size_t last(antlr4::ParserRuleContext* tree) { return tree->getStop()->getTokenIndex(); }
  void set(std::size_t token, std::size_t spaces) { spaces_[token] = spaces; }
  void after(antlr4::Token* token, std::size_t spaces) { set(token->getTokenIndex() + 1, spaces); }

  /// No spaces from the token `begin` to the token `end`.
  void join(std::size_t begin, std::size_t end) {
    for (auto i = begin + 1; i <= end; ++i) set(i, 0);
  }

  /// No space before the tokens of a kind that stand directly in a construct.
  void glue(antlr4::ParserRuleContext* tree, std::size_t kind) {
    for (auto* token : tree->getTokens(kind)) set(token->getSymbol()->getTokenIndex(), 0);
  }

  /// `sew[i-2](a, b)`: sums of dimensions have no spaces, here as elsewhere.
  void call_dimensions(P::PostfixContext& tree) {
    auto const suffixes = tree.suffix();
    if (suffixes.size() < 2 || suffixes[0]->LBRACKET() == nullptr || suffixes[1]->LPAREN() == nullptr) return;
    for (auto* dimension : suffixes[0]->expression()) join(first(dimension), last(dimension));
  }

  /// `exchange (0,2), (1,3);` but `exchange (i, j) where …`.
  void model_statement(P::ModelStatementContext& tree) {
    if (tree.KW_WHERE() != nullptr) return;
    for (auto* pair : tree.dimensionPair()) join(first(pair), last(pair));
  }

  /// `-2[2]-`: all but the name at its end.
  void arc(P::ArcContext& tree) {
    auto const name = first(tree.name());
    join(first(&tree), name - 1);
    set(name, 1);
  }

  std::vector<std::size_t> spaces_;
};

/// Between two tokens about which the tree says nothing special.
std::size_t usual_spaces(std::size_t before, std::size_t kind) {
  static std::set<std::size_t> const none_before{P::SEMICOLON, P::COMMA, P::RPAREN, P::RBRACKET,
                                                 P::DOT,       P::COLON, P::RANGE,  P::AT};
  static std::set<std::size_t> const none_after{P::LPAREN, P::LBRACKET, P::DOT, P::AT, P::TILDE, P::RANGE};
  if (kind == P::LBRACE && before == P::KW_LEFT) return 2;  // in line with the brace of `right {`
  return none_before.count(kind) + none_after.count(before) == 0 ? 1 : 0;
}

FormatToken::Kind kind_of(antlr4::Token const& token) {
  using Kind = FormatToken::Kind;
  switch (token.getType()) {
    case P::DOC:
    case P::LINE_COMMENT: return Kind::line_comment;
    case P::BLOCK_COMMENT: return Kind::block_comment;
    case P::LBRACE: return Kind::open_brace;
    case P::RBRACE: return Kind::close_brace;
    case P::SEMICOLON: return Kind::semicolon;
    case P::KW_ELSE: return Kind::keyword_else;
    default: return Kind::word;
  }
}

std::string without_trailing_spaces(std::string_view text) {
  std::string result;
  for (std::size_t begin = 0; begin <= text.size();) {
    auto const end = std::min(text.find('\n', begin), text.size());
    auto const line = text.substr(begin, end - begin);
    result += line.substr(0, line.find_last_not_of(" \t\f") + 1);
    if (end < text.size()) result += '\n';
    begin = end + 1;
  }
  return result;
}

std::size_t code_points(std::string_view text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

class Collector {
 public:
  explicit Collector(std::string_view text) : text_(text) {}

  bool run() {
    Splitter splitter(text_);
    std::uint32_t done = 0;
    while (auto piece = splitter.next()) {
      if (piece->kind == Piece::Kind::stray || piece->open_comment || piece->too_deep) return false;
      comments(done, piece->begin);
      parser_.load(source::no_file, text_, piece->begin, piece->end);
      auto* tree = parser_.parse();
      if (tree == nullptr) return false;
      Spacing spacing(parser_.tokens().size());
      spacing.visit(tree);
      add_tokens(&spacing);
      done = piece->end;
    }
    comments(done, static_cast<std::uint32_t>(text_.size()));
    align_embeddings();
    return true;
  }

  std::vector<FormatToken> take() { return std::move(tokens_); }

 private:
  void comments(std::uint32_t begin, std::uint32_t end) {
    parser_.load(source::no_file, text_, begin, end);
    add_tokens(nullptr);
  }

  void add_tokens(Spacing const* spacing) {
    for (auto const* token : parser_.tokens()) {
      if (token->getType() == antlr4::Token::EOF) break;
      add(*token, spacing);
    }
  }

  void add(antlr4::Token const& token, Spacing const* spacing) {
    using Kind = FormatToken::Kind;
    auto const place = parser_.span(&token);
    auto const gap = text_.substr(end_, place.begin - end_);
    FormatToken result;
    result.kind = kind_of(token);
    result.text = without_trailing_spaces(text_.substr(place.begin, place.end - place.begin));
    result.width = code_points(result.text);
    result.newlines = static_cast<std::size_t>(std::count(gap.begin(), gap.end(), '\n'));

    auto const known = spacing == nullptr ? Spacing::unknown : (*spacing)[token.getTokenIndex()];
    bool const beside_comment = result.is_comment() || (!tokens_.empty() && tokens_.back().is_comment());
    bool const after_statement = !tokens_.empty() && result.kind != Kind::semicolon &&
                                 result.kind != Kind::close_brace &&
                                 (tokens_.back().kind == Kind::semicolon || tokens_.back().kind == Kind::close_brace);
    if (beside_comment) {
      result.spaces = result.kind == Kind::line_comment ? 2 : 1;
    } else if (after_statement) {
      // Like blank lines between lines, a wide gap between statements of one line is the author's: one is kept.
      result.spaces = gap.size() > 1 && result.kind != Kind::keyword_else ? 2 : 1;
    } else {
      result.spaces = known != Spacing::unknown ? known : usual_spaces(last_type_, token.getType());
    }

    auto const index = tokens_.size();
    if (result.kind == Kind::open_brace) braces_.push_back(index);
    if (result.kind == Kind::close_brace) {
      auto& open = tokens_[braces_.back()];
      result.partner = braces_.back();
      open.partner = index;
      open.has_newline_inside =
          text_.substr(brace_offsets_.back(), place.begin - brace_offsets_.back()).find('\n') != std::string_view::npos;
      braces_.pop_back();
      brace_offsets_.pop_back();
    }
    if (result.kind == Kind::open_brace) brace_offsets_.push_back(place.begin);
    if (token.getType() == P::KW_MODELER) modelers_.push_back(index);
    if (token.getType() == P::KW_EMBEDDING) embeddings_.push_back(index);
    tokens_.push_back(std::move(result));
    last_type_ = token.getType();
    end_ = place.end;
  }

  /// The colons of a modeler's embeddings stand in one column, unless the whole modeler stands on one line.
  void align_embeddings() {
    auto const ends = inline_ends(tokens_);
    auto embedding = embeddings_.begin();
    for (auto modeler : modelers_) {
      auto open = modeler;
      while (tokens_[open].kind != FormatToken::Kind::open_brace && tokens_[open].kind != FormatToken::Kind::semicolon)
        ++open;
      if (tokens_[open].kind == FormatToken::Kind::semicolon) continue;
      auto const close = tokens_[open].partner;
      auto const group_begin = embedding;
      embedding = std::lower_bound(embedding, embeddings_.end(), close);
      auto const width = ends[close] - ends[modeler] + tokens_[modeler].width;
      if (!tokens_[open].has_newline_inside && width <= line_width) continue;

      std::size_t widest = 0;
      for (auto i = group_begin; i != embedding; ++i) widest = std::max(widest, tokens_[*i + 1].width);
      for (auto i = group_begin; i != embedding; ++i) {
        bool const plain = tokens_[*i + 2].text == ":";  // no comment between the words
        if (plain) tokens_[*i + 2].spaces = 1 + widest - tokens_[*i + 1].width;
      }
    }
  }

  std::string_view text_;
  ItemParser parser_;
  std::vector<FormatToken> tokens_;
  std::vector<std::size_t> braces_;           ///< indices of the open ones
  std::vector<std::uint32_t> brace_offsets_;  ///< where these stand in the text
  std::vector<std::size_t> modelers_;
  std::vector<std::size_t> embeddings_;
  std::size_t last_type_ = 0;
  std::uint32_t end_ = 0;
};

}  // namespace

std::vector<std::size_t> inline_ends(std::vector<FormatToken> const& tokens) {
  std::vector<std::size_t> ends;
  ends.reserve(tokens.size());
  std::size_t column = 0;
  for (auto const& token : tokens) {
    column += token.spaces + token.width;
    ends.push_back(column);
  }
  return ends;
}

std::optional<std::vector<FormatToken>> format_tokens(std::string_view text) {
  Collector collector(text);
  if (!collector.run()) return std::nullopt;
  return collector.take();
}

}  // namespace jrule::syntax
