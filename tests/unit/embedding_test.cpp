#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <stdexcept>

#include "jrule/embedding.h"

namespace jrule {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double inf = std::numeric_limits<double>::infinity();

// --- values ---

TEST(Value, HasATypeAndComponents) {
  EXPECT_EQ(type_of(Value(true)), Type::Bool);
  EXPECT_EQ(type_of(Value(std::int64_t{3})), Type::Int);
  EXPECT_EQ(type_of(Value(Color{})), Type::Color);
  EXPECT_EQ(to_string(Type::Point2), "Point2");
  EXPECT_EQ(component_count(Type::Int), 1);
  EXPECT_EQ(component_count(Type::Vec2), 2);
  EXPECT_EQ(component_count(Type::Color), 3);
  EXPECT_EQ(component(Value(true), 0), 1);
  EXPECT_EQ(component(Value(Point3{1, 2, 3}), 2), 3);
}

TEST(Value, IsBuiltFromItsComponents) {
  Value const all[] = {Value(true),          Value(std::int64_t{-7}), Value(0.25),           Value(Vec2{1, 2}),
                       Value(Vec3{1, 2, 3}), Value(Point2{4, 5}),     Value(Point3{6, 7, 8}), Value(Color{.1, .2, .3})};
  for (Value const& v : all) {
    std::vector<double> c;
    for (int k = 0; k < component_count(type_of(v)); ++k) c.push_back(component(v, k));
    EXPECT_EQ(from_components(type_of(v), c), v) << to_string(v);
  }
  auto const integer = [](double x) { return std::get<std::int64_t>(from_components(Type::Int, std::array{x})); };
  EXPECT_EQ(integer(2.5), 3);
  EXPECT_EQ(integer(-2.5), -3);
  EXPECT_EQ(integer(1e300), std::numeric_limits<std::int64_t>::max());
  EXPECT_EQ(integer(-inf), std::numeric_limits<std::int64_t>::min());
  EXPECT_EQ(integer(nan), 0);
  EXPECT_EQ(from_components(Type::Bool, std::array{0.0}), Value(false));
  EXPECT_EQ(from_components(Type::Bool, std::array{-2.0}), Value(true));
  EXPECT_EQ(from_components(Type::Bool, std::array{nan}), Value(false));
}

TEST(Value, IsSpelledToReadBackExactly) {
  EXPECT_EQ(to_string(Value(true)), "true");
  EXPECT_EQ(to_string(Value(std::int64_t{-12})), "-12");
  EXPECT_EQ(to_string(Value(0.5)), "0.5");
  EXPECT_EQ(to_string(Value(0.1)), "0.1");
  EXPECT_EQ(to_string(Value(Point3{0, 1, 0})), "Point3(0, 1, 0)");
  EXPECT_EQ(to_string(Value(Vec2{-1.5, 1e-300})), "Vec2(-1.5, 1e-300)");
  EXPECT_EQ(to_string(Value(nan)), "nan");
  EXPECT_EQ(to_string(Value(-nan)), "nan");
  EXPECT_EQ(to_string(Value(Color{inf, -inf, 0})), "Color(inf, -inf, 0)");
  for (double x : {1.0 / 3, 0.1 + 0.2, 1e22, 5e-324, 1.7976931348623157e308}) {
    EXPECT_EQ(std::strtod(to_string(Value(x)).c_str(), nullptr), x) << x;
  }
}

TEST(Geometry, VectorsAndPoints) {
  EXPECT_EQ((Point3{1, 2, 3} - Point3{1, 1, 1}), (Vec3{0, 1, 2}));
  EXPECT_EQ((Point3{1, 2, 3} + 2.0 * Vec3{1, 0, -1}), (Point3{3, 2, 1}));
  EXPECT_EQ((Point2{1, 2} - Vec2{1, 1} / 2.0), (Point2{0.5, 1.5}));
  EXPECT_EQ((-Vec2{1, -2}), (Vec2{-1, 2}));
  EXPECT_EQ(0.5 * (Color{1, 0, 0} + Color{0, 1, 0}), (Color{0.5, 0.5, 0}));
  EXPECT_EQ(dot(Vec2{1, 2}, Vec2{3, 4}), 11);
  EXPECT_EQ(dot(Vec3{1, 2, 3}, Vec3{4, 5, 6}), 32);
  EXPECT_EQ(cross(Vec3{1, 0, 0}, Vec3{0, 1, 0}), (Vec3{0, 0, 1}));
  EXPECT_EQ(cross(Vec3{1, 2, 3}, Vec3{4, 5, 6}), (Vec3{-3, 6, -3}));
  EXPECT_EQ(norm(Vec2{3, -4}), 5);
  EXPECT_EQ(norm(Vec3{3, 4, 12}), 13);
  EXPECT_EQ(distance(Point2{1, 1}, Point2{4, 5}), 5);
  EXPECT_EQ(distance(Point3{0, 0, 1}, Point3{2, 3, 7}), 7);
}

TEST(Geometry, NormalizeKeepsTheZeroVector) {
  EXPECT_EQ(normalize(Vec3{0, 0, -2}), (Vec3{0, 0, -1}));
  EXPECT_EQ(normalize(Vec2{3, 4}), (Vec2{0.6, 0.8}));
  EXPECT_EQ(normalize(Vec3{}), Vec3{});
  EXPECT_EQ(normalize(Vec2{}), Vec2{});
  EXPECT_TRUE(std::isnan(normalize(Vec2{nan, 1}).y)) << "a bad input is not hidden";
}

TEST(Geometry, MixingIsExactAtTheEnds) {
  EXPECT_EQ(lerp(1e16, 1.0, 1.0), 1.0);
  EXPECT_EQ(lerp(2.0, 4.0, 0.25), 2.5);
  EXPECT_EQ(lerp(Point3{0, 0, 0}, Point3{4, 8, -4}, 0.75), (Point3{3, 6, -3}));
  EXPECT_EQ(lerp(Vec2{0, 2}, Vec2{2, 0}, 0.5), (Vec2{1, 1}));
  EXPECT_EQ(lerp(Color{0, 0, 0}, Color{1, 1, 1}, 0.5), (Color{0.5, 0.5, 0.5}));
  EXPECT_EQ(midpoint(1.0, 2.0), 1.5);
  EXPECT_EQ(midpoint(Point2{0, 0}, Point2{2, 4}), (Point2{1, 2}));
  EXPECT_EQ(midpoint(Point3{0, 0, 0}, Point3{2, 4, 6}), (Point3{1, 2, 3}));
  EXPECT_EQ(midpoint(Vec3{0, 0, 0}, Vec3{2, 4, 6}), (Vec3{1, 2, 3}));
  EXPECT_EQ(midpoint(Color{0, 0, 0}, Color{1, 0.5, 0}), (Color{0.5, 0.25, 0}));
}

TEST(Geometry, AreaVectorOfPolygons) {
  std::vector<Point3> square = {{5, 5, 1}, {7, 5, 1}, {7, 7, 1}, {5, 7, 1}};
  EXPECT_EQ(area_vector(square), (Vec3{0, 0, 4}));
  std::reverse(square.begin(), square.end());
  EXPECT_EQ(area_vector(square), (Vec3{0, 0, -4}));
  // An L, which is not convex: the first corner does not see all of it.
  std::vector<Point3> const ell = {{2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}, {0, 0, 0}, {2, 0, 0}};
  EXPECT_EQ(area_vector(ell), (Vec3{0, 0, 3}));
  EXPECT_EQ(area_vector(std::vector<Point3>{{1, 2, 3}, {4, 5, 6}}), Vec3{});
  EXPECT_EQ(area_vector({}), Vec3{});
}

TEST(Aggregates, MeanAndSum) {
  EXPECT_EQ(mean(std::vector<double>{1, 2, 6}), 3);
  EXPECT_EQ(mean(std::vector<Vec2>{{1, 0}, {0, 1}}), (Vec2{0.5, 0.5}));
  EXPECT_EQ(mean(std::vector<Vec3>{{1, 0, 2}, {0, 1, 4}}), (Vec3{0.5, 0.5, 3}));
  EXPECT_EQ(mean(std::vector<Point2>{{1, 0}, {3, 1}}), (Point2{2, 0.5}));
  EXPECT_EQ(mean(std::vector<Point3>{{0, 0, 0}, {3, 0, 0}, {0, 3, 6}}), (Point3{1, 1, 2}));
  EXPECT_EQ(mean(std::vector<Color>{{1, 0, 0}, {0, 0, 1}}), (Color{0.5, 0, 0.5}));
  EXPECT_EQ(sum(std::vector<double>{0.5, 2}), 2.5);
  EXPECT_EQ(sum(std::vector<double>{}), 0);
  EXPECT_EQ(sum(std::vector<Vec2>{{1, 2}, {3, 4}}), (Vec2{4, 6}));
  EXPECT_EQ(sum(std::vector<Vec3>{{1, 2, 3}, {3, 4, 5}}), (Vec3{4, 6, 8}));
  EXPECT_EQ(sum(std::vector<std::int64_t>{5, -7}), -2);
  constexpr auto most = std::numeric_limits<std::int64_t>::max();
  EXPECT_EQ(sum(std::vector<std::int64_t>{most, 1}), std::numeric_limits<std::int64_t>::min()) << "it wraps";
}

TEST(Aggregates, MinAndMax) {
  EXPECT_EQ(min(std::vector<std::int64_t>{3, -1, 2}), -1);
  EXPECT_EQ(max(std::vector<std::int64_t>{3, -1, 2}), 3);
  EXPECT_EQ(min(std::vector<double>{3, -1, 2}), -1);
  EXPECT_EQ(max(std::vector<double>{3, -1, 2}), 3);
  EXPECT_TRUE(std::isnan(min(std::vector<double>{1, nan, 0})));
  EXPECT_TRUE(std::isnan(max(std::vector<double>{nan, 2})));
  EXPECT_TRUE(std::signbit(min(std::vector<double>{-0.0, 0.0})));
  EXPECT_FALSE(std::signbit(min(std::vector<double>{0.0, -0.0}))) << "of equal values, the first";
}

// --- embeddings ---

EmbeddingSpec spec(Type type, MergePolicy merge = MergePolicy::none) {
  return {"weight", orbit_of_dimensions({0, 1}), type, std::nullopt, merge};
}

std::vector<Handle> handles(Embedding const& e) { return {e.handles().begin(), e.handles().end()}; }

TEST(Embedding, StoresValuesOfEveryType) {
  Value const all[] = {Value(true),          Value(std::int64_t{-7}), Value(0.25),           Value(Vec2{1, 2}),
                       Value(Vec3{1, 2, 3}), Value(Point2{4, 5}),     Value(Point3{6, 7, 8}), Value(Color{.1, .2, .3})};
  for (Value const& v : all) {
    Embedding e(spec(type_of(v)));
    EXPECT_EQ(e.value_count(), 0u);
    EXPECT_EQ(e.add(v), 0u);
    EXPECT_EQ(e.add(v), 1u) << "a value is added each time";
    EXPECT_EQ(e.value(1), v) << to_string(v);
    EXPECT_EQ(e.value_count(), 2u);
  }
}

TEST(Embedding, RefusesAValueOfAnotherType) {
  Embedding e(spec(Type::Real));
  e.add(1.0);
  EXPECT_THROW(e.add(Value(std::int64_t{1})), std::bad_variant_access);
  EXPECT_EQ(e.value_count(), 1u);
}

TEST(Embedding, RefusesASpecThatCannotBe) {
  EmbeddingSpec s = spec(Type::Real);
  s.default_value = Value(true);
  EXPECT_THROW(Embedding{s}, std::invalid_argument);
  for (Type t : {Type::Bool, Type::Int}) EXPECT_THROW(Embedding{spec(t, MergePolicy::mean)}, std::invalid_argument);
  for (Type t : {Type::Bool, Type::Vec2, Type::Vec3, Type::Point2, Type::Point3, Type::Color}) {
    EXPECT_THROW(Embedding{spec(t, MergePolicy::min)}, std::invalid_argument);
    EXPECT_THROW(Embedding{spec(t, MergePolicy::max)}, std::invalid_argument);
    EXPECT_NO_THROW(Embedding{spec(t, MergePolicy::first)});
  }
}

TEST(Embedding, TruncationUndoesAdding) {
  Embedding e(spec(Type::Int));
  for (std::int64_t k = 0; k < 5; ++k) e.add(k);
  e.truncate_values(2);
  EXPECT_EQ(e.values<std::int64_t>(), (ColumnOf<std::int64_t>{0, 1}));
  e.truncate_values(4);
  EXPECT_EQ(e.value_count(), 2u) << "it never adds";
  EXPECT_EQ(e.add(std::int64_t{9}), 2u);
}

TEST(Embedding, ReservedRoomKeepsThePoolInPlace) {
  Embedding e(spec(Type::Real));
  e.add(0.5);
  e.reserve_values(100);
  double const* const before = e.values<double>().data();
  for (int k = 0; k < 100; ++k) e.add(1.0);
  EXPECT_EQ(e.values<double>().data(), before);
}

TEST(Embedding, HasAHandleForEachDart) {
  Embedding e(spec(Type::Real));
  e.resize(2);
  EXPECT_EQ(e.handle(1), no_handle);
  e.set_handle(1, e.add(2.5));
  e.resize(3);
  EXPECT_EQ(handles(e), (std::vector<Handle>{no_handle, 0, no_handle}));
}

TEST(Embedding, CompactDropsUnusedValuesAndKeepsTheOrder) {
  Embedding e(spec(Type::Real));
  for (double x : {0.0, 1.0, 2.0, 3.0, 4.0}) e.add(x);
  e.resize(5);
  e.set_handle(0, 3);
  e.set_handle(2, 1);
  e.set_handle(3, 3);
  e.set_handle(4, 4);
  e.compact();
  EXPECT_EQ(e.values<double>(), (ColumnOf<double>{1, 3, 4}));
  EXPECT_EQ(handles(e), (std::vector<Handle>{1, no_handle, 0, 1, 2}));
}

TEST(Embedding, MergesByItsPolicy) {
  auto const merged = [](MergePolicy policy, std::vector<Value> const& values) {
    Embedding e(spec(type_of(values.front()), policy));
    std::vector<Handle> parts;
    for (Value const& v : values) parts.push_back(e.add(v));
    return e.merge(parts);
  };
  EXPECT_EQ(merged(MergePolicy::first, {Value(true), Value(false)}), Value(true));
  EXPECT_EQ(merged(MergePolicy::first, {Point3{1, 2, 3}, Point3{}}), Value(Point3{1, 2, 3}));
  EXPECT_EQ(merged(MergePolicy::mean, {1.0, 2.0, 6.0}), Value(3.0));
  EXPECT_EQ(merged(MergePolicy::mean, {Point3{0, 0, 0}, Point3{2, 4, 6}}), Value(Point3{1, 2, 3}));
  EXPECT_EQ(merged(MergePolicy::mean, {Color{1, 0, 0}}), Value(Color{1, 0, 0}));
  EXPECT_EQ(merged(MergePolicy::min, {2.0, -1.0}), Value(-1.0));
  EXPECT_EQ(merged(MergePolicy::max, {Value(std::int64_t{2}), Value(std::int64_t{9})}), Value(std::int64_t{9}));
}

}  // namespace
}  // namespace jrule
