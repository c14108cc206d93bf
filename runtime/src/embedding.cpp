#include "jrule/embedding.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cassert>
#include <concepts>
#include <stdexcept>
#include <type_traits>
#include <utility>

namespace jrule {

namespace {

/// The language's type of a pool's elements: a Bool is stored as a byte, for std::vector<bool> has no addressable ones.
template <class S>
using Unstored = std::conditional_t<std::is_same_v<S, std::uint8_t>, bool, S>;

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
    case MergePolicy::function: return true;
  }
  return false;
}

}  // namespace

Embedding::Embedding(EmbeddingSpec spec) : spec_(std::move(spec)) {
  switch (spec_.type) {
    case Type::Bool: pool_.emplace<ColumnOf<std::uint8_t>>(); break;
    case Type::Int: pool_.emplace<ColumnOf<std::int64_t>>(); break;
    case Type::Real: pool_.emplace<ColumnOf<double>>(); break;
    case Type::Vec2: pool_.emplace<ColumnOf<Vec2>>(); break;
    case Type::Vec3: pool_.emplace<ColumnOf<Vec3>>(); break;
    case Type::Point2: pool_.emplace<ColumnOf<Point2>>(); break;
    case Type::Point3: pool_.emplace<ColumnOf<Point3>>(); break;
    case Type::Color: pool_.emplace<ColumnOf<Color>>(); break;
    case Type::Extern:
      if (spec_.extern_parts.make_pool != nullptr) extern_pool_ = spec_.extern_parts.make_pool();
      break;
  }
  bool const is_extern = spec_.type == Type::Extern;
  if (is_extern != (extern_pool_ != nullptr) || is_extern == spec_.extern_name.empty()) {
    throw std::invalid_argument("embedding `" + spec_.name + "`: Type::Extern goes with a C++ type's name and pool");
  }
  if ((spec_.merge == MergePolicy::function) != (spec_.extern_parts.add_merged != nullptr)) {
    throw std::invalid_argument("embedding `" + spec_.name + "`: merging by a function needs one, and only that does");
  }
  if (spec_.default_value && type_of(*spec_.default_value) != spec_.type) {
    throw std::invalid_argument("embedding `" + spec_.name + "`: the default is not of type " + to_string(spec_.type));
  }
  // Of a type from outside nothing is known that `mean`, `min` or `max` could use.
  bool const mergeable =
      is_extern ? offers<bool>(spec_.merge)
                : std::visit([&]<class S>(ColumnOf<S> const&) { return offers<Unstored<S>>(spec_.merge); }, pool_);
  if (!mergeable) {
    throw std::invalid_argument("embedding `" + spec_.name + "`: its merge policy is not offered for type " +
                                to_string(spec_.type));
  }
}

Embedding::Embedding(Embedding const& other)
    : spec_(other.spec_),
      handles_(other.handles_),
      overwritten_(other.overwritten_),
      compacted_(other.compacted_),
      pool_(other.pool_),
      extern_pool_(other.extern_pool_ ? other.extern_pool_->clone() : nullptr) {}

Embedding& Embedding::operator=(Embedding const& other) { return *this = Embedding(other); }

std::size_t Embedding::value_count() const noexcept {
  if (extern_pool_) return extern_pool_->size();
  return std::visit([](auto const& pool) { return pool.size(); }, pool_);
}

std::optional<Handle> Embedding::add_default() {
  if (spec_.extern_parts.add_default != nullptr) return spec_.extern_parts.add_default(*this);
  if (spec_.default_value) return add(*spec_.default_value);
  return std::nullopt;
}

Handle Embedding::add(Value const& value) {
  if (extern_pool_) throw std::invalid_argument("embedding `" + spec_.name + "` holds values of " + spec_.extern_name);
  std::size_t const handle = value_count();
  if (handle >= no_handle) throw std::length_error("too many values of embedding `" + spec_.name + "`");
  std::visit([&]<class S>(ColumnOf<S>& pool) { pool.push_back(std::get<Unstored<S>>(value)); },
             pool_);
  return static_cast<Handle>(handle);
}

void Embedding::reserve_values(std::size_t count) {
  if (extern_pool_) {
    if (extern_pool_->size() + count >= no_handle) throw std::length_error("too many values of embedding `" + spec_.name + "`");
    extern_pool_->reserve(count);
    return;
  }
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
  if (extern_pool_) return extern_pool_->truncate(count);
  std::visit(
      [&](auto& pool) {
        if (count < pool.size()) pool.resize(count);
      },
      pool_);
}

Value Embedding::value(Handle h) const noexcept {
  assert(!extern_pool_);
  return std::visit(
      [&]<class S>(ColumnOf<S> const& pool) -> Value {
        // In place, so that the byte of a Bool becomes that alternative and no other.
        return Value(std::in_place_type<Unstored<S>>, static_cast<Unstored<S>>(pool[h]));
      },
      pool_);
}

void Embedding::compact(std::vector<Handle>& scratch, Threads threads) {
  scratch.clear();  // a larger buffer then copies nothing
  scratch.resize(value_count(), no_handle);
  parallel::for_each(handles_.size(), threads, [&](std::size_t d) {
    Handle const h = handles_[d];
    // Atomic, for several threads may write the same.
    if (h != no_handle) std::atomic_ref(scratch[h]).store(0, std::memory_order_relaxed);
  });
  Handle kept = 0;
  for (Handle& number : scratch) {
    if (number != no_handle) number = kept++;
  }
  overwritten_ = 0;
  compacted_ = kept;
  if (kept == scratch.size()) return;
  if (extern_pool_) {
    extern_pool_->keep_numbered(scratch);
  } else {
    std::visit([&](auto& pool) { keep_numbered(pool, std::span<Handle const>(scratch)); }, pool_);
  }
  parallel::for_each(handles_.size(), threads, [&](std::size_t d) {
    Handle& h = handles_[d];
    if (h != no_handle) h = scratch[h];
  });
}

void Embedding::compact() {
  std::vector<Handle> scratch;
  compact(scratch);
}

bool Embedding::is_compaction_due() const noexcept {
  std::size_t const values = value_count(), added = values > compacted_ ? values - compacted_ : 0;
  return overwritten_ + added > 0 && overwritten_ + added >= handles_.size();
}

Value Embedding::merge(std::span<Handle const> parts) const noexcept {
  assert(!parts.empty() && !extern_pool_);
  assert(spec_.merge != MergePolicy::none && spec_.merge != MergePolicy::function);
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
