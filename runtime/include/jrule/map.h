// A map of any model: darts, one column of arcs for each dimension, and values on orbits.
//
// Units: darts are indices below `dart_limit()`; the index of a live dart never changes while the dart lives, and is
// reused after it is erased. Everything is in index order, so equal inputs give equal maps.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "jrule/embedding.h"
#include "jrule/column.h"
#include "jrule/model.h"
#include "jrule/parallel.h"
#include "jrule/result.h"
#include "jrule/word.h"

namespace jrule {

using Dart = std::uint32_t;
inline constexpr Dart no_dart = 0xffffffffU;

class Map {
 public:
  /// An empty map. The dimensions of `model` must be in 0..9.
  explicit Map(Model model, std::vector<EmbeddingSpec> embeddings = {});

  Model const& model() const noexcept { return model_; }
  std::size_t dart_count() const noexcept { return limit_ - free_.size(); }
  /// Every dart's index is below it. O(1).
  Dart dart_limit() const noexcept { return limit_; }
  bool contains(Dart d) const noexcept { return d < limit_ && columns_[0].targets[d] != no_dart; }
  /// The live darts, ascending. O(dart_limit()).
  std::vector<Dart> darts() const;

  /// The target of d's outgoing arc of that dimension. `dimension` must be one of the model's; d must be live. O(1).
  Dart target(Dart d, int dimension) const noexcept { return columns_[index_[dimension]].targets[d]; }
  /// The source of d's incoming arc of that dimension. O(1).
  Dart source(Dart d, int dimension) const noexcept {
    Column const& c = columns_[index_[dimension]];
    return c.sources.empty() ? c.targets[d] : c.sources[d];
  }
  /// All targets and sources of that dimension, by dart; no_dart for erased darts. Valid until darts are added.
  std::span<Dart const> targets(int dimension) const noexcept { return columns_[index_[dimension]].targets; }
  std::span<Dart const> sources(int dimension) const noexcept {
    Column const& c = columns_[index_[dimension]];
    return c.sources.empty() ? c.targets : c.sources;
  }
  Dart step(Dart d, Letter letter) const noexcept {
    return letter.conjugate ? source(d, letter.dimension) : target(d, letter.dimension);
  }
  /// d·w (paper, section 6.1). O(|w|).
  Dart walk(Dart d, Word const& word) const noexcept {
    for (Letter letter : word) d = step(d, letter);
    return d;
  }
  /// The dart from which w leads to d. O(|w|).
  Dart walk_back(Dart d, Word const& word) const noexcept {
    for (auto letter = word.rbegin(); letter != word.rend(); ++letter) d = step(d, {letter->dimension, !letter->conjugate});
    return d;
  }

  /// The same to be written, for commits: `arcs(i)[d]` is the target of d's i-arc, and in an oriented dimension
  /// `sources_of_arcs(i)[e]` the source of e's; the caller keeps both consistent. Valid until darts are added.
  Dart* arcs(int dimension) noexcept { return columns_[index_[dimension]].targets.data(); }
  Dart* sources_of_arcs(int dimension) noexcept { return columns_[index_[dimension]].sources.data(); }

  /// Adds darts whose arcs are all loops and that have no values; returns them. Reuses erased indices, the smallest
  /// first, then appends. Strong guarantee; throws std::bad_alloc, or std::length_error past 2^32 - 2 darts.
  std::vector<Dart> add_darts(std::size_t count);
  /// The same without memory of its own: gives as many darts as fit.
  void add_darts(std::span<Dart> added);
  /// Appends `count` darts, the first of which it returns, without setting their arcs and handles: the caller sets every one.
  /// Strong guarantee; throws as add_darts().
  Dart append_darts(std::size_t count, Threads threads = {});
  /// Targets that a map has no more, by dimension; none where its own are still the old ones.
  using FormerTargets = std::array<ColumnOf<Dart>, max_dimension + 1>;
  /// The same for callers who also set all arcs of some dimensions that are not oriented: where these get other memory, nothing is
  /// copied to it, and what was there is left in `former`.
  Dart append_darts(std::size_t count, Threads threads, std::span<int const> overwritten, FormerTargets& former);
  std::span<Dart const> targets(int dimension, FormerTargets const& former) const noexcept {
    auto const& old = former[static_cast<std::size_t>(dimension)];
    return old.empty() ? targets(dimension) : std::span<Dart const>(old);
  }
  /// Room for so many further darts, and for so many further values of each embedding: adding them takes no memory. Strong
  /// guarantee; throws as add_darts(). Scratch memory has room of its own: rewrite::Workspace::reserve().
  void reserve(std::size_t darts, std::size_t values);
  bool has_erased_darts() const noexcept { return !free_.empty(); }
  /// Undoes the last add_darts(): `added` is what it returned, `limit` what dart_limit() was before. Nothing may refer to
  /// the darts any more.
  void undo_add(std::span<Dart const> added, Dart limit) noexcept;
  /// Erases a dart. No arc of a live dart may lead to it when the caller is done. noexcept once `reserve_erase` has
  /// made room.
  void erase(Dart d);
  /// Room for so many further erase() calls without allocation.
  void reserve_erase(std::size_t count);
  /// Sets the arc `from -dimension-> to`, and its reverse if the dimension is non-oriented. The caller leaves each column
  /// a permutation.
  void link(Dart from, int dimension, Dart to) noexcept;
  /// Sets one directed arc; in a non-oriented dimension the caller also sets the reverse.
  void set_target(Dart from, int dimension, Dart to) noexcept {
    Column& c = columns_[index_[dimension]];
    c.targets[from] = to;
    if (!c.sources.empty()) c.sources[to] = from;
  }
  /// Undoes set_target(from, dimension, to), given the target of `from` and the source of `to` before it.
  void undo_target(Dart from, int dimension, Dart to, Dart old_target, Dart old_source) noexcept {
    Column& c = columns_[index_[dimension]];
    if (!c.sources.empty()) c.sources[to] = old_source;
    c.targets[from] = old_target;
  }

  /// Embeddings in the order of their declaration.
  std::size_t embedding_count() const noexcept { return embeddings_.size(); }
  Embedding const& embedding(std::size_t i) const noexcept { return embeddings_[i]; }
  Embedding& embedding(std::size_t i) noexcept { return embeddings_[i]; }
  /// Index of the embedding of that name; none if there is none.
  std::optional<std::size_t> find_embedding(std::string const& name) const noexcept;

 private:
  // Room for `count` darts more; what dart_limit() will be. As append_darts().
  std::size_t reserve_darts(std::size_t count, Threads threads, std::span<int const> overwritten, FormerTargets& former);
  std::size_t reserve_darts(std::size_t count, Threads threads);

  struct Column {
    ColumnOf<Dart> targets;  // no_dart for erased darts
    ColumnOf<Dart> sources;  // the inverse; empty for a non-oriented dimension, which is its own inverse
  };

  Model model_;
  std::uint8_t index_[max_dimension + 1] = {};  // dimension -> column
  std::vector<Column> columns_;
  Dart limit_ = 0;
  std::vector<Dart> free_;  // a min-heap of erased darts
  std::vector<Embedding> embeddings_;
};

/// The darts of ⟨o⟩(d), d first, depth first, words in their order and forwards: so the darts of a closed face or vertex come
/// in their cyclic order. O(orbit size · words).
std::vector<Dart> orbit(Map const& map, OrbitType const& type, Dart d);
/// The orbit of each dart, numbered by smallest dart; `no_orbit` for erased darts. O(darts · words).
struct OrbitNumbers {
  ColumnOf<std::uint32_t> number;  ///< by dart index
  std::vector<Dart> first;         ///< the smallest dart of each orbit
};
inline constexpr std::uint32_t no_orbit = 0xffffffffU;
OrbitNumbers number_orbits(Map const& map, OrbitType const& type);
/// One dart of each cell of that dimension, the smallest, ascending; none where the model has no such cells. O(darts · words).
std::vector<Dart> cells(Map const& map, int dimension);

/// The first violation of the model's constraints or of the embeddings, in the order incident arcs, non-orientation,
/// cycles, closedness, values; by dimension, then dart.
struct Violation {
  enum class Kind { incident_arcs, non_orientation, cycle, closed, embedding };
  Kind kind;
  Dart dart;          ///< a dart at which it shows
  int i = -1;         ///< the dimension
  int j = -1;         ///< the second dimension of a cycle
  std::string text;   ///< "dart 12: the path 0202 does not return (it ends at dart 7)"
};
/// None if the map is a map of its model and each orbit of each embedding carries exactly one value. O(darts · |D|²).
std::optional<Violation> find_violation(Map const& map);

/// What `jrule info` prints. Where an arc is missing or shared (Kind::incident_arcs) there are no orbits to count, and
/// `cells`, `components` and `euler` stay 0.
struct Summary {
  std::string model;
  int dimension = 0;
  std::size_t darts = 0;
  std::vector<std::size_t> cells;  ///< of dimension 0..n; for a model without i-cells, 0
  std::size_t components = 0;
  long long euler = 0;             ///< the alternating sum of `cells`
  bool orientable = true;
  std::size_t boundary_darts = 0;  ///< darts whose n-arc is a loop (0 for an oriented dimension n)
  bool valid = false;
};
Summary summarize(Map const& map);

}  // namespace jrule
