#include "jrule/map.h"

#include <algorithm>
#include <cassert>
#include <functional>
#include <stdexcept>
#include <utility>

namespace jrule {

namespace {

/// no_dart itself is not an index, and one less keeps every count of darts a 32-bit one below no_dart too.
constexpr std::size_t most_darts = no_dart - 1;

[[maybe_unused]] bool is_orbit_of(Model const& model, OrbitType const& type) {
  return std::all_of(type.words.begin(), type.words.end(), [&](Word const& word) {
    return std::all_of(word.begin(), word.end(), [&](Letter letter) { return model.has(letter.dimension); });
  });
}

}  // namespace

Map::Map(Model model, std::vector<EmbeddingSpec> embeddings)
    : model_(std::move(model)), columns_(model_.dimensions.size()) {
  assert(!model_.dimensions.empty());
  for (std::size_t k = 0; k < model_.dimensions.size(); ++k) {
    assert(model_.dimensions[k] >= 0 && model_.dimensions[k] <= max_dimension);
    index_[model_.dimensions[k]] = static_cast<std::uint8_t>(k);
  }
  embeddings_.reserve(embeddings.size());
  for (EmbeddingSpec& spec : embeddings) {
    assert(is_orbit_of(model_, spec.orbit));
    embeddings_.emplace_back(std::move(spec));
  }
}

std::vector<Dart> Map::darts() const {
  std::vector<Dart> live;
  live.reserve(dart_count());
  for (Dart d = 0; d < limit_; ++d) {
    if (contains(d)) live.push_back(d);
  }
  return live;
}

std::size_t Map::reserve_darts(std::size_t count, Threads threads) {
  FormerTargets former;
  return reserve_darts(count, threads, {}, former);
}

std::size_t Map::reserve_darts(std::size_t count, Threads threads, std::span<int const> overwritten, FormerTargets& former) {
  if (count > most_darts - limit_) throw std::length_error("a map has at most 2^32 - 2 darts");
  std::size_t const limit = limit_ + count;
  std::size_t capacity = columns_[0].targets.capacity();
  if (limit > capacity) capacity = std::max(limit, 2 * capacity);
  for (std::size_t k = 0; k < columns_.size(); ++k) {
    bool const is_kept = std::find(overwritten.begin(), overwritten.end(), model_.dimensions[k]) == overwritten.end();
    if (is_kept || columns_[k].targets.grows_without_copy(capacity)) {
      columns_[k].targets.reserve(capacity, threads);
    } else {
      former[static_cast<std::size_t>(model_.dimensions[k])].reserve(capacity);
    }
    if (model_.is_oriented(model_.dimensions[k])) columns_[k].sources.reserve(capacity, threads);
  }
  for (Embedding& e : embeddings_) e.reserve(capacity, threads);
  // Nothing fails any more.
  for (int const d : overwritten) {
    ColumnOf<Dart>& grown = former[static_cast<std::size_t>(d)];
    if (grown.capacity() == 0) continue;
    grown.resize(limit_);
    grown.swap(columns_[index_[d]].targets);
  }
  return limit;
}

void Map::reserve(std::size_t darts, std::size_t values) {
  (void)reserve_darts(darts - std::min(darts, free_.size()), {});
  for (Embedding& e : embeddings_) e.reserve_values(values);
}

std::vector<Dart> Map::add_darts(std::size_t count) {
  if (count > most_darts) throw std::length_error("a map has at most 2^32 - 2 darts");
  std::vector<Dart> added(count);
  add_darts(added);
  return added;
}

void Map::add_darts(std::span<Dart> added) {
  std::size_t const reused = std::min(added.size(), free_.size());
  std::size_t const limit = reserve_darts(added.size() - reused, {});  // everything that may fail

  for (std::size_t k = 0; k < reused; ++k) {
    added[k] = free_.front();
    std::pop_heap(free_.begin(), free_.end(), std::greater<>{});
    free_.pop_back();
  }
  for (std::size_t d = limit_; d < limit; ++d) added[reused + d - limit_] = static_cast<Dart>(d);
  for (std::size_t k = 0; k < columns_.size(); ++k) {
    Column& c = columns_[k];
    c.targets.resize(limit);
    if (model_.is_oriented(model_.dimensions[k])) c.sources.resize(limit);
    for (Dart d : added) c.targets[d] = d;
    if (!c.sources.empty()) {
      for (Dart d : added) c.sources[d] = d;
    }
  }
  for (Embedding& e : embeddings_) e.resize(limit);  // an erased dart's handle is no_handle already
  limit_ = static_cast<Dart>(limit);
}

Dart Map::append_darts(std::size_t count, Threads threads) {
  FormerTargets former;
  return append_darts(count, threads, {}, former);
}

Dart Map::append_darts(std::size_t count, Threads threads, std::span<int const> overwritten, FormerTargets& former) {
  std::size_t const limit = reserve_darts(count, threads, overwritten, former);
  for (std::size_t k = 0; k < columns_.size(); ++k) {
    columns_[k].targets.resize(limit);
    if (model_.is_oriented(model_.dimensions[k])) columns_[k].sources.resize(limit);
  }
  for (Embedding& e : embeddings_) e.extend(limit);
  Dart const first = limit_;
  limit_ = static_cast<Dart>(limit);
  return first;
}

void Map::undo_add(std::span<Dart const> added, Dart limit) noexcept {
  for (Column& c : columns_) {
    c.targets.resize(limit);
    if (!c.sources.empty()) c.sources.resize(limit);
  }
  for (Embedding& e : embeddings_) e.resize(limit);
  limit_ = limit;
  for (Dart const d : added) {
    if (d < limit) erase(d);  // there is room: the index came from there
  }
}

void Map::erase(Dart d) {
  assert(contains(d));
  free_.push_back(d);
  std::push_heap(free_.begin(), free_.end(), std::greater<>{});
  for (Column& c : columns_) {
    c.targets[d] = no_dart;
    if (!c.sources.empty()) c.sources[d] = no_dart;
  }
  for (Embedding& e : embeddings_) e.set_handle(d, no_handle);
}

void Map::reserve_erase(std::size_t count) {
  std::size_t const needed = free_.size() + count;
  if (needed > free_.capacity()) free_.reserve(std::max(needed, 2 * free_.capacity()));
}

void Map::link(Dart from, int dimension, Dart to) noexcept {
  set_target(from, dimension, to);
  if (!model_.is_oriented(dimension)) set_target(to, dimension, from);
}

std::optional<std::size_t> Map::find_embedding(std::string const& name) const noexcept {
  for (std::size_t i = 0; i < embeddings_.size(); ++i) {
    if (embeddings_[i].spec().name == name) return i;
  }
  return std::nullopt;
}

}  // namespace jrule
