// The values of constants, and of the functions on lists and on what only a map gives.
#include "compiler/ir/evaluate.h"

#include <cmath>
#include <limits>
#include <numbers>

#include "expressions_fixture.h"

namespace jrule::sema {
namespace {

using ir::Builtin;
using ir::Evaluated;

class Evaluation : public Expressions {
 protected:
  template <class T>
  T value(std::string const& text, Type type) {
    std::optional<Value> const v = constant(text, type);
    EXPECT_TRUE(v) << text << ": " << all_messages();
    return v ? std::get<T>(*v) : T{};
  }
  double real(std::string const& text) { return value<double>(text, Type::Real); }
  std::int64_t integer(std::string const& text) { return value<std::int64_t>(text, Type::Int); }
  bool truth(std::string const& text) { return value<bool>(text, Type::Bool); }
};

Value apply_to_list(Builtin function, std::vector<Value> list) {
  return std::get<Value>(ir::apply(function, std::vector<Evaluated>{std::move(list)}));
}

constexpr std::int64_t greatest = std::numeric_limits<std::int64_t>::max();
constexpr std::int64_t least = std::numeric_limits<std::int64_t>::min();

TEST_F(Evaluation, Integers) {
  EXPECT_EQ(integer("2 + 3 * 4 - 5"), 9);
  EXPECT_EQ(integer("7 - 2 - 3"), 2);
  EXPECT_EQ(integer("--7"), 7);
  EXPECT_EQ(integer("abs(-7) + abs(7)"), 14);
  EXPECT_EQ(integer("min(3, -2) * max(3, -2)"), -6);
}

TEST_F(Evaluation, IntegersWrapAround) {
  EXPECT_EQ(integer("9223372036854775807 + 1"), least);
  EXPECT_EQ(integer("-9223372036854775807 - 2"), greatest);
  EXPECT_EQ(integer("9223372036854775807 * 2"), -2);
  EXPECT_EQ(integer("-(-9223372036854775807 - 1)"), least);
  EXPECT_EQ(integer("abs(-9223372036854775807 - 1)"), least);
  EXPECT_EQ(std::get<std::int64_t>(apply_to_list(Builtin::sum, {greatest, std::int64_t{1}})), least);
}

TEST_F(Evaluation, Reals) {
  EXPECT_EQ(real("1 / 4"), 0.25);
  EXPECT_EQ(real("7 / 2 * 2"), 7.0);
  EXPECT_EQ(real("0.1 + 0.2"), 0.1 + 0.2);
  EXPECT_EQ(real("pi"), std::numbers::pi);
  EXPECT_EQ(real("3"), 3.0);
  EXPECT_EQ(real("9007199254740993"), 9007199254740992.0);
  EXPECT_EQ(real("sqrt(2)"), std::sqrt(2.0));
  EXPECT_EQ(real("floor(-1.5) + 10 * ceil(1.25)"), 18.0);
  EXPECT_EQ(real("abs(-0.5)"), 0.5);
  EXPECT_EQ(real("sin(1)"), std::sin(1.0));
  EXPECT_EQ(real("cos(1)"), std::cos(1.0));
  EXPECT_EQ(real("tan(1)"), std::tan(1.0));
  EXPECT_EQ(real("atan2(1, -2)"), std::atan2(1.0, -2.0));
  EXPECT_EQ(real("pow(2, 0.5)"), std::pow(2.0, 0.5));
  EXPECT_EQ(real("exp(1)"), std::exp(1.0));
  EXPECT_EQ(real("log(10)"), std::log(10.0));
  EXPECT_EQ(real("min(1, 0.5) - max(1, 0.5)"), -0.5);
  EXPECT_EQ(real("midpoint(1, 2)"), 1.5);
  EXPECT_EQ(real("lerp(1, 3, 0.25)"), 1.5);
}

TEST_F(Evaluation, DivisionByZeroAndNaNFollowIeee754) {
  double const infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(real("1 / 0"), infinity);
  EXPECT_EQ(real("-1 / 0"), -infinity);
  EXPECT_TRUE(std::isnan(real("0 / 0")));
  EXPECT_TRUE(std::isnan(real("sqrt(-1)")));
  EXPECT_EQ(real("log(0)"), -infinity);
  EXPECT_FALSE(truth("0 / 0 == 0 / 0"));
  EXPECT_TRUE(truth("0 / 0 != 0 / 0"));
  EXPECT_FALSE(truth("0 / 0 < 1"));
  EXPECT_FALSE(truth("0 / 0 >= 1"));
  EXPECT_FALSE(truth("Vec2(0 / 0, 1) == Vec2(0 / 0, 1)"));
  EXPECT_TRUE(std::isnan(real("min(1, 0 / 0)")));
  EXPECT_TRUE(std::isnan(real("max(0 / 0, 1)")));
  EXPECT_EQ(value<Vec2>("Vec2(1, -1) / 0", Type::Vec2), (Vec2{infinity, -infinity}));
  EXPECT_EQ(value<Vec3>("normalize(Vec3(0, 0, 0))", Type::Vec3), Vec3{});
}

TEST_F(Evaluation, Truths) {
  EXPECT_TRUE(truth("1 < 2 and 2 <= 2 and 3 > 2 and 2 >= 2 and 1 == 1 and 1 != 2"));
  EXPECT_FALSE(truth("2 < 2 or 3 <= 2 or 2 > 2 or 1 >= 2 or 1 == 2 or 1 != 1"));
  EXPECT_TRUE(truth("1 == 1.0"));
  EXPECT_TRUE(truth("not false and not not true"));
  EXPECT_FALSE(truth("true and false"));
  EXPECT_FALSE(truth("false and true"));
  EXPECT_TRUE(truth("false or true"));
  EXPECT_TRUE(truth("true == true"));
  EXPECT_TRUE(truth("9007199254740993 != 9007199254740992"));  // as Int, exactly
  EXPECT_FALSE(truth("Point3(0, 0, 1) == Point3(0, 0, 2)"));
  EXPECT_TRUE(truth("Color(0, 0.5, 1) == Color(0, 0.5, 1)"));
}

TEST_F(Evaluation, VectorsPointsAndColours) {
  EXPECT_EQ(value<Vec3>("Vec3(1, 2, 3) + 2 * Vec3(1, 0, 0) - Vec3(0, 1, 0) * 3 - Vec3(2, 2, 2) / 2", Type::Vec3),
            (Vec3{2, -2, 2}));
  EXPECT_EQ(value<Vec2>("-Vec2(1, -2) + Vec2(4, 4)", Type::Vec2), (Vec2{3, 6}));
  EXPECT_EQ(value<Vec3>("Point3(3, 2, 1) - Point3(1, 1, 1)", Type::Vec3), (Vec3{2, 1, 0}));
  EXPECT_EQ(value<Point3>("Point3(3, 2, 1) + Vec3(1, 1, 1)", Type::Point3), (Point3{4, 3, 2}));
  EXPECT_EQ(value<Point3>("Vec3(1, 1, 1) + Point3(3, 2, 1)", Type::Point3), (Point3{4, 3, 2}));
  EXPECT_EQ(value<Point2>("Point2(3, 2) - Vec2(1, 1)", Type::Point2), (Point2{2, 1}));
  EXPECT_EQ(value<Color>("(Color(0, 1, 0) + 0.5 * Color(1, 0, 0)) / 2", Type::Color), (Color{0.25, 0.5, 0}));
  EXPECT_EQ(real("dot(Vec3(1, 2, 3), Vec3(4, 5, 6)) + dot(Vec2(1, 2), Vec2(3, 4))"), 43.0);
  EXPECT_EQ(value<Vec3>("cross(Vec3(1, 0, 0), Vec3(0, 1, 0))", Type::Vec3), (Vec3{0, 0, 1}));
  EXPECT_EQ(real("norm(Vec2(3, 4)) + norm(Vec3(2, 3, 6))"), 12.0);
  EXPECT_EQ(value<Vec2>("normalize(Vec2(3, 4))", Type::Vec2), (Vec2{0.6, 0.8}));
  EXPECT_EQ(real("distance(Point3(1, 1, 1), Point3(3, 4, 7))"), 7.0);
  EXPECT_EQ(value<Point3>("midpoint(Point3(0, 0, 0), Point3(1, 2, 3))", Type::Point3), (Point3{0.5, 1, 1.5}));
  EXPECT_EQ(value<Point2>("lerp(Point2(0, 0), Point2(4, 8), 0.25)", Type::Point2), (Point2{1, 2}));
  EXPECT_EQ(value<Vec3>("Vec3(Point3(1, 2, 3).y, Color(4, 5, 6).b, Vec2(7, 8).x)", Type::Vec3), (Vec3{2, 6, 7}));
}

TEST_F(Evaluation, Conditionals) {
  EXPECT_EQ(integer("if 1 < 2 then 3 else 4"), 3);
  EXPECT_EQ(real("if 1 > 2 then 3 else if true then 4.5 else 5"), 4.5);
}

TEST_F(Evaluation, Lists) {
  EXPECT_EQ(std::get<double>(apply_to_list(Builtin::mean, {1.0, 2.0, 6.0})), 3.0);
  EXPECT_EQ(std::get<Point3>(apply_to_list(Builtin::mean, {Point3{0, 0, 0}, Point3{2, 4, 6}})), (Point3{1, 2, 3}));
  EXPECT_EQ(std::get<Color>(apply_to_list(Builtin::mean, {Color{0, 1, 0}, Color{1, 0, 0}})), (Color{0.5, 0.5, 0}));
  EXPECT_EQ(std::get<Vec2>(apply_to_list(Builtin::sum, {Vec2{1, 2}, Vec2{3, 4}})), (Vec2{4, 6}));
  EXPECT_EQ(std::get<std::int64_t>(apply_to_list(Builtin::min, {std::int64_t{3}, std::int64_t{-4}})), -4);
  EXPECT_EQ(std::get<double>(apply_to_list(Builtin::max, {3.0, -4.0})), 3.0);
  EXPECT_EQ(std::get<std::int64_t>(apply_to_list(Builtin::count, {true, false, true})), 3);
  EXPECT_EQ(std::get<Vec3>(apply_to_list(Builtin::first, {Vec3{1, 2, 3}, Vec3{}})), (Vec3{1, 2, 3}));
  EXPECT_TRUE(std::get<bool>(apply_to_list(Builtin::all, {true, true})));
  EXPECT_FALSE(std::get<bool>(apply_to_list(Builtin::all, {true, false})));
  EXPECT_TRUE(std::get<bool>(apply_to_list(Builtin::any, {false, true})));
  EXPECT_FALSE(std::get<bool>(apply_to_list(Builtin::any, {false, false})));
  EXPECT_EQ(std::get<Vec3>(apply_to_list(Builtin::area_vector,
                                         {Point3{0, 0, 0}, Point3{2, 0, 0}, Point3{2, 3, 0}, Point3{0, 3, 0}})),
            (Vec3{0, 0, 6}));
}

TEST_F(Evaluation, ArgumentsOfOtherTypesAreAFaultOfTheCaller) {
  auto const apply_to = [](Builtin f, std::vector<Evaluated> arguments) { return ir::apply(f, arguments); };
  EXPECT_THROW(apply_to(Builtin::add, {Value{Point3{}}, Value{Point3{}}}), std::invalid_argument);
  EXPECT_THROW(apply_to(Builtin::add, {Value{true}, Value{true}}), std::invalid_argument);
  EXPECT_THROW(apply_to(Builtin::add, {Value{std::int64_t{1}}, Value{1.0}}), std::invalid_argument);
  EXPECT_THROW(apply_to(Builtin::mean, {std::vector<Value>{}}), std::invalid_argument);
}

TEST_F(Evaluation, LeavesAreAskedForOnceEachAndOnlyWhereTheyCount) {
  ExprPtr const expr = check("if flag then h * a.weight + h else b.weight");
  ASSERT_TRUE(expr) << all_messages();
  std::vector<std::string> asked;
  Evaluated const result = ir::evaluate(*expr, [&](ir::Expr const& leaf) -> Evaluated {
    asked.push_back(ir::print(leaf, rule_));
    if (leaf.type == one(Type::Bool)) return Value{true};
    return Value{2.0};
  });
  EXPECT_EQ(std::get<double>(std::get<Value>(result)), 6.0);
  EXPECT_EQ(asked, (std::vector<std::string>{"flag", "h", "a.weight", "h"}));
}

// The parser bounds the depth of an expression at 500; up to there, every stage may recurse.
TEST_F(Evaluation, DeepExpressions) {
  std::string sum = "1";
  for (int i = 1; i < 499; ++i) sum += i % 2 == 0 ? " + 1" : " - 1.0";
  EXPECT_EQ(real(sum), 1.0);
  EXPECT_EQ(integer(std::string(480, '-') + "7"), 7);
  std::string nots, brackets;
  for (int i = 0; i < 480; ++i) nots += "not ";
  EXPECT_TRUE(truth(nots + "true"));
  std::string right = "1";
  for (int i = 0; i < 200; ++i) right = "(1 + " + right + ")";
  EXPECT_EQ(integer(right), 201);
}

TEST_F(Evaluation, ATooLongSumIsRefusedBeforeItIsChecked) {
  std::string sum = "1";
  for (int i = 1; i < 10000; ++i) sum += " + 1";
  auto const file =
      sources_.add("long.jrule", "modeler M on gmap(2) { embedding e : <> -> Int { default " + sum + "; } }");
  source::Diagnostics syntax;
  EXPECT_TRUE(syntax::parse(sources_, file, syntax).items.empty());
  ASSERT_FALSE(syntax.all().empty());
  EXPECT_EQ(info(syntax.all()[0].code).number, "J0103");
}

}  // namespace
}  // namespace jrule::sema
