#include "compiler/backend/text/expression.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "compiler/sema/expressions.h"
#include "compiler/sema/overloads.h"

namespace jrule::text {

using ir::Builtin;
using ir::Expr;
using ir::ExprPtr;
using ir::ExprType;

namespace {

// ---- Numbers ----

/// With a dot or an exponent, without which it would be an Int.
std::string spell_finite(double x) {
  std::string text = fmt::format("{}", x);
  return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

/// Not as quotients by zero: those get a warning.
std::string spell_real(double x) {
  if (std::isnan(x)) return "sqrt(-1.0)";
  if (std::isinf(x)) return x > 0 ? "-log(0.0)" : "log(0.0)";
  return spell_finite(x);
}

std::string spell_integer(std::int64_t i) {
  // The least Int has no opposite that could be written behind a minus.
  if (i == std::numeric_limits<std::int64_t>::min()) return fmt::format("{} - 1", i + 1);
  return fmt::format("{}", i);
}

// ---- Operators ----

/// How tightly an expression holds together, as in the grammar.
enum Level { conditional, disjunction, conjunction, negation, comparison, addition, multiplication, unary, postfix };

std::optional<Level> infix_level(Builtin function) {
  switch (function) {
    case Builtin::logical_or: return disjunction;
    case Builtin::logical_and: return conjunction;
    case Builtin::less:
    case Builtin::less_equal:
    case Builtin::greater:
    case Builtin::greater_equal:
    case Builtin::equal:
    case Builtin::not_equal: return comparison;
    case Builtin::add:
    case Builtin::subtract: return addition;
    case Builtin::multiply:
    case Builtin::divide: return multiplication;
    default: return {};
  }
}

Level tighter(Level level) { return static_cast<Level>(level + 1); }

/// Of the text that a constant has.
Level level_of(Value const& value, std::string const& text) {
  if (value == Value{std::numeric_limits<std::int64_t>::min()}) return addition;
  return text.starts_with('-') ? unary : postfix;
}

std::optional<std::size_t> component_of(Builtin function) {
  switch (function) {
    case Builtin::component_0: return 0;
    case Builtin::component_1: return 1;
    case Builtin::component_2: return 2;
    default: return {};
  }
}

/// What is converted to a Real here; null if nothing is.
Expr const* converted(Expr const& expr) {
  auto const* apply = std::get_if<ir::Apply>(&expr.value);
  if (!apply || apply->function != Builtin::to_real || apply->arguments.size() != 1) return nullptr;
  bool const is_conversion = expr.type == ExprType{Type::Real} && apply->arguments[0]->type == ExprType{Type::Int};
  return is_conversion ? apply->arguments[0].get() : nullptr;
}

/// What is written for an operand: conversions are not.
Expr const& written(Expr const& expr) {
  Expr const* const inner = converted(expr);
  return inner ? *inner : expr;
}

/// Would ir::fold do something of it?
bool folds(Expr const& expr) {
  auto const is_constant = [](ExprPtr const& part) { return std::holds_alternative<ir::Constant>(part->value); };
  if (auto const* apply = std::get_if<ir::Apply>(&expr.value)) {
    auto const begin = apply->arguments.begin(), end = apply->arguments.end();
    bool const one_decides = apply->function == Builtin::logical_and || apply->function == Builtin::logical_or;
    return one_decides ? std::any_of(begin, end, is_constant) : std::all_of(begin, end, is_constant);
  }
  auto const* choice = std::get_if<ir::Conditional>(&expr.value);
  return choice && is_constant(choice->condition);
}

ExprType list_of(ExprType type) {
  type.list = true;
  return type;
}

/// Recursive, as the checker is. The first fault is kept; the text is of no use then.
class Speller {
 public:
  Speller(ir::RuleScheme const& rule, algebra::Group const& group, std::size_t lets) : rule_(rule), group_(group), lets_(lets) {}

  /// In parentheses if it holds together less than the place needs.
  std::string spell(Expr const& expr, Level least) {
    if (folds(expr)) return fail("an operation that constants decide stands for its value");
    Level level = postfix;
    std::string text = std::visit([&](auto const& node) { return spell(node, expr.type, level); }, expr.value);
    return level < least ? "(" + text + ")" : text;
  }

  std::string fault;

 private:
  std::string fail(std::string reason) {
    if (fault.empty()) fault = std::move(reason);
    return {};
  }
  void expect_type(ExprType const& type, ExprType const& expected) {
    if (type != expected) fail(fmt::format("an expression of type {} stands as {}", to_string(expected), to_string(type)));
  }

  std::string spell(ir::Constant const& constant, ExprType const& type, Level& level) {
    expect_type(type, {type_of(constant.value)});
    std::string text = spell_constant(constant.value);
    level = level_of(constant.value, text);
    return text;
  }

  std::string spell(ir::ParameterRef const& ref, ExprType const& type, Level&) {
    ir::Parameter const& parameter = rule_.parameters[ref.index];
    expect_type(type, parameter.value_type());
    return parameter.name;
  }

  std::string spell(ir::LetRef const& ref, ExprType const& type, Level&) {
    ir::Let const& let = rule_.lets[ref.index];
    if (ref.index >= lets_) return fail(fmt::format("`{}` is read before it is declared", let.name));
    if (std::holds_alternative<ir::Constant>(let.value->value)) return fail(fmt::format("`{}` is read, and not its constant", let.name));
    expect_type(type, let.value->type);
    return let.name;
  }

  // ---- Variables of operations ----

  std::string spell(ir::VariableRef const& variable, ExprType const&, Level&) { return variable.name; }
  std::string spell(ir::CopyOf const& copy, ExprType const& type, Level&) {
    expect_type(type, ir::dart_type);
    std::string const at = copy.at ? fmt::format("[{}]", dart(*copy.at, conditional)) : "";
    return fmt::format("{}.{}{}", copy.result.name, copy.node_name, at);
  }

  // ---- Darts ----

  template <class Declared>
  static bool has_name(Declared const& declared, std::size_t count, std::string const& name) {
    auto const end = declared.begin() + static_cast<std::ptrdiff_t>(count);
    return std::any_of(declared.begin(), end, [&](auto const& d) { return d.name == name; });
  }
  bool is_value(std::string const& name) const {
    return has_name(rule_.parameters, rule_.parameters.size(), name) || has_name(rule_.lets, lets_, name);
  }
  bool is_variable(std::string const& name) const { return std::find(variables_.begin(), variables_.end(), name) != variables_.end(); }

  std::string spell(ir::NodeDart const& dart, ExprType const& type, Level&) {
    std::string const& name = rule_.nodes[dart.node].name;
    expect_type(type, ir::dart_type);
    if (is_value(name)) fail(fmt::format("the node `{}` is hidden by a value of that name", name));
    return name;
  }

  std::string spell(ir::Bound const& bound, ExprType const& type, Level&) {
    expect_type(type, ir::dart_type);
    if (variables_[bound.level] != bound.name) {
      fail(fmt::format("the variable `{}` is called `{}` where it is bound", bound.name, variables_[bound.level]));
    }
    return bound.name;
  }

  std::string spell(ir::Walk const& walk, ExprType const& type, Level&) {
    Word const& path = walk.path;
    expect_type(type, ir::dart_type);
    if (path.empty() || group_.normal_form(path) != path) fail(fmt::format("the path {} is not in normal form", spell_word(path)));
    if (std::holds_alternative<ir::Walk>(walk.from->value)) fail("a path starts where another one ends");
    return fmt::format("{}@{}", dart(*walk.from, postfix), path.size() == 1 ? text::spell(path[0]) : spell_word(path));
  }

  std::string dart(Expr const& expr, Level least) {
    expect_type(expr.type, ir::dart_type);
    return spell(expr, least);
  }

  /// `<0,1>(a) by <0>`; `implied` is what is meant without `by`.
  std::string orbit(ir::Darts const& darts, OrbitType const& implied) {
    std::string const text = fmt::format("{}({})", text::spell(darts.orbit), dart(*darts.at, conditional));
    if (darts.by == implied) return text;
    auto const is_inside = [&](Word const& word) { return group_.in_orbit(word, darts.orbit); };
    if (!std::all_of(darts.by.words.begin(), darts.by.words.end(), is_inside)) {
      fail(fmt::format("the orbits {} do not lie inside {}", text::spell(darts.by), text::spell(darts.orbit)));
    }
    return fmt::format("{} by {}", text, text::spell(darts.by));
  }

  std::string spell(ir::Darts const&, ExprType const&, Level&) { return fail("an orbit is not counted, but a value"); }

  // ---- Reading the map ----

  std::string spell(ir::ValueAt const& read, ExprType const& type, Level&) {
    EmbeddingSpec const& embedding = rule_.modeler->embeddings[read.embedding];
    expect_type(type, rule_.modeler->value_type(read.embedding));
    return fmt::format("{}.{}", dart(*read.at, postfix), embedding.name);
  }

  std::string spell(ir::Collect const& read, ExprType const& type, Level&) {
    EmbeddingSpec const& embedding = rule_.modeler->embeddings[read.embedding];
    expect_type(type, list_of(rule_.modeler->value_type(read.embedding)));
    OrbitType const implied = sema::common_orbit(group_, read.over.orbit, embedding.orbit);
    std::string const darts = orbit(read.over, implied);
    return fmt::format("{}.{}", read.over.by == implied ? darts : "(" + darts + ")", embedding.name);
  }

  std::string spell(ir::ForEach const&, ExprType const&, Level&) { return fail("the list of a comprehension is not aggregated"); }

  /// What stands between the aggregate's parentheses.
  std::string comprehension(ir::ForEach const& each, ExprType const& type) {
    std::string const& variable = each.variable.name;
    expect_type(type, list_of(each.element->type));
    if (is_value(variable) || is_variable(variable) || has_name(rule_.nodes, rule_.nodes.size(), variable)) {
      fail(fmt::format("the variable `{}` has the name of something around it", variable));
    }
    std::string const darts = orbit(each.over, {});
    variables_.push_back(variable);
    std::string const element = spell(*each.element, conditional);
    variables_.pop_back();
    return fmt::format("{} for {} in {}", element, variable, darts);
  }

  // ---- Functions ----

  /// The language converts operands as its first fitting signature says: is that what the tree has, if Ints are written
  /// for their conversions, or if these are written themselves?
  bool fits(ir::Apply const& apply, ExprType const& type, bool converts) const {
    bool const any_list = apply.function == Builtin::first || apply.function == Builtin::count;
    if (ExprType const& list = apply.arguments[0]->type; any_list && list.list && list.external) {
      return apply.function == Builtin::count ? type == ExprType{Type::Int} : list_of(type) == list;
    }
    std::vector<ExprType> types;
    for (ExprPtr const& argument : apply.arguments) types.push_back(converts ? written(*argument).type : argument->type);
    sema::Signature const* const signature = sema::find_signature(apply.function, types);
    bool same = signature && signature->result == type;
    for (std::size_t i = 0; same && i < types.size(); ++i) same = signature->parameters[i] == apply.arguments[i]->type;
    return same;
  }

  /// Where the language does not convert, a conditional with a Real does; what decides it leaves nothing else of it.
  std::string conversion(ir::Apply const& apply, ExprType const& type, Level& level) {
    expect_type(type, {Type::Real});
    expect_type(apply.arguments[0]->type, {Type::Int});
    level = conditional;
    return fmt::format("if true then {} else 0.0", spell(*apply.arguments[0], conditional));
  }

  std::string component(ir::Apply const& apply, std::size_t index, ExprType const& type) {
    expect_type(type, {Type::Real});
    ExprType const of = apply.arguments[0]->type;
    std::string const names = of.list || of.dart ? "" : sema::component_names(of.element);
    if (index >= names.size()) return fail(fmt::format("a {} has no such component", to_string(of)));
    return fmt::format("{}.{}", spell(*apply.arguments[0], postfix), names[index]);
  }

  std::string spell(ir::Apply const& apply, ExprType const& type, Level& level) {
    auto const& arguments = apply.arguments;
    if (auto const index = component_of(apply.function)) return component(apply, *index, type);
    if (apply.function == Builtin::to_real) return conversion(apply, type, level);
    if (auto const* counted = std::get_if<ir::Darts>(&arguments[0]->value); counted && apply.function == Builtin::count) {
      expect_type(type, {Type::Int});
      return fmt::format("count({})", orbit(*counted, {}));
    }
    bool const converts = fits(apply, type, true);
    if (!converts && !fits(apply, type, false)) {
      return fail(fmt::format("`{}` is applied to other types than the language would", spelling(apply.function)));
    }
    auto const operand = [&](std::size_t i, Level least) { return spell(converts ? written(*arguments[i]) : *arguments[i], least); };
    if (auto const infix = infix_level(apply.function)) {
      level = *infix;
      // Operators of one level group from the left; comparisons do not chain.
      std::string const left = operand(0, level == comparison ? tighter(level) : level);
      return fmt::format("{} {} {}", left, spelling(apply.function), operand(1, tighter(level)));
    }
    if (apply.function == Builtin::logical_not) {
      level = negation;
      return "not " + operand(0, negation);
    }
    if (apply.function == Builtin::negate) {
      level = unary;
      return "-" + operand(0, unary);
    }
    if (auto const* each = std::get_if<ir::ForEach>(&arguments[0]->value)) {
      return fmt::format("{}({})", spelling(apply.function), comprehension(*each, arguments[0]->type));
    }
    std::vector<std::string> all;
    for (std::size_t i = 0; i < arguments.size(); ++i) all.push_back(operand(i, conditional));
    return fmt::format("{}({})", spelling(apply.function), fmt::join(all, ", "));
  }

  /// Arguments are converted where a parameter is a Real.
  std::string spell(ir::Call const& call, ExprType const& type, Level&) {
    expect_type(type, call.function->result);
    std::vector<std::string> all;
    for (std::size_t i = 0; i < call.arguments.size(); ++i) {
      Expr const& argument = *call.arguments[i];
      expect_type(argument.type, call.function->parameters[i].type);
      auto const* each = std::get_if<ir::ForEach>(&argument.value);
      bool const aggregated = each && call.arguments.size() == 1;
      all.push_back(aggregated ? comprehension(*each, argument.type) : spell(written(argument), conditional));
    }
    return fmt::format("{}({})", call.function->name, fmt::join(all, ", "));
  }

  std::string spell(ir::Conditional const& c, ExprType const& type, Level& level) {
    level = conditional;
    expect_type(c.condition->type, {Type::Bool});
    expect_type(c.then_value->type, type);
    expect_type(c.else_value->type, type);
    // A branch is converted if the other one is a Real.
    bool const then_real = written(*c.then_value).type == ExprType{Type::Real};
    bool const else_real = written(*c.else_value).type == ExprType{Type::Real};
    Expr const& then_value = else_real ? written(*c.then_value) : *c.then_value;
    Expr const& else_value = then_real ? written(*c.else_value) : *c.else_value;
    return fmt::format("if {} then {} else {}", spell(*c.condition, conditional), spell(then_value, conditional),
                       spell(else_value, conditional));
  }

  ir::RuleScheme const& rule_;
  algebra::Group const& group_;
  std::size_t lets_;
  std::vector<std::string> variables_;  // of the comprehensions around, the outermost first
};

}  // namespace

std::string spell(Letter letter) { return fmt::format("{}{}", letter.conjugate ? "~" : "", letter.dimension); }

std::string spell_word(Word const& word) {
  std::string text;
  for (Letter const letter : word) text += (text.empty() ? "" : ",") + spell(letter);
  return "[" + text + "]";
}

std::string spell(OrbitType const& orbit) {
  std::string text;
  for (Word const& word : orbit.words) {
    if (!text.empty()) text += ',';
    text += word.size() == 1 ? spell(word[0]) : spell_word(word);
  }
  return "<" + text + ">";
}

std::string spell_constant(Value const& value) {
  if (auto const* b = std::get_if<bool>(&value)) return *b ? "true" : "false";
  if (auto const* i = std::get_if<std::int64_t>(&value)) return spell_integer(*i);
  if (auto const* x = std::get_if<double>(&value)) return spell_real(*x);
  std::string components;
  for (int k = 0; k < component_count(type_of(value)); ++k) {
    components += (k == 0 ? "" : ", ") + spell_real(component(value, k));
  }
  return fmt::format("{}({})", jrule::to_string(type_of(value)), components);
}

Spelled<std::string> spell(Expr const& expr, ir::RuleScheme const& rule, algebra::Group const& group, std::size_t lets,
                           std::optional<ExprType> expected) {
  Speller speller(rule, group, lets);
  if (expected && expr.type != *expected) {
    return tl::unexpected(Unspellable{fmt::format("a {} stands where a {} is expected", to_string(expr.type), to_string(*expected))});
  }
  std::string text = speller.spell(expected == ExprType{Type::Real} ? written(expr) : expr, conditional);
  if (!speller.fault.empty()) return tl::unexpected(Unspellable{std::move(speller.fault)});
  return text;
}

}  // namespace jrule::text
