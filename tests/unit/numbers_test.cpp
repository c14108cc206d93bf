// Numbers at their edges: what each operation gives, and that constants and what is computed later agree to the last bit.
// That generated C++ does too is tested by tests/integration/generated_test.
#include <bit>
#include <cmath>
#include <functional>
#include <limits>

#include "compiler/ir/evaluate.h"
#include "expressions_fixture.h"

namespace jrule::sema {
namespace {

using Real = double;
using Int = std::int64_t;
using ir::Evaluated;

constexpr Real infinity = std::numeric_limits<Real>::infinity();
constexpr Real nan = std::numeric_limits<Real>::quiet_NaN();
constexpr Int greatest = std::numeric_limits<Int>::max();
constexpr Int least = std::numeric_limits<Int>::min();

template <class T>
struct Edge {
  char const* text;
  T value;
};

constexpr Edge<Real> reals[] = {
    {"0.0", 0.0},
    {"(-0.0)", -0.0},
    {"1.0", 1.0},
    {"(-1.0)", -1.0},
    {"0.1", 0.1},
    {"(-2.5)", -2.5},
    {"3.0", 3.0},
    {"5e-324", 5e-324},
    {"1.7976931348623157e308", std::numeric_limits<Real>::max()},
    {"(-1.7976931348623157e308)", std::numeric_limits<Real>::lowest()},
    {"9007199254740993.0", 9007199254740992.0},
    {"(1e308 * 10)", infinity},
    {"(-(1e308 * 10))", -infinity},
    {"(1e308 * 10 - 1e308 * 10)", nan},
};

constexpr Edge<Int> ints[] = {
    {"0", 0}, {"1", 1}, {"(-1)", -1}, {"2", 2}, {"(-7)", -7}, {"4611686018427387904", Int{1} << 62},
    {"9007199254740993", 9007199254740993}, {"9223372036854775807", greatest}, {"(-9223372036854775807)", -greatest},
    {"(-9223372036854775807 - 1)", least},
};

bool same(Value const& a, Value const& b) {
  if (a.index() != b.index()) return false;
  for (int k = 0; k < component_count(type_of(a)); ++k) {
    Real const x = component(a, k), y = component(b, k);
    // Which NaN it is cannot be seen; the sign of a zero can.
    if (std::isnan(x) ? !std::isnan(y) : std::bit_cast<std::uint64_t>(x) != std::bit_cast<std::uint64_t>(y)) return false;
  }
  return type_of(a) != Type::Int || a == b;  // components of an Int are rounded
}

class Numbers : public Expressions {
 protected:
  Numbers() {
    for (char const* name : {"x", "y"}) rule_.parameters.push_back({name, Type::Real, {}});
    for (char const* name : {"p", "q"}) rule_.parameters.push_back({name, Type::Int, {}});
  }

  // `text` with each of the two names, both of one letter and as a word, replaced.
  static std::string replaced(std::string const& text, char first, std::string const& a, char second, std::string const& b) {
    auto const letter = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; };
    std::string result;
    for (std::size_t i = 0; i < text.size(); ++i) {
      bool const word = (i == 0 || !letter(text[i - 1])) && (i + 1 == text.size() || !letter(text[i + 1]));
      if (word && text[i] == first) result += a;
      else if (word && text[i] == second) result += b;
      else result += text[i];
    }
    return result;
  }

  template <class T, class Function, std::size_t N>
  void check_operation(std::string const& text, Edge<T> const (&edges)[N], Function expected) {
    char const first = std::is_same_v<T, Real> ? 'x' : 'p', second = std::is_same_v<T, Real> ? 'y' : 'q';
    ExprPtr const later = check(text);
    ASSERT_TRUE(later) << text << ": " << all_messages();
    ASSERT_FALSE(std::holds_alternative<ir::Constant>(later->value)) << text;
    for (Edge<T> const& a : edges) {
      for (Edge<T> const& b : edges) {
        Value const wanted = expected(a.value, b.value);
        std::string const constant_text = replaced(text, first, a.text, second, b.text);
        ExprPtr const folded = check(constant_text);
        ASSERT_TRUE(folded) << constant_text << ": " << all_messages();
        auto const* constant = std::get_if<ir::Constant>(&folded->value);
        ASSERT_TRUE(constant) << constant_text << " is not folded: " << ir::print(*folded, rule_);
        EXPECT_TRUE(same(constant->value, wanted)) << constant_text << " is " << to_string(constant->value) << ", not " << to_string(wanted);
        Evaluated const run = ir::evaluate(*later, [&](ir::Expr const& leaf) -> Evaluated {
          std::string const& name = rule_.parameters[std::get<ir::ParameterRef>(leaf.value).index].name;
          return Value{name[0] == first ? a.value : b.value};
        });
        EXPECT_TRUE(same(std::get<Value>(run), wanted)) << constant_text << " is " << to_string(std::get<Value>(run)) << " later, not " << to_string(wanted);
      }
    }
  }
  void real_operation(std::string const& text, std::function<Value(Real, Real)> const& expected) {
    check_operation(text, reals, expected);
  }
  void int_operation(std::string const& text, std::function<Value(Int, Int)> const& expected) {
    check_operation(text, ints, expected);
  }
};

__extension__ typedef __int128 Wide;  // ISO C++ has no such type

Int wrapped(Wide exact) { return static_cast<Int>(static_cast<std::uint64_t>(exact)); }

TEST_F(Numbers, IntArithmeticWrapsAt64Bits) {
  int_operation("p + q", [](Int a, Int b) { return wrapped(static_cast<Wide>(a) + b); });
  int_operation("p - q", [](Int a, Int b) { return wrapped(static_cast<Wide>(a) - b); });
  int_operation("p * q", [](Int a, Int b) { return wrapped(static_cast<Wide>(a) * b); });
  int_operation("-p + 0 * q", [](Int a, Int) { return wrapped(-static_cast<Wide>(a)); });
  int_operation("abs(p) + 0 * q", [](Int a, Int) { return wrapped(a < 0 ? -static_cast<Wide>(a) : a); });
}

TEST_F(Numbers, IntComparisonsAreExact) {
  int_operation("p < q", [](Int a, Int b) { return a < b; });
  int_operation("p <= q", [](Int a, Int b) { return a <= b; });
  int_operation("p > q", [](Int a, Int b) { return a > b; });
  int_operation("p >= q", [](Int a, Int b) { return a >= b; });
  int_operation("p == q", [](Int a, Int b) { return a == b; });
  int_operation("p != q", [](Int a, Int b) { return a != b; });
  int_operation("min(p, q)", [](Int a, Int b) { return std::min(a, b); });
  int_operation("max(p, q)", [](Int a, Int b) { return std::max(a, b); });
}

TEST_F(Numbers, AnIntBecomesTheNearestReal) {
  auto const to_real = [](Int a) { return static_cast<Real>(a); };
  int_operation("p / q", [&](Int a, Int b) { return to_real(a) / to_real(b); });
  int_operation("p + 0.5 * q", [&](Int a, Int b) { return to_real(a) + 0.5 * to_real(b); });
  int_operation("p == q + 0.0", [&](Int a, Int b) { return to_real(a) == to_real(b); });
  int_operation("if p < q then p else 1.5", [&](Int a, Int b) { return a < b ? to_real(a) : 1.5; });
}

TEST_F(Numbers, RealArithmeticFollowsIeee754) {
  real_operation("x + y", [](Real a, Real b) { return a + b; });
  real_operation("x - y", [](Real a, Real b) { return a - b; });
  real_operation("x * y", [](Real a, Real b) { return a * b; });
  real_operation("x / y", [](Real a, Real b) { return a / b; });
  real_operation("if y == y then -x else -x", [](Real a, Real) { return -a; });
  real_operation("if y == y then abs(x) else abs(x)", [](Real a, Real) { return std::fabs(a); });
  real_operation("if y == y then sqrt(x) else sqrt(x)", [](Real a, Real) { return a < 0 ? nan : std::sqrt(a); });
}

TEST_F(Numbers, NaNIsUnequalAndUnordered) {
  real_operation("x < y", [](Real a, Real b) { return std::isless(a, b); });
  real_operation("x <= y", [](Real a, Real b) { return std::islessequal(a, b); });
  real_operation("x > y", [](Real a, Real b) { return std::isgreater(a, b); });
  real_operation("x >= y", [](Real a, Real b) { return std::isgreaterequal(a, b); });
  real_operation("x == y", [](Real a, Real b) { return !std::isunordered(a, b) && !std::islessgreater(a, b); });
  real_operation("x != y", [](Real a, Real b) { return std::isunordered(a, b) || std::islessgreater(a, b); });
  real_operation("Vec2(x, 1) == Vec2(y, 1)", [](Real a, Real b) { return a == b; });
  real_operation("not (x < y) == (x >= y)", [](Real a, Real b) { return (!(a < b)) == (a >= b); });
}

// NaN if either is; of two equal ones the first: 0 and -0 are equal.
TEST_F(Numbers, ExtremesOfTwoReals) {
  real_operation("min(x, y)", [](Real a, Real b) { return std::isunordered(a, b) ? nan : b < a ? b : a; });
  real_operation("max(x, y)", [](Real a, Real b) { return std::isunordered(a, b) ? nan : b > a ? b : a; });
}

TEST_F(Numbers, RoundingStaysReal) {
  real_operation("if y == y then floor(x) else floor(x)", [](Real a, Real) {
    return !std::isfinite(a) || std::fabs(a) >= 4503599627370496.0 ? a : std::copysign(std::floor(a), a == 0 ? a : std::floor(a));
  });
  real_operation("if y == y then ceil(x) else ceil(x)", [](Real a, Real) {
    // Upwards to zero keeps the sign: ceil(-0.5) is -0.
    return !std::isfinite(a) || std::fabs(a) >= 4503599627370496.0 ? a : std::copysign(std::ceil(a), a);
  });
  EXPECT_EQ(check("floor(2.5)")->type, one(Type::Real));
}

TEST_F(Numbers, TheZeroVectorHasNoDirection) {
  real_operation("normalize(Vec2(0 * x, 0 * y))",
                 [](Real a, Real b) { return std::isfinite(a) && std::isfinite(b) ? Vec2{} : Vec2{nan, nan}; });
  real_operation("normalize(Vec3(x, 0, 0)).z + 0 * y", [](Real a, Real b) { return (std::isnan(a) ? nan : 0.0) + 0 * b; });
  real_operation("norm(Vec2(x, y))", [](Real a, Real b) { return std::sqrt(a * a + b * b); });
  real_operation("Vec2(x, y) / x", [](Real a, Real b) { return Vec2{a / a, b / a}; });
  real_operation("Color(x, y, 1) / y", [](Real a, Real b) { return Color{a / b, b / b, 1 / b}; });
}

TEST_F(Numbers, MathematicalFunctionsHaveNoErrors) {
  real_operation("pow(x, y)", [](Real a, Real b) { return std::pow(a, b); });
  real_operation("atan2(x, y)", [](Real a, Real b) { return std::atan2(a, b); });
  real_operation("exp(x) + log(y)", [](Real a, Real b) { return std::exp(a) + std::log(b); });
  real_operation("sin(x) + cos(y)", [](Real a, Real b) { return std::sin(a) + std::cos(b); });
  real_operation("tan(x) + 0 * y", [](Real a, Real b) { return std::tan(a) + 0 * b; });
  real_operation("midpoint(x, y)", [](Real a, Real b) { return std::midpoint(a, b); });
  real_operation("lerp(x, y, 0.25)", [](Real a, Real b) { return std::lerp(a, b, 0.25); });
  real_operation("lerp(x, 1.0, y)", [](Real a, Real b) { return std::lerp(a, 1.0, b); });
}

TEST_F(Numbers, AggregatesOfSpecialNumbers) {
  auto const of = [](ir::Builtin f, std::vector<Value> list) { return std::get<Value>(ir::apply(f, std::vector<Evaluated>{std::move(list)})); };
  using enum ir::Builtin;
  EXPECT_TRUE(same(of(min, {1.0, nan, -1.0}), nan));
  EXPECT_TRUE(same(of(max, {nan, 1.0}), nan));
  EXPECT_TRUE(same(of(min, {0.0, -0.0}), 0.0));
  EXPECT_TRUE(same(of(max, {-0.0, 0.0}), -0.0));
  EXPECT_TRUE(same(of(sum, {infinity, -infinity}), nan));
  EXPECT_TRUE(same(of(mean, {infinity, 1.0}), infinity));
  EXPECT_TRUE(same(of(mean, {1e308, 1e308}), infinity));  // the sum comes first
  EXPECT_TRUE(same(of(sum, {0.1, 0.2, 0.3}), 0.0 + 0.1 + 0.2 + 0.3));  // from left to right
  EXPECT_TRUE(same(of(sum, {greatest, Int{2}}), -greatest));
  EXPECT_TRUE(same(of(mean, {greatest, greatest}), 9223372036854775808.0));  // Ints are added as Reals
  EXPECT_TRUE(same(of(mean, {Int{1}, Int{2}}), 1.5));
  EXPECT_TRUE(same(of(min, {greatest, least}), least));
}

}  // namespace
}  // namespace jrule::sema
