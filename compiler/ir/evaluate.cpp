#include "compiler/ir/evaluate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace jrule::ir {

namespace {

template <class... Functions>
struct Overloaded : Functions... {
  using Functions::operator()...;
};

using Int = std::int64_t;
// The overloads below take exactly these types: C++ would convert one into another.
template <class T>
concept Integer = std::same_as<T, Int>;
template <class T>
concept Number = Integer<T> || std::same_as<T, double>;
/// All but Bool and Int.
template <class T>
concept Continuous = std::same_as<T, double> || std::is_class_v<T>;

constexpr Overloaded plus{[](Integer auto a, Integer auto b) { return add(a, b); },
                          [](Continuous auto a, Continuous auto b) -> decltype(a + b) { return a + b; }};
constexpr Overloaded minus{[](Integer auto a, Integer auto b) { return subtract(a, b); },
                           [](Continuous auto a, Continuous auto b) -> decltype(a - b) { return a - b; }};
constexpr Overloaded times{[](Integer auto a, Integer auto b) { return multiply(a, b); },
                           [](Continuous auto a, Continuous auto b) -> decltype(a * b) { return a * b; }};
constexpr Overloaded opposite{[](Integer auto a) { return negate(a); },
                              [](Continuous auto a) -> decltype(-a) { return -a; }};
constexpr auto quotient = [](Continuous auto a, std::same_as<double> auto b) -> decltype(a / b) { return a / b; };

/// A function of two numbers of one type, for those only.
constexpr auto of_numbers = [](auto f) { return [f]<Number T>(T a, T b) { return f(a, b); }; };

class Application {
 public:
  Application(Builtin function, std::span<Evaluated const> arguments) : function_(function), arguments_(arguments) {}

  Value result() const {
    switch (function_) {
      case Builtin::add: return binary(plus);
      case Builtin::subtract: return binary(minus);
      case Builtin::multiply: return binary(times);
      case Builtin::divide: return binary(quotient);
      case Builtin::negate: return unary(opposite);
      case Builtin::less: return binary(of_numbers([](auto a, auto b) { return a < b; }));
      case Builtin::less_equal: return binary(of_numbers([](auto a, auto b) { return a <= b; }));
      case Builtin::greater: return binary(of_numbers([](auto a, auto b) { return a > b; }));
      case Builtin::greater_equal: return binary(of_numbers([](auto a, auto b) { return a >= b; }));
      case Builtin::equal: return arguments_[0] == arguments_[1];  // values or darts
      case Builtin::not_equal: return !(arguments_[0] == arguments_[1]);
      case Builtin::logical_and: return as<bool>(0) && as<bool>(1);
      case Builtin::logical_or: return as<bool>(0) || as<bool>(1);
      case Builtin::logical_not: return !as<bool>(0);
      case Builtin::to_real: return static_cast<double>(as<Int>(0));
      case Builtin::vec2: return Vec2{real(0), real(1)};
      case Builtin::vec3: return Vec3{real(0), real(1), real(2)};
      case Builtin::point2: return Point2{real(0), real(1)};
      case Builtin::point3: return Point3{real(0), real(1), real(2)};
      case Builtin::color: return Color{real(0), real(1), real(2)};
      case Builtin::component_0: return component(value(0), 0);
      case Builtin::component_1: return component(value(0), 1);
      case Builtin::component_2: return component(value(0), 2);
      case Builtin::dot:
        return binary([](Continuous auto a, Continuous auto b) -> decltype(dot(a, b)) { return dot(a, b); });
      case Builtin::cross: return cross(as<Vec3>(0), as<Vec3>(1));
      case Builtin::norm: return unary([](Continuous auto a) -> decltype(norm(a)) { return norm(a); });
      case Builtin::normalize: return unary([](Continuous auto a) -> decltype(normalize(a)) { return normalize(a); });
      case Builtin::midpoint:
        return binary([](Continuous auto a, Continuous auto b) -> decltype(midpoint(a, b)) { return midpoint(a, b); });
      case Builtin::lerp: {
        double const t = real(2);
        return binary([t](Continuous auto a, Continuous auto b) -> decltype(lerp(a, b, 0.0)) { return lerp(a, b, t); });
      }
      case Builtin::distance:
        return binary([](Continuous auto a, Continuous auto b) -> decltype(distance(a, b)) { return distance(a, b); });
      case Builtin::area_vector: return aggregate([](std::span<Point3 const> corners) { return area_vector(corners); });
      case Builtin::sqrt: return std::sqrt(real(0));
      case Builtin::abs: return unary([](Number auto a) { return abs(a); });
      case Builtin::floor: return std::floor(real(0));
      case Builtin::ceil: return std::ceil(real(0));
      case Builtin::sin: return jrule::sin(real(0));
      case Builtin::cos: return jrule::cos(real(0));
      case Builtin::tan: return jrule::tan(real(0));
      case Builtin::atan2: return jrule::atan2(real(0), real(1));
      case Builtin::pow: return jrule::pow(real(0), real(1));
      case Builtin::exp: return jrule::exp(real(0));
      case Builtin::log: return jrule::log(real(0));
      case Builtin::mean: return aggregate([](auto values) -> decltype(mean(values)) { return mean(values); });
      case Builtin::sum: return aggregate([](auto values) -> decltype(sum(values)) { return sum(values); });
      case Builtin::min:
        if (arguments_.size() == 2) return binary(of_numbers([](auto a, auto b) { return min(a, b); }));
        return aggregate([](auto values) -> decltype(min(values)) { return min(values); });
      case Builtin::max:
        if (arguments_.size() == 2) return binary(of_numbers([](auto a, auto b) { return max(a, b); }));
        return aggregate([](auto values) -> decltype(max(values)) { return max(values); });
      case Builtin::count: return static_cast<Int>(size());
      case Builtin::first: return list().at(0);
      case Builtin::all: return std::all_of(list().begin(), list().end(), is_true);
      case Builtin::any: return std::any_of(list().begin(), list().end(), is_true);
    }
    fail();
  }

 private:
  [[noreturn]] void fail() const {
    throw std::invalid_argument("`" + std::string(spelling(function_)) + "` does not take these arguments");
  }
  Value const& value(std::size_t i) const { return std::get<Value>(arguments_[i]); }
  std::vector<Value> const& list() const { return std::get<List<Value>>(arguments_[0]); }
  std::size_t size() const {
    auto const* darts = std::get_if<List<Dart>>(&arguments_[0]);
    return darts ? darts->size() : list().size();
  }
  template <class T>
  T as(std::size_t i) const {
    return std::get<T>(value(i));
  }
  double real(std::size_t i) const { return as<double>(i); }
  static bool is_true(Value const& v) { return std::get<bool>(v); }

  // `f` of the arguments as the C++ types that they have, where it takes them.
  template <class F>
  Value unary(F f) const {
    return std::visit(
        [&](auto a) -> Value {
          if constexpr (std::invocable<F, decltype(a)>) return f(a);
          else fail();
        },
        value(0));
  }
  template <class F>
  Value binary(F f) const {
    return std::visit(
        [&](auto a, auto b) -> Value {
          if constexpr (std::invocable<F, decltype(a), decltype(b)>) return f(a, b);
          else fail();
        },
        value(0), value(1));
  }
  template <class F>
  Value aggregate(F f) const {
    if (list().empty()) fail();
    return std::visit(
        [&]<class T>(T const&) -> Value {
          if constexpr (std::invocable<F, std::span<T const>>) {
            std::vector<T> values;
            for (Value const& v : list()) values.push_back(std::get<T>(v));
            return f(std::span<T const>(values));
          } else {
            fail();
          }
        },
        list().front());
  }

  Builtin function_;
  std::span<Evaluated const> arguments_;
};

}  // namespace

Evaluated apply(Builtin function, std::span<Evaluated const> arguments) {
  return Application(function, arguments).result();
}

namespace {

bool is_true(Evaluated const& value) { return std::get<bool>(std::get<Value>(value)); }

Value const* constant(Expr const& expr) {
  auto const* c = std::get_if<Constant>(&expr.value);
  return c ? &c->value : nullptr;
}

}  // namespace

namespace {
constexpr std::size_t max_arguments = 3;  // of a built-in function
}  // namespace

Evaluated evaluate(Expr const& expr, std::function<Evaluated(Expr const&)> const& leaf) {
  if (auto const* constant = std::get_if<Constant>(&expr.value)) return constant->value;
  if (auto const* application = std::get_if<Apply>(&expr.value)) {
    std::array<Evaluated, max_arguments> arguments;  // no memory is taken for single values
    std::size_t count = 0;
    for (ExprPtr const& argument : application->arguments) {
      Evaluated& value = arguments.at(count++) = evaluate(*argument, leaf);
      if (application->function == Builtin::logical_and && !is_true(value)) return Value{false};
      if (application->function == Builtin::logical_or && is_true(value)) return Value{true};
    }
    return ir::apply(application->function, std::span(arguments).first(count));
  }
  if (auto const* conditional = std::get_if<Conditional>(&expr.value)) {
    bool const holds = is_true(evaluate(*conditional->condition, leaf));
    return evaluate(holds ? *conditional->then_value : *conditional->else_value, leaf);
  }
  return leaf(expr);
}

ExprPtr fold(Expr expr) {
  auto const stand_in = [&](ExprPtr const& part) { return std::make_shared<Expr const>(Expr{expr.type, part->value, expr.span}); };
  if (auto const* application = std::get_if<Apply>(&expr.value)) {
    Builtin const function = application->function;
    auto const& parts = application->arguments;
    std::vector<Evaluated> values;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      Value const* const value = constant(*parts[i]);
      if (!value) continue;
      if (function == Builtin::logical_and || function == Builtin::logical_or) {
        bool const decides = std::get<bool>(*value) == (function == Builtin::logical_or);
        return stand_in(parts[decides ? i : 1 - i]);
      }
      values.push_back(*value);
    }
    if (!values.empty() && values.size() == parts.size()) {
      expr.value = Constant{std::get<Value>(ir::apply(function, values))};
    }
  } else if (auto const* conditional = std::get_if<Conditional>(&expr.value)) {
    if (Value const* const holds = constant(*conditional->condition)) {
      return stand_in(std::get<bool>(*holds) ? conditional->then_value : conditional->else_value);
    }
  }
  return std::make_shared<Expr const>(std::move(expr));
}

}  // namespace jrule::ir
