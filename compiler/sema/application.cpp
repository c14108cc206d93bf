#include "compiler/sema/application.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "compiler/ir/evaluate.h"
#include "compiler/sema/overloads.h"

namespace jrule::sema {

using ir::Builtin;
using ir::ExprPtr;
using ir::ExprType;
using source::Code;
using source::Diagnostics;
using source::Label;
using source::Span;

namespace {

char const* const read_it = "a value at a dart is read with a dot: `a.position`";

bool is_point(ExprPtr const& expr) { return expr->type.element == Type::Point2 || expr->type.element == Type::Point3; }

/// What the operator takes, or what to do instead of it.
std::vector<std::string> advice(Builtin op, std::vector<ExprPtr> const& operands) {
  if (std::any_of(operands.begin(), operands.end(), [](ExprPtr const& e) { return e->type.dart; })) return {read_it};
  if (op == Builtin::add && std::all_of(operands.begin(), operands.end(), is_point)) {
    return {"`midpoint(a, b)`, `mean(…)` and `lerp(a, b, t)` mix points"};
  }
  bool const scales = op == Builtin::multiply || op == Builtin::divide || op == Builtin::negate;
  if (scales && std::any_of(operands.begin(), operands.end(), is_point)) {
    return {"a point is a place and has no multiples; a vector has: `a + t * (b - a)`, which is `lerp(a, b, t)`"};
  }
  bool const vectors = std::all_of(operands.begin(), operands.end(),
                                   [](ExprPtr const& e) { return e->type.element == Type::Vec2 || e->type.element == Type::Vec3; });
  switch (op) {
    case Builtin::multiply:
      if (!vectors) return {};
      return {"two vectors have the products `dot(v, w)` and, in space, `cross(v, w)`"};
    case Builtin::logical_and:
    case Builtin::logical_or:
    case Builtin::logical_not: return {"it takes a `Bool`, such as a comparison: `n > 0`"};
    case Builtin::less:
    case Builtin::less_equal:
    case Builtin::greater:
    case Builtin::greater_equal: return {"only an `Int` or a `Real` is less or greater than another"};
    case Builtin::equal:
    case Builtin::not_equal: return {"it compares values of one type, or an `Int` with a `Real`"};
    default: return {};
  }
}

/// "it is defined as `dot(Vec2, Vec2)`, `dot(Vec3, Vec3)`"
std::string definitions(Builtin function) {
  std::vector<std::string> all;
  for (Signature const& s : signatures(function)) {
    std::vector<std::string> parameters;
    for (ExprType const& type : s.parameters) parameters.push_back(to_string(type));
    all.push_back(fmt::format("`{}({})`", spelling(function), fmt::join(parameters, ", ")));
  }
  return fmt::format("it is defined as {}", fmt::join(all, ", "));
}

bool is_function(Builtin builtin) { return find_function(std::string(spelling(builtin))).has_value(); }

/// Reports the arguments that are lists where no signature has one, or the reverse.
bool check_lists(Builtin function, std::vector<ExprPtr> const& arguments, Diagnostics& diagnostics) {
  bool good = true;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    ExprType const& type = arguments[i]->type;
    bool const fits = std::any_of(signatures(function).begin(), signatures(function).end(), [&](Signature const& s) {
      return s.parameters.size() == arguments.size() && s.parameters[i].list == type.list;
    });
    if (fits) continue;
    good = false;
    if (type.list) {
      report_list(std::string(spelling(function)), *arguments[i], diagnostics);
    } else {
      diagnostics.add({.code = Code::type_mismatch,
                       .span = arguments[i]->span,
                       .message = fmt::format("`{}` needs a list, this is {}", spelling(function), described(type)),
                       .notes = {"a list is what an orbit gives: `<0,1>(a).position`"}});
    }
  }
  return good;
}

void report_types(Builtin function, Span name, std::vector<ExprPtr> const& arguments, Diagnostics& diagnostics) {
  std::string types;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    std::string_view const separator = i == 0 ? "" : i + 1 == arguments.size() ? " and " : ", ";
    types += fmt::format("{}`{}`", separator, to_string(arguments[i]->type));
  }
  source::Diagnostic d{.code = Code::no_operator,
                       .span = name,
                       .message = fmt::format("`{}` is not defined for {}", spelling(function), types),
                       .labels = type_labels(arguments),
                       .notes = {}};
  bool const has_extern = std::any_of(arguments.begin(), arguments.end(), [](auto const& a) { return a->type.external != nullptr; });
  if (has_extern) {
    d.notes.push_back("of values of an extern type only `first` and `count` are known; the rest is for an `extern fn`");
  } else {
    d.notes = advice(function, arguments);
    if (is_function(function)) d.notes.push_back(definitions(function));
  }
  diagnostics.add(std::move(d));
}

void warn_of_zero(Span op, ir::Expr const& divisor, Diagnostics& diagnostics) {
  auto const* constant = std::get_if<ir::Constant>(&divisor.value);
  if (!constant || constant->value != Value{0.0}) return;
  diagnostics.add({.code = Code::division_by_zero,
                   .span = op,
                   .message = "division by the constant zero",
                   .labels = {{divisor.span, "this is zero"}},
                   .notes = {"the quotient is infinite, or no number at all"}});
}

}  // namespace

std::string described(ExprType const& type) {
  if (type.list) return fmt::format("a list `{}`", to_string(type));
  std::string const name = to_string(type);
  bool const vowel = std::string_view("AEIO").find(name.front()) != std::string_view::npos;
  return fmt::format("{} `{}`", vowel ? "an" : "a", name);
}

std::vector<Label> type_labels(std::vector<ExprPtr> const& operands) {
  std::vector<Label> labels;
  for (ExprPtr const& operand : operands) labels.push_back({operand->span, "this is " + described(operand->type)});
  return labels;
}

std::string aggregate_it(ExprType const& list) {
  switch (list.element) {
    case Type::Bool: return "aggregate it: `all(…)`, `any(…)`";
    case Type::Extern: return "aggregate it: `first(…)`, or an `extern fn` that takes a list";
    default: return "aggregate it: `mean(…)`, `first(…)`";
  }
}

ExprPtr report_list(std::string const& user, ir::Expr const& argument, Diagnostics& diagnostics) {
  diagnostics.add({.code = Code::type_mismatch,
                   .span = argument.span,
                   .message = fmt::format("`{}` needs one value, this is {}", user, described(argument.type)),
                   .notes = {aggregate_it(argument.type)}});
  return {};
}

bool is_taken_as(ExprType const& argument, ExprType const& expected) {
  return argument == expected || (argument == ExprType{Type::Int} && expected == ExprType{Type::Real});
}

ExprPtr convert(ExprPtr value, ExprType expected, Diagnostics& diagnostics) {
  if (value->type == expected) return value;
  Span const span = value->span;
  if (value->type == ExprType{Type::Int} && expected == ExprType{Type::Real}) {
    return ir::fold({expected, ir::Apply{Builtin::to_real, {std::move(value)}}, span});
  }
  source::Diagnostic d{.code = Code::type_mismatch,
                       .span = span,
                       .message = fmt::format("expected {}, this is {}", described(expected), described(value->type))};
  if (value->type.list && !expected.list) d.notes.push_back(aggregate_it(value->type));
  if (value->type.dart) d.notes.push_back(read_it);
  diagnostics.add(std::move(d));
  return {};
}

bool check_argument_count(Builtin function, Span name, std::size_t count, Diagnostics& diagnostics) {
  std::vector<std::size_t> counts;
  for (Signature const& s : signatures(function)) counts.push_back(s.parameters.size());
  if (std::find(counts.begin(), counts.end(), count) != counts.end()) return true;
  auto const [least, most] = std::minmax_element(counts.begin(), counts.end());
  std::string const wanted = *least == *most ? fmt::format("{}", *least) : fmt::format("{} or {}", *least, *most);
  diagnostics.add({.code = Code::argument_count,
                   .span = name,
                   .message = fmt::format("`{}` takes {} argument{}, not {}", spelling(function), wanted,
                                          *most == 1 ? "" : "s", count),
                   .notes = {definitions(function)}});
  return false;
}

ExprPtr apply(Builtin function, Span name, std::vector<ExprPtr> arguments, Span span, Diagnostics& diagnostics) {
  // What the table cannot have a row for: these two take a list of any extern type.
  bool const any_list = function == Builtin::first || function == Builtin::count;
  if (ExprType type = arguments.front()->type; any_list && type.list && type.external) {
    type.list = false;
    if (function == Builtin::count) type = ExprType{Type::Int};
    return std::make_shared<ir::Expr const>(ir::Expr{std::move(type), ir::Apply{function, std::move(arguments)}, span});
  }
  std::vector<ExprType> types;
  for (ExprPtr const& argument : arguments) types.push_back(argument->type);
  Signature const* const signature = find_signature(function, types);
  if (!signature) {
    if (check_lists(function, arguments, diagnostics)) report_types(function, name, arguments, diagnostics);
    return {};
  }
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    arguments[i] = convert(std::move(arguments[i]), signature->parameters[i], diagnostics);
  }
  if (function == Builtin::divide) warn_of_zero(name, *arguments[1], diagnostics);
  return ir::fold({signature->result, ir::Apply{function, std::move(arguments)}, span});
}

}  // namespace jrule::sema
