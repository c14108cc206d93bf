// The values of an embedding as C++ values: what generated code reads and adds, without jrule::Value in between.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

#include "jrule/map.h"
#include "jrule/rewrite.h"

namespace jrule::rewrite {

/// How a value is read: those of the language by value, others in place, valid until the embedding changes.
template <class T>
using Read = std::conditional_t<std::is_constructible_v<Value, std::in_place_type_t<T>>, T, T const&>;

/// Adds a value; strong guarantee.
template <class T>
Handle add(Embedding& embedding, T value) {
  std::vector<Stored<T>>& pool = embedding.values<Stored<T>>();
  if (pool.size() >= no_handle - 1) throw std::length_error("too many values");
  pool.push_back(std::move(value));
  return static_cast<Handle>(pool.size() - 1);
}

/// The values of an embedding by dart, T being the C++ type of its values. Valid until the embedding changes.
template <class T>
class Values {
 public:
  explicit Values(Embedding const& embedding) : handles_(embedding.handles()), pool_(embedding.values<Stored<T>>()) {}
  Read<T> operator[](Dart d) const { return static_cast<Read<T>>(pool_[handles_[d]]); }
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
  Handle add(T value) {
    std::size_t const handle = base_ + values_.size();
    if (handle >= no_handle) throw std::length_error("too many values");
    values_.push_back(std::move(value));
    return static_cast<Handle>(handle);
  }
  /// Room in the embedding for these values and `more`.
  void reserve(std::size_t more = 0) { embedding_.reserve_values(values_.size() + more); }
  void commit() noexcept {
    std::vector<Stored<T>>& pool = embedding_.values<Stored<T>>();
    for (Stored<T>& value : values_) pool.push_back(std::move(value));
  }

 private:
  Embedding& embedding_;
  std::size_t base_;
  std::vector<Stored<T>> values_;
};

/// Gives the whole orbit of `d` a new value; strong guarantee. Not part of a rule: for programs that change values by hand.
template <class T>
void set_extern_value(Map& map, std::size_t embedding, Dart d, T value, Workspace& workspace) {
  workspace.reserve(map.dart_limit());
  workspace.clear_marks();
  assign_orbit(map, embedding, d, add<T>(map.embedding(embedding), std::move(value)), workspace);
}

/// For ExternParts::add_merged: the values merged two at a time, `merge(merge(a, b), c)`, and all at once, `merge({a, b, c})`.
template <class T, class Merge>
Handle add_folded(Embedding& embedding, std::span<Handle const> parts, Merge merge) {
  std::vector<Stored<T>> const& pool = embedding.values<Stored<T>>();
  std::optional<T> merged(static_cast<T>(pool[parts[0]]));  // optional: T need not be assignable
  for (Handle const part : parts.subspan(1)) {
    T next = merge(std::as_const(*merged), static_cast<Read<T>>(pool[part]));
    merged.emplace(std::move(next));
  }
  return add<T>(embedding, std::move(*merged));
}
template <class T, class Merge>
Handle add_merged_list(Embedding& embedding, std::span<Handle const> parts, Merge merge) {
  std::vector<Stored<T>> const& pool = embedding.values<Stored<T>>();
  std::vector<Stored<T>> list;
  list.reserve(parts.size());
  for (Handle const part : parts) list.push_back(pool[part]);
  return add<T>(embedding, merge(std::as_const(list)));
}

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
