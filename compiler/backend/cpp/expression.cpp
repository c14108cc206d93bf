#include "compiler/backend/cpp/expression.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <optional>
#include <set>
#include <stdexcept>

#include "compiler/backend/cpp/text.h"

namespace jrule::cpp {

using ir::Builtin;

namespace {

// How tightly C++ binds an expression's outermost operator.
enum Binding { conditional, disjunction, conjunction, comparison, sum, product, unary, primary };

struct Code {
  std::string text;
  Binding binding = primary;
};

std::string bound(Code const& code, Binding least) { return code.binding < least ? '(' + code.text + ')' : code.text; }

struct Printer {
  Function const* function;  // null for an expression that reads nothing, or that is an operation's
  Where where;
  OperationNames const* operation = nullptr;
  mutable std::set<std::size_t> mentioned{};  // levels of the comprehensions whose variables are

  Function const& f() const {
    if (!function) throw std::logic_error("a constant expression reads");
    return *function;
  }

  Code print(ir::Expr const& expr) const {
    return std::visit([&](auto const& node) { return print_node(node); }, expr.value);
  }

  static Code constant(std::string text) { return {text, text.front() == '-' ? unary : primary}; }

  Code print_node(ir::Constant const& c) const { return constant(literal(c.value)); }
  Code print_node(ir::ParameterRef const& p) const { return {f().parameters[p.index]}; }
  Code print_node(ir::LetRef const& l) const {
    if (where != Where::in_loop || f().form != Form::listed) return {f().lets[l.index]};
    std::string const let = fmt::format("{}[{}[{}]]", f().let_lists[l.index], f().local("number"), f().index);
    // A list of Bool is a list of bytes.
    return f().rule.lets[l.index].value->type == ir::ExprType{Type::Bool} ? Code{let + " != 0", comparison} : Code{let};
  }
  Code print_node(ir::NodeDart const& n) const {
    if (where != Where::at_hooks) return {f().dart(n.node)};
    return {f().node(n.node).hook ? f().hooks[*f().node(n.node).hook] : f().darts[n.node] + "[0]"};
  }
  std::string const& bound_name(std::string const& name) const { return operation ? operation->bound.at(name) : f().variables.at(name); }
  Code print_node(ir::Bound const& b) const {
    mentioned.insert(b.level);
    return {bound_name(b.name)};
  }
  // A dart where the map is read. In an operation it may have been deleted, but not where a path or a comprehension has just led.
  std::string dart(ir::Expr const& expr) const {
    std::string text = print(expr).text;
    bool const is_there = std::holds_alternative<ir::Bound>(expr.value) || std::holds_alternative<ir::Walk>(expr.value);
    return !operation || is_there ? text : fmt::format("{}({})", operation->alive, text);
  }
  Code print_node(ir::Walk const& w) const {
    if (!operation) return {f().walk(dart(*w.from), w.path)};
    std::string at = dart(*w.from);
    for (Letter const letter : w.path) at = fmt::format("{}.{}({}, {})", operation->map, letter.conjugate ? "source" : "target", at, letter.dimension);
    return {at};
  }
  Code print_node(ir::VariableRef const& v) const { return {of_operation().variables[v.index]}; }
  Code print_node(ir::CopyOf const& c) const {
    OperationNames const& o = of_operation();
    if (!c.at) return {fmt::format("{}.{}", o.variables[c.result.index], o.members[c.result.index][c.node])};
    return {fmt::format("{}.at({}, {}, {})", o.copies.at({c.result.index, c.node}), print(*c.at).text, o.operation,
                        literal(c.result.name + "." + c.node_name))};
  }
  OperationNames const& of_operation() const {
    if (!operation) throw std::logic_error("a rule reads a variable of an operation");
    return *operation;
  }
  // The arguments that say which darts: "walk_1_2_by_1, a".
  std::string darts(ir::Darts const& d) const {
    return fmt::format("{}, {}", (operation ? operation->walks : f().walks).at({d.orbit, d.by}), dart(*d.at));
  }
  Code print_node(ir::Darts const&) const { throw std::logic_error("darts are counted or aggregated"); }
  std::string value(std::size_t embedding, std::string const& at) const {
    return operation ? fmt::format("{}.{}({})", operation->object, operation->modeler->embeddings[embedding].name, at)
                     : fmt::format("{}[{}]", f().values[embedding], at);
  }
  Code print_node(ir::ValueAt const& v) const { return {value(v.embedding, dart(*v.at))}; }
  Code print_node(ir::Collect const& c) const {
    if (!operation) return {fmt::format("{}.over({})", f().values[c.embedding], darts(c.over))};
    return {fmt::format("jrule::rewrite::Values<{}>({}.embedding({})).over({})", type_name(operation->modeler->value_type(c.embedding)),
                        operation->map, c.embedding, darts(c.over))};
  }
  // "walk_1_2_by_1, a, [&](jrule::Dart f) { return …; }"
  std::string each(ir::Darts const& over, std::string const& name, std::string const& element) const {
    return fmt::format("{}, [&](jrule::Dart{}) {{ return {}; }}", darts(over), name, element);
  }
  std::string each(ir::ForEach const& e) const {
    mentioned.erase(e.variable.level);
    std::string const element = print(*e.element).text;
    std::string const name = mentioned.contains(e.variable.level) ? ' ' + bound_name(e.variable.name) : "";
    return each(e.over, name, element);
  }
  Code print_node(ir::ForEach const& e) const { return {fmt::format("jrule::rewrite::each({})", each(e))}; }
  // What is written inside an aggregate of a walk, so that it needs no list; nothing for other lists.
  std::string each(ir::Expr const& list) const {
    if (auto const* e = std::get_if<ir::ForEach>(&list.value)) return each(*e);
    auto const* c = std::get_if<ir::Collect>(&list.value);
    if (!c) return {};
    std::string const& at = operation ? operation->at : f().local("at");
    return each(c->over, ' ' + at, value(c->embedding, at));
  }
  std::optional<Code> aggregate(ir::Apply const& a) const {
    std::string const walked = each(*a.arguments[0]);
    if (walked.empty()) return {};
    bool const adds = a.function == Builtin::sum || a.function == Builtin::mean;
    return Code{adds ? fmt::format("jrule::rewrite::total({}).{}()", walked, ir::spelling(a.function))
                     : fmt::format("jrule::rewrite::{}({})", ir::spelling(a.function), walked)};
  }
  Code print_node(ir::Conditional const& c) const {
    return {fmt::format("{} ? {} : {}", bound(print(*c.condition), disjunction),
                        bound(print(*c.then_value), disjunction), bound(print(*c.else_value), disjunction)),
            conditional};
  }

  // Of equal binding, the left operand needs no brackets. Compilers warn of comparisons and negations that are compared,
  // and of && in ||.
  Code infix(char const* op, Binding binding, ir::Apply const& a) const {
    Binding left = binding, right = static_cast<Binding>(binding + 1);
    if (binding == comparison) left = sum;
    if (binding == disjunction) left = right = comparison;
    return {fmt::format("{} {} {}", bound(print(*a.arguments[0]), left), op, bound(print(*a.arguments[1]), right)),
            binding};
  }

  Code call(std::string const& name, std::vector<ir::ExprPtr> const& arguments) const {
    std::vector<std::string> texts;
    for (ir::ExprPtr const& argument : arguments) texts.push_back(print(*argument).text);
    return {fmt::format("{}({})", name, fmt::join(texts, ", "))};
  }
  Code call(std::string const& name, ir::Apply const& a) const { return call(name, a.arguments); }
  Code print_node(ir::Call const& c) const { return call("::" + c.function->cpp_name, c.arguments); }

  // Compilers warn of a dart that is compared with itself.
  bool is_same_dart(ir::Apply const& a) const {
    if (a.arguments[0]->type != ir::dart_type) return false;
    auto const before = mentioned;
    bool const same = print(*a.arguments[0]).text == print(*a.arguments[1]).text;
    if (same) mentioned = before;
    return same;
  }

  Code construct(ir::Apply const& a, Type type) const {
    Code code = call(type_name(type), a);
    code.text[type_name(type).size()] = '{';
    code.text.back() = '}';
    return code;
  }

  Code component(ir::Apply const& a, std::size_t k) const {
    std::string const names = a.arguments[0]->type.element == Type::Color ? "rgb" : "xyz";
    return {fmt::format("{}.{}", bound(print(*a.arguments[0]), primary), names[k])};
  }

  // A list of Bool is a list of bytes.
  Code first(ir::Apply const& a) const {
    std::string const front = bound(print(*a.arguments[0]), primary) + ".front()";
    return a.arguments[0]->type.element == Type::Bool ? Code{front + " != 0", comparison} : Code{front};
  }

  Code print_node(ir::Apply const& a) const {
    bool const integer = a.arguments[0]->type == ir::ExprType{Type::Int};
    switch (a.function) {
      // Int arithmetic wraps around.
      case Builtin::add: return integer ? call("jrule::add", a) : infix("+", sum, a);
      case Builtin::subtract: return integer ? call("jrule::subtract", a) : infix("-", sum, a);
      case Builtin::multiply: return integer ? call("jrule::multiply", a) : infix("*", product, a);
      case Builtin::divide: return infix("/", product, a);
      case Builtin::negate:
        return integer ? call("jrule::negate", a) : Code{"-" + bound(print(*a.arguments[0]), primary), unary};
      case Builtin::less: return infix("<", comparison, a);
      case Builtin::less_equal: return infix("<=", comparison, a);
      case Builtin::greater: return infix(">", comparison, a);
      case Builtin::greater_equal: return infix(">=", comparison, a);
      case Builtin::equal: return is_same_dart(a) ? Code{"true"} : infix("==", comparison, a);
      case Builtin::not_equal: return is_same_dart(a) ? Code{"false"} : infix("!=", comparison, a);
      case Builtin::logical_and: return infix("&&", conjunction, a);
      case Builtin::logical_or: return infix("||", disjunction, a);
      case Builtin::logical_not: return {"!" + bound(print(*a.arguments[0]), primary), comparison};
      case Builtin::to_real: return call("static_cast<double>", a);
      case Builtin::vec2: return construct(a, Type::Vec2);
      case Builtin::vec3: return construct(a, Type::Vec3);
      case Builtin::point2: return construct(a, Type::Point2);
      case Builtin::point3: return construct(a, Type::Point3);
      case Builtin::color: return construct(a, Type::Color);
      case Builtin::component_0: return component(a, 0);
      case Builtin::component_1: return component(a, 1);
      case Builtin::component_2: return component(a, 2);
      case Builtin::sqrt:
      case Builtin::floor:
      case Builtin::ceil: return call(fmt::format("std::{}", ir::spelling(a.function)), a);
      case Builtin::count:
        if (auto const* over = std::get_if<ir::Darts>(&a.arguments[0]->value)) return {fmt::format("jrule::rewrite::count({})", darts(*over))};
        return {fmt::format("static_cast<std::int64_t>({}.size())", bound(print(*a.arguments[0]), primary))};
      case Builtin::first: return first(a);
      case Builtin::all:
      case Builtin::any:
        if (auto code = aggregate(a)) return *code;
        return call(fmt::format("jrule::rewrite::{}", ir::spelling(a.function)), a);
      case Builtin::mean:
      case Builtin::sum:
        if (auto code = aggregate(a)) return *code;
        break;
      case Builtin::dot:
      case Builtin::cross:
      case Builtin::norm:
      case Builtin::normalize:
      case Builtin::midpoint:
      case Builtin::lerp:
      case Builtin::distance:
      case Builtin::area_vector:
      case Builtin::abs:
      case Builtin::sin:
      case Builtin::cos:
      case Builtin::tan:
      case Builtin::atan2:
      case Builtin::pow:
      case Builtin::exp:
      case Builtin::log:
      case Builtin::min:
      case Builtin::max: break;
    }
    return call(fmt::format("jrule::{}", ir::spelling(a.function)), a);
  }
};

}  // namespace

std::string expression(ir::Expr const& expr, Function const& f, Where where) {
  return Printer{&f, where}.print(expr).text;
}

std::string expression(ir::Expr const& expr, OperationNames const& names) { return Printer{nullptr, Where::at_hooks, &names}.print(expr).text; }

std::string dart_in_map(ir::Expr const& expr, OperationNames const& names) { return Printer{nullptr, Where::at_hooks, &names}.dart(expr); }

std::string constant_expression(ir::Expr const& expr) { return Printer{nullptr, Where::at_hooks}.print(expr).text; }

std::string default_value(ir::Modeler const& modeler, std::size_t embedding) {
  if (auto const computed = modeler.externs_of(embedding).default_value) return constant_expression(*computed);
  return literal(*modeler.embeddings[embedding].default_value);
}

}  // namespace jrule::cpp
