#include "compiler/jerboa/value.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace jrule::jerboa {

using enum Value::Level;

namespace {

bool is_number(Value const& v) { return v.kind == Value::Kind::plain && (v.type == Type::integer || v.type == Type::real); }
bool is_vector(Value const& v) { return v.kind == Value::Kind::plain && (v.type == Type::vec2 || v.type == Type::vec3); }
bool is_point(Value const& v) { return v.kind == Value::Kind::plain && (v.type == Type::point2 || v.type == Type::point3); }
bool is_color(Value const& v) { return v.kind == Value::Kind::plain && v.type == Type::color; }
bool is_tuple(Value const& v) { return v.kind == Value::Kind::tuple; }
bool is_flat(Type type) { return type == Type::vec2 || type == Type::point2; }
Type vector_of(Type type) { return is_flat(type) ? Type::vec2 : Type::vec3; }
Type point_of(Type type) { return is_flat(type) ? Type::point2 : Type::point3; }

tl::unexpected<Reason> no(std::string text) { return tl::unexpected(Reason{std::move(text)}); }

std::string describe(Value const& v) {
  switch (v.kind) {
    case Value::Kind::tuple: return "coordinates";
    case Value::Kind::list: return "a list";
    case Value::Kind::dart: return "a dart";
    case Value::Kind::plain: break;
  }
  return fmt::format("{} {}", v.type == Type::integer ? "an" : "a", name_of(v.type));
}

std::string origin(Type point) { return is_flat(point) ? "Point2(0, 0)" : "Point3(0, 0, 0)"; }

Value infix(Value const& a, std::string_view sign, Value const& b, Type type, Value::Level level) {
  auto const tighter = static_cast<Value::Level>(static_cast<int>(level) + 1);
  return plain(fmt::format("{} {} {}", at_level(a, level), sign, at_level(b, tighter)), type, level);
}

/// Two values of one type, the tuples among them taken for what the other is.
Translated<std::pair<Value, Value>> alike(Value const& a, Value const& b) {
  if (is_number(a) && is_number(b)) return std::pair{a, b};
  Type const type = !is_tuple(a) ? a.type : !is_tuple(b) ? b.type : a.components == 2 ? Type::point2 : Type::point3;
  auto left = convert(a, type), right = convert(b, type);
  if (!left) return tl::unexpected(left.error());
  if (!right) return tl::unexpected(right.error());
  return std::pair{std::move(*left), std::move(*right)};
}

Type number_type(Value const& a, Value const& b) { return a.type == Type::integer && b.type == Type::integer ? Type::integer : Type::real; }

}  // namespace

std::string at_level(Value const& value, Value::Level level) { return value.level < level ? "(" + value.text + ")" : value.text; }

Value plain(std::string text, Type type, Value::Level level) {
  return {.kind = Value::Kind::plain, .text = std::move(text), .type = type, .level = level};
}

Value tuple(std::vector<Value> const& components) {
  std::string text;
  for (Value const& component : components) text += fmt::format("{}{}", text.empty() ? "" : ", ", component.text);
  return {.kind = Value::Kind::tuple, .text = "(" + text + ")", .components = components.size()};
}

Translated<Value> convert(Value const& value, Type type) {
  if (is_tuple(value)) {
    bool const fits = type == Type::color ? value.components == 3 : type >= Type::vec2 && value.components == (is_flat(type) ? 2U : 3U);
    if (!fits) return no(fmt::format("{} coordinates are no {}", value.components, name_of(type)));
    return plain(fmt::format("{}{}", name_of(type), value.text), type);
  }
  if (value.kind != Value::Kind::plain) return no(fmt::format("{} is no {}", describe(value), name_of(type)));
  if (value.type == type || (value.type == Type::integer && type == Type::real)) return value;
  if (is_vector(value) && type == point_of(value.type)) return plain(fmt::format("{} + {}", origin(type), at_level(value, multiplication)), type, addition);
  if (is_point(value) && type == vector_of(value.type)) return plain(fmt::format("{} - {}", at_level(value, addition), origin(value.type)), type, addition);
  return no(fmt::format("{} is no {}", describe(value), name_of(type)));
}

Translated<Value> add(Value const& a, Value const& b) {
  if (is_number(a) && is_number(b)) return infix(a, "+", b, number_type(a, b), addition);
  if (is_color(a) || is_color(b)) {
    auto const both = alike(a, b);
    return both ? Translated<Value>(infix(both->first, "+", both->second, Type::color, addition)) : tl::unexpected(both.error());
  }
  // The first operand says which it is, a place or a displacement; what is added is a displacement.
  Value const& known = is_tuple(a) ? b : a;
  if (is_tuple(known) || !(is_point(known) || is_vector(known))) return no(fmt::format("there is no sum of {} and {}", describe(a), describe(b)));
  Type const type = is_tuple(a) ? vector_of(b.type) : a.type;
  auto const left = convert(a, type), right = convert(b, vector_of(known.type));
  if (!left) return tl::unexpected(left.error());
  if (!right) return tl::unexpected(right.error());
  return infix(*left, "+", *right, type, addition);
}

Translated<Value> subtract(Value const& a, Value const& b) {
  if (is_number(a) && is_number(b)) return infix(a, "-", b, number_type(a, b), addition);
  if (is_point(a) && is_point(b) && a.type == b.type) return infix(a, "-", b, vector_of(a.type), addition);
  if (is_point(b) && is_tuple(a)) {
    auto const left = convert(a, b.type);
    return left ? Translated<Value>(infix(*left, "-", b, vector_of(b.type), addition)) : tl::unexpected(left.error());
  }
  if (is_point(a) || is_vector(a)) {
    auto const right = convert(b, vector_of(a.type));
    return right ? Translated<Value>(infix(a, "-", *right, a.type, addition)) : tl::unexpected(right.error());
  }
  return no(fmt::format("there is no difference of {} and {}", describe(a), describe(b)));
}

Translated<Value> multiply(Value const& a, Value const& b) {
  if (is_number(a) && is_number(b)) return infix(a, "*", b, number_type(a, b), multiplication);
  Value const& number = is_number(a) ? a : b;
  Value const& other = is_number(a) ? b : a;
  if (!is_number(number) || is_number(other) || other.kind == Value::Kind::list || other.kind == Value::Kind::dart || other.type == Type::boolean)
    return no(fmt::format("there is no product of {} and {}", describe(a), describe(b)));
  Type const type = is_tuple(other) ? (other.components == 2 ? Type::vec2 : Type::vec3) : is_color(other) ? Type::color : vector_of(other.type);
  auto const factor = convert(other, type);
  if (!factor) return tl::unexpected(factor.error());
  return is_number(a) ? infix(a, "*", *factor, type, multiplication) : infix(*factor, "*", b, type, multiplication);
}

Translated<Value> divide(Value const& a, Value const& b) {
  if (!is_number(b)) return no(fmt::format("there is no quotient of {} and {}", describe(a), describe(b)));
  if (a.constant && b.constant) {
    if (*b.constant == 0 || *b.constant == -1) return no("there is no quotient of these Ints");
    Value quotient = plain(std::to_string(*a.constant / *b.constant), Type::integer);
    quotient.constant = *a.constant / *b.constant;
    return quotient;
  }
  if (is_number(a)) {
    if (number_type(a, b) == Type::integer) return no("there is no division of Ints");
    return infix(a, "/", b, Type::real, multiplication);
  }
  auto product = multiply(a, b);
  if (!product) return product;
  auto const dividend = convert(a, product->type);
  return dividend ? Translated<Value>(infix(*dividend, "/", b, product->type, multiplication)) : tl::unexpected(dividend.error());
}

Translated<Value> negate(Value const& a) {
  if (is_number(a)) {
    Value result = plain("-" + at_level(a, unary), a.type, unary);
    if (a.constant) result.constant = -*a.constant;
    return result;
  }
  if (!is_tuple(a) && !is_vector(a)) return no(fmt::format("there is no opposite of {}", describe(a)));
  auto const operand = is_tuple(a) ? convert(a, a.components == 2 ? Type::vec2 : Type::vec3) : Translated<Value>(a);
  if (!operand) return tl::unexpected(operand.error());
  return plain("-" + at_level(*operand, unary), operand->type, unary);
}

Translated<Value> compare(std::string_view sign, Value const& a, Value const& b) {
  bool const equality = sign == "==" || sign == "!=";
  bool const darts = a.kind == Value::Kind::dart && b.kind == Value::Kind::dart;
  if (!(is_number(a) && is_number(b)) && !(equality && darts)) return no(fmt::format("{} and {} are not compared by `{}`", describe(a), describe(b), sign));
  return plain(fmt::format("{} {} {}", at_level(a, addition), sign, at_level(b, addition)), Type::boolean, comparison);
}

// ---- Functions ----

namespace {

bool is_any_of(std::string_view name, std::initializer_list<std::string_view> names) { return std::find(names.begin(), names.end(), name) != names.end(); }

Translated<Value> mix(std::string_view function, Value const& a, Value const& b, std::string_view weight) {
  auto const both = alike(a, b);
  if (!both) return tl::unexpected(both.error());
  if (both->first.type == Type::boolean || both->first.kind != Value::Kind::plain) return no(fmt::format("there is no mean of {} and {}", describe(a), describe(b)));
  Type const type = is_number(a) ? Type::real : both->first.type;
  return plain(fmt::format("{}({}, {}{})", function, both->first.text, both->second.text, weight), type);
}

/// As vectors, both operands in three dimensions or both in two.
Translated<std::pair<Value, Value>> vectors(Value const& a, Value const& b) {
  Type const type = vector_of(is_tuple(a) ? (a.components == 2 ? Type::vec2 : Type::vec3) : a.type);
  auto left = convert(a, type), right = convert(b, type);
  if (!left) return tl::unexpected(left.error());
  if (!right) return tl::unexpected(right.error());
  return std::pair{std::move(*left), std::move(*right)};
}

}  // namespace

Translated<Value> call(std::string_view function, std::vector<Value> const& arguments) {
  std::size_t const count = arguments.size();
  if (is_any_of(function, {"mid", "middle", "midpoint", "barycenter", "barycentre", "bary", "mean", "average"})) {
    if (count == 1 && arguments[0].kind == Value::Kind::list) {
      Type const type = arguments[0].type == Type::integer ? Type::real : arguments[0].type;
      return plain(fmt::format("mean({})", arguments[0].text), type);
    }
    if (count == 2) return mix("midpoint", arguments[0], arguments[1], "");
    return no(fmt::format("`{}` is known of a list or of two values", function));
  }
  if (is_any_of(function, {"segmentABByWeight", "lerp"}) && count == 3) {
    if (!is_number(arguments[2])) return no(fmt::format("the weight is {}", describe(arguments[2])));
    return mix("lerp", arguments[0], arguments[1], ", " + arguments[2].text);
  }
  if (is_any_of(function, {"dot", "cross"}) && count == 2) {
    auto const both = vectors(arguments[0], arguments[1]);
    if (!both) return tl::unexpected(both.error());
    if (function == "cross" && both->first.type != Type::vec3) return no("there is no cross product in the plane");
    return plain(fmt::format("{}({}, {})", function, both->first.text, both->second.text), function == "dot" ? Type::real : Type::vec3);
  }
  if (is_any_of(function, {"dist", "distance"}) && count == 2) {
    Type const type = point_of(is_tuple(arguments[0]) ? (arguments[0].components == 2 ? Type::point2 : Type::point3) : arguments[0].type);
    auto const a = convert(arguments[0], type), b = convert(arguments[1], type);
    if (!a) return tl::unexpected(a.error());
    if (!b) return tl::unexpected(b.error());
    return plain(fmt::format("distance({}, {})", a->text, b->text), Type::real);
  }
  if (is_any_of(function, {"norm", "length"}) && count == 1 && (is_vector(arguments[0]) || is_point(arguments[0]))) {
    auto const vector = convert(arguments[0], vector_of(arguments[0].type));
    if (!vector) return tl::unexpected(vector.error());
    return plain(fmt::format("norm({})", vector->text), Type::real);
  }
  if (is_any_of(function, {"sqrt", "sin", "cos", "tan", "exp", "log", "floor", "ceil"}) && count == 1 && is_number(arguments[0]))
    return plain(fmt::format("{}({})", function, arguments[0].text), Type::real);
  if (function == "abs" && count == 1 && is_number(arguments[0])) return plain(fmt::format("abs({})", arguments[0].text), arguments[0].type);
  if (is_any_of(function, {"atan2", "pow", "min", "max"}) && count == 2 && is_number(arguments[0]) && is_number(arguments[1])) {
    Type const type = is_any_of(function, {"min", "max"}) ? number_type(arguments[0], arguments[1]) : Type::real;
    return plain(fmt::format("{}({}, {})", function, arguments[0].text, arguments[1].text), type);
  }
  return no(fmt::format("there is no counterpart of `{}` for these values", function));
}

Translated<Value> construct(std::string_view jerboa_type, std::vector<Value> const& arguments) {
  auto const type = type_of(jerboa_type);
  if (!type) return no(fmt::format("the type `{}` is not known", jerboa_type));
  if (arguments.size() == 1) {
    bool const both_spatial = *type >= Type::vec2 && *type <= Type::point3 && (is_point(arguments[0]) || is_vector(arguments[0]));
    return both_spatial ? Translated<Value>(arguments[0]) : convert(arguments[0], *type);
  }
  if (!std::all_of(arguments.begin(), arguments.end(), is_number)) return no(fmt::format("the components of `{}` are not all numbers", jerboa_type));
  if (*type == Type::color) {
    // As in java.awt: Ints are of 255, Reals of 1.
    if (arguments.size() != 3) return no("colors have three components, red, green and blue");
    if (!std::all_of(arguments.begin(), arguments.end(), [](Value const& v) { return v.type == Type::integer; })) return tuple(arguments);
    std::vector<Value> parts;
    for (Value const& part : arguments) {
      bool const whole = part.constant && (*part.constant == 0 || *part.constant == 255);
      parts.push_back(whole ? plain(*part.constant == 0 ? "0" : "1", Type::integer)
                            : plain(fmt::format("{} / 255", at_level(part, multiplication)), Type::real, multiplication));
    }
    return tuple(parts);
  }
  std::size_t const needed = is_flat(*type) ? 2 : 3;
  if (*type < Type::vec2) return no(fmt::format("`{}` is not made of components", jerboa_type));
  if (arguments.empty()) return tuple(std::vector<Value>(needed, plain("0", Type::integer)));
  if (arguments.size() != needed) return no(fmt::format("`{}` has {} components", jerboa_type, needed));
  return tuple(arguments);
}

std::optional<Value> constant(std::string_view qualifier, std::string_view name) {
  if (name == "M_PI" || (qualifier == "Math" && name == "PI")) return plain("pi", Type::real);
  if (qualifier != "Color") return std::nullopt;
  static constexpr auto colors = std::to_array<std::pair<std::string_view, std::string_view>>({
      {"BLACK", "(0, 0, 0)"},  {"WHITE", "(1, 1, 1)"},   {"RED", "(1, 0, 0)"},     {"GREEN", "(0, 1, 0)"},         {"BLUE", "(0, 0, 1)"},
      {"CYAN", "(0, 1, 1)"},   {"MAGENTA", "(1, 0, 1)"}, {"YELLOW", "(1, 1, 0)"},  {"ORANGE", "(1, 200 / 255, 0)"}, {"PINK", "(1, 175 / 255, 175 / 255)"},
      {"GRAY", "(128 / 255, 128 / 255, 128 / 255)"},     {"DARK_GRAY", "(64 / 255, 64 / 255, 64 / 255)"},
      {"LIGHT_GRAY", "(192 / 255, 192 / 255, 192 / 255)"},
  });
  std::string upper;
  for (char const c : name) upper += static_cast<char>(c >= 'a' && c <= 'z' ? c - 'a' + 'A' : c);
  auto const* const found = std::find_if(colors.begin(), colors.end(), [&](auto const& entry) { return entry.first == upper; });
  if (found == colors.end()) return std::nullopt;
  return plain(fmt::format("Color{}", found->second), Type::color);
}

}  // namespace jrule::jerboa
