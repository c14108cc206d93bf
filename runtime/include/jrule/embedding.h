// Values on orbits: a handle per dart into a pool of values. Two orbits may share a handle (a split copies handles, not
// values), so a value in the pool is never changed while a dart refers to it: an orbit gets a new value by a new handle.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "jrule/value.h"
#include "jrule/word.h"

namespace jrule {

/// What the value of a merged orbit is when no clause gives it.
enum class MergePolicy : std::uint8_t { none, first, mean, min, max };

/// `embedding name : <orbit> -> type { default …; merge …; }`
struct EmbeddingSpec {
  std::string name;
  OrbitType orbit;
  Type type = Type::Real;
  std::optional<Value> default_value;
  MergePolicy merge = MergePolicy::none;
  bool operator==(EmbeddingSpec const&) const = default;
};

using Handle = std::uint32_t;
inline constexpr Handle no_handle = 0xffffffffU;

class Embedding {
 public:
  /// Throws std::invalid_argument if the default is of another type or the type does not offer the merge policy: `mean`
  /// is of Real, vectors, points and colours, `min` and `max` of Int and Real.
  explicit Embedding(EmbeddingSpec spec);

  EmbeddingSpec const& spec() const noexcept { return spec_; }
  Handle handle(std::uint32_t dart) const noexcept { return handles_[dart]; }
  void set_handle(std::uint32_t dart, Handle h) noexcept { handles_[dart] = h; }
  std::span<Handle const> handles() const noexcept { return handles_; }
  /// One handle for each dart index; new ones are no_handle. Called by Map.
  void resize(std::size_t darts) { handles_.resize(darts, no_handle); }
  void reserve(std::size_t darts) { handles_.reserve(darts); }

  std::size_t value_count() const noexcept;
  /// Adds a value of the embedding's type; strong guarantee; noexcept once reserved.
  Handle add(Value const& value);
  /// Room for so many further values: adding them does not throw. May throw std::bad_alloc, std::length_error.
  void reserve_values(std::size_t count);
  /// Keeps the first `count` values: undoes add().
  void truncate_values(std::size_t count) noexcept;
  Value value(Handle h) const noexcept;
  /// The values themselves, T being the C++ type of `spec().type`.
  template <class T>
  std::vector<T> const& values() const { return std::get<std::vector<T>>(pool_); }
  template <class T>
  std::vector<T>& values() { return std::get<std::vector<T>>(pool_); }
  /// Drops the values that no dart refers to and renumbers the rest in the order of the darts. O(darts + values).
  void compact();

  /// The value of a merged orbit by the embedding's policy (not `none`) from its parts' values; one part or more, in the
  /// order of the darts that bring them.
  Value merge(std::span<Handle const> parts) const noexcept;

 private:
  EmbeddingSpec spec_;
  std::vector<Handle> handles_;
  std::variant<std::vector<std::uint8_t>, std::vector<std::int64_t>, std::vector<double>, std::vector<Vec2>, std::vector<Vec3>,
               std::vector<Point2>, std::vector<Point3>, std::vector<Color>>
      pool_;
};

}  // namespace jrule
