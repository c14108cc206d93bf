#include "tests/reference/expressions.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <stdexcept>
#include <string>

namespace jrule::reference {

namespace {

using Int = std::int64_t;
using ir::Builtin;
using Values = std::vector<Value>;
using Darts = std::vector<Dart>;
using Evaluated = std::variant<Value, Values, Dart, Darts>;

Dart step(PlainMap const& map, Dart d, Letter letter) {
  if (!letter.conjugate) return map.targets.at(d).at(letter.dimension).at(0);
  for (auto const& [source, arcs] : map.targets) {
    if (arcs.at(letter.dimension).at(0) == d) return source;
  }
  throw std::invalid_argument("a dart without an incoming arc");
}

/// Depth first: from each dart along the words in their order, forwards, to darts not met before.
void visit(PlainMap const& map, OrbitType const& type, Dart d, Darts& met) {
  if (std::find(met.begin(), met.end(), d) != met.end()) return;
  met.push_back(d);
  for (Word const& word : type.words) visit(map, type, walk(map, d, word), met);
}

// Unsigned arithmetic wraps around.
Int wrapped(std::uint64_t a) { return static_cast<Int>(a); }
std::uint64_t bits(Int a) { return static_cast<std::uint64_t>(a); }

struct Evaluator {
  Ground const& ground;
  Dart u;
  Darts bound{};  // by level

  Evaluated operator()(ir::Expr const& expr) {
    return std::visit([&](auto const& node) { return evaluate(node); }, expr.value);
  }
  template <class T>
  T as(ir::ExprPtr const& expr) {
    return std::get<T>((*this)(*expr));
  }
  template <class T>
  T plain(ir::ExprPtr const& expr) {
    return std::get<T>(as<Value>(expr));
  }

  Evaluated evaluate(ir::Constant const& constant) { return constant.value; }
  Evaluated evaluate(ir::NodeDart const& node) { return ground.match.at({u, node.node}); }
  Evaluated evaluate(ir::Bound const& variable) { return bound.at(variable.level); }
  Evaluated evaluate(ir::Walk const& w) { return walk(ground.map, as<Dart>(w.from), w.path); }
  Evaluated evaluate(ir::Darts const& darts) { return members(darts); }
  Evaluated evaluate(ir::ValueAt const& v) { return ground.values.at(v.embedding).at(as<Dart>(v.at)); }
  Evaluated evaluate(ir::Collect const& collect) {
    Values list;
    for (Dart const d : members(collect.over)) list.push_back(ground.values.at(collect.embedding).at(d));
    return list;
  }
  Evaluated evaluate(ir::ForEach const& comprehension) {
    Values list;
    for (Dart const d : members(comprehension.over)) {
      bound.resize(comprehension.variable.level);
      bound.push_back(d);
      list.push_back(as<Value>(comprehension.element));
    }
    return list;
  }
  Evaluated evaluate(ir::Conditional const& c) {
    return (*this)(*(plain<bool>(c.condition) ? c.then_value : c.else_value));
  }
  Evaluated evaluate(ir::ParameterRef const&) { throw std::invalid_argument("a parameter"); }
  Evaluated evaluate(ir::LetRef const&) { throw std::invalid_argument("a let"); }
  Evaluated evaluate(ir::VariableRef const&) { throw std::invalid_argument("a variable of an operation"); }
  Evaluated evaluate(ir::CopyOf const&) { throw std::invalid_argument("a copy, in an operation"); }
  Evaluated evaluate(ir::Call const&) { throw std::invalid_argument("an extern function"); }

  /// The first dart met of each ⟨by⟩-orbit inside the orbit.
  Darts members(ir::Darts const& darts) {
    Darts met, first;
    std::set<Dart> taken;
    visit(ground.map, darts.orbit, as<Dart>(darts.at), met);
    for (Dart const d : met) {
      if (taken.contains(d)) continue;
      first.push_back(d);
      Darts same;
      visit(ground.map, darts.by, d, same);
      taken.insert(same.begin(), same.end());
    }
    return first;
  }

  Evaluated evaluate(ir::Apply const& apply) {
    auto const& arguments = apply.arguments;
    switch (apply.function) {
      case Builtin::logical_and: return Value(plain<bool>(arguments[0]) && plain<bool>(arguments[1]));
      case Builtin::logical_or: return Value(plain<bool>(arguments[0]) || plain<bool>(arguments[1]));
      case Builtin::logical_not: return Value(!plain<bool>(arguments[0]));
      case Builtin::equal: return Value((*this)(*arguments[0]) == (*this)(*arguments[1]));
      case Builtin::not_equal: return Value((*this)(*arguments[0]) != (*this)(*arguments[1]));
      case Builtin::to_real: return Value(static_cast<double>(plain<Int>(arguments[0])));
      case Builtin::negate:
        if (arguments[0]->type.element == Type::Int) return Value(wrapped(-bits(plain<Int>(arguments[0]))));
        return Value(-plain<double>(arguments[0]));
      default: break;
    }
    if (arguments.size() == 2) {
      if (arguments[0]->type.element == Type::Int)
        return of_two(apply.function, plain<Int>(arguments[0]), plain<Int>(arguments[1]));
      return of_two(apply.function, plain<double>(arguments[0]), plain<double>(arguments[1]));
    }
    Evaluated const list = (*this)(*arguments.at(0));
    if (apply.function == Builtin::count) {
      auto const* darts = std::get_if<Darts>(&list);
      return Value(static_cast<Int>(darts ? darts->size() : std::get<Values>(list).size()));
    }
    return of_list(apply.function, std::get<Values>(list));
  }

  [[noreturn]] static void fail(Builtin function) {
    throw std::invalid_argument("no reference for `" + std::string(ir::spelling(function)) + "`");
  }

  static Value of_two(Builtin function, Int a, Int b) {
    switch (function) {
      case Builtin::add: return wrapped(bits(a) + bits(b));
      case Builtin::subtract: return wrapped(bits(a) - bits(b));
      case Builtin::multiply: return wrapped(bits(a) * bits(b));
      default: return compared(function, a, b);
    }
  }
  static Value of_two(Builtin function, double a, double b) {
    switch (function) {
      case Builtin::add: return a + b;
      case Builtin::subtract: return a - b;
      case Builtin::multiply: return a * b;
      case Builtin::divide: return a / b;
      case Builtin::midpoint: return std::midpoint(a, b);
      default: return compared(function, a, b);
    }
  }
  template <class T>
  static Value compared(Builtin function, T a, T b) {
    switch (function) {
      case Builtin::less: return a < b;
      case Builtin::less_equal: return a <= b;
      case Builtin::greater: return a > b;
      case Builtin::greater_equal: return a >= b;
      case Builtin::min: return lesser(a, b);
      case Builtin::max: return greater(a, b);
      default: fail(function);
    }
  }

  // The first of equal values, and NaN if either is.
  template <class T>
  static T lesser(T a, T b) {
    return a != a || !(b < a || b != b) ? a : b;
  }
  template <class T>
  static T greater(T a, T b) {
    return a != a || !(a < b || b != b) ? a : b;
  }

  static Value of_list(Builtin function, Values const& list) {
    if (function == Builtin::first) return list.at(0);
    if (function == Builtin::all || function == Builtin::any) {
      bool const decides = function == Builtin::any;
      return std::find(list.begin(), list.end(), Value(decides)) != list.end() ? decides : !decides;
    }
    if (std::holds_alternative<Int>(list.at(0))) return of_numbers<Int>(function, list);
    return of_numbers<double>(function, list);
  }
  template <class T>
  static Value of_numbers(Builtin function, Values const& list) {
    if (function == Builtin::mean) {  // Ints are added as Reals
      double sum = 0;
      for (Value const& v : list) sum += static_cast<double>(std::get<T>(v));
      return sum / static_cast<double>(list.size());
    }
    Value result = function == Builtin::sum ? Value(T{}) : list[0];
    for (Value const& v : list) {
      Builtin const two = function == Builtin::sum ? Builtin::add : function;
      result = of_two(two, std::get<T>(result), std::get<T>(v));
    }
    return result;
  }
};

}  // namespace

Dart walk(PlainMap const& map, Dart d, Word const& word) {
  for (Letter const letter : word) d = step(map, d, letter);
  return d;
}

std::vector<std::vector<Dart>> orbits(PlainMap const& map, OrbitType const& type) {
  std::vector<std::vector<Dart>> all;
  std::set<Dart> seen;
  for (auto const& [d, arcs] : map.targets) {
    if (seen.contains(d)) continue;
    Darts members;
    visit(map, type, d, members);  // words permute the darts: what leads here is also where they lead
    std::sort(members.begin(), members.end());
    seen.insert(members.begin(), members.end());
    all.push_back(std::move(members));
  }
  return all;
}

Value value_at(ir::Expr const& expr, Ground const& ground, Dart u) {
  return std::get<Value>(Evaluator{ground, u}(expr));
}

}  // namespace jrule::reference
