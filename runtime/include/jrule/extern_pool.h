// Values of a C++ type from outside (`extern type`): a map keeps, copies and drops them without knowing the type.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "jrule/column.h"

namespace jrule {

using Handle = std::uint32_t;
inline constexpr Handle no_handle = 0xffffffffU;

/// How a pool stores values of type T: a bool as a byte, for std::vector<bool> has no addressable ones.
template <class T>
using Stored = std::conditional_t<std::is_same_v<T, bool>, std::uint8_t, T>;

/// The values of an embedding.
template <class T>
using PoolValues = std::conditional_t<std::is_trivially_copyable_v<T>, ColumnOf<T>, std::vector<T>>;

/// Moves each value to its new number, which is no greater than its old one and ascends with it; drops those whose
/// number is no_handle. O(values), in place: a value is moved at most once.
template <class Values>
void keep_numbered(Values& values, std::span<Handle const> numbers) noexcept {
  std::size_t kept = 0;
  for (std::size_t h = 0; h < values.size(); ++h) {
    if (numbers[h] == no_handle) continue;
    if (kept != h) {
      // By construction, for T need not be assignable.
      std::destroy_at(&values[kept]);
      std::construct_at(&values[kept], std::move(values[h]));
    }
    ++kept;
  }
  while (values.size() > kept) values.pop_back();
}

class ExternPool {
 public:
  virtual ~ExternPool() = default;
  /// May throw what copying a value throws.
  virtual std::unique_ptr<ExternPool> clone() const = 0;
  virtual std::size_t size() const noexcept = 0;
  /// Room for so many further values; strong guarantee.
  virtual void reserve(std::size_t further) = 0;
  /// Keeps the first `count` values.
  virtual void truncate(std::size_t count) noexcept = 0;
  /// jrule::keep_numbered() of its values.
  virtual void keep_numbered(std::span<Handle const> numbers) noexcept = 0;
};

template <class T>
class PoolOf final : public ExternPool {
  static_assert(std::is_copy_constructible_v<T>, "values of an `extern type` are copied with their map");
  static_assert(std::is_nothrow_move_constructible_v<T>, "moving a value of an `extern type` must not throw");

 public:
  PoolValues<T> values;

  std::unique_ptr<ExternPool> clone() const override { return std::make_unique<PoolOf>(*this); }
  std::size_t size() const noexcept override { return values.size(); }
  void reserve(std::size_t further) override {
    // Doubling keeps a long series of small reservations linear.
    std::size_t const needed = values.size() + further;
    if (needed > values.capacity()) values.reserve(std::max(needed, 2 * values.capacity()));
  }
  void truncate(std::size_t count) noexcept override {
    while (values.size() > count) values.pop_back();
  }
  void keep_numbered(std::span<Handle const> numbers) noexcept override { jrule::keep_numbered(values, numbers); }
};

/// An empty pool of values of type T.
template <class T>
std::unique_ptr<ExternPool> make_pool() {
  return std::make_unique<PoolOf<Stored<T>>>();
}

}  // namespace jrule
