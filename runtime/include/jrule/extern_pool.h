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

namespace jrule {

using Handle = std::uint32_t;
inline constexpr Handle no_handle = 0xffffffffU;

/// How a pool stores values of type T: a bool as a byte, for std::vector<bool> has no addressable ones.
template <class T>
using Stored = std::conditional_t<std::is_same_v<T, bool>, std::uint8_t, T>;

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
  /// Keeps these values, each once, in this order; strong guarantee.
  virtual void keep(std::span<Handle const> kept) = 0;
};

template <class T>
class PoolOf final : public ExternPool {
  static_assert(std::is_copy_constructible_v<T>, "values of an `extern type` are copied with their map");
  static_assert(std::is_nothrow_move_constructible_v<T>, "moving a value of an `extern type` must not throw");

 public:
  std::vector<T> values;

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
  void keep(std::span<Handle const> kept) override {
    std::vector<T> result;
    result.reserve(kept.size());
    for (Handle const h : kept) result.push_back(std::move(values[h]));
    values = std::move(result);
  }
};

/// An empty pool of values of type T.
template <class T>
std::unique_ptr<ExternPool> make_pool() {
  return std::make_unique<PoolOf<Stored<T>>>();
}

}  // namespace jrule
