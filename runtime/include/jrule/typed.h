// The values of an embedding as C++ values: what generated code reads and adds, without jrule::Value in between.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

#include "jrule/map.h"
#include "jrule/orbit_walk.h"
#include "jrule/rewrite.h"
#include "jrule/stream.h"

namespace jrule::rewrite {

/// How a value is read: those of the language by value, others in place, valid until the embedding changes.
template <class T>
using Read = std::conditional_t<std::is_constructible_v<Value, std::in_place_type_t<T>>, T, T const&>;

/// Adds a value to the pool of an embedding; strong guarantee.
template <class T>
Handle add(PoolValues<Stored<T>>& pool, T value) {
  std::size_t const handle = pool.size();
  if (handle >= no_handle - 1) throw std::length_error("too many values");
  pool.push_back(std::move(value));
  return static_cast<Handle>(handle);
}
template <class T>
Handle add(Embedding& embedding, T value) {
  return add<T>(embedding.values<Stored<T>>(), std::move(value));
}

/// The values of an embedding by dart, T being the C++ type of its values. Valid until darts are added.
template <class T>
class Values {
 public:
  explicit Values(Embedding const& embedding) : handles_(embedding.handles().data()), pool_(embedding.values<Stored<T>>()) {}
  Read<T> operator[](Dart d) const { return static_cast<Read<T>>(pool_[handles_[d]]); }
  /// Those at the darts of a walk.
  template <class Walk>
  std::vector<Stored<T>> over(Walk const& walk, Dart d) const {
    std::vector<Stored<T>> list;
    walk(d, [&](Dart at) { list.push_back(pool_[handles_[at]]); });
    return list;
  }

 private:
  Handle const* handles_;
  PoolValues<Stored<T>> const& pool_;
};

/// The list of the values of `element` at the darts of a walk.
template <class Walk, class Element>
auto each(Walk const& walk, Dart d, Element element) {
  std::vector<Stored<decltype(element(d))>> list;
  walk(d, [&](Dart at) { list.push_back(element(at)); });
  return list;
}

/// sum() and mean() of values that come one by one: the same to the last bit, without a list.
template <class T>
class Total {
 public:
  void add(T const& value) {
    total_ = total_ + value;
    ++count_;
  }
  T sum() const { return total_; }
  T mean() const { return total_ / static_cast<double>(count_); }

 private:
  T total_{};
  std::size_t count_ = 0;
};
/// Points have no sum: theirs is the mean of the vectors from the origin.
template <class Point, class Vector>
class PointTotal {
 public:
  void add(Point value) { vectors_.add(value - Point{}); }
  Point mean() const { return Point{} + vectors_.mean(); }

 private:
  Total<Vector> vectors_;
};
template <>
class Total<Point2> : public PointTotal<Point2, Vec2> {};
template <>
class Total<Point3> : public PointTotal<Point3, Vec3> {};
template <>
class Total<std::int64_t> {
 public:
  void add(std::int64_t value) {
    wrapped_ += static_cast<std::uint64_t>(value);
    reals_.add(static_cast<double>(value));
  }
  std::int64_t sum() const { return static_cast<std::int64_t>(wrapped_); }
  double mean() const { return reals_.mean(); }

 private:
  std::uint64_t wrapped_ = 0;  // unsigned, so that overflow is defined
  Total<double> reals_;
};

template <class Walk, class Element>
auto total(Walk const& walk, Dart d, Element element) {
  Total<std::decay_t<decltype(element(d))>> total;
  walk(d, [&](Dart at) { total.add(element(at)); });
  return total;
}
/// Is `element` true at some dart of a walk, at all of them? It is evaluated at each.
template <class Walk, class Element>
bool any(Walk const& walk, Dart d, Element element) {
  bool found = false;
  walk(d, [&](Dart at) { found = element(at) || found; });
  return found;
}
template <class Walk, class Element>
bool all(Walk const& walk, Dart d, Element element) {
  return !any(walk, d, [&](Dart at) { return !element(at); });
}
/// The number of darts of a walk.
template <class Walk>
std::int64_t count(Walk const& walk, Dart d) {
  std::int64_t count = 0;
  walk(d, [&](Dart) { ++count; });
  return count;
}

/// Values that an application is going to give to orbits. They are in the pool at once, but no dart refers to them; unless keep()
/// is called, the destructor takes them out again.
template <class T>
class NewValues {
 public:
  explicit NewValues(Embedding& embedding)
      : embedding_(embedding), pool_(embedding.values<Stored<T>>()), base_(embedding.value_count()) {}
  ~NewValues() {
    if (!kept_) embedding_.truncate_values(base_);
  }
  NewValues(NewValues const&) = delete;
  NewValues& operator=(NewValues const&) = delete;

  /// Its handle. References to values of the embedding are no longer valid.
  Handle add(T value) { return rewrite::add<T>(pool_, std::move(value)); }
  void keep() noexcept { kept_ = true; }

  /// `count` further values, which are still unset: the first one's handle. Not of types from outside.
  Handle extend(std::size_t count, Threads threads) {
    std::size_t const first = pool_.size(), size = first + count;
    if (size >= no_handle) throw std::length_error("too many values");
    // As adding one after the other doubles it: what is added next may find room.
    std::size_t capacity = std::max<std::size_t>(pool_.capacity(), 1);
    while (capacity < size) capacity *= 2;
    pool_.reserve(capacity, threads);
    pool_.resize(size);
    return static_cast<Handle>(first);
  }
  /// Of extend(): different values may be set at the same time.
  void set(Handle handle, T value) noexcept { pool_[handle] = value; }

 private:
  Embedding& embedding_;
  PoolValues<Stored<T>>& pool_;
  std::size_t base_;
  bool kept_ = false;
};

/// Gives the whole orbit of `d` a new value; strong guarantee. Not part of a rule: for programs that change values by hand.
/// Ends with drop_unused_values().
template <class T>
void set_extern_value(Map& map, std::size_t embedding, Dart d, T value, Workspace& workspace) {
  workspace.reserve(map.dart_limit());
  workspace.clear_marks();
  assign_orbit(map, embedding, d, add<T>(map.embedding(embedding), std::move(value)), workspace);
  drop_unused_values(map, workspace);
}

/// For ExternParts::add_merged: the values merged two at a time, `merge(merge(a, b), c)`, and all at once, `merge({a, b, c})`.
template <class T, class Merge>
Handle add_folded(Embedding& embedding, std::span<Handle const> parts, Merge merge) {
  PoolValues<Stored<T>> const& pool = embedding.values<Stored<T>>();
  std::optional<T> merged(static_cast<T>(pool[parts[0]]));  // optional: T need not be assignable
  for (Handle const part : parts.subspan(1)) {
    T next = merge(std::as_const(*merged), static_cast<Read<T>>(pool[part]));
    merged.emplace(std::move(next));
  }
  return add<T>(embedding, std::move(*merged));
}
template <class T, class Merge>
Handle add_merged_list(Embedding& embedding, std::span<Handle const> parts, Merge merge) {
  PoolValues<Stored<T>> const& pool = embedding.values<Stored<T>>();
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
