#include "jrule/value.h"

#include <array>
#include <cassert>
#include <functional>

#include <fmt/format.h>

namespace jrule {

namespace {

struct Parts {
  std::array<double, 3> numbers{};
  int count = 1;
};

Parts parts(bool b) { return {{b ? 1.0 : 0.0}, 1}; }
Parts parts(std::int64_t i) { return {{static_cast<double>(i)}, 1}; }
Parts parts(double x) { return {{x}, 1}; }
Parts parts(Vec2 v) { return {{v.x, v.y}, 2}; }
Parts parts(Vec3 v) { return {{v.x, v.y, v.z}, 3}; }
Parts parts(Point2 p) { return {{p.x, p.y}, 2}; }
Parts parts(Point3 p) { return {{p.x, p.y, p.z}, 3}; }
Parts parts(Color c) { return {{c.r, c.g, c.b}, 3}; }

/// fmt gives the shortest text that reads back exactly, but also signs NaN.
std::string spell(double x) { return std::isnan(x) ? "nan" : fmt::format("{}", x); }

std::int64_t round_to_int(double x) {
  constexpr double bound = 9223372036854775808.0;  // 2^63, one past the greatest Int
  if (std::isnan(x)) return 0;
  if (x >= bound) return INT64_MAX;
  if (x < -bound) return INT64_MIN;
  return std::llround(x);
}

template <class V>
V unit(V a) {
  double const length = norm(a);
  return length == 0 ? V{} : a / length;
}

template <class V>
V sum_of(std::span<V const> values) {
  V total{};
  for (V const& v : values) total = total + v;
  return total;
}

template <class V>
V mean_of(std::span<V const> values) {
  assert(!values.empty());
  return sum_of(values) / static_cast<double>(values.size());
}

template <class T>
bool is_nan(T x) {
  return x != x;
}

/// The first value that no other one comes before, or NaN.
template <class T, class Before>
T extreme(std::span<T const> values, Before before) {
  assert(!values.empty());
  T best = values.front();
  for (T x : values) {
    if (is_nan(x)) return x;
    if (before(x, best)) best = x;
  }
  return best;
}

}  // namespace

std::string to_string(Type type) {
  switch (type) {
    case Type::Bool: return "Bool";
    case Type::Int: return "Int";
    case Type::Real: return "Real";
    case Type::Vec2: return "Vec2";
    case Type::Vec3: return "Vec3";
    case Type::Point2: return "Point2";
    case Type::Point3: return "Point3";
    case Type::Color: return "Color";
    case Type::Extern: return "extern";
  }
  assert(false);
  return {};
}

std::string to_string(Value const& value) {
  if (auto const* b = std::get_if<bool>(&value)) return *b ? "true" : "false";
  if (auto const* i = std::get_if<std::int64_t>(&value)) return std::to_string(*i);
  if (auto const* x = std::get_if<double>(&value)) return spell(*x);
  Type const type = type_of(value);
  std::string text = to_string(type) + '(';
  for (int k = 0; k < component_count(type); ++k) {
    if (k > 0) text += ", ";
    text += spell(component(value, k));
  }
  return text + ')';
}

int component_count(Type type) noexcept {
  switch (type) {
    case Type::Bool:
    case Type::Int:
    case Type::Real: return 1;
    case Type::Vec2:
    case Type::Point2: return 2;
    case Type::Vec3:
    case Type::Point3:
    case Type::Color: return 3;
    case Type::Extern: return 0;
  }
  assert(false);
  return 0;
}

double component(Value const& value, int index) noexcept {
  Parts const p = std::visit([](auto const& v) { return parts(v); }, value);
  assert(index >= 0 && index < p.count);
  return p.numbers[static_cast<std::size_t>(index)];
}

Value from_components(Type type, std::span<double const> c) noexcept {
  assert(c.size() >= static_cast<std::size_t>(component_count(type)));
  switch (type) {
    case Type::Bool: return c[0] != 0 && !std::isnan(c[0]);
    case Type::Int: return round_to_int(c[0]);
    case Type::Real: return c[0];
    case Type::Vec2: return Vec2{c[0], c[1]};
    case Type::Vec3: return Vec3{c[0], c[1], c[2]};
    case Type::Point2: return Point2{c[0], c[1]};
    case Type::Point3: return Point3{c[0], c[1], c[2]};
    case Type::Color: return Color{c[0], c[1], c[2]};
    case Type::Extern: break;
  }
  assert(false);
  return {};
}

double sin(double a) { return std::sin(a); }
double cos(double a) { return std::cos(a); }
double tan(double a) { return std::tan(a); }
double atan2(double y, double x) { return std::atan2(y, x); }
double pow(double base, double exponent) { return std::pow(base, exponent); }
double exp(double a) { return std::exp(a); }
double log(double a) { return std::log(a); }

Vec2 normalize(Vec2 a) { return unit(a); }
Vec3 normalize(Vec3 a) { return unit(a); }

Vec3 area_vector(std::span<Point3 const> corners) {
  Vec3 twice;
  for (std::size_t k = 2; k < corners.size(); ++k) {
    twice = twice + cross(corners[k - 1] - corners[0], corners[k] - corners[0]);
  }
  return 0.5 * twice;
}

double mean(std::span<std::int64_t const> values) {
  assert(!values.empty());
  double total = 0;
  for (std::int64_t v : values) total += static_cast<double>(v);
  return total / static_cast<double>(values.size());
}

double mean(std::span<double const> values) { return mean_of(values); }
Vec2 mean(std::span<Vec2 const> values) { return mean_of(values); }
Vec3 mean(std::span<Vec3 const> values) { return mean_of(values); }
Color mean(std::span<Color const> values) { return mean_of(values); }

// Points have no sum: theirs is the mean of the vectors from the origin.
Point2 mean(std::span<Point2 const> values) {
  assert(!values.empty());
  Vec2 total;
  for (Point2 p : values) total = total + (p - Point2{});
  return Point2{} + total / static_cast<double>(values.size());
}

Point3 mean(std::span<Point3 const> values) {
  assert(!values.empty());
  Vec3 total;
  for (Point3 p : values) total = total + (p - Point3{});
  return Point3{} + total / static_cast<double>(values.size());
}

std::int64_t sum(std::span<std::int64_t const> values) {
  std::uint64_t total = 0;  // unsigned, so that overflow is defined
  for (std::int64_t v : values) total += static_cast<std::uint64_t>(v);
  return static_cast<std::int64_t>(total);
}

double sum(std::span<double const> values) { return sum_of(values); }
Vec2 sum(std::span<Vec2 const> values) { return sum_of(values); }
Vec3 sum(std::span<Vec3 const> values) { return sum_of(values); }
Color sum(std::span<Color const> values) { return sum_of(values); }

std::int64_t min(std::span<std::int64_t const> values) { return extreme(values, std::less<>{}); }
double min(std::span<double const> values) { return extreme(values, std::less<>{}); }
std::int64_t max(std::span<std::int64_t const> values) { return extreme(values, std::greater<>{}); }
double max(std::span<double const> values) { return extreme(values, std::greater<>{}); }

}  // namespace jrule
