#include "compiler/sema/overloads.h"

#include <algorithm>
#include <array>

namespace jrule::sema {

using ir::Builtin;
using ir::ExprType;

namespace {

/// The type of a parameter or result in a row of the table: one type, or the row's variable T; or a list of that.
struct Pattern {
  std::optional<Type> type;
  bool list = false;
  bool dart = false;

  ExprType with(std::optional<Type> variable) const {
    return dart ? ir::dart_type : ExprType{type ? *type : *variable, list};
  }
};

/// Some signatures of a function: one for each type that T stands for.
struct Row {
  Builtin function;
  std::vector<Type> variable;  ///< empty in a row without T
  std::vector<Pattern> parameters;
  Pattern result;
};

std::vector<Row> rows() {
  using enum Type;
  using enum Builtin;
  Pattern const T, Ts{{}, true}, truth{Bool}, truths{Bool, true}, integer{Int}, integers{Int, true}, real{Real},
      dart{{}, false, true};
  Pattern const v2{Vec2}, v3{Vec3}, p2{Point2}, p3{Point3}, p3s{Point3, true}, rgb{Color};
  std::vector<Type> const every{Bool, Int, Real, Vec2, Vec3, Point2, Point3, Color};
  std::vector<Type> const numbers{Int, Real}, vectors{Vec2, Vec3}, points{Point2, Point3};
  std::vector<Type> const scaled{Vec2, Vec3, Color}, mixed{Real, Vec2, Vec3, Point2, Point3, Color};
  return {
      // Operators
      {add, {Int, Real, Vec2, Vec3, Color}, {T, T}, T},
      {add, {}, {p2, v2}, p2}, {add, {}, {v2, p2}, p2},
      {add, {}, {p3, v3}, p3}, {add, {}, {v3, p3}, p3},
      {subtract, {Int, Real, Vec2, Vec3, Color}, {T, T}, T},
      {subtract, {}, {p2, p2}, v2}, {subtract, {}, {p2, v2}, p2},
      {subtract, {}, {p3, p3}, v3}, {subtract, {}, {p3, v3}, p3},
      {multiply, numbers, {T, T}, T},
      {multiply, scaled, {real, T}, T}, {multiply, scaled, {T, real}, T},
      {divide, {Real, Vec2, Vec3, Color}, {T, real}, T},
      {negate, {Int, Real, Vec2, Vec3}, {T}, T},
      {less, numbers, {T, T}, truth}, {less_equal, numbers, {T, T}, truth},
      {greater, numbers, {T, T}, truth}, {greater_equal, numbers, {T, T}, truth},
      {equal, every, {T, T}, truth}, {not_equal, every, {T, T}, truth},
      {equal, {}, {dart, dart}, truth}, {not_equal, {}, {dart, dart}, truth},
      {logical_and, {}, {truth, truth}, truth}, {logical_or, {}, {truth, truth}, truth},
      {logical_not, {}, {truth}, truth},
      // Constructors
      {vec2, {}, {real, real}, v2}, {vec3, {}, {real, real, real}, v3},
      {point2, {}, {real, real}, p2}, {point3, {}, {real, real, real}, p3},
      {color, {}, {real, real, real}, rgb},
      // Geometry
      {dot, vectors, {T, T}, real},
      {cross, {}, {v3, v3}, v3},
      {norm, vectors, {T}, real},
      {normalize, vectors, {T}, T},
      {midpoint, mixed, {T, T}, T},
      {lerp, mixed, {T, T, real}, T},
      {distance, points, {T, T}, real},
      {area_vector, {}, {p3s}, v3},
      // Mathematics
      {sqrt, {}, {real}, real}, {abs, numbers, {T}, T},
      {floor, {}, {real}, real}, {ceil, {}, {real}, real},  // a Real: an Int could not hold them all
      {sin, {}, {real}, real}, {cos, {}, {real}, real}, {tan, {}, {real}, real}, {atan2, {}, {real, real}, real},
      {pow, {}, {real, real}, real}, {exp, {}, {real}, real}, {log, {}, {real}, real},
      // Aggregates
      {mean, mixed, {Ts}, T}, {mean, {}, {integers}, real},
      {sum, {Int, Real, Vec2, Vec3, Color}, {Ts}, T},
      {min, numbers, {Ts}, T}, {min, numbers, {T, T}, T},
      {max, numbers, {Ts}, T}, {max, numbers, {T, T}, T},
      {count, every, {Ts}, integer},
      {first, every, {Ts}, T},
      {all, {}, {truths}, truth}, {any, {}, {truths}, truth},
  };
}

constexpr std::size_t function_count = static_cast<std::size_t>(Builtin::any) + 1;
using Table = std::array<std::vector<Signature>, function_count>;

Table build_table() {
  Table table;
  for (Row const& row : rows()) {
    auto const add = [&](std::optional<Type> variable) {
      Signature signature;
      for (Pattern const& p : row.parameters) signature.parameters.push_back(p.with(variable));
      signature.result = row.result.with(variable);
      table[static_cast<std::size_t>(row.function)].push_back(std::move(signature));
    };
    if (row.variable.empty()) add({});
    for (Type type : row.variable) add(type);
  }
  return table;
}

bool takes(Signature const& signature, std::span<ExprType const> arguments) {
  auto const fits = [](ExprType const& parameter, ExprType const& argument) {
    return parameter == argument || (parameter == ExprType{Type::Real} && argument == ExprType{Type::Int});
  };
  return std::equal(signature.parameters.begin(), signature.parameters.end(), arguments.begin(), arguments.end(), fits);
}

}  // namespace

std::vector<Signature> const& signatures(Builtin function) {
  static Table const table = build_table();
  return table[static_cast<std::size_t>(function)];
}

Signature const* find_signature(Builtin function, std::span<ExprType const> arguments) {
  for (Signature const& signature : signatures(function)) {
    if (takes(signature, arguments)) return &signature;
  }
  return nullptr;
}

std::optional<Builtin> find_function(std::string const& name) {
  for (auto i = static_cast<std::size_t>(Builtin::vec2); i < function_count; ++i) {
    auto const function = static_cast<Builtin>(i);
    // Components have a spelling but no signature: they are read with a dot.
    if (spelling(function) == name && !signatures(function).empty()) return function;
  }
  return {};
}

std::vector<std::string> function_names() {
  std::vector<std::string> names;
  for (auto i = static_cast<std::size_t>(Builtin::vec2); i < function_count; ++i) {
    auto const function = static_cast<Builtin>(i);
    if (!signatures(function).empty()) names.emplace_back(spelling(function));
  }
  return names;
}

std::string component_names(Type type) {
  switch (type) {
    case Type::Vec2:
    case Type::Point2: return "xy";
    case Type::Vec3:
    case Type::Point3: return "xyz";
    case Type::Color: return "rgb";
    case Type::Bool:
    case Type::Int:
    case Type::Real:
    case Type::Extern: return "";
  }
  return "";
}

std::optional<Builtin> find_component(Type type, std::string const& name) {
  constexpr std::array components{Builtin::component_0, Builtin::component_1, Builtin::component_2};
  std::size_t const index = name.size() == 1 ? component_names(type).find(name.front()) : std::string::npos;
  if (index == std::string::npos) return {};
  return components[index];
}

}  // namespace jrule::sema
