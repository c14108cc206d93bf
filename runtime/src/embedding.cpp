#include "jrule/embedding.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <concepts>
#include <stdexcept>
#include <type_traits>
#include <utility>

namespace jrule {

namespace {

/// The language's type of a pool's elements: a Bool is stored as a byte, for std::vector<bool> has no addressable ones.
template <class Stored>
using Unstored = std::conditional_t<std::is_same_v<Stored, std::uint8_t>, bool, Stored>;

template <class T>
concept HasMean = requires(std::span<T const> values) { { mean(values) } -> std::same_as<T>; };
template <class T>
concept HasOrder = requires(std::span<T const> values) { { min(values) } -> std::same_as<T>; };

template <class T>
bool offers(MergePolicy policy) {
  switch (policy) {
    case MergePolicy::none:
    case MergePolicy::first: return true;
    case MergePolicy::mean: return HasMean<T>;
    case MergePolicy::min:
    case MergePolicy::max: return HasOrder<T>;
  }
  return false;
}

}  // namespace

Embedding::Embedding(EmbeddingSpec spec) : spec_(std::move(spec)) {
  switch (spec_.type) {
    case Type::Bool: pool_.emplace<std::vector<std::uint8_t>>(); break;
    case Type::Int: pool_.emplace<std::vector<std::int64_t>>(); break;
    case Type::Real: pool_.emplace<std::vector<double>>(); break;
    case Type::Vec2: pool_.emplace<std::vector<Vec2>>(); break;
    case Type::Vec3: pool_.emplace<std::vector<Vec3>>(); break;
    case Type::Point2: pool_.emplace<std::vector<Point2>>(); break;
    case Type::Point3: pool_.emplace<std::vector<Point3>>(); break;
    case Type::Color: pool_.emplace<std::vector<Color>>(); break;
  }
  if (spec_.default_value && type_of(*spec_.default_value) != spec_.type) {
    throw std::invalid_argument("embedding `" + spec_.name + "`: the default is not of type " + to_string(spec_.type));
  }
  bool const mergeable = std::visit(
      [&]<class Stored>(std::vector<Stored> const&) { return offers<Unstored<Stored>>(spec_.merge); }, pool_);
  if (!mergeable) {
    throw std::invalid_argument("embedding `" + spec_.name + "`: its merge policy is not offered for type " +
                                to_string(spec_.type));
  }
}

std::size_t Embedding::value_count() const noexcept {
  return std::visit([](auto const& pool) { return pool.size(); }, pool_);
}

Handle Embedding::add(Value const& value) {
  std::size_t const handle = value_count();
  if (handle >= no_handle) throw std::length_error("too many values of embedding `" + spec_.name + "`");
  std::visit([&]<class Stored>(std::vector<Stored>& pool) { pool.push_back(std::get<Unstored<Stored>>(value)); },
             pool_);
  return static_cast<Handle>(handle);
}

void Embedding::reserve_values(std::size_t count) {
  std::visit(
      [&](auto& pool) {
        std::size_t const needed = pool.size() + count;
        if (needed >= no_handle) throw std::length_error("too many values of embedding `" + spec_.name + "`");
        // Doubling keeps a long series of small reservations linear.
        if (needed > pool.capacity()) pool.reserve(std::max(needed, 2 * pool.capacity()));
      },
      pool_);
}

void Embedding::truncate_values(std::size_t count) noexcept {
  std::visit(
      [&](auto& pool) {
        if (count < pool.size()) pool.erase(pool.begin() + static_cast<std::ptrdiff_t>(count), pool.end());
      },
      pool_);
}

Value Embedding::value(Handle h) const noexcept {
  return std::visit(
      [&]<class Stored>(std::vector<Stored> const& pool) -> Value {
        // In place, so that the byte of a Bool becomes that alternative and no other.
        return Value(std::in_place_type<Unstored<Stored>>, static_cast<Unstored<Stored>>(pool[h]));
      },
      pool_);
}

void Embedding::compact() {
  std::visit(
      [&]<class Stored>(std::vector<Stored>& pool) {
        std::vector<Handle> renumbered(pool.size(), no_handle);
        std::vector<Stored> kept;
        for (Handle h : handles_) {
          if (h == no_handle || renumbered[h] != no_handle) continue;
          renumbered[h] = static_cast<Handle>(kept.size());
          kept.push_back(pool[h]);
        }
        for (Handle& h : handles_) {
          if (h != no_handle) h = renumbered[h];
        }
        pool = std::move(kept);
      },
      pool_);
}

Value Embedding::merge(std::span<Handle const> parts) const noexcept {
  assert(!parts.empty() && spec_.merge != MergePolicy::none);
  Value result = value(parts.front());
  if (spec_.merge == MergePolicy::mean) {
    // As mean() of the list, but without the list: sums from zero in its order, divided once.
    int const count = component_count(spec_.type);
    std::array<double, 3> sums{};
    for (Handle const part : parts) {
      Value const v = value(part);
      for (int c = 0; c < count; ++c) sums[static_cast<std::size_t>(c)] += component(v, c);
    }
    for (double& sum : sums) sum /= static_cast<double>(parts.size());
    return from_components(spec_.type, std::span<double const>(sums).first(static_cast<std::size_t>(count)));
  }
  for (Handle const part : parts.subspan(1)) {
    std::visit(
        [&]<class T>(T& kept) {
          if constexpr (HasOrder<T>) {
            T const other = std::get<T>(value(part));
            if (spec_.merge == MergePolicy::min) kept = min(kept, other);
            if (spec_.merge == MergePolicy::max) kept = max(kept, other);
          }
        },
        result);
  }
  return result;
}

}  // namespace jrule
