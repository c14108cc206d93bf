// Values of expressions on their way from Jerboa's languages to jrule's: text with a type. There one class stands for places and
// for displacements; here they differ.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "compiler/jerboa/modeler.h"

namespace jrule::jerboa {

enum class Type { boolean, integer, real, vec2, vec3, point2, point3, color };
/// `Point3`
std::string_view name_of(Type type);
/// What `fr.lias.Vec3`, `Integer` or `const Vector*` stand for; vectors as displacements. Nothing if it is none of ours.
std::optional<Type> type_of(std::string_view jerboa_type);
/// The type of an embedding's values: a vector at the vertices is a place, unless it is called a normal.
std::optional<Type> type_of(Embedding const& embedding, int dimension);

struct Value {
  /// `tuple`: components that are a place, a displacement or a color, as what is around it needs.
  enum class Kind { plain, tuple, list, dart } kind = Kind::plain;
  /// How tightly the text holds together.
  enum class Level { conditional, disjunction, conjunction, negation, comparison, addition, multiplication, unary, postfix };

  std::string text;  ///< of a tuple: `(1, 0, 0)`
  Type type = Type::real;  ///< of a plain value, and of those of a list
  Level level = Level::postfix;
  std::size_t components = 0;              ///< of a tuple
  std::optional<std::int64_t> constant{};  ///< of an Int
};

/// Why something has no counterpart in jrule, or none that is known: a clause to follow "is not translated: ".
struct Reason {
  std::string text;
};
template <class T>
using Translated = tl::expected<T, Reason>;

/// Its text, in parentheses if it holds together less tightly than that.
std::string at_level(Value const& value, Value::Level level);
/// The value as one of that type: a place for the displacement from the origin, and the other way round.
Translated<Value> convert(Value const& value, Type type);

Value plain(std::string text, Type type, Value::Level level = Value::Level::postfix);
Value tuple(std::vector<Value> const& components);
Translated<Value> add(Value const& a, Value const& b);
Translated<Value> subtract(Value const& a, Value const& b);
Translated<Value> multiply(Value const& a, Value const& b);
Translated<Value> divide(Value const& a, Value const& b);
Translated<Value> negate(Value const& a);
Translated<Value> compare(std::string_view sign, Value const& a, Value const& b);

/// Midpoint, mean of a list, `dot` …: the function of that name, by its names in Jerboa's libraries.
Translated<Value> call(std::string_view function, std::vector<Value> const& arguments);
/// `new Vec3(1, 0, 0)`, `Vec3(v)`, `new Color(255, 0, 0)`.
Translated<Value> construct(std::string_view jerboa_type, std::vector<Value> const& arguments);
/// `Math.PI`, `Color.RED`, by the last two parts of its name; nothing if it is not known.
std::optional<Value> constant(std::string_view qualifier, std::string_view name);

}  // namespace jrule::jerboa
