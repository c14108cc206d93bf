// The values of an embedding as C++ values: what generated code reads and adds, without jrule::Value in between.
#pragma once

#include <cstdint>
#include <span>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

#include "jrule/map.h"
#include "jrule/rewrite.h"

namespace jrule::rewrite {

/// How a pool stores values of type T: a bool as a byte.
template <class T>
using Stored = std::conditional_t<std::is_same_v<T, bool>, std::uint8_t, T>;

/// The values of an embedding by dart, T being the C++ type of its values. Valid until the embedding changes.
template <class T>
class Values {
 public:
  explicit Values(Embedding const& embedding) : handles_(embedding.handles()), pool_(embedding.values<Stored<T>>()) {}
  T operator[](Dart d) const { return static_cast<T>(pool_[handles_[d]]); }
  /// Those over ⟨type⟩(d), one for each ⟨by⟩-orbit inside, in the order of orbit().
  std::vector<Stored<T>> over(Map const& map, OrbitType const& type, OrbitType const& by, Dart d) const {
    std::vector<Stored<T>> list;
    for (Dart const representative : representatives(map, type, by, d)) list.push_back(pool_[handles_[representative]]);
    return list;
  }

 private:
  std::span<Handle const> handles_;
  std::span<Stored<T> const> pool_;
};

/// The list of the values of `element` at one dart for each ⟨by⟩-orbit inside ⟨type⟩(d), in the order of orbit().
template <class Element>
auto each(Map const& map, OrbitType const& type, OrbitType const& by, Dart d, Element element) {
  std::vector<Stored<decltype(element(d))>> list;
  for (Dart const representative : representatives(map, type, by, d)) list.push_back(element(representative));
  return list;
}

/// Values that an application is going to add to an embedding: nothing is seen of them before commit().
template <class T>
class NewValues {
 public:
  explicit NewValues(Embedding& embedding) : embedding_(embedding), base_(embedding.value_count()) {}
  /// The handle that the value will have.
  Handle add(T const& value) {
    std::size_t const handle = base_ + values_.size();
    if (handle >= no_handle) throw std::length_error("too many values");
    values_.push_back(value);
    return static_cast<Handle>(handle);
  }
  /// Room in the embedding for these values and `more`.
  void reserve(std::size_t more = 0) { embedding_.reserve_values(values_.size() + more); }
  void commit() noexcept {
    std::vector<Stored<T>>& pool = embedding_.values<Stored<T>>();
    pool.insert(pool.end(), values_.begin(), values_.end());
  }

 private:
  Embedding& embedding_;
  std::size_t base_;
  std::vector<Stored<T>> values_;
};

/// The aggregates of lists of Bool, which are lists of bytes.
inline bool all(std::span<std::uint8_t const> list) {
  for (std::uint8_t const b : list) {
    if (b == 0) return false;
  }
  return true;
}
inline bool any(std::span<std::uint8_t const> list) {
  for (std::uint8_t const b : list) {
    if (b != 0) return true;
  }
  return false;
}

}  // namespace jrule::rewrite
