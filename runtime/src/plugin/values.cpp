#include "values.h"

#include <fmt/format.h>

#include <cmath>
#include <span>

namespace jrule::plugin {

static_assert(static_cast<int>(Type::Bool) == JRULE_BOOL && static_cast<int>(Type::Int) == JRULE_INT &&
              static_cast<int>(Type::Real) == JRULE_REAL && static_cast<int>(Type::Vec2) == JRULE_VEC2 &&
              static_cast<int>(Type::Vec3) == JRULE_VEC3 && static_cast<int>(Type::Point2) == JRULE_POINT2 &&
              static_cast<int>(Type::Point3) == JRULE_POINT3 && static_cast<int>(Type::Color) == JRULE_COLOR &&
              static_cast<int>(Type::Extern) == JRULE_EXTERN);

jrule_value to_c(Value const& value) noexcept {
  jrule_value result{static_cast<std::int32_t>(type_of(value)), 0, 0, {0, 0, 0}};
  if (auto const* b = std::get_if<bool>(&value)) {
    result.integer = *b ? 1 : 0;
  } else if (auto const* i = std::get_if<std::int64_t>(&value)) {
    result.integer = *i;
  } else {
    for (int k = 0; k < component_count(type_of(value)); ++k) result.numbers[k] = component(value, k);
  }
  return result;
}

tl::expected<Value, Failure> from_c(jrule_value const& value, Type type, std::string const& what) {
  if (value.type != static_cast<std::int32_t>(type)) {
    bool const is_known = value.type >= 0 && value.type <= JRULE_EXTERN;
    std::string const given =
        is_known ? jrule::to_string(static_cast<Type>(value.type)) : fmt::format("type {}", value.type);
    return bad_argument(fmt::format("{} is a {}, not {}", what, jrule::to_string(type), given));
  }
  if (type == Type::Bool) return Value(value.integer != 0);
  if (type == Type::Int) return Value(value.integer);
  std::span<double const> const numbers(value.numbers, static_cast<std::size_t>(component_count(type)));
  for (double const number : numbers) {
    if (!std::isfinite(number)) return bad_argument(fmt::format("{} has a number that is not finite", what));
  }
  return from_components(type, numbers);
}

}  // namespace jrule::plugin
