#include "compiler/analysis/operations.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "compiler/analysis/independence.h"

namespace jrule::analysis {

using source::Code;
using source::Diagnostic;

namespace {

Diagnostic refused(ir::Operation const& operation, ir::Called const& call, ir::RuleScheme const& rule, Refusal const& why) {
  return {.code = Code::refused_call, .span = call.span,
          .message = fmt::format("`{}` calls `{}`, which is refused: {}", operation.name, rule.name, why.diagnostic.message),
          .labels = {{rule.span, fmt::format("`{}` is declared here", rule.name)}},
          .notes = {fmt::format("`jrule explain {}` says more", source::info(why.diagnostic.code).number)}};
}

void check_independence(ir::Operation const& operation, ir::Block const& block, ir::Program const& program, std::vector<Verdict> const& verdicts,
                        std::vector<Diagnostic>& found) {
  for (ir::Statement const& statement : block) {
    for (ir::Block const* inner : ir::blocks(statement)) check_independence(operation, *inner, program, verdicts, found);
    auto const* everywhere = std::get_if<ir::ApplyAll>(&statement.value);
    if (!everywhere || !verdicts[everywhere->rule].accepted()) continue;
    ir::RuleScheme const& rule = program.rules[everywhere->rule];
    Independence const verdict = analyze_independence(rule, verdicts[everywhere->rule].plan);
    if (verdict.independent()) continue;
    Diagnostic d{.code = Code::dependent_rule, .span = everywhere->span,
                 .message = fmt::format("`{}` is not proved independent, so it cannot be applied everywhere at once", rule.name)};
    for (Dependence const& reason : verdict.reasons) {
      if (reason.span.file != source::no_file && d.labels.empty()) d.labels.push_back({reason.span, "because of this"});
      d.notes.push_back(reason.text);
    }
    d.notes.push_back(fmt::format("apply it in turn: `for d in … by … {{ {}(d); }}`", rule.name));
    found.push_back(std::move(d));
  }
}

// ---- Transactions ----

// Reading the map may fail, and so may whatever takes memory. To compute one value of others takes none, in the interpreter neither.
bool may_fail(ir::ExprPtr const& expr) {
  bool const computed = std::holds_alternative<ir::Constant>(expr->value) || std::holds_alternative<ir::VariableRef>(expr->value) ||
                        std::holds_alternative<ir::Apply>(expr->value) || std::holds_alternative<ir::Conditional>(expr->value);
  auto const* copy = std::get_if<ir::CopyOf>(&expr->value);
  if (copy && !copy->at) return false;
  if (!computed || expr->type.list || expr->type.external) return true;
  std::vector<ir::ExprPtr> const parts = ir::parts(*expr);
  return std::any_of(parts.begin(), parts.end(), may_fail);
}

// Follows the statements in their order.
struct Walk {
  bool changed = false;  // may the map differ from what it was where the block began?
  bool fails = false;    // may a statement fail after that?

  void fail_here() { fails = fails || changed; }

  void block(ir::Block const& statements) {
    for (ir::Statement const& s : statements) {
      auto const expressions = ir::expressions(s);
      if (std::any_of(expressions.begin(), expressions.end(), may_fail)) fail_here();
      std::visit([&](auto const& statement) { walk(statement); }, s.value);
    }
  }
  void call(ir::Origin const& origin) {
    if (std::holds_alternative<ir::ExprPtr>(origin)) return;
    fail_here();
    changed = true;
  }
  void walk(ir::Set const& s) { call(s.value); }
  void walk(ir::Do const& s) { call(s.call); }
  void walk(ir::Return const& s) {
    if (s.value) call(*s.value);
  }
  void walk(ir::Fail const&) { fail_here(); }
  void walk(ir::ApplyAll const&) {
    fail_here();
    changed = true;
  }
  void walk(ir::If const& s) { either(s.then_block, s.else_block); }
  // One of two blocks runs; behind them, it is one that does not end.
  void either(ir::Block const& first, ir::Block const& second) {
    Walk other = *this;
    block(first);
    other.block(second);
    changed = (changed && !ir::ends(first)) || (other.changed && !ir::ends(second));
    fails = fails || other.fails;
  }
  // What one round has changed, the next one may fail after.
  void loop(ir::Block const& body) {
    block(body);
    block(body);
  }
  void walk(ir::For const& s) {
    fail_here();  // the list of its darts
    loop(s.body);
  }
  void walk(ir::While const& s) {
    fail_here();
    bool const before = changed;
    loop(s.body);
    if (changed != before) fail_here();
  }
  // What fails in the body is undone, but for what ends the operation whatever is tried: running out of memory, being cancelled.
  void walk(ir::Try const& s) {
    fail_here();  // to remember what the variables were
    either(s.body, s.otherwise);
  }
};

}  // namespace

std::vector<Diagnostic> check_calls(ir::Operation const& operation, ir::Program const& program, std::vector<Verdict> const& verdicts) {
  std::vector<Diagnostic> found;
  std::set<std::size_t> told;
  for (ir::Called const& call : ir::calls(operation.body)) {
    if (!call.is_rule || verdicts[call.index].accepted() || !told.insert(call.index).second) continue;
    found.push_back(refused(operation, call, program.rules[call.index], verdicts[call.index].refusals.front()));
  }
  check_independence(operation, operation.body, program, verdicts, found);
  return found;
}

bool may_fail_after_change(ir::Block const& block) {
  Walk walk;
  walk.block(block);
  return walk.fails;
}

}  // namespace jrule::analysis
