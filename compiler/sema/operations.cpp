#include "compiler/sema/operations.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

#include "compiler/sema/application.h"
#include "compiler/sema/expressions.h"
#include "compiler/sema/imports.h"
#include "compiler/sema/names.h"
#include "compiler/sema/overloads.h"
#include "compiler/sema/parameters.h"
#include "compiler/sema/types.h"

namespace jrule::sema {

using ir::ExprPtr;
using ir::ExprType;
using source::Code;
using source::Diagnostics;
using source::Label;
using source::Span;

namespace {

// What a call is given for: a hook, or a parameter.
struct Formal {
  std::string name;
  ExprType type;
  ExprPtr default_value;  // null if there is none
  bool is_hook;
};

std::vector<Formal> formals(std::vector<ir::Parameter> const& parameters) {
  std::vector<Formal> all;
  for (ir::Parameter const& p : parameters) {
    ExprPtr value = p.computed_default;
    if (p.default_value) value = std::make_shared<ir::Expr const>(ir::Expr{p.value_type(), ir::Constant{*p.default_value}, p.span});
    all.push_back({p.name, p.value_type(), std::move(value), false});
  }
  return all;
}

std::vector<Formal> hook_formals(ir::RuleScheme const& rule) {
  std::vector<Formal> all;
  for (ir::NodeId const hook : rule.hooks) all.push_back({rule.nodes[hook].name, ir::dart_type, nullptr, true});
  return all;
}

std::string counted(std::size_t count, std::string const& thing) { return fmt::format("{} {}{}", count, thing, count == 1 ? "" : "s"); }

// "1 dart and 2 values", "no arguments".
std::string summary(std::vector<Formal> const& formals) {
  auto const darts = static_cast<std::size_t>(std::count_if(formals.begin(), formals.end(), [](Formal const& f) { return f.type.dart; }));
  std::size_t const values = formals.size() - darts;
  if (formals.empty()) return "no arguments";
  if (values == 0) return counted(darts, "dart");
  return darts == 0 ? counted(values, "value") : fmt::format("{} and {}", counted(darts, "dart"), counted(values, "value"));
}

// One body.
struct Body {
  ast::Operation const& declared;
  std::size_t index;
  ir::Program& program;
  Callees& callees;
  Externs const& externs;
  Diagnostics& diagnostics;

  OperationItem const item = callees.operations()[index];
  ir::Operation operation = program.operations[index];
  algebra::Group const group{operation.model()};
  ir::RuleScheme const reader = ir::expression_scope(operation);
  OperationScope scope{&operation, &program, {}, {}, {}, [this](std::string const& name) { return callees.knows(*item.module, name); }};
  ExprContext const context{&reader, &group, &item.values, &externs, &scope};

  // ---- Reporting ----

  void report(Code code, Span span, std::string message, std::vector<Label> labels = {}, std::vector<std::string> notes = {}) {
    diagnostics.add({.code = code, .span = span, .message = std::move(message), .labels = std::move(labels), .notes = std::move(notes)});
  }

  ExprPtr value(ast::Expr const& expr, std::optional<ExprType> expected) { return check_expression(expr, context, expected, diagnostics); }

  // ---- Variables ----

  void collect_declarations(ast::Block const& block) {
    for (ast::Statement const& s : block) {
      if (auto const* let = std::get_if<ast::Let>(&s.value)) scope.declarations.emplace(let->name.text, let->name.span);
      if (auto const* loop = std::get_if<ast::ForOrbit>(&s.value)) {
        scope.declarations.emplace(loop->variable.text, loop->variable.span);
        collect_declarations(*loop->body);
      }
      if (auto const* loop = std::get_if<ast::While>(&s.value)) collect_declarations(*loop->body);
      if (auto const* branch = std::get_if<ast::If>(&s.value)) {
        collect_declarations(*branch->then_block);
        if (branch->else_block) collect_declarations(*branch->else_block);
      }
      if (auto const* attempt = std::get_if<ast::Try>(&s.value)) {
        collect_declarations(*attempt->body);
        collect_declarations(*attempt->otherwise);
      }
    }
  }

  std::size_t declare(ast::Name const& name, ExprType type, std::optional<std::size_t> result) {
    operation.variables.push_back({name.text, type, result, name.span});
    scope.visible[name.text] = operation.variables.size() - 1;
    return operation.variables.size() - 1;
  }

  bool is_fresh(ast::Name const& name) {
    auto const known = scope.visible.find(name.text);
    if (known == scope.visible.end()) return true;
    report(Code::duplicate_name, name.span, fmt::format("`{}` is declared already", name.text), {{operation.variables[known->second].span, "first declared here"}},
           {fmt::format("another value is given to it without `let`: `{} = …;`", name.text)});
    return false;
  }

  // ---- Calls ----

  // One expression for each formal, in their order; none, reported, if the arguments are not those.
  std::optional<std::vector<ExprPtr>> bind(ast::Call const& call, std::vector<Formal> const& formals) {
    std::string const& called = call.function.text;
    std::vector<ExprPtr> given(formals.size());
    std::vector<std::optional<Span>> places(formals.size());
    std::size_t next = 0;
    bool good = true, named = false;
    for (ast::Argument const& argument : call.arguments) {
      std::optional<std::size_t> place;
      if (argument.name) {
        named = true;
        place = find_formal(*argument.name, called, formals);
      } else if (named) {
        report(Code::bad_argument, argument.value->span, "an argument without a name stands behind one with a name", {},
               {"the first arguments are told apart by their order, the others by their names"});
      } else if (next < formals.size()) {
        place = next;
      }
      if (!argument.name && !named && next++ >= formals.size()) {
        value(*argument.value, {});
        continue;  // there are too many: told below
      }
      if (place && places[*place]) {
        report(Code::bad_argument, argument.value->span, fmt::format("`{}` of `{}` is given twice", formals[*place].name, called),
               {{*places[*place], "first given here"}});
        place.reset();
      }
      ExprPtr const expr = value(*argument.value, place ? std::optional(formals[*place].type) : std::nullopt);
      good = good && place && expr;
      if (!place) continue;
      places[*place] = argument.value->span;
      given[*place] = expr;
    }
    if (next > formals.size()) {
      report(Code::argument_count, call.function.span, fmt::format("`{}` takes {}, not {}", called, summary(formals), counted(next, "argument")), {},
             {takes(called, formals)});
      return {};
    }
    for (std::size_t i = 0; i < formals.size(); ++i) {
      if (places[i]) continue;
      given[i] = formals[i].default_value;
      if (given[i] || !good) continue;
      report(Code::argument_count, call.function.span,
             fmt::format("`{}` needs {} for its {} `{}`", called, formals[i].type.dart ? "a dart" : "a value", formals[i].is_hook ? "hook" : "parameter", formals[i].name), {},
             {takes(called, formals)});
      return {};
    }
    return good ? std::optional(std::move(given)) : std::nullopt;
  }

  // "it is called as `cone(a: Dart, apex: Point3)`".
  static std::string takes(std::string const& called, std::vector<Formal> const& formals) {
    std::vector<std::string> all;
    for (Formal const& f : formals) all.push_back(fmt::format("{}: {}{}", f.name, to_string(f.type), f.default_value ? " = …" : ""));
    return fmt::format("it is called as `{}({})`", called, fmt::join(all, ", "));
  }

  // A parameter of that name, else a hook.
  std::optional<std::size_t> find_formal(ast::Name const& name, std::string const& called, std::vector<Formal> const& formals) {
    for (bool const hook : {false, true}) {
      for (std::size_t i = 0; i < formals.size(); ++i) {
        if (formals[i].name == name.text && formals[i].is_hook == hook) return i;
      }
    }
    std::vector<std::string> known;
    for (Formal const& f : formals) known.push_back(f.name);
    if (known.empty()) {
      report(Code::bad_argument, name.span, fmt::format("`{}` takes no arguments", called));
    } else {
      report_not_found(diagnostics, Code::bad_argument, name, fmt::format("`{}` has no parameter or hook `{}`", called, name.text), known);
    }
    return {};
  }

  std::optional<ir::Origin> call(ast::Call const& written, Span span) {
    auto const callee = callees.find(index, written, diagnostics);
    if (!callee) {
      for (ast::Argument const& argument : written.arguments) value(*argument.value, {});
      return {};
    }
    if (!callee->is_rule) {
      auto arguments = bind(written, formals(program.operations[callee->index].parameters));
      return arguments ? std::optional<ir::Origin>(ir::OperationCall{callee->index, std::move(*arguments), span}) : std::nullopt;
    }
    ir::RuleScheme const& rule = program.rules[callee->index];
    std::vector<Formal> all = hook_formals(rule);
    for (Formal& f : formals(rule.parameters)) all.push_back(std::move(f));
    auto arguments = bind(written, all);
    if (!arguments) return {};
    auto const split = arguments->begin() + static_cast<std::ptrdiff_t>(program.rules[callee->index].hooks.size());
    return ir::RuleCall{callee->index, {arguments->begin(), split}, {split, arguments->end()}, span};
  }

  ast::Call const* callee_call(ast::Expr const& expr) const {
    auto const* call = std::get_if<ast::Call>(&expr.value);
    return call && callees.knows(*item.module, call->function.text) ? call : nullptr;
  }

  // What a variable gets: a value, or what a call gives.
  std::optional<ir::Origin> origin(ast::Expr const& expr, std::optional<ExprType> expected) {
    if (auto const* called = callee_call(expr)) {
      auto result = call(*called, expr.span);
      if (!result) return {};
      auto const* operation_call = std::get_if<ir::OperationCall>(&*result);
      if (!operation_call) return result;
      auto const& type = program.operations[operation_call->operation].result;
      if (!type) {
        report(Code::bad_result, expr.span, fmt::format("the operation `{}` has no result", called->function.text));
        return {};
      }
      if (!expected || *type == *expected) return result;
      report(Code::type_mismatch, expr.span, fmt::format("expected {}, `{}` gives {}", described(*expected), called->function.text, described(*type)));
      return {};
    }
    if (ExprPtr v = value(expr, expected)) return v;
    return {};
  }

  // ---- Statements ----

  std::optional<ir::Statement> statement(ast::Let const& let, Span span) {
    bool const fresh = is_fresh(let.name);
    auto given = origin(*let.value, {});
    if (!fresh) return {};
    if (!given) {
      scope.broken.insert(let.name.text);
      return {};
    }
    auto const* v = std::get_if<ExprPtr>(&*given);
    auto const* rule = std::get_if<ir::RuleCall>(&*given);
    auto const* called = std::get_if<ir::OperationCall>(&*given);
    ExprType const type = v ? (*v)->type : called ? *program.operations[called->operation].result : ExprType{};
    std::size_t const variable = declare(let.name, type, rule ? std::optional(rule->rule) : std::nullopt);
    return ir::Statement{ir::Set{variable, std::move(*given), true}, span};
  }

  std::optional<ir::Statement> statement(ast::Assign const& assign, Span span) {
    auto const* name = std::get_if<ast::NameExpr>(&assign.target->value);
    if (!name) {
      value(*assign.value, {});
      report(Code::bad_assignment, assign.target->span, "only a variable is assigned to", {},
             {"a value on the map, such as `d.position`, is changed by a rule that has a clause for it"});
      return {};
    }
    auto const known = scope.visible.find(name->name);
    if (known == scope.visible.end()) {
      value(*assign.value, {});
      value(*assign.target, {});  // says that it is not known
      return {};
    }
    ir::Variable const target = operation.variables[known->second];
    auto given = origin(*assign.value, target.result ? std::nullopt : std::optional(target.type));
    if (!given) return {};
    auto const* rule = std::get_if<ir::RuleCall>(&*given);
    std::optional<std::size_t> const result = rule ? std::optional(rule->rule) : std::nullopt;
    if (result != target.result) {
      auto const named = [&](std::optional<std::size_t> r) { return r ? fmt::format("the result of `{}`", program.rules[*r].name) : std::string("a value"); };
      report(Code::bad_result, assign.value->span, fmt::format("`{}` holds {}, this is {}", target.name, named(target.result), named(result)),
             {{target.span, "declared here"}});
      return {};
    }
    return ir::Statement{ir::Set{known->second, std::move(*given), false}, span};
  }

  std::optional<ir::Statement> statement(ast::If const& s, Span span) {
    ExprPtr condition = value(*s.condition, ExprType{Type::Bool});
    auto then_block = block(*s.then_block);
    auto else_block = s.else_block ? block(*s.else_block) : ir::Block{};
    if (!condition) return {};
    return ir::Statement{ir::If{std::move(condition), std::move(then_block), std::move(else_block)}, span};
  }

  std::optional<ir::Statement> statement(ast::ForOrbit const& s, Span span) {
    auto over = check_darts(*s.orbit, context, "a `for`", diagnostics);
    bool const fresh = is_fresh(s.variable);
    auto const outside = scope.visible;
    std::size_t const variable = declare(s.variable, ir::dart_type, {});
    auto body = block(*s.body);
    scope.visible = outside;
    if (!over || !fresh) return {};
    return ir::Statement{ir::For{variable, std::move(*over), std::move(body)}, span};
  }

  std::optional<ir::Statement> statement(ast::While const& s, Span span) {
    ExprPtr condition = value(*s.condition, ExprType{Type::Bool});
    auto body = block(*s.body);
    if (!condition) return {};
    return ir::Statement{ir::While{std::move(condition), std::move(body)}, span};
  }

  std::optional<ir::Statement> statement(ast::Return const& s, Span span) {
    if (s.value && !operation.result) {
      report(Code::bad_return, s.value->span, fmt::format("`{}` has no result to return", operation.name), {{operation.span, "declared without `->`"}},
             {fmt::format("declare its type: `operation {}(…) on {} -> Dart`", operation.name, operation.modeler->name)});
      return {};
    }
    if (!s.value && operation.result) {
      report(Code::bad_return, span, fmt::format("`{}` returns {}", operation.name, described(*operation.result)), {{operation.span, "declared here"}});
      return {};
    }
    if (!s.value) return ir::Statement{ir::Return{}, span};
    auto given = origin(*s.value, operation.result);
    if (!given) return {};
    if (auto const* rule = std::get_if<ir::RuleCall>(&*given)) {
      report(Code::bad_result, s.value->span, fmt::format("expected {}, this is the result of the rule `{}`", described(*operation.result), program.rules[rule->rule].name), {},
             {"choose a dart of it: `let r = …; return r.a;`"});
      return {};
    }
    return ir::Statement{ir::Return{std::move(*given)}, span};
  }

  std::optional<ir::Statement> statement(ast::Fail const& s, Span span) { return ir::Statement{ir::Fail{s.message}, span}; }

  std::optional<ir::Statement> statement(ast::Try const& s, Span span) {
    auto body = block(*s.body);
    auto otherwise = block(*s.otherwise);
    return ir::Statement{ir::Try{std::move(body), std::move(otherwise)}, span};
  }

  std::optional<ir::Statement> statement(ast::ApplyAll const& s, Span span) {
    auto const callee = callees.find(index, s.call, diagnostics);
    auto over = check_darts(*s.orbit, context, "`apply_all`", diagnostics);
    if (!callee) return {};
    if (!callee->is_rule) {
      report(Code::bad_apply_all, s.call.function.span, fmt::format("`{}` is an operation: only a rule is applied everywhere at once", s.call.function.text), {},
             {fmt::format("call it in turn: `for d in … {{ {}(d); }}`", s.call.function.text)});
      return {};
    }
    ir::RuleScheme const& rule = program.rules[callee->index];
    if (rule.hooks.size() != 1) {
      report(Code::bad_apply_all, s.call.function.span,
             rule.hooks.empty() ? fmt::format("`{}` has no hook, so there are no orbits to apply it at", rule.name)
                                : fmt::format("`{}` has {} hooks: there are no orbits to apply it at", rule.name, rule.hooks.size()),
             {{rule.span, "declared here"}}, {"`apply_all` takes rules with one hook"});
      return {};
    }
    auto const* orbit = std::get_if<ast::OrbitOf>(&s.orbit->value);
    if (over && orbit && orbit->by) {
      report(Code::bad_apply_all, orbit->by->span, "`apply_all` takes all of an orbit, without `by`", {},
             {fmt::format("`{}` is applied once for each orbit of its hook there", rule.name)});
      return {};
    }
    OrbitType const hook = rule.hook_orbit();
    auto const is_inside = [&](Word const& word) { return group.in_orbit(word, over->orbit); };
    if (over && !std::all_of(hook.words.begin(), hook.words.end(), is_inside)) {
      report(Code::orbit_not_inside, orbit->type.span,
             fmt::format("the orbits {} of the hook `{}` do not lie inside {}", jrule::to_string(hook), rule.nodes[rule.hooks[0]].name, jrule::to_string(over->orbit)),
             {{s.call.function.span, fmt::format("`{}` is applied at each of them", rule.name)}},
             {"`connected(d)` is all that is connected with d"});
      over.reset();
    }
    auto arguments = bind(s.call, formals(rule.parameters));
    if (!over || !arguments) return {};
    return ir::Statement{ir::ApplyAll{callee->index, std::move(*arguments), over->orbit, over->at, s.call.function.span}, span};
  }

  std::optional<ir::Statement> statement(ast::ExprStatement const& s, Span span) {
    auto const* called = std::get_if<ast::Call>(&s.value->value);
    bool const is_function = called && called->dimensions.empty() && (find_function(called->function.text) || externs.functions.contains(called->function.text));
    if (called && (callee_call(*s.value) || !is_function)) {
      auto given = call(*called, s.value->span);
      return given ? std::optional(ir::Statement{ir::Do{std::move(*given)}, span}) : std::nullopt;
    }
    if (value(*s.value, {})) {
      report(Code::no_effect, s.value->span, "this value is not used", {},
             {"a statement is a call of a rule or an operation, or says what happens to a value: `let x = …;`, `return …;`"});
    }
    return {};
  }

  ir::Block block(ast::Block const& statements) {
    auto const outside = scope.visible;
    ir::Block all;
    bool told = false;
    for (ast::Statement const& s : statements) {
      if (!all.empty() && ends(all.back()) && !told) {
        told = true;
        report(Code::unreachable_statement, s.span, "this statement is never reached", {{all.back().span, "nothing comes after this"}});
      }
      if (auto checked = std::visit([&](auto const& node) { return statement(node, s.span); }, s.value)) all.push_back(std::move(*checked));
    }
    scope.visible = outside;
    return all;
  }

  bool run() {
    std::size_t const errors_before = diagnostics.error_count();
    for (std::size_t i = 0; i < operation.parameters.size(); ++i) scope.visible[operation.parameters[i].name] = i;
    collect_declarations(declared.body);
    operation.body = block(declared.body);
    bool good = diagnostics.error_count() == errors_before;
    if (good && operation.result && !ends(operation.body)) {
      report(Code::missing_return, operation.span, fmt::format("`{}` may end without its result, {}", operation.name, described(*operation.result)), {},
             {"each way through it ends with `return` or `fail`"});
      good = false;
    }
    if (good) program.operations[index] = std::move(operation);
    return good;
  }
};

}  // namespace

std::optional<ir::Operation> declare_operation(ast::Operation const& declared, std::string const& name, std::string const& module,
                                               std::shared_ptr<ir::Modeler const> modeler, Externs const& externs, Diagnostics& diagnostics) {
  std::size_t const errors_before = diagnostics.error_count();
  ir::Operation operation;
  operation.name = name;
  operation.doc = declared.doc;
  operation.span = declared.name.span;
  operation.module = module;
  operation.modeler = std::move(modeler);
  operation.parameters = elaborate_parameters(declared.parameters, Darts::allowed, externs, diagnostics);
  for (ir::Parameter const& p : operation.parameters) operation.variables.push_back({p.name, p.value_type(), {}, p.span});
  if (declared.result) {
    bool const dart = declared.result->name.text == "Dart" && !declared.result->list;
    operation.result = dart ? std::optional(ir::dart_type) : resolve_stored_type(*declared.result, externs, diagnostics);
  }
  if (diagnostics.error_count() != errors_before) return {};
  return operation;
}

bool elaborate_body(std::size_t index, ir::Program& program, Callees& callees, Externs const& externs, Diagnostics& diagnostics) {
  ast::Operation const& declared = *callees.operations()[index].declared;
  auto const import = program.operations[index].import;
  if (!import) return Body{declared, index, program, callees, externs, diagnostics}.run();
  Diagnostics found;
  bool const good = Body{declared, index, program, callees, externs, found}.run();
  ir::Operation const& operation = program.operations[index];
  for (source::Diagnostic const& d : found.all()) {
    diagnostics.add(told_at_import(d, *import, operation.name, operation.module, operation.modeler->name));
  }
  return good;
}

}  // namespace jrule::sema
