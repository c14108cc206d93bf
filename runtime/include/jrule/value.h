// The values of embeddings and parameters: the language's types as C++ types, and their arithmetic (language reference,
// section 6). The interpreter and generated code both compute with these functions, so they agree to the last bit.
#pragma once

#include <cmath>
#include <cstdint>
#include <numeric>
#include <span>
#include <string>
#include <variant>

namespace jrule {

struct Vec2 { double x = 0, y = 0; bool operator==(Vec2 const&) const = default; };
struct Vec3 { double x = 0, y = 0, z = 0; bool operator==(Vec3 const&) const = default; };
struct Point2 { double x = 0, y = 0; bool operator==(Point2 const&) const = default; };
struct Point3 { double x = 0, y = 0, z = 0; bool operator==(Point3 const&) const = default; };
/// Red, green, blue, each usually in 0..1.
struct Color { double r = 0, g = 0, b = 0; bool operator==(Color const&) const = default; };

/// Extern: a C++ type from outside, of which there is no Value.
enum class Type : std::uint8_t { Bool, Int, Real, Vec2, Vec3, Point2, Point3, Color, Extern };
/// One alternative for each Type but Extern, in the same order.
using Value = std::variant<bool, std::int64_t, double, Vec2, Vec3, Point2, Point3, Color>;

inline Type type_of(Value const& value) noexcept { return static_cast<Type>(value.index()); }
/// "Bool", "Point3", …; "extern".
std::string to_string(Type type);
/// As the language spells it and reads back exactly: "0.5", "Point3(0, 1, 0)".
std::string to_string(Value const& value);
/// How many numbers a value has: 1, 2 or 3; 0 for Extern.
int component_count(Type type) noexcept;
double component(Value const& value, int index) noexcept;
/// The value of that type, not Extern, from its components, `component_count(type)` of them. Bool: neither zero nor NaN; Int:
/// rounded, halves away from zero, and held to the range of Int, NaN to 0.
Value from_components(Type type, std::span<double const> components) noexcept;

// Integers wrap around at 64 bits: computed without sign, where overflow is defined.
constexpr std::int64_t add(std::int64_t a, std::int64_t b) {
  return static_cast<std::int64_t>(static_cast<std::uint64_t>(a) + static_cast<std::uint64_t>(b));
}
constexpr std::int64_t subtract(std::int64_t a, std::int64_t b) {
  return static_cast<std::int64_t>(static_cast<std::uint64_t>(a) - static_cast<std::uint64_t>(b));
}
constexpr std::int64_t multiply(std::int64_t a, std::int64_t b) {
  return static_cast<std::int64_t>(static_cast<std::uint64_t>(a) * static_cast<std::uint64_t>(b));
}
constexpr std::int64_t negate(std::int64_t a) { return subtract(0, a); }
/// The least integer, which has no opposite, stays itself.
constexpr std::int64_t abs(std::int64_t a) { return a < 0 ? negate(a) : a; }
inline double abs(double a) { return std::abs(a); }

// The functions of <cmath> that IEEE 754 does not define to the last bit, out of line: a compiler that computes some calls
// by itself (`pow(x, 2)`, `sin(1)`) would round them differently from one place to the next.
double sin(double a);
double cos(double a);
double tan(double a);
double atan2(double y, double x);
double pow(double base, double exponent);
double exp(double a);
double log(double a);

// Vectors.
constexpr Vec2 operator+(Vec2 a, Vec2 b) { return {a.x + b.x, a.y + b.y}; }
constexpr Vec2 operator-(Vec2 a, Vec2 b) { return {a.x - b.x, a.y - b.y}; }
constexpr Vec2 operator-(Vec2 a) { return {-a.x, -a.y}; }
constexpr Vec2 operator*(double s, Vec2 a) { return {s * a.x, s * a.y}; }
constexpr Vec2 operator*(Vec2 a, double s) { return {a.x * s, a.y * s}; }
constexpr Vec2 operator/(Vec2 a, double s) { return {a.x / s, a.y / s}; }
constexpr Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
constexpr Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
constexpr Vec3 operator-(Vec3 a) { return {-a.x, -a.y, -a.z}; }
constexpr Vec3 operator*(double s, Vec3 a) { return {s * a.x, s * a.y, s * a.z}; }
constexpr Vec3 operator*(Vec3 a, double s) { return {a.x * s, a.y * s, a.z * s}; }
constexpr Vec3 operator/(Vec3 a, double s) { return {a.x / s, a.y / s, a.z / s}; }

// Points: a difference is a vector, a point moves by a vector; there is no sum of points.
constexpr Vec2 operator-(Point2 a, Point2 b) { return {a.x - b.x, a.y - b.y}; }
constexpr Point2 operator+(Point2 a, Vec2 b) { return {a.x + b.x, a.y + b.y}; }
constexpr Point2 operator+(Vec2 a, Point2 b) { return b + a; }
constexpr Point2 operator-(Point2 a, Vec2 b) { return {a.x - b.x, a.y - b.y}; }
constexpr Vec3 operator-(Point3 a, Point3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
constexpr Point3 operator+(Point3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
constexpr Point3 operator+(Vec3 a, Point3 b) { return b + a; }
constexpr Point3 operator-(Point3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }

// Colours mix componentwise.
constexpr Color operator+(Color a, Color b) { return {a.r + b.r, a.g + b.g, a.b + b.b}; }
constexpr Color operator-(Color a, Color b) { return {a.r - b.r, a.g - b.g, a.b - b.b}; }
constexpr Color operator*(double s, Color a) { return {s * a.r, s * a.g, s * a.b}; }
constexpr Color operator*(Color a, double s) { return {a.r * s, a.g * s, a.b * s}; }
constexpr Color operator/(Color a, double s) { return {a.r / s, a.g / s, a.b / s}; }

// Geometry.
constexpr double dot(Vec2 a, Vec2 b) { return a.x * b.x + a.y * b.y; }
constexpr double dot(Vec3 a, Vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
constexpr Vec3 cross(Vec3 a, Vec3 b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
inline double norm(Vec2 a) { return std::sqrt(dot(a, a)); }
inline double norm(Vec3 a) { return std::sqrt(dot(a, a)); }
inline double distance(Point2 a, Point2 b) { return norm(b - a); }
inline double distance(Point3 a, Point3 b) { return norm(b - a); }
/// The vector of norm 1 in the direction of `a`; the zero vector, which has none, stays zero.
Vec2 normalize(Vec2 a);
Vec3 normalize(Vec3 a);
/// The area of a polygon times its unit normal, from whose end the corners, given in the order of the boundary, turn
/// counterclockwise (Newell): half the sum of the cross products about the first corner; zero for fewer than three.
Vec3 area_vector(std::span<Point3 const> corners);

/// From a (t = 0, exactly) to b (t = 1, exactly), componentwise.
constexpr double lerp(double a, double b, double t) { return std::lerp(a, b, t); }
constexpr Vec2 lerp(Vec2 a, Vec2 b, double t) { return {lerp(a.x, b.x, t), lerp(a.y, b.y, t)}; }
constexpr Vec3 lerp(Vec3 a, Vec3 b, double t) { return {lerp(a.x, b.x, t), lerp(a.y, b.y, t), lerp(a.z, b.z, t)}; }
constexpr Point2 lerp(Point2 a, Point2 b, double t) { return {lerp(a.x, b.x, t), lerp(a.y, b.y, t)}; }
constexpr Point3 lerp(Point3 a, Point3 b, double t) {
  return {lerp(a.x, b.x, t), lerp(a.y, b.y, t), lerp(a.z, b.z, t)};
}
constexpr Color lerp(Color a, Color b, double t) { return {lerp(a.r, b.r, t), lerp(a.g, b.g, t), lerp(a.b, b.b, t)}; }

constexpr double midpoint(double a, double b) { return std::midpoint(a, b); }
constexpr Vec2 midpoint(Vec2 a, Vec2 b) { return {midpoint(a.x, b.x), midpoint(a.y, b.y)}; }
constexpr Vec3 midpoint(Vec3 a, Vec3 b) { return {midpoint(a.x, b.x), midpoint(a.y, b.y), midpoint(a.z, b.z)}; }
constexpr Point2 midpoint(Point2 a, Point2 b) { return {midpoint(a.x, b.x), midpoint(a.y, b.y)}; }
constexpr Point3 midpoint(Point3 a, Point3 b) { return {midpoint(a.x, b.x), midpoint(a.y, b.y), midpoint(a.z, b.z)}; }
constexpr Color midpoint(Color a, Color b) { return {midpoint(a.r, b.r), midpoint(a.g, b.g), midpoint(a.b, b.b)}; }

// Aggregates of lists. A sum adds in the list's order, from zero; a mean is that sum divided once by the length.

/// Precondition of every mean: the list is not empty. Integers are added as reals.
double mean(std::span<std::int64_t const> values);
double mean(std::span<double const> values);
Vec2 mean(std::span<Vec2 const> values);
Vec3 mean(std::span<Vec3 const> values);
Point2 mean(std::span<Point2 const> values);
Point3 mean(std::span<Point3 const> values);
Color mean(std::span<Color const> values);

/// Zero for an empty list. Integers wrap around at 64 bits.
std::int64_t sum(std::span<std::int64_t const> values);
double sum(std::span<double const> values);
Vec2 sum(std::span<Vec2 const> values);
Vec3 sum(std::span<Vec3 const> values);
Color sum(std::span<Color const> values);

/// Precondition: the list is not empty. NaN if any of the values is; of equal values (-0 and 0), the first.
std::int64_t min(std::span<std::int64_t const> values);
double min(std::span<double const> values);
std::int64_t max(std::span<std::int64_t const> values);
double max(std::span<double const> values);
inline std::int64_t min(std::int64_t a, std::int64_t b) { return b < a ? b : a; }
inline std::int64_t max(std::int64_t a, std::int64_t b) { return a < b ? b : a; }
inline double min(double a, double b) {
  double const both[] = {a, b};
  return min(std::span<double const>(both));
}
inline double max(double a, double b) {
  double const both[] = {a, b};
  return max(std::span<double const>(both));
}

}  // namespace jrule
