#include "compiler/syntax/parse.h"

#include <fmt/format.h>

#include <optional>
#include <string>
#include <string_view>

#include "compiler/syntax/build.h"
#include "compiler/syntax/item_parser.h"
#include "compiler/syntax/split.h"
#include "compiler/syntax/syntax_message.h"
#include "compiler/syntax/text_fault.h"

namespace jrule::syntax {

using source::Code;
using source::Span;

namespace {

constexpr std::size_t file_limit = 16U << 20U;  // bytes
constexpr std::size_t item_limit = 1U << 20U;   // bytes: the parser needs some hundred times as much memory
constexpr std::size_t errors_per_item = 10;
constexpr std::size_t errors_per_file = 1000;

std::uint32_t narrow(std::size_t offset) { return static_cast<std::uint32_t>(offset); }

/// The first reason why the file is no text, if there is one.
std::optional<source::Diagnostic> check_text(source::Sources const& sources, source::FileId file) {
  std::string_view const text = sources.file(file).text;
  auto const fault = find_text_fault(text);
  if (!fault) return std::nullopt;
  auto const at = narrow(fault->offset);
  auto const place = fmt::format("byte 0x{:02X} at offset {} (line {})", static_cast<unsigned char>(text[at]), at,
                                 sources.position(file, at).line);
  auto const* what =
      fault->is_control ? "the file is not text: it has the control character " : "the file is not UTF-8: ";
  return source::Diagnostic{
      .code = Code::not_utf8, .span = {file, at, at + 1}, .message = fmt::format("{}{}", what, place)};
}

/// The spelling of a sign that word processors and formulas put in its place; empty if there is none.
std::string ascii_for(std::string_view character) {
  static constexpr std::pair<std::string_view, std::string_view> known[] = {
      {"−", "-"},  {"–", "-"},  {"“", "\""}, {"”", "\""}, {"→", "->"}, {"≤", "<="},
      {"≥", ">="}, {"≠", "!="}, {"×", "*"},  {"·", "*"},  {"⟨", "<"},  {"⟩", ">"}};
  for (auto const& [sign, meant] : known) {
    if (sign == character) return std::string(meant);
  }
  return {};
}

// ---- One file ----

class FileParser {
 public:
  FileParser(source::Sources const& sources, source::FileId file, source::Diagnostics& diagnostics)
      : file_(file), text_(sources.file(file).text), diagnostics_(diagnostics) {
    result_.file = file;
  }

  ast::File run() {
    Splitter splitter(text_);
    auto piece = splitter.next();
    if (!piece) add({.code = Code::empty_file, .span = {file_, 0, 0}, .message = "the file has no items"});
    bool last_was_right = true;
    while (piece) {
      if (errors_ >= errors_per_file) {
        add({.code = Code::syntax_error,
             .span = place(piece->first_token, piece->first_token),
             .message = fmt::format("more than {} errors; the rest of the file is not read", errors_per_file)});
        break;
      }
      auto const next = splitter.next();
      auto const errors_before = errors_;
      if (piece->kind == Piece::Kind::item) {
        item(*piece, next);
      } else if (last_was_right || piece->open_comment) {
        stray(*piece);
      }
      last_was_right = errors_ == errors_before;
      piece = next;
    }
    return std::move(result_);
  }

 private:
  Span place(std::uint32_t begin, std::uint32_t end) const { return {file_, begin, end}; }

  void add(source::Diagnostic diagnostic) {
    ++errors_;
    diagnostics_.add(std::move(diagnostic));
  }

  /// Text where an item should stand. After a broken item it is most likely a part of that one.
  void stray(Piece const& piece) {
    if (piece.open_comment) {
      open_comment(*piece.open_comment);
      if (piece.begin == *piece.open_comment) return;
    }
    // The first token is enough, and a file full of rubbish is not worth lexing whole.
    auto end = std::min<std::size_t>(piece.end, piece.first_token + 200U);
    while (end < piece.end && (static_cast<unsigned char>(text_[end]) & 0xC0U) == 0x80U) ++end;
    parser_.load(file_, text_, piece.first_token, narrow(end));
    auto const* token = parser_.tokens().front();
    if (lexical_error(token)) return;
    add({.code = Code::syntax_error,
         .span = parser_.span(token),
         .message = fmt::format("expected an item, found `{}`", token->getText()),
         .notes = {"a file is made of `import`, `model`, `modeler`, `rule`, `operation` and `extern`"}});
  }

  void open_comment(std::uint32_t at) {
    add({.code = Code::unterminated_comment,
         .span = place(at, at + 2),
         .message = "this comment is not closed; the rest of the file is in it"});
  }

  /// Reports a token that the lexer made of text that is none.
  bool lexical_error(antlr4::Token const* token) {
    if (token->getType() == JRuleParser::UNEXPECTED) {
      auto const text = token->getText();
      auto const meant = ascii_for(text);
      source::Diagnostic diagnostic{.code = Code::unexpected_character,
                                    .span = parser_.span(token),
                                    .message = fmt::format("unexpected character `{}`", text)};
      if (!meant.empty()) diagnostic.fixits.push_back({diagnostic.span, meant, fmt::format("write `{}`", meant)});
      add(std::move(diagnostic));
      return true;
    }
    if (token->getType() == JRuleParser::UNCLOSED_STRING) {
      add({.code = Code::unterminated_string,
           .span = parser_.span(token),
           .message = "this string is not closed on its line"});
      return true;
    }
    return false;
  }

  /// All lexical errors of the loaded piece; of a run of unexpected characters the first.
  bool lexical_errors() {
    std::size_t count = 0;
    std::size_t run_end = 0;
    for (auto const* token : parser_.tokens()) {
      if (count == errors_per_item) break;
      bool const in_run = token->getType() == JRuleParser::UNEXPECTED && token->getStartIndex() == run_end && count > 0;
      if (token->getType() == JRuleParser::UNEXPECTED) run_end = token->getStopIndex() + 1;
      if (in_run || !lexical_error(token)) continue;
      ++count;
    }
    return count > 0;
  }

  void item(Piece const& piece, std::optional<Piece> const& next) {
    if (piece.too_deep) {
      bool const is_if = text_[*piece.too_deep] == 'i';
      add({.code = Code::nesting_too_deep,
           .span = place(*piece.too_deep, *piece.too_deep + (is_if ? 2 : 1)),
           .message = fmt::format("more than {} brackets{} are open here", nesting_limit, is_if ? " and `if`s" : "")});
      return;
    }
    if (piece.open_comment) return open_comment(*piece.open_comment);
    if (piece.end - piece.begin > item_limit) {
      add({.code = Code::file_too_large,
           .span = place(piece.first_token, piece.first_token),
           .message = fmt::format("this item has {} bytes; the limit is {}", piece.end - piece.begin, item_limit)});
      return;
    }
    parser_.load(file_, text_, piece.begin, piece.end);
    if (lexical_errors()) return;

    auto* tree = parser_.parse();
    if (tree != nullptr) {
      source::Diagnostics found;
      Builder builder(parser_, found);
      auto result = builder.item(tree);
      for (auto const& diagnostic : found.all()) add(diagnostic);
      if (!builder.has_failed()) result_.items.push_back(std::move(result));
      return;
    }
    auto const following = next ? fmt::format("`{}`", first_word(*next)) : std::string("the end of the file");
    if (piece.unclosed_brace) return unclosed(*piece.unclosed_brace, following);
    for (std::size_t i = 0; tree == nullptr && i < errors_per_item; ++i) {
      add(describe(parser_, following));
      if (!parser_.drop_failed_statement()) return;
      tree = parser_.parse();
    }
  }

  /// A missing `}` is seen only at the end of the item, or where something does not fit into the block it left open.
  void unclosed(std::uint32_t brace, std::string const& following) {
    source::Diagnostic diagnostic{
        .code = Code::syntax_error, .span = place(brace, brace + 1), .message = "this `{` is not closed"};
    auto seen = describe(parser_, following);
    diagnostic.labels.push_back({seen.span, std::move(seen.message)});
    add(std::move(diagnostic));
  }

  std::string_view first_word(Piece const& piece) const {
    auto const rest = text_.substr(piece.first_token);
    auto const length = rest.find_first_not_of("abcdefghijklmnopqrstuvwxyz");
    return rest.substr(0, std::max<std::size_t>(1, std::min(length, rest.size())));
  }

  source::FileId file_;
  std::string_view text_;
  source::Diagnostics& diagnostics_;
  ItemParser parser_;
  ast::File result_;
  std::size_t errors_ = 0;
};

}  // namespace

ast::File parse(source::Sources const& sources, source::FileId file, source::Diagnostics& diagnostics) {
  auto const size = sources.file(file).text.size();
  if (size > file_limit) {
    diagnostics.add({.code = Code::file_too_large,
                     .span = {file, 0, 0},
                     .message = fmt::format("the file has {} bytes; the limit is {} (16 MiB)", size, file_limit)});
    return {file, {}};
  }
  if (auto no_text = check_text(sources, file)) {
    diagnostics.add(std::move(*no_text));
    return {file, {}};
  }
  return FileParser(sources, file, diagnostics).run();
}

}  // namespace jrule::syntax
