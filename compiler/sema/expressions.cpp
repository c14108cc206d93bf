#include "compiler/sema/expressions.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <numbers>

#include "compiler/ir/evaluate.h"
#include "compiler/sema/application.h"
#include "compiler/sema/externs.h"
#include "compiler/sema/names.h"
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

ExprType const boolean{Type::Bool}, real{Type::Real}, integer{Type::Int};

template <class Node>
ExprPtr make(ExprType type, Node node, Span span) {
  return std::make_shared<ir::Expr const>(ir::Expr{type, std::move(node), span});
}

Builtin builtin_of(ast::BinaryOp op) {
  // In the order of ast::BinaryOp.
  static constexpr std::array builtins{
      Builtin::add,     Builtin::subtract,   Builtin::multiply, Builtin::divide,
      Builtin::less,    Builtin::less_equal, Builtin::greater,  Builtin::greater_equal,
      Builtin::equal,   Builtin::not_equal,  Builtin::logical_and, Builtin::logical_or};
  static_assert(builtins.size() == static_cast<std::size_t>(ast::BinaryOp::logical_or) + 1);
  return builtins[static_cast<std::size_t>(op)];
}

// Recursive: the parser bounds the depth of an expression.
class Checker {
 public:
  Checker(ExprContext const& context, Diagnostics& diagnostics) : context_(context), diagnostics_(diagnostics) {}

  /// The typed value of the expression, constants folded; null, reported, if it is none.
  ExprPtr check(ast::Expr const& expr) {
    return std::visit([&](auto const& node) { return check(node, expr.span); }, expr.value);
  }

  /// The darts of the orbit that `user` ranges over.
  std::optional<ir::Darts> range(ast::Expr const& expr, std::string const& user) {
    if (auto const* orbit = std::get_if<ast::OrbitOf>(&expr.value)) return darts(*orbit);
    if (ExprPtr const value = check(expr)) {
      report(Code::type_mismatch, expr.span,
             fmt::format("{} ranges over an orbit, this is {}", user, described(value->type)), {},
             {"an orbit is written with its type and a dart: `<1,2>(a)`, `<1,2>(a) by <1>`"});
    }
    return {};
  }

 private:
  struct Pi {};
  using Meaning = std::variant<ir::Bound, ir::VariableRef, ir::ParameterRef, ir::LetRef, ir::NodeDart, Pi>;

  ExprPtr report(Code code, Span span, std::string message, std::vector<Label> labels = {},
                 std::vector<std::string> notes = {}) {
    diagnostics_.add({.code = code, .span = span, .message = std::move(message), .labels = std::move(labels),
                      .notes = std::move(notes)});
    return {};
  }

  // ---- Names ----

  std::optional<Meaning> find(std::string const& name) const {
    auto const position = [&](auto const& declared) {
      auto const found = std::find_if(declared.begin(), declared.end(), [&](auto const& d) { return d.name == name; });
      return found == declared.end() ? std::nullopt : std::optional(static_cast<std::size_t>(found - declared.begin()));
    };
    for (std::size_t level = 0; level < variables_.size(); ++level) {
      if (variables_[level].text == name) return ir::Bound{level, name};
    }
    if (auto const variable = find_variable(name)) return *variable;
    if (context_.rule) {
      if (auto const i = position(context_.rule->parameters)) return ir::ParameterRef{*i};
      if (auto const i = position(context_.rule->lets)) return ir::LetRef{*i};
      if (auto const i = position(context_.rule->nodes)) return ir::NodeDart{static_cast<ir::NodeId>(*i)};
    }
    if (name == "pi") return Pi{};
    return {};
  }

  std::optional<ir::VariableRef> find_variable(std::string const& name) const {
    if (!context_.operation) return {};
    auto const found = context_.operation->visible.find(name);
    return found == context_.operation->visible.end() ? std::nullopt : std::optional(ir::VariableRef{found->second, name});
  }
  ir::Variable const& variable(ir::VariableRef const& ref) const { return context_.operation->operation->variables[ref.index]; }
  ir::RuleScheme const& called(ir::Variable const& result) const { return context_.operation->program->rules[*result.result]; }

  /// What the name means; none, reported, if it means nothing in an expression.
  std::optional<Meaning> resolve(std::string const& name, Span span) {
    std::optional<Meaning> const meaning = find(name);
    if (!meaning) {
      report_unknown_name(name, span);
      return {};
    }
    auto const* node = std::get_if<ir::NodeDart>(&*meaning);
    if (!node || !context_.rule->nodes[node->node].added()) return meaning;
    report(Code::unknown_value, span, fmt::format("`{}` is a node of the right side only", name),
           {{context_.rule->nodes[node->node].span(), fmt::format("`{}` is added here", name)}},
           {"an expression sees the map before the rule is applied"});
    return {};
  }

  void report_unknown_name(std::string const& name, Span span) {
    if (report_undeclared(name, span)) return;
    if (find_function(name) || (context_.externs && context_.externs->functions.contains(name))) {
      report(Code::unknown_value, span, fmt::format("`{}` is a function, not a value", name), {},
             {fmt::format("it is called with its arguments: `{}(…)`", name)});
      return;
    }
    if (!context_.rule) {
      report(Code::unknown_value, span, fmt::format("a default is a constant: it cannot read `{}`", name));
      return;
    }
    std::vector<std::string> known;
    for (ast::Name const& variable : variables_) known.push_back(variable.text);
    if (context_.operation) {
      for (auto const& [variable, index] : context_.operation->visible) known.push_back(variable);
    }
    for (ir::Parameter const& p : context_.rule->parameters) known.push_back(p.name);
    for (ir::Let const& l : context_.rule->lets) known.push_back(l.name);
    for (ir::Node const& n : context_.rule->nodes) {
      if (!n.added()) known.push_back(n.name);
    }
    known.push_back("pi");
    report_unknown(diagnostics_, Code::unknown_value, {name, span}, "value", known);
  }

  /// Names of an operation that mean something elsewhere in it, or in a call.
  bool report_undeclared(std::string const& name, Span span) {
    if (!context_.operation) return false;
    if (context_.operation->broken.contains(name)) return true;
    auto const& declarations = context_.operation->declarations;
    if (auto const declared = declarations.find(name); declared != declarations.end()) {
      bool const later = span.begin < declared->second.begin;
      report(Code::unknown_value, span,
             later ? fmt::format("`{}` is used before it is declared", name) : fmt::format("`{}` is not known behind the block that declares it", name),
             {{declared->second, "declared here"}});
      return true;
    }
    if (!context_.operation->is_callee(name)) return false;
    report(Code::unknown_value, span, fmt::format("`{}` is a rule or an operation, not a value", name), {},
           {fmt::format("it is called with its arguments: `{}(…);`", name)});
    return true;
  }

  // ---- Leaves ----

  ExprPtr check(ast::BoolLiteral const& literal, Span span) { return make(boolean, ir::Constant{literal.value}, span); }
  ExprPtr check(ast::IntLiteral const& literal, Span span) { return make(integer, ir::Constant{literal.value}, span); }
  ExprPtr check(ast::RealLiteral const& literal, Span span) { return make(real, ir::Constant{literal.value}, span); }
  ExprPtr check(ast::StringLiteral const&, Span span) {
    return report(Code::type_mismatch, span, "a string is not a value of an expression", {},
                  {"values are of type Bool, Int, Real, Vec2, Vec3, Point2, Point3 or Color"});
  }

  ExprPtr check(ast::NameExpr const& expr, Span span) {
    std::optional<Meaning> const meaning = resolve(expr.name, span);
    if (!meaning) return {};
    if (auto const* v = std::get_if<ir::VariableRef>(&*meaning)) {
      if (variable(*v).result) return report_result(*v, span);
      return make(variable(*v).type, *v, span);
    }
    if (auto const* p = std::get_if<ir::ParameterRef>(&*meaning)) {
      return make(context_.rule->parameters[p->index].value_type(), *p, span);
    }
    if (auto const* l = std::get_if<ir::LetRef>(&*meaning)) {
      ir::Expr const& value = *context_.rule->lets[l->index].value;
      if (auto const* constant = std::get_if<ir::Constant>(&value.value)) return make(value.type, *constant, span);
      return make(value.type, *l, span);
    }
    if (auto const* n = std::get_if<ir::NodeDart>(&*meaning)) return make(ir::dart_type, *n, span);
    if (auto const* b = std::get_if<ir::Bound>(&*meaning)) return make(ir::dart_type, *b, span);
    return make(real, ir::Constant{std::numbers::pi}, span);
  }

  // ---- Results of rules ----

  ExprPtr report_result(ir::VariableRef const& result, Span span) {
    ir::RuleScheme const& rule = called(variable(result));
    std::vector<std::string> darts = right_nodes(rule);
    for (std::string& d : darts) d = fmt::format("`{}.{}`", result.name, d);
    return report(Code::bad_result, span, fmt::format("`{}` is the result of `{}`, not a value", result.name, rule.name), {},
                  {darts.empty() ? fmt::format("`{}` leaves no darts", rule.name)
                                 : fmt::format("the darts of its right side are {}", fmt::join(darts, ", "))});
  }

  static std::vector<std::string> right_nodes(ir::RuleScheme const& rule) {
    std::vector<std::string> names;
    for (ir::Node const& node : rule.nodes) {
      if (!node.deleted()) names.push_back(node.name);
    }
    return names;
  }

  /// The result that the expression names, if it is the name of one.
  std::optional<ir::VariableRef> find_result(ast::Expr const& expr) const {
    auto const* name = std::get_if<ast::NameExpr>(&expr.value);
    bool const bound = name && std::any_of(variables_.begin(), variables_.end(), [&](ast::Name const& v) { return v.text == name->name; });
    auto const found = name && !bound ? find_variable(name->name) : std::nullopt;
    return found && variable(*found).result ? found : std::nullopt;
  }

  ExprPtr copy(ir::VariableRef const& result, ast::Name const& name, ExprPtr at, Span span) {
    ir::RuleScheme const& rule = called(variable(result));
    auto const node = std::find_if(rule.nodes.begin(), rule.nodes.end(), [&](ir::Node const& n) { return n.name == name.text; });
    if (node != rule.nodes.end() && !node->deleted()) {
      return make(ir::dart_type, ir::CopyOf{result, static_cast<ir::NodeId>(node - rule.nodes.begin()), name.text, std::move(at)}, span);
    }
    if (node != rule.nodes.end()) {
      return report(Code::bad_result, name.span, fmt::format("`{}` deletes `{}`: no dart of it is left", rule.name, name.text),
                    {{node->span(), "on the left side only"}});
    }
    report_not_found(diagnostics_, Code::bad_result, name, fmt::format("`{}` has no node `{}` on its right side", rule.name, name.text), right_nodes(rule));
    return {};
  }

  /// `r.c[d]`
  ExprPtr check(ast::Index const& index, Span span) {
    auto const* member = std::get_if<ast::Member>(&index.base->value);
    auto const result = member ? find_result(*member->base) : std::nullopt;
    if (!result) {
      if (!check(*index.base)) return {};
      return report(Code::type_mismatch, span, "an expression has nothing to index", {},
                    {context_.operation ? "`[…]` selects from the result of a rule: `r.c[d]` is the copy of its right node `c` for the dart `d`"
                                        : "`[…]` selects from the result of a rule, in an operation"});
    }
    ir::RuleScheme const& rule = called(variable(*result));
    ExprPtr const at = check(*index.index);
    if (at && at->type != ir::dart_type) {
      return report(Code::not_a_dart, at->span, fmt::format("a copy is chosen by a dart of the pattern, this is {}", described(at->type)));
    }
    if (rule.hooks.empty() || rule.nodes[rule.hooks[0]].deleted()) {
      std::string const why = rule.hooks.empty() ? "has no hook: there is one copy of each node"
                                                 : fmt::format("deletes its hook `{}`, and with it the pattern", rule.nodes[rule.hooks[0]].name);
      return report(Code::bad_result, span, fmt::format("`{}` {}", rule.name, why), {},
                    {fmt::format("the copy for the hook's dart is `{}.{}`", result->name, member->name.text)});
    }
    return at ? copy(*result, member->name, at, span) : nullptr;
  }

  // ---- Reading the map ----

  ExprPtr report_not_constant(Span span) {
    return report(Code::unknown_value, span, "a default is a constant: it cannot read the map");
  }

  /// The dart at which `user`, a path or an orbit, starts.
  ExprPtr dart(ast::Expr const& expr, std::string const& user) {
    if (std::holds_alternative<ast::OrbitOf>(expr.value)) {
      return report(Code::not_a_dart, expr.span, fmt::format("{} starts at a dart, this is an orbit", user));
    }
    ExprPtr const start = check(expr);
    if (!start || start->type == ir::dart_type) return start;
    return report(Code::not_a_dart, expr.span,
                  fmt::format("{} starts at a dart, this is {}", user, described(start->type)), {},
                  {context_.operation ? "a dart is a variable that holds one, a node of a rule's result, or where a path from one leads: `d`, `r.a`, `d@0`"
                                      : "a dart is a node of the left side, or where a path from one leads: `a`, `a@0`"});
  }

  ExprPtr check(ast::Walk const& walk, Span span) {
    if (!context_.rule) return report_not_constant(span);
    ExprPtr start = dart(*walk.base, "`@`");
    auto word = evaluate_word(context_.rule->model(), walk.word, *context_.dimensions, diagnostics_);
    if (!start || !word) return {};
    if (auto const* before = std::get_if<ir::Walk>(&start->value)) {
      word = context_.group->product(before->path, *word);
      start = before->from;
    }
    Word path = context_.group->normal_form(*word);
    if (path.empty()) return std::make_shared<ir::Expr const>(ir::Expr{ir::dart_type, start->value, span});
    return make(ir::dart_type, ir::Walk{std::move(start), std::move(path)}, span);
  }

  /// The darts of an orbit: one for each ⟨by⟩-orbit, or all of them; none if something was reported.
  std::optional<ir::Darts> darts(ast::OrbitOf const& expr) {
    ExprPtr start = dart(*expr.dart, "an orbit");
    Model const& model = context_.rule->model();
    auto const orbit = evaluate_orbit(model, expr.type, *context_.dimensions, diagnostics_);
    if (!expr.by) return start && orbit ? std::optional(ir::Darts{std::move(start), *orbit, {}}) : std::nullopt;
    auto const by = evaluate_orbit(model, *expr.by, *context_.dimensions, diagnostics_);
    if (!start || !orbit || !by) return {};
    if (!is_inside(*by, *orbit)) {
      report(Code::orbit_not_inside, expr.by->span,
             fmt::format("the orbits {} do not lie inside {}", jrule::to_string(*by), jrule::to_string(*orbit)),
             {{expr.type.span, "this is the orbit that is walked"}},
             {fmt::format("`by` takes one dart for each of the smaller orbits; those of {} inside are {}",
                          jrule::to_string(*by), jrule::to_string(common_orbit(*context_.group, *orbit, *by)))});
      return {};
    }
    return ir::Darts{std::move(start), *orbit, *by};
  }

  bool is_inside(OrbitType const& by, OrbitType const& orbit) const {
    return std::all_of(by.words.begin(), by.words.end(),
                       [&](Word const& word) { return context_.group->in_orbit(word, orbit); });
  }

  ExprPtr check(ast::OrbitOf const& expr, Span span) {
    if (!context_.rule) return report_not_constant(span);
    if (!darts(expr)) return {};
    return report(Code::type_mismatch, span, "an orbit is not a value", {},
                  {"a dot and an embedding's name make it a list of values: `<0,1>(a).position`"});
  }

  ExprPtr check(ast::Member const& member, Span span) {
    if (auto const* orbit = std::get_if<ast::OrbitOf>(&member.base->value)) {
      if (!context_.rule) return report_not_constant(member.base->span);
      auto over = darts(*orbit);
      auto const embedding = over ? find_embedding(member.name) : std::nullopt;
      if (!embedding) return {};
      EmbeddingSpec const& spec = context_.rule->modeler->embeddings[*embedding];
      ExprType type = context_.rule->modeler->value_type(*embedding);
      type.list = true;
      if (!orbit->by) over->by = common_orbit(*context_.group, over->orbit, spec.orbit);  // each value once
      return make(std::move(type), ir::Collect{*embedding, std::move(*over)}, span);
    }
    if (auto const result = find_result(*member.base)) return copy(*result, member.name, nullptr, span);
    ExprPtr base = check(*member.base);
    if (!base) return {};
    if (base->type != ir::dart_type) return component(member, std::move(base), span);
    auto const embedding = find_embedding(member.name);
    if (!embedding) return {};
    return make(context_.rule->modeler->value_type(*embedding), ir::ValueAt{*embedding, std::move(base)}, span);
  }

  std::optional<std::size_t> find_embedding(ast::Name const& name) {
    auto const& embeddings = context_.rule->modeler->embeddings;
    std::vector<std::string> known;
    for (EmbeddingSpec const& e : embeddings) known.push_back(e.name);
    auto const found = std::find(known.begin(), known.end(), name.text);
    if (found != known.end()) return static_cast<std::size_t>(found - known.begin());
    report_unknown(diagnostics_, Code::unknown_embedding, name, "embedding", known);
    return {};
  }

  ExprPtr component(ast::Member const& member, ExprPtr base, Span span) {
    if (base->type.list) return report_list("." + member.name.text, *base, diagnostics_);
    if (auto const component = find_component(base->type.element, member.name.text)) {
      return ir::fold({real, ir::Apply{*component, {std::move(base)}}, span});
    }
    std::string const names = component_names(base->type.element);
    std::string const note = names.empty() ? fmt::format("{} has no components", described(base->type))
                                           : fmt::format("its components are `.{}`", fmt::join(names, "`, `."));
    return report(Code::no_operator, member.name.span,
                  fmt::format("`.{}` is not defined for `{}`", member.name.text, to_string(base->type)),
                  type_labels({base}), {note});
  }

  // ---- Operators and functions ----

  ExprPtr check(ast::Unary const& unary, Span span) {
    Builtin const op = unary.op == ast::UnaryOp::negate ? Builtin::negate : Builtin::logical_not;
    Span const op_span{span.file, span.begin, span.begin + static_cast<std::uint32_t>(spelling(op).size())};
    ExprPtr operand = check(*unary.operand);
    return operand ? apply(op, op_span, {std::move(operand)}, span, diagnostics_) : nullptr;
  }

  ExprPtr check(ast::Binary const& binary, Span span) {
    ExprPtr left = check(*binary.left);
    ExprPtr right = check(*binary.right);
    if (!left || !right) return {};
    return apply(builtin_of(binary.op), binary.op_span, {std::move(left), std::move(right)}, span, diagnostics_);
  }

  ir::ExternFunctionPtr const* find_extern(std::string const& name) const {
    if (!context_.externs) return nullptr;
    auto const found = context_.externs->functions.find(name);
    return found == context_.externs->functions.end() ? nullptr : &found->second;
  }

  ExprPtr report_unknown_function(ast::Name const& name) {
    std::vector<std::string> known = function_names();
    if (context_.externs) {
      if (context_.externs->types.contains(name.text)) {
        return report(Code::unknown_function, name.span, fmt::format("`{}` is an extern type, not a function", name.text), {},
                      {"its values come from extern functions and from embeddings"});
      }
      for (std::string& f : context_.externs->function_names()) known.push_back(std::move(f));
    }
    report_unknown(diagnostics_, Code::unknown_function, name, "function", known);
    return {};
  }

  ExprPtr check(ast::Call const& call, Span span) {
    std::string const& name = call.function.text;
    if (!call.dimensions.empty() && !(context_.operation && context_.operation->is_callee(name))) {
      return report(Code::unknown_function, call.function.span, fmt::format("`{}[…]` is not a function", name), {},
                    {"rules are applied by operations, not by expressions"});
    }
    std::optional<Builtin> const function = find_function(name);
    ir::ExternFunctionPtr const* const external = function ? nullptr : find_extern(name);
    if (context_.operation && context_.operation->is_callee(name)) {
      return report(Code::misplaced_call, call.function.span, fmt::format("`{}` may change the map, so it is not called within an expression", name), {},
                    {fmt::format("call it before: `let r = {}(…);`", name)});
    }
    if (!function && !external) return report_unknown_function(call.function);
    if (function == Builtin::count && context_.rule && call.arguments.size() == 1 && !call.arguments.front().name) {
      auto const* orbit = std::get_if<ast::OrbitOf>(&call.arguments.front().value->value);
      if (orbit) return count(*orbit, call.arguments.front().value->span, span);
    }
    std::vector<ExprPtr> arguments;
    bool good = true;
    for (ast::Argument const& argument : call.arguments) {
      if (argument.name) {
        report(Code::type_mismatch, argument.name->span, fmt::format("the arguments of `{}` have no names", name), {},
               {"they are told apart by their order"});
      }
      arguments.push_back(check(*argument.value));
      good = good && !argument.name && arguments.back();
    }
    if (external) {
      good = good && *external;  // null: its declaration is reported
      return good ? call_extern(*external, call.function.span, std::move(arguments), span, diagnostics_) : nullptr;
    }
    good = check_argument_count(*function, call.function.span, arguments.size(), diagnostics_) && good;
    return good ? apply(*function, call.function.span, std::move(arguments), span, diagnostics_) : nullptr;
  }

  ExprPtr count(ast::OrbitOf const& orbit, Span orbit_span, Span span) {
    auto counted = darts(orbit);
    if (!counted) return {};
    ExprPtr list = make(ir::darts_type, std::move(*counted), orbit_span);
    return make(integer, ir::Apply{Builtin::count, {std::move(list)}}, span);
  }

  ExprPtr check(ast::Conditional const& conditional, Span span) {
    ExprPtr condition = check(*conditional.condition);
    if (condition) condition = convert(std::move(condition), boolean, diagnostics_);
    ExprPtr then_value = check(*conditional.then_value);
    ExprPtr else_value = check(*conditional.else_value);
    if (!then_value || !else_value) return {};
    auto const is_number = [](ExprPtr const& e) { return e->type == integer || e->type == real; };
    if (then_value->type != else_value->type && is_number(then_value) && is_number(else_value)) {
      then_value = convert(then_value, real, diagnostics_);
      else_value = convert(else_value, real, diagnostics_);
    }
    if (then_value->type != else_value->type) {
      return report(Code::type_mismatch, else_value->span,
                    fmt::format("the branches have different types: {} and {}", described(then_value->type),
                                described(else_value->type)),
                    type_labels({then_value, else_value}));
    }
    if (!condition) return {};
    ExprType const type = then_value->type;
    return ir::fold({type, ir::Conditional{std::move(condition), std::move(then_value), std::move(else_value)}, span});
  }

  // ---- Comprehensions ----

  ExprPtr check(ast::Comprehension const& comprehension, Span span) {
    if (!context_.rule) return report_not_constant(comprehension.orbit->span);
    ir::ExternFunctionPtr const* const external = find_extern(comprehension.aggregate.text);
    auto const aggregate = external ? std::nullopt : find_aggregate(comprehension.aggregate);
    auto over = range(*comprehension.orbit, "a comprehension");
    if (!check_fresh(comprehension.variable)) return {};
    ir::Bound variable{variables_.size(), comprehension.variable.text};
    variables_.push_back(comprehension.variable);
    ExprPtr element = check(*comprehension.element);
    variables_.pop_back();
    if (element && (element->type.list || element->type.dart)) {
      std::vector<std::string> notes;
      if (element->type.list) notes.push_back(aggregate_it(element->type));
      if (element->type.dart) notes.push_back(fmt::format("a value at it is read with a dot: `{}.…`", variable.name));
      element = report(Code::type_mismatch, element->span,
                       fmt::format("the element of a comprehension is one value, this is {}", described(element->type)),
                       {}, std::move(notes));
    }
    bool const known = external ? *external != nullptr : aggregate.has_value();
    if (!known || !over || !element) return {};
    ExprType type = element->type;
    type.list = true;
    Span const element_span = element->span;
    ExprPtr list = make(type, ir::ForEach{std::move(variable), std::move(*over), std::move(element)}, element_span);
    if (external) return call_extern(*external, comprehension.aggregate.span, {std::move(list)}, span, diagnostics_);
    return apply(*aggregate, comprehension.aggregate.span, {std::move(list)}, span, diagnostics_);
  }

  std::optional<Builtin> find_aggregate(ast::Name const& name) {
    std::vector<std::string> known;
    for (std::string const& function : function_names()) {
      if (takes_list(*find_function(function))) known.push_back(function);
    }
    auto const function = find_function(name.text);
    if (function && takes_list(*function)) return function;
    if (function) {
      report(Code::no_operator, name.span, fmt::format("`{}` does not aggregate a list", name.text), {},
             {fmt::format("a comprehension is aggregated by `{}`", fmt::join(known, "`, `"))});
    } else {
      report_unknown(diagnostics_, Code::unknown_function, name, "aggregate", known);
    }
    return {};
  }

  static bool takes_list(Builtin function) {
    return std::any_of(signatures(function).begin(), signatures(function).end(),
                       [](Signature const& s) { return s.parameters.size() == 1 && s.parameters.front().list; });
  }

  /// Is the name of a comprehension's variable new here? Reported if not.
  bool check_fresh(ast::Name const& name) {
    auto const meaning = find(name.text);
    if (!meaning || std::holds_alternative<Pi>(*meaning)) return true;
    std::vector<Label> labels;
    if (auto const* b = std::get_if<ir::Bound>(&*meaning)) {
      labels.push_back({variables_[b->level].span, "first declared here"});
    } else if (auto const* n = std::get_if<ir::NodeDart>(&*meaning)) {
      labels.push_back({context_.rule->nodes[n->node].span(), "first declared here"});
    } else if (auto const* v = std::get_if<ir::VariableRef>(&*meaning)) {
      labels.push_back({variable(*v).span, "first declared here"});
    }
    std::string_view const what = std::holds_alternative<ir::ParameterRef>(*meaning) ? "a parameter"
                                  : std::holds_alternative<ir::LetRef>(*meaning)     ? "a `let`"
                                  : std::holds_alternative<ir::NodeDart>(*meaning)   ? "a node"
                                  : std::holds_alternative<ir::VariableRef>(*meaning) ? "a variable"
                                                                                     : "the variable of a comprehension";
    report(Code::duplicate_name, name.span, fmt::format("`{}` is {} already", name.text, what), std::move(labels),
           {"a comprehension's variable has a name of its own"});
    return false;
  }

  ExprContext const& context_;
  Diagnostics& diagnostics_;
  std::vector<ast::Name> variables_;  // of the comprehensions around, the outermost first
};

}  // namespace

OrbitType common_orbit(algebra::Group const& group, OrbitType const& a, OrbitType const& b) {
  OrbitType result;
  auto const add_common = [&](OrbitType const& from, OrbitType const& other) {
    for (Word const& written : from.words) {
      Word word = group.normal_form(written);
      bool const known = std::any_of(result.words.begin(), result.words.end(),
                                     [&](Word const& w) { return w == word || w == group.inverse(word); });
      if (!word.empty() && !known && group.in_orbit(word, other)) result.words.push_back(std::move(word));
    }
  };
  add_common(a, b);
  add_common(b, a);
  return result;
}

ExprPtr check_expression(ast::Expr const& expr, ExprContext const& context, std::optional<ExprType> expected,
                         Diagnostics& diagnostics) {
  ExprPtr value = Checker(context, diagnostics).check(expr);
  return value && expected ? convert(std::move(value), *expected, diagnostics) : value;
}

std::optional<ir::Darts> check_darts(ast::Expr const& expr, ExprContext const& context, std::string const& user, Diagnostics& diagnostics) {
  return Checker(context, diagnostics).range(expr, user);
}

}  // namespace jrule::sema
