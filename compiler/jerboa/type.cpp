#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

#include "compiler/jerboa/value.h"

namespace jrule::jerboa {

namespace {

/// Without its namespaces or packages, qualifiers, and in lower case: `fr.lias.Vec3`, `geo::Vec3 const&` -> `vec3`.
std::string bare(std::string_view type) {
  std::string result;
  std::string word;
  auto const take = [&] {
    if (!word.empty() && word != "const") result = word;
    word.clear();
  };
  for (char const c : type) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_') {
      word += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    } else if (c == '<' || c == '[') {
      return "";  // lists and the like
    } else {
      take();
    }
  }
  take();
  return result;
}

constexpr auto known = std::to_array<std::pair<std::string_view, Type>>({
    {"bool", Type::boolean},   {"boolean", Type::boolean}, {"int", Type::integer},     {"integer", Type::integer},  {"long", Type::integer},
    {"short", Type::integer},  {"unsigned", Type::integer}, {"float", Type::real},     {"double", Type::real},      {"real", Type::real},
    {"vec2", Type::vec2},      {"vector2", Type::vec2},    {"vec3", Type::vec3},       {"vector", Type::vec3},      {"vector3", Type::vec3},
    {"vec3f", Type::vec3},     {"vec3d", Type::vec3},      {"vector3f", Type::vec3},   {"vector3d", Type::vec3},    {"normal", Type::vec3},
    {"normal3", Type::vec3},   {"point2", Type::point2},   {"point2d", Type::point2},  {"point", Type::point3},     {"point3", Type::point3},
    {"point3f", Type::point3}, {"point3d", Type::point3},  {"color", Type::color},     {"color3", Type::color},     {"colorv", Type::color},
});

}  // namespace

std::string_view name_of(Type type) {
  switch (type) {
    case Type::boolean: return "Bool";
    case Type::integer: return "Int";
    case Type::real: return "Real";
    case Type::vec2: return "Vec2";
    case Type::vec3: return "Vec3";
    case Type::point2: return "Point2";
    case Type::point3: return "Point3";
    case Type::color: return "Color";
  }
  return "";
}

std::optional<Type> type_of(std::string_view jerboa_type) {
  std::string const name = bare(jerboa_type);
  auto const* const found = std::find_if(known.begin(), known.end(), [&](auto const& entry) { return entry.first == name; });
  if (found == known.end()) return std::nullopt;
  return found->second;
}

std::optional<Type> type_of(Embedding const& embedding, int dimension) {
  auto const type = type_of(embedding.type.text);
  if (!type || bare(embedding.type.text).starts_with("normal") || bare(embedding.name.text).starts_with("normal")) return type;
  Orbit orbit = embedding.orbit;
  std::sort(orbit.begin(), orbit.end());
  bool at_vertices = orbit.size() == static_cast<std::size_t>(dimension);
  for (std::size_t i = 0; i < orbit.size(); ++i) at_vertices = at_vertices && orbit[i] == static_cast<int>(i) + 1;
  if (at_vertices && *type == Type::vec2) return Type::point2;
  if (at_vertices && *type == Type::vec3) return Type::point3;
  return type;
}

}  // namespace jrule::jerboa
