#include <fmt/format.h>

#include "compiler/ir/program.h"
#include "compiler/ir/verify_expr.h"

namespace jrule::ir {

namespace {

bool same_modeler(Modeler const& a, Modeler const& b) {
  return a.name == b.name && a.module == b.module && a.model == b.model && a.embeddings == b.embeddings;
}

struct Verification {
  Operation const& operation;
  Program const& program;
  RuleScheme const scope = expression_scope(operation);
  std::vector<bool> declared = std::vector<bool>(operation.variables.size(), false);

  Fault expr(ExprPtr const& e, std::optional<ExprType> const& expected) const {
    VisibleVariables const visible{operation.variables, declared, program.rules};
    if (Fault fault = verify_expr(scope, e, &visible)) return fault;
    if (!expected || e->type == *expected) return {};
    return fmt::format("an expression of type {} stands for a {}", to_string(e->type), to_string(*expected));
  }

  Fault arguments(std::vector<ExprPtr> const& given, std::vector<Parameter> const& parameters) const {
    if (given.size() != parameters.size()) return "a call has not a value for each parameter";
    for (std::size_t i = 0; i < given.size(); ++i) {
      if (Fault fault = expr(given[i], parameters[i].value_type())) return fault;
    }
    return {};
  }

  Fault rule(std::size_t index) const {
    if (index >= program.rules.size()) return "the rule of a call is out of range";
    return same_modeler(*program.rules[index].modeler, *operation.modeler) ? Fault{} : "a call is of a rule on another modeler";
  }

  Fault call(RuleCall const& c) const {
    if (Fault fault = rule(c.rule)) return fault;
    if (c.darts.size() != program.rules[c.rule].hooks.size()) return "a call has not a dart for each hook";
    for (ExprPtr const& dart : c.darts) {
      if (Fault fault = expr(dart, dart_type)) return fault;
    }
    return arguments(c.values, program.rules[c.rule].parameters);
  }
  Fault call(OperationCall const& c) const {
    if (c.operation >= program.operations.size()) return "the operation of a call is out of range";
    Operation const& called = program.operations[c.operation];
    if (!same_modeler(*called.modeler, *operation.modeler)) return "a call is of an operation on another modeler";
    return arguments(c.arguments, called.parameters);
  }

  // What is to become of the value: a variable of that type, or one that holds the result of that rule.
  Fault origin(Origin const& o, ExprType const& type, std::optional<std::size_t> result) const {
    if (auto const* e = std::get_if<ExprPtr>(&o)) return result ? Fault{"a value stands for the result of a rule"} : expr(*e, type);
    if (auto const* c = std::get_if<RuleCall>(&o)) return result == c->rule ? call(*c) : Fault{"the result of a rule stands for a value"};
    auto const& c = std::get<OperationCall>(o);
    if (Fault fault = call(c)) return fault;
    return !result && program.operations[c.operation].result == type ? Fault{} : "an operation's result is of another type";
  }

  Fault block(Block const& b) {
    std::vector<bool> const outside = declared;
    for (Statement const& s : b) {
      if (Fault fault = std::visit([&](auto const& statement) { return check(statement); }, s.value)) return fault;
    }
    declared = outside;
    return {};
  }

  Fault check(Set const& s) {
    if (s.variable >= operation.variables.size()) return "a variable is out of range";
    Variable const& variable = operation.variables[s.variable];
    if (declared[s.variable] == s.declares) return fmt::format("`{}` is set before or after its declaration", variable.name);
    if (Fault fault = origin(s.value, variable.type, variable.result)) return fault;
    declared[s.variable] = true;
    return {};
  }
  Fault check(Do const& s) {
    if (auto const* c = std::get_if<RuleCall>(&s.call)) return call(*c);
    auto const* c = std::get_if<OperationCall>(&s.call);
    return c ? call(*c) : Fault{"a statement is a value"};
  }
  Fault check(If const& s) {
    if (Fault fault = expr(s.condition, ExprType{Type::Bool})) return fault;
    if (Fault fault = block(s.then_block)) return fault;
    return block(s.else_block);
  }
  Fault check(For const& s) {
    if (s.variable >= operation.variables.size() || operation.variables[s.variable].type != dart_type) return "the variable of a `for` is no dart";
    if (Fault fault = expr(s.over.at, dart_type)) return fault;
    declared[s.variable] = true;
    Fault fault = block(s.body);
    declared[s.variable] = false;
    return fault;
  }
  Fault check(While const& s) {
    if (Fault fault = expr(s.condition, ExprType{Type::Bool})) return fault;
    return block(s.body);
  }
  Fault check(Return const& s) {
    if (s.value.has_value() != operation.result.has_value()) return "a `return` does not give what the operation gives";
    return s.value ? origin(*s.value, *operation.result, {}) : Fault{};
  }
  Fault check(Fail const&) { return {}; }
  Fault check(Try const& s) {
    if (Fault fault = block(s.body)) return fault;
    return block(s.otherwise);
  }
  Fault check(ApplyAll const& s) {
    if (Fault fault = rule(s.rule)) return fault;
    if (program.rules[s.rule].hooks.size() != 1) return "a rule without one hook is applied everywhere";
    if (Fault fault = arguments(s.values, program.rules[s.rule].parameters)) return fault;
    return expr(s.at, dart_type);
  }

  Fault run() {
    if (operation.parameters.size() > operation.variables.size()) return "a parameter is no variable";
    for (std::size_t i = 0; i < operation.parameters.size(); ++i) {
      if (operation.variables[i].type != operation.parameters[i].value_type()) return "a parameter and its variable differ";
      declared[i] = true;
    }
    if (Fault fault = block(operation.body)) return fault;
    return operation.result && !ends(operation.body) ? Fault{"the operation may end without its result"} : Fault{};
  }
};

}  // namespace

std::optional<std::string> verify(Operation const& operation, Program const& program) {
  if (!operation.modeler) return "the operation has no modeler";
  return Verification{operation, program}.run();
}

}  // namespace jrule::ir
