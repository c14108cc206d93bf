#include "compiler/sema/counts.h"

#include <fmt/format.h>

#include "compiler/ir/rule_scheme.h"

namespace jrule::sema {

using ir::Count;
using ir::Fraction;
using source::Code;
using source::Span;

namespace {

class CountElaboration {
 public:
  CountElaboration(Model const& model, source::Diagnostics& diagnostics) : model_(model), diagnostics_(diagnostics) {}

  /// What `name` counts: cells of a dimension, or darts. None, reported, if nothing.
  std::optional<std::optional<int>> counted(std::string const& name, Span span) const {
    if (name == "D") return std::optional<int>();
    for (int i = 0; i < static_cast<int>(Count::named_cells); ++i) {
      if (name.size() != 1 || name[0] != ir::count_name(i)) continue;
      if (cell_orbit(model_, i)) return i;
      diagnostics_.add({.code = Code::no_such_cell, .span = span, .message = fmt::format("a {} has no {}-cells", ir::map_name(model_), i)});
      return {};
    }
    report(span, fmt::format("`{}` is no number of cells", name));
    return {};
  }

  std::optional<Count> count(ast::Expr const& expr) const {
    auto const value = unbounded(expr);
    if (!value || value->fits()) return value;
    report(expr.span, fmt::format("numbers in an `expect` are at most {}", Fraction::limit));
    return {};
  }

 private:
  void report(Span span, std::string message) const {
    diagnostics_.add({.code = Code::bad_expectation, .span = span, .message = std::move(message),
                      .notes = {"an `expect` says how many vertices (V), edges (E), faces (F), 3-cells (C) or darts (D) there are afterwards, as a "
                                "sum of multiples of those before: `expect V' = V + E + F;`, `expect E' = 4 * E;`"}});
  }

  std::optional<Count> unbounded(ast::Expr const& expr) const {
    if (auto const* literal = std::get_if<ast::IntLiteral>(&expr.value)) {
      if (Fraction const number{literal->value, 1}; number.fits()) return Count{.constant = number};
      return Count{.constant = {Fraction::limit + 1, 1}};
    }
    if (auto const* name = std::get_if<ast::NameExpr>(&expr.value)) {
      auto const what = counted(name->name, expr.span);
      if (!what) return {};
      Count result;
      (*what ? result.cells.at(static_cast<std::size_t>(**what)) : result.darts) = {1, 1};
      return result;
    }
    if (auto const* unary = std::get_if<ast::Unary>(&expr.value); unary && unary->op == ast::UnaryOp::negate) {
      auto const operand = count(*unary->operand);
      return operand ? Fraction{-1, 1} * *operand : operand;
    }
    if (auto const* binary = std::get_if<ast::Binary>(&expr.value)) return operation(*binary, expr.span);
    report(expr.span, "this is no sum of cells and darts");
    return {};
  }

  std::optional<Count> operation(ast::Binary const& binary, Span span) const {
    using Op = ast::BinaryOp;
    if (binary.op != Op::add && binary.op != Op::subtract && binary.op != Op::multiply && binary.op != Op::divide) {
      report(span, "this is no sum of cells and darts");
      return {};
    }
    auto const left = count(*binary.left), right = count(*binary.right);
    if (!left || !right) return {};
    if (binary.op == Op::add) return *left + *right;
    if (binary.op == Op::subtract) return *left + Fraction{-1, 1} * *right;
    if (binary.op == Op::multiply && left->is_constant()) return left->constant * *right;
    if (binary.op == Op::multiply && right->is_constant()) return right->constant * *left;
    if (binary.op == Op::divide && right->is_constant() && !right->constant.is_zero()) {
      return Fraction::of(right->constant.under, right->constant.over) * *left;
    }
    report(span, binary.op == Op::multiply ? "a number of cells is multiplied by a number only" : "a number of cells is divided by a number other than zero only");
    return {};
  }

  Model const& model_;
  source::Diagnostics& diagnostics_;
};

}  // namespace

std::optional<ir::Expectation> elaborate_expectation(ast::Expectation const& expectation, Model const& model, source::Diagnostics& diagnostics) {
  CountElaboration const elaboration(model, diagnostics);
  auto const counted = elaboration.counted(expectation.count.text, expectation.count.span);
  auto const count = elaboration.count(*expectation.value);
  if (!counted || !count) return {};
  return ir::Expectation{*counted, *count, expectation.span};
}

}  // namespace jrule::sema
