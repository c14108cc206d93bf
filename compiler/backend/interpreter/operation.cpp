#include "compiler/backend/interpreter/operation.h"

#include <fmt/format.h>

#include <map>
#include <new>
#include <stdexcept>

#include "compiler/analysis/operations.h"
#include "compiler/backend/interpreter/evaluate.h"
#include "compiler/backend/interpreter/interpreter.h"

namespace jrule::interpreter {

namespace {

using operation::Failure;
using operation::Undo;

// What all calls of one run share.
struct Machine {
  Runnable const& runnable;
  Map& map;
  rewrite::Workspace& workspace;
  operation::Run run;
  std::map<ir::Block const*, bool> copies{};  // blocks that may fail after they have changed the map, as far as they were met

  bool is_copied(ir::Block const& block) {
    auto const [known, fresh] = copies.try_emplace(&block);
    if (fresh) known->second = analysis::may_fail_after_change(block);
    return known->second;
  }

  Local call(std::size_t index, std::vector<ir::Evaluated> const& arguments);
};

// One call of an operation. How it went on after a statement: nothing, or what it returned.
struct Frame {
  Machine& machine;
  ir::Operation const& operation;
  ir::RuleScheme const reader = ir::expression_scope(operation);
  Locals locals{operation.name, std::vector<Local>(operation.variables.size())};
  std::optional<Local> returned{};

  // ---- Expressions and calls ----

  ir::Evaluated value(ir::Expr const& expr) const { return evaluate(expr, {machine.map, reader, {}, {}, {}, &locals}, 0); }
  bool holds(ir::ExprPtr const& condition) const { return std::get<bool>(std::get<Value>(value(*condition))); }
  Dart dart(ir::ExprPtr const& expr) const { return std::get<Dart>(value(*expr)); }
  /// Where the map is read.
  Dart dart_in_map(ir::ExprPtr const& expr) const { return operation::alive(machine.map, dart(expr), operation.name); }
  std::vector<Value> values(std::vector<ir::ExprPtr> const& all) const {
    std::vector<Value> result;
    for (ir::ExprPtr const& e : all) result.push_back(std::get<Value>(value(*e)));
    return result;
  }

  Local call(ir::RuleCall const& c) {
    ir::RuleScheme const& rule = machine.runnable.program.rules[c.rule];
    machine.run.step();
    std::vector<Dart> darts;
    for (ir::ExprPtr const& d : c.darts) darts.push_back(dart(d));
    std::vector<Value> const arguments = values(c.values);
    Applied applied = machine.run.applied(
        interpreter::apply(rule, machine.runnable.verdicts[c.rule].plan, machine.map, darts, arguments, machine.workspace));
    // Nothing here may fail any more: the map has changed.
    bool const keeps_pattern = !rule.hooks.empty() && !rule.nodes[rule.hooks[0]].deleted();
    return CallResult{c.rule, keeps_pattern ? std::optional(rule.hooks[0]) : std::nullopt, std::move(applied.copies)};
  }
  Local call(ir::OperationCall const& c) {
    std::vector<ir::Evaluated> arguments;
    for (ir::ExprPtr const& e : c.arguments) arguments.push_back(value(*e));
    return machine.call(c.operation, arguments);
  }
  Local call(ir::ExprPtr const& e) { return value(*e); }
  Local from(ir::Origin const& origin) {
    return std::visit([&](auto const& o) { return call(o); }, origin);
  }

  // ---- Statements ----

  void block(ir::Block const& statements) {
    for (ir::Statement const& s : statements) {
      std::visit([&](auto const& statement) { execute(statement); }, s.value);
      if (returned) return;
    }
  }

  void execute(ir::Set const& s) { locals.variables[s.variable] = from(s.value); }
  void execute(ir::Do const& s) { from(s.call); }
  void execute(ir::If const& s) { block(holds(s.condition) ? s.then_block : s.else_block); }
  void execute(ir::For const& s) {
    for (Dart const d : rewrite::representatives(machine.map, s.over.orbit, s.over.by, dart_in_map(s.over.at))) {
      if (!machine.map.contains(d)) continue;
      locals.variables[s.variable] = ir::Evaluated(d);
      block(s.body);
      if (returned) return;
    }
  }
  void execute(ir::While const& s) {
    while (!returned && holds(s.condition)) {
      machine.run.step();
      block(s.body);
    }
  }
  void execute(ir::Return const& s) { returned = s.value ? from(*s.value) : Local{}; }
  void execute(ir::Fail const& s) { operation::fail(operation.name, s.message); }
  void execute(ir::Try const& s) {
    if (!attempt(s.body)) block(s.otherwise);
  }
  void execute(ir::ApplyAll const& s) {
    ir::RuleScheme const& rule = machine.runnable.program.rules[s.rule];
    machine.run.step();
    std::vector<Value> const arguments = values(s.values);
    Dart const at = dart_in_map(s.at);
    machine.run.applied_everywhere(
        interpreter::apply_all_within(rule, machine.runnable.verdicts[s.rule].plan, machine.map, s.orbit, at, arguments, machine.workspace));
  }

  // False if it failed, and then the map and the variables are as they were.
  bool attempt(ir::Block const& body) {
    std::vector<std::pair<std::size_t, Local>> before;
    for (std::size_t const variable : ir::assigned(body)) before.emplace_back(variable, locals.variables[variable]);
    try {
      Undo const undo(machine.run, machine.map, machine.is_copied(body) ? Undo::Of::attempt : Undo::Of::call);
      block(body);
      return true;
    } catch (Failure const& failure) {
      if (!failure.is_tried()) throw;
    }
    for (auto& [variable, value] : before) locals.variables[variable] = std::move(value);
    return false;
  }
};

Local Machine::call(std::size_t index, std::vector<ir::Evaluated> const& arguments) {
  ir::Operation const& operation = runnable.program.operations[index];
  operation::Call const call(run, operation.name);
  std::optional<Undo> undo;
  if (is_copied(operation.body)) undo.emplace(run, map, Undo::Of::operation);
  Frame frame{*this, operation};
  for (std::size_t i = 0; i < arguments.size(); ++i) frame.locals.variables[i] = arguments[i];
  frame.block(operation.body);
  return frame.returned.value_or(Local{});
}

bool fits(ir::Evaluated const& argument, ir::Parameter const& parameter) {
  if (parameter.dart) return std::holds_alternative<Dart>(argument);
  auto const* value = std::get_if<Value>(&argument);
  return value && type_of(*value) == parameter.type;
}

Result<void> check_input(ir::Operation const& operation, Map const& map, std::vector<ir::Evaluated> const& arguments) {
  if (auto const checked = rewrite::check_modeler(map, operation.model(), operation.modeler->embeddings); !checked) return checked;
  bool good = arguments.size() == operation.parameters.size();
  for (std::size_t i = 0; good && i < arguments.size(); ++i) good = fits(arguments[i], operation.parameters[i]);
  if (good) return {};
  return fail(Error::Kind::bad_input, fmt::format("the arguments of `{}` are not those of its {} parameters", operation.name, operation.parameters.size()));
}

}  // namespace

Result<std::optional<ir::Evaluated>> run(Runnable const& runnable, std::size_t index, Map& map, std::vector<ir::Evaluated> const& arguments,
                                         rewrite::Workspace& workspace, operation::Progress const& progress, std::size_t* applications) {
  ir::Operation const& operation = runnable.program.operations[index];
  if (auto const checked = check_input(operation, map, arguments); !checked) return tl::unexpected(checked.error());
  try {
    Machine machine{runnable, map, workspace, operation::Run(operation.name, progress)};
    Local const result = machine.call(index, arguments);
    if (applications) *applications = machine.run.applications();
    auto const* value = std::get_if<ir::Evaluated>(&result);
    return value ? std::optional(*value) : std::nullopt;
  } catch (Failure const& failure) {
    return tl::unexpected(failure.error);
  } catch (std::bad_alloc const&) {
    return tl::unexpected(rewrite::no_memory(operation.name));
  } catch (std::length_error const&) {
    return tl::unexpected(rewrite::no_memory(operation.name));
  }
}

}  // namespace jrule::interpreter
