// The Builder's expressions, dimensions, words and orbit types.
#include <charconv>
#include <limits>

#include "compiler/syntax/build.h"

namespace jrule::syntax {

using source::Code;

namespace {

antlr4::Token* token_of(antlr4::tree::ParseTree* child) {
  return dynamic_cast<antlr4::tree::TerminalNode&>(*child).getSymbol();
}

ast::BinaryOp binary_op(antlr4::Token const* token) {
  using Op = ast::BinaryOp;
  switch (token->getType()) {
    case JRuleParser::KW_OR: return Op::logical_or;
    case JRuleParser::KW_AND: return Op::logical_and;
    case JRuleParser::LESS: return Op::less;
    case JRuleParser::LESS_EQUAL: return Op::less_equal;
    case JRuleParser::GREATER: return Op::greater;
    case JRuleParser::GREATER_EQUAL: return Op::greater_equal;
    case JRuleParser::EQUAL: return Op::equal;
    case JRuleParser::NOT_EQUAL: return Op::not_equal;
    case JRuleParser::PLUS: return Op::add;
    case JRuleParser::MINUS: return Op::subtract;
    case JRuleParser::STAR: return Op::multiply;
    default: return Op::divide;
  }
}

}  // namespace

// ---- Operators ----

/// An expression one step deeper than its deepest part; past the limit the error, and a leaf in place of the tree.
Builder::Built Builder::deeper(ast::Expr expr, std::initializer_list<Built const*> parts) {
  int depth = 1;
  for (auto const* part : parts) depth = std::max(depth, part->depth + 1);
  if (depth > depth_limit) {
    if (!is_too_deep_) {
      error({.code = Code::nesting_too_deep,
             .span = expr.span,
             .message = "more than " + std::to_string(depth_limit) + " operations within each other in one expression",
             .notes = {"split it with `let`"}});
    }
    is_too_deep_ = true;
    return {std::make_shared<ast::Expr const>(ast::Expr{ast::BoolLiteral{false}, expr.span}), 1};
  }
  return {std::make_shared<ast::Expr const>(std::move(expr)), depth};
}

Builder::Built Builder::binary(Built left, antlr4::Token* op, Built right, antlr4::Token* first, antlr4::Token* last) {
  ast::Expr expr{ast::Binary{binary_op(op), parser_.span(op), left.expr, right.expr}, parser_.span(first, last)};
  return deeper(std::move(expr), {&left, &right});
}

Builder::Built Builder::built(JRuleParser::ExpressionContext* tree) {
  auto result = disjunction(tree->disjunction());
  auto const parts = tree->expression();
  auto const ifs = tree->KW_IF();
  for (auto i = ifs.size(); i-- > 0;) {
    auto const condition = built(parts[2 * i]);
    auto const then_value = built(parts[2 * i + 1]);
    ast::Expr expr{ast::Conditional{condition.expr, then_value.expr, result.expr},
                   parser_.span(ifs[i]->getSymbol(), tree->getStop())};
    result = deeper(std::move(expr), {&condition, &then_value, &result});
  }
  return result;
}

Builder::Built Builder::disjunction(JRuleParser::DisjunctionContext* tree) {
  auto const parts = tree->conjunction();
  auto result = conjunction(parts[0]);
  for (std::size_t i = 1; i < parts.size(); ++i) {
    auto* op = token_of(tree->children[2 * i - 1]);
    result = binary(result, op, conjunction(parts[i]), tree->getStart(), parts[i]->getStop());
  }
  return result;
}

Builder::Built Builder::conjunction(JRuleParser::ConjunctionContext* tree) {
  auto const parts = tree->negation();
  auto result = negation(parts[0]);
  for (std::size_t i = 1; i < parts.size(); ++i) {
    auto* op = token_of(tree->children[2 * i - 1]);
    result = binary(result, op, negation(parts[i]), tree->getStart(), parts[i]->getStop());
  }
  return result;
}

Builder::Built Builder::negation(JRuleParser::NegationContext* tree) {
  auto result = comparison(tree->comparison());
  auto const nots = tree->KW_NOT();
  for (auto i = nots.size(); i-- > 0;) {
    ast::Expr expr{ast::Unary{ast::UnaryOp::logical_not, result.expr},
                   parser_.span(nots[i]->getSymbol(), tree->getStop())};
    result = deeper(std::move(expr), {&result});
  }
  return result;
}

Builder::Built Builder::comparison(JRuleParser::ComparisonContext* tree) {
  auto const parts = tree->addition();
  auto result = addition(parts[0]);
  if (parts.size() == 1) return result;
  return binary(result, token_of(tree->children[1]), addition(parts[1]), tree->getStart(), tree->getStop());
}

Builder::Built Builder::addition(JRuleParser::AdditionContext* tree) {
  auto const parts = tree->multiplication();
  auto result = multiplication(parts[0]);
  for (std::size_t i = 1; i < parts.size(); ++i) {
    auto* op = token_of(tree->children[2 * i - 1]);
    result = binary(result, op, multiplication(parts[i]), tree->getStart(), parts[i]->getStop());
  }
  return result;
}

Builder::Built Builder::multiplication(JRuleParser::MultiplicationContext* tree) {
  auto const parts = tree->unary();
  auto result = unary(parts[0]);
  for (std::size_t i = 1; i < parts.size(); ++i) {
    auto* op = token_of(tree->children[2 * i - 1]);
    result = binary(result, op, unary(parts[i]), tree->getStart(), parts[i]->getStop());
  }
  return result;
}

Builder::Built Builder::unary(JRuleParser::UnaryContext* tree) {
  auto result = postfix(tree->postfix());
  auto const signs = tree->MINUS();
  for (auto i = signs.size(); i-- > 0;) {
    ast::Expr expr{ast::Unary{ast::UnaryOp::negate, result.expr}, parser_.span(signs[i]->getSymbol(), tree->getStop())};
    result = deeper(std::move(expr), {&result});
  }
  return result;
}

// ---- Primaries and what follows them ----

Builder::Built Builder::postfix(JRuleParser::PostfixContext* tree) {
  auto const suffixes = tree->suffix();
  auto const is = [&](std::size_t i, std::size_t type) {
    return i < suffixes.size() && suffixes[i]->getStart()->getType() == type;
  };
  // Only a plain name is called: `f(x)`, or with dimensions `sew[2](a, b)`.
  Built result;
  std::size_t done = 0;
  bool const is_name = tree->primary()->name() != nullptr;
  if (is_name && is(0, JRuleParser::LPAREN)) {
    result = call(tree, nullptr, suffixes[0]);
    done = 1;
  } else if (is_name && is(0, JRuleParser::LBRACKET) && is(1, JRuleParser::LPAREN)) {
    result = call(tree, suffixes[0], suffixes[1]);
    done = 2;
  } else {
    result = primary(tree->primary());
  }
  for (; done < suffixes.size(); ++done) result = suffix(result, tree->getStart(), suffixes[done]);
  return result;
}

Builder::Built Builder::suffix(Built base, antlr4::Token* first, JRuleParser::SuffixContext* tree) {
  auto const whole = parser_.span(first, tree->getStop());
  if (auto* member = tree->name()) return deeper({ast::Member{base.expr, name(member)}, whole}, {&base});
  if (tree->AT() != nullptr) return deeper({ast::Walk{base.expr, walk(tree)}, whole}, {&base});
  if (tree->LBRACKET() != nullptr) {
    auto const indices = tree->expression();
    if (indices.size() > 1) {
      error({.code = Code::syntax_error,
             .span = parser_.span(tree->COMMA(0)->getSymbol()),
             .message = "expected `]` after the index, found `,`"});
    }
    auto const index = built(indices[0]);
    return deeper({ast::Index{base.expr, index.expr}, whole}, {&base, &index});
  }
  error({.code = Code::syntax_error,
         .span = parser_.span(tree->getStart()),
         .message = "what stands before `(` cannot be called",
         .notes = {"functions, rules and operations are called by their names: `f(x)`, `sew[2](a, b)`"}});
  return base;
}

ast::Word Builder::walk(JRuleParser::SuffixContext* tree) {
  if (auto* w = tree->word()) return word(w);
  auto* last = tree->getStop();
  auto const place = parser_.span(tree->TILDE() != nullptr ? tree->TILDE()->getSymbol() : last, last);
  return {{{tree->TILDE() != nullptr, {{dimension_term(last, false)}, parser_.span(last)}, place}}, place};
}

Builder::Built Builder::call(JRuleParser::PostfixContext* tree, JRuleParser::SuffixContext* dimensions,
                             JRuleParser::SuffixContext* arguments) {
  auto const function = name(tree->getStart());
  auto const whole = parser_.span(tree->getStart(), arguments->getStop());
  auto const parts = arguments->argument();
  for (auto* part : parts) {
    if (part->KW_FOR() == nullptr) continue;
    if (parts.size() > 1 || dimensions != nullptr) {
      error({.code = Code::syntax_error,
             .span = span(part),
             .message = "a comprehension must be the only argument of an aggregate",
             .notes = {"for example `mean(f.position for f in <1,2>(a))`"}});
      continue;
    }
    auto const values = part->expression();
    auto const element = built(values[0]);
    auto const orbit = built(values[1]);
    return deeper({ast::Comprehension{function, element.expr, name(part->name()), orbit.expr}, whole},
                  {&element, &orbit});
  }

  ast::Call result{function, {}, {}};
  if (dimensions != nullptr) {
    for (auto* value : dimensions->expression()) result.dimensions.push_back(dimension_of(*expression(value)));
  }
  Built deepest;
  for (auto* part : parts) {
    auto const values = part->expression();
    auto const value = built(values.back());
    deepest.depth = std::max(deepest.depth, value.depth);
    ast::Argument argument{std::nullopt, value.expr};
    if (part->COLON() != nullptr) {
      auto* first = values[0]->getStart();
      if (first != values[0]->getStop() || first->getType() != JRuleParser::NAME) {
        error({.code = Code::syntax_error,
               .span = span(values[0]),
               .message = "expected the name of a parameter before `:`"});
      }
      argument.name = name(first);
    }
    result.arguments.push_back(std::move(argument));
  }
  return deeper({std::move(result), whole}, {&deepest});
}

Builder::Built Builder::primary(JRuleParser::PrimaryContext* tree) {
  auto* first = tree->getStart();
  auto const place = span(tree);
  auto const leaf = [&](auto value) { return deeper({std::move(value), place}, {}); };
  if (auto* n = tree->name()) return leaf(ast::NameExpr{n->getText()});
  if (auto const types = tree->orbitType(); !types.empty()) {
    auto const dart = built(tree->expression());
    ast::OrbitOf orbit{orbit_type(types[0]), dart.expr, std::nullopt};
    if (types.size() > 1) orbit.by = orbit_type(types[1]);
    return deeper({std::move(orbit), place}, {&dart});
  }
  if (auto* inner = tree->expression()) return built(inner);
  switch (first->getType()) {
    case JRuleParser::INT: return leaf(ast::IntLiteral{integer(first)});
    case JRuleParser::REAL: return leaf(ast::RealLiteral{real(first), first->getText()});
    case JRuleParser::STRING: return leaf(ast::StringLiteral{string(first)});
    default: return leaf(ast::BoolLiteral{first->getType() == JRuleParser::KW_TRUE});
  }
}

// ---- Literals ----

std::int64_t Builder::integer(antlr4::Token* token) {
  auto const text = token->getText();
  std::int64_t value = 0;
  if (std::from_chars(text.data(), text.data() + text.size(), value).ec == std::errc()) return value;
  error({.code = Code::number_out_of_range,
         .span = parser_.span(token),
         .message = "the number `" + text + "` is too large",
         .notes = {"the largest integer is " + std::to_string(std::numeric_limits<std::int64_t>::max())}});
  return 0;
}

double Builder::real(antlr4::Token* token) {
  auto const text = token->getText();
  double value = 0;
  if (std::from_chars(text.data(), text.data() + text.size(), value).ec == std::errc()) return value;
  error({.code = Code::number_out_of_range,
         .span = parser_.span(token),
         .message = "the number `" + text + "` is too large or too small for a double"});
  return 0;
}

std::string Builder::string(antlr4::Token* token) {
  auto const text = token->getText();
  std::string value;
  auto const place = parser_.span(token);
  for (std::size_t i = 1; i + 1 < text.size(); ++i) {
    if (text[i] != '\\') {
      value += text[i];
      continue;
    }
    ++i;
    if (text[i] == '"' || text[i] == '\\') {
      value += text[i];
    } else if (text[i] == 'n') {
      value += '\n';
    } else {
      auto const at = place.begin + static_cast<std::uint32_t>(i) - 1;
      error({.code = Code::syntax_error,
             .span = {place.file, at, at + 1},
             .message = "unknown escape in a string",
             .notes = {"a string knows `\\\"`, `\\\\` and `\\n`"}});
    }
  }
  return value;
}

// ---- Dimensions, words, orbit types ----

ast::DimensionTerm Builder::dimension_term(antlr4::Token* token, bool negative) {
  if (token->getType() == JRuleParser::INT) return {negative, integer(token), parser_.span(token)};
  return {negative, token->getText(), parser_.span(token)};
}

ast::Dimension Builder::dimension(JRuleParser::DimensionContext* tree) {
  ast::Dimension result{{}, span(tree)};
  bool negative = false;
  for (auto* child : tree->children) {
    if (auto* term = dynamic_cast<JRuleParser::DimensionTermContext*>(child)) {
      result.terms.push_back(dimension_term(term->getStart(), negative));
    } else {
      negative = token_of(child)->getType() == JRuleParser::MINUS;
    }
  }
  return result;
}

/// The dimensions of a call, `sew[i-2](a, b)`, are parsed as expressions.
ast::Dimension Builder::dimension_of(ast::Expr const& expr) {
  ast::Dimension result{{}, expr.span};
  auto const* rest = &expr;
  auto const add_term = [&](ast::Expr const& term, bool negative) {
    if (auto const* number = std::get_if<ast::IntLiteral>(&term.value)) {
      result.terms.insert(result.terms.begin(), {negative, number->value, term.span});
    } else if (auto const* variable = std::get_if<ast::NameExpr>(&term.value)) {
      result.terms.insert(result.terms.begin(), {negative, variable->name, term.span});
    } else {
      error({.code = Code::syntax_error,
             .span = term.span,
             .message = "expected a dimension: a number, a dimension parameter, or a sum such as `i-2`"});
    }
  };
  while (auto const* sum = std::get_if<ast::Binary>(&rest->value)) {
    if (sum->op != ast::BinaryOp::add && sum->op != ast::BinaryOp::subtract) break;
    add_term(*sum->right, sum->op == ast::BinaryOp::subtract);
    rest = sum->left.get();
  }
  add_term(*rest, false);
  return result;
}

ast::Word Builder::word(JRuleParser::WordContext* tree) {
  ast::Word result{{}, span(tree)};
  for (auto* letter : tree->letter()) {
    result.letters.push_back({letter->TILDE() != nullptr, dimension(letter->dimension()), span(letter)});
  }
  return result;
}

ast::OrbitElement Builder::dimension_range(JRuleParser::DimensionRangeContext* tree) {
  auto const ends = tree->dimension();
  auto const place = span(tree);
  if (ends.size() == 1) return {ast::Letter{false, dimension(ends[0]), place}, place};
  return {ast::Range{dimension(ends[0]), dimension(ends[1])}, place};
}

ast::OrbitElement Builder::orbit_element(JRuleParser::OrbitElementContext* tree) {
  auto const place = span(tree);
  if (auto* range = tree->dimensionRange()) return dimension_range(range);
  if (auto* w = tree->word()) return {word(w), place};
  if (auto* conjugated = tree->dimension()) return {ast::Letter{true, dimension(conjugated), place}, place};
  return {ast::Removed{}, place};
}

ast::ElementList Builder::element_list(JRuleParser::ElementListContext* tree) {
  ast::ElementList result{{}, span(tree)};
  for (auto* element : tree->orbitElement()) result.elements.push_back(orbit_element(element));
  return result;
}

ast::OrbitType Builder::orbit_type(JRuleParser::OrbitTypeContext* tree) {
  using Kind = ast::CellName::Kind;
  if (auto* list = tree->elementList()) return {element_list(list), span(tree)};
  auto const kind = [&] {
    switch (tree->getStart()->getType()) {
      case JRuleParser::KW_VERTEX: return Kind::vertex;
      case JRuleParser::KW_EDGE: return Kind::edge;
      case JRuleParser::KW_FACE: return Kind::face;
      case JRuleParser::KW_VOLUME: return Kind::volume;
      case JRuleParser::KW_CONNECTED: return Kind::connected;
      default: return Kind::cell;
    }
  };
  ast::CellName cell{kind(), std::nullopt, span(tree)};
  if (auto* d = tree->dimension()) cell.dimension = dimension(d);
  return {std::move(cell), span(tree)};
}

}  // namespace jrule::syntax
