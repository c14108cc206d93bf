// Values on orbits: a handle per dart into a pool of values. Two orbits may share a handle (a split copies handles, not
// values), so a value in the pool is never changed while a dart refers to it: an orbit gets a new value by a new handle.
//
// A value that no dart refers to any more is dropped by compact(), which applications of rules and rewrite::set_value
// call at their end when is_compaction_due(). That renumbers: a handle, or a reference to a value, is valid until the
// next of them succeeds. tests/bench/storage_bench.cpp compares this with other ways of storing values.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "jrule/extern_pool.h"
#include "jrule/column.h"
#include "jrule/value.h"
#include "jrule/word.h"

namespace jrule {

class Embedding;

/// What the value of a merged orbit is when no clause gives it; `function`: what a function of C++ makes of them.
enum class MergePolicy : std::uint8_t { none, first, mean, min, max, function };

/// What of an embedding is C++ from outside, as generated code gives it; null what is not.
struct ExternParts {
  /// Of Type::Extern, and of no other type: `make_pool<T>`, T being the type of the values.
  std::unique_ptr<ExternPool> (*make_pool)() = nullptr;
  /// Adds the default value. May throw anything, and then adds nothing.
  Handle (*add_default)(Embedding& embedding) = nullptr;
  /// Of MergePolicy::function: adds what the values of two parts or more are merged to. May throw anything, and then adds
  /// nothing.
  Handle (*add_merged)(Embedding& embedding, std::span<Handle const> parts) = nullptr;
};

/// `embedding name : <orbit> -> type { default …; merge …; }`
struct EmbeddingSpec {
  std::string name;
  OrbitType orbit;
  Type type = Type::Real;
  std::optional<Value> default_value{};
  MergePolicy merge = MergePolicy::none;
  std::string extern_name{};  ///< of Type::Extern, the C++ type: "geo::Soil"
  ExternParts extern_parts{};
  /// Do they declare the same? The functions are not compared: those of one embedding are the same in one program.
  bool operator==(EmbeddingSpec const& other) const {
    return name == other.name && orbit == other.orbit && type == other.type && default_value == other.default_value &&
           merge == other.merge && extern_name == other.extern_name;
  }
};

class Embedding {
 public:
  /// Throws std::invalid_argument if the default is of another type or the type does not offer the merge policy: `mean`
  /// is of Real, vectors, points and colours, `min` and `max` of Int and Real. Also if extern parts are missing: the pool
  /// of Type::Extern, the function of MergePolicy::function.
  explicit Embedding(EmbeddingSpec spec);
  /// Copies the values; those of a C++ type from outside may throw what they like.
  Embedding(Embedding const& other);
  Embedding& operator=(Embedding const& other);
  Embedding(Embedding&&) noexcept = default;
  Embedding& operator=(Embedding&&) noexcept = default;
  ~Embedding() = default;

  EmbeddingSpec const& spec() const noexcept { return spec_; }
  Handle handle(std::uint32_t dart) const noexcept { return handles_[dart]; }
  void set_handle(std::uint32_t dart, Handle h) noexcept {
    if (handles_[dart] != no_handle) ++overwritten_;
    handles_[dart] = h;
  }
  std::span<Handle const> handles() const noexcept { return handles_; }
  /// The same to be written, for commits, which say how many of them had a handle already. Valid until darts are added.
  Handle* handles_of_darts() noexcept { return handles_.data(); }
  void count_overwritten(std::size_t handles) noexcept { overwritten_ += handles; }
  /// One handle for each dart index; new ones are no_handle. Called by Map.
  void resize(std::size_t darts) { handles_.resize(darts, no_handle); }
  /// The same, but leaves the new ones unset.
  void extend(std::size_t darts) { handles_.resize(darts); }
  void reserve(std::size_t darts, Threads threads) { handles_.reserve(darts, threads); }

  std::size_t value_count() const noexcept;
  /// Adds a value of the embedding's type; strong guarantee; noexcept once reserved. Type::Extern has no jrule::Value: see
  /// rewrite::add() of typed.h.
  Handle add(Value const& value);
  /// Adds the default value; none if there is no default. May throw what a default that is computed by C++ throws.
  std::optional<Handle> add_default();
  /// Room for so many further values: adding them does not throw. May throw std::bad_alloc, std::length_error.
  void reserve_values(std::size_t count);
  /// Keeps the first `count` values: undoes add().
  void truncate_values(std::size_t count) noexcept;
  /// Not of Type::Extern.
  Value value(Handle h) const noexcept;
  /// The values themselves, T being Stored<the C++ type of `spec().type`>, of Type::Extern the type that its name says.
  template <class T>
  PoolValues<T> const& values() const { return values_of<T>(*this); }
  template <class T>
  PoolValues<T>& values() { return values_of<T>(*this); }
  /// Drops the values that no dart refers to and renumbers the rest, which keep their order. O(darts + values), in place
  /// but for a handle for each value in `scratch`: throws only std::bad_alloc for that, and then nothing has changed.
  void compact(std::vector<Handle>& scratch, Threads threads = {});
  void compact();
  /// Have as many handles been overwritten and values been added since the last compact() as there are dart indices?
  /// Called when due, compact() costs O(1) for each of these changes, however few values there are, and the pool never
  /// holds more than two values for each dart index and, if the orbits are of one size and no index is free, twice the
  /// values that darts refer to, besides those that no dart ever had; plus what the last change added. O(1).
  bool is_compaction_due() const noexcept;

  /// The value of a merged orbit by the embedding's policy (`first`, `mean`, `min` or `max`; not of Type::Extern) from its
  /// parts' values; one part or more, in the order of the darts that bring them.
  Value merge(std::span<Handle const> parts) const noexcept;

 private:
  using Pool = std::variant<ColumnOf<std::uint8_t>, ColumnOf<std::int64_t>, ColumnOf<double>, ColumnOf<Vec2>,
                            ColumnOf<Vec3>, ColumnOf<Point2>, ColumnOf<Point3>, ColumnOf<Color>>;
  template <class T>
  static constexpr bool is_pooled = std::is_constructible_v<Pool, std::in_place_type_t<PoolValues<T>>>;

  // Of the embedding, const or not. A type from outside may be another name of a type of the language.
  template <class T, class Self>
  static auto& values_of(Self& self) {
    if constexpr (is_pooled<T>) {
      if (!self.extern_pool_) return std::get<PoolValues<T>>(self.pool_);
    }
    auto& pool = *self.extern_pool_;
    return static_cast<std::conditional_t<std::is_const_v<Self>, PoolOf<T> const, PoolOf<T>>&>(pool).values;
  }

  EmbeddingSpec spec_;
  ColumnOf<Handle> handles_;
  std::size_t overwritten_ = 0;  ///< how many handles, since the last compact()
  std::size_t compacted_ = 0;    ///< how many values the last compact() left
  Pool pool_;
  std::unique_ptr<ExternPool> extern_pool_;  ///< of Type::Extern, whose pool_ stays empty
};

}  // namespace jrule
