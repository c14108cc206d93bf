#include <fmt/format.h>
#include <fmt/ranges.h>

#include "compiler/ir/program.h"

namespace jrule::ir {

namespace {

struct Printer {
  Operation const& operation;
  Program const& program;
  RuleScheme const scope = expression_scope(operation);
  std::string text{};

  void line(std::size_t depth, std::string const& words) { text += std::string(2 * depth, ' ') + words + '\n'; }

  std::string expr(ExprPtr const& e) const { return ir::print(*e, scope); }
  std::string list(std::vector<ExprPtr> const& all) const {
    std::vector<std::string> texts;
    for (ExprPtr const& e : all) texts.push_back(expr(e));
    return fmt::format("{}", fmt::join(texts, ", "));
  }
  std::string origin(Origin const& o) const {
    if (auto const* e = std::get_if<ExprPtr>(&o)) return expr(*e);
    if (auto const* call = std::get_if<RuleCall>(&o)) {
      return fmt::format("rule {} at ({}) with ({})", program.rules[call->rule].name, list(call->darts), list(call->values));
    }
    auto const& call = std::get<OperationCall>(o);
    return fmt::format("operation {}({})", program.operations[call.operation].name, list(call.arguments));
  }

  void block(std::size_t depth, Block const& b) {
    for (Statement const& s : b) {
      std::visit([&](auto const& statement) { print(depth, statement); }, s.value);
    }
  }
  void print(std::size_t depth, Set const& s) {
    line(depth, fmt::format("{}{} = {}", s.declares ? "let " : "", operation.variables[s.variable].name, origin(s.value)));
  }
  void print(std::size_t depth, Do const& s) { line(depth, origin(s.call)); }
  void print(std::size_t depth, If const& s) {
    line(depth, "if " + expr(s.condition));
    block(depth + 1, s.then_block);
    if (s.else_block.empty()) return;
    line(depth, "else");
    block(depth + 1, s.else_block);
  }
  void print(std::size_t depth, For const& s) {
    line(depth, fmt::format("for {} in {}({} by {})", operation.variables[s.variable].name, jrule::to_string(s.over.orbit), expr(s.over.at),
                            jrule::to_string(s.over.by)));
    block(depth + 1, s.body);
  }
  void print(std::size_t depth, While const& s) {
    line(depth, "while " + expr(s.condition));
    block(depth + 1, s.body);
  }
  void print(std::size_t depth, Return const& s) { line(depth, s.value ? "return " + origin(*s.value) : "return"); }
  void print(std::size_t depth, Fail const& s) { line(depth, fmt::format("fail \"{}\"", s.message)); }
  void print(std::size_t depth, Try const& s) {
    line(depth, "try");
    block(depth + 1, s.body);
    line(depth, "else");
    block(depth + 1, s.otherwise);
  }
  void print(std::size_t depth, ApplyAll const& s) {
    line(depth, fmt::format("apply_all rule {} with ({}) on {}({})", program.rules[s.rule].name, list(s.values), jrule::to_string(s.orbit),
                            expr(s.at)));
  }

  std::string run() {
    line(0, fmt::format("operation {} on {}{}", operation.name, operation.modeler->name,
                        operation.result ? " -> " + to_string(*operation.result) : ""));
    for (Parameter const& p : operation.parameters) text += print_parameter(p);
    block(1, operation.body);
    return std::move(text);
  }
};

}  // namespace

std::string print(Operation const& operation, Program const& program) { return Printer{operation, program}.run(); }

}  // namespace jrule::ir
