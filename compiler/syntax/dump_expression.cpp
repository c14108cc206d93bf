#include "compiler/syntax/dump_expression.h"

#include <fmt/format.h>

#include <string_view>

namespace jrule::syntax {

namespace {

std::string_view op_name(ast::BinaryOp op) {
  using Op = ast::BinaryOp;
  switch (op) {
    case Op::add: return "add";
    case Op::subtract: return "subtract";
    case Op::multiply: return "multiply";
    case Op::divide: return "divide";
    case Op::less: return "less";
    case Op::less_equal: return "less_equal";
    case Op::greater: return "greater";
    case Op::greater_equal: return "greater_equal";
    case Op::equal: return "equal";
    case Op::not_equal: return "not_equal";
    case Op::logical_and: return "and";
    case Op::logical_or: return "or";
  }
  return "?";
}

std::string_view cell_name(ast::CellName::Kind kind) {
  using Kind = ast::CellName::Kind;
  switch (kind) {
    case Kind::vertex: return "vertex";
    case Kind::edge: return "edge";
    case Kind::face: return "face";
    case Kind::volume: return "volume";
    case Kind::connected: return "connected";
    case Kind::cell: return "cell";
  }
  return "?";
}

struct ElementText {
  std::string operator()(ast::Removed const&) const { return "_"; }
  std::string operator()(ast::Letter const& letter) const {
    return fmt::format("{}{}", letter.conjugate ? "~" : "", text_of(letter.dimension));
  }
  std::string operator()(ast::Range const& range) const {
    return fmt::format("{}..{}", text_of(range.first), text_of(range.last));
  }
  std::string operator()(ast::Word const& word) const { return text_of(word); }
};

struct ExprText {
  std::string operator()(ast::BoolLiteral const& e) const { return e.value ? "true" : "false"; }
  std::string operator()(ast::IntLiteral const& e) const { return fmt::format("{}", e.value); }
  std::string operator()(ast::RealLiteral const& e) const { return fmt::format("(real {})", e.text); }
  std::string operator()(ast::StringLiteral const& e) const { return quoted(e.value); }
  std::string operator()(ast::NameExpr const& e) const { return e.name; }
  std::string operator()(ast::Unary const& e) const {
    return fmt::format("({} {})", e.op == ast::UnaryOp::negate ? "negate" : "not", text_of(*e.operand));
  }
  std::string operator()(ast::Binary const& e) const {
    return fmt::format("({} {} {})", op_name(e.op), text_of(*e.left), text_of(*e.right));
  }
  std::string operator()(ast::Conditional const& e) const {
    return fmt::format("(if {} {} {})", text_of(*e.condition), text_of(*e.then_value), text_of(*e.else_value));
  }
  std::string operator()(ast::Member const& e) const {
    return fmt::format("(member {} {})", text_of(*e.base), e.name.text);
  }
  std::string operator()(ast::Walk const& e) const {
    return fmt::format("(walk {} {})", text_of(*e.base), text_of(e.word));
  }
  std::string operator()(ast::Index const& e) const {
    return fmt::format("(index {} {})", text_of(*e.base), text_of(*e.index));
  }
  std::string operator()(ast::OrbitOf const& e) const {
    return fmt::format("(orbit {} {}{})", text_of(e.type), text_of(*e.dart),
                       e.by ? fmt::format(" by {}", text_of(*e.by)) : "");
  }
  std::string operator()(ast::Call const& e) const { return text_of(e); }
  std::string operator()(ast::Comprehension const& e) const {
    return fmt::format("(comprehension {} {} for {} in {})", e.aggregate.text, text_of(*e.element), e.variable.text,
                       text_of(*e.orbit));
  }
};

}  // namespace

std::string quoted(std::string const& text) {
  std::string result = "\"";
  for (char c : text) {
    if (c == '\n') {
      result += "\\n";
      continue;
    }
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result + '"';
}

std::string text_of(ast::Dimension const& dimension) {
  std::string result;
  for (auto const& term : dimension.terms) {
    if (term.negative) {
      result += '-';
    } else if (!result.empty()) {
      result += '+';
    }
    auto const* number = std::get_if<std::int64_t>(&term.value);
    result += number != nullptr ? fmt::format("{}", *number) : std::get<std::string>(term.value);
  }
  return result;
}

std::string text_of(ast::Word const& word) {
  std::string result = "[";
  for (auto const& letter : word.letters) {
    if (result.size() > 1) result += ',';
    result += ElementText{}(letter);
  }
  return result + ']';
}

std::string text_of(ast::OrbitElement const& element) { return std::visit(ElementText{}, element.value); }

std::string text_of(std::vector<ast::OrbitElement> const& elements) {
  std::string result;
  for (auto const& element : elements) {
    if (!result.empty()) result += ',';
    result += text_of(element);
  }
  return result;
}

std::string text_of(ast::OrbitType const& type) {
  if (auto const* list = std::get_if<ast::ElementList>(&type.value))
    return fmt::format("<{}>", text_of(list->elements));
  auto const& cell = std::get<ast::CellName>(type.value);
  if (cell.dimension) return fmt::format("{}({})", cell_name(cell.kind), text_of(*cell.dimension));
  return std::string(cell_name(cell.kind));
}

std::string text_of(ast::TypeName const& type) {
  return type.list ? fmt::format("[{}]", type.name.text) : type.name.text;
}

std::string text_of(ast::ModelRef const& model) {
  return model.dimension ? fmt::format("{}({})", model.name.text, text_of(*model.dimension)) : model.name.text;
}

std::string text_of(ast::Call const& call) {
  auto result = fmt::format("(call {}", call.function.text);
  for (std::size_t i = 0; i < call.dimensions.size(); ++i) {
    result += fmt::format("{}{}", i == 0 ? "[" : ",", text_of(call.dimensions[i]));
  }
  if (!call.dimensions.empty()) result += ']';
  for (auto const& argument : call.arguments) {
    result += ' ';
    if (argument.name) result += fmt::format("{}: ", argument.name->text);
    result += text_of(*argument.value);
  }
  return result + ')';
}

std::string text_of(ast::Expr const& expr) { return std::visit(ExprText{}, expr.value); }

}  // namespace jrule::syntax
