// What an application of a rule scheme is made of: generated code and the interpreter call these functions in the order
// match, plan, commit. Everything that can fail comes before the commit; the commit cannot.
//
// Notation: P is the pattern, the darts u_0 … u_{n-1}; a column of a word w holds for each k the index of u_k·w; a match
// column of a left node s holds for each k the dart m(u_k, s) of the map (paper, section 6.3).
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "jrule/map.h"
#include "jrule/result.h"

namespace jrule::rewrite {

using Index = std::uint32_t;
using Column = ColumnOf<Index>;

/// Scratch memory, reused between applications so that none allocates after warm-up. One application at a time.
class Workspace {
 public:
  Workspace() = default;
  /// A copy begins without memory; what is assigned keeps its own.
  Workspace(Workspace const&) noexcept {}
  Workspace& operator=(Workspace const&) noexcept { return *this; }
  Workspace(Workspace&& other) noexcept { swap(other); }
  Workspace& operator=(Workspace&& other) noexcept {
    swap(other);
    return *this;
  }
  ~Workspace();

  /// Room to mark every dart below `darts` and to queue as many; forgets all marks if that needs more memory. May throw
  /// std::bad_alloc. O(1): memory that is not marked is not touched.
  void reserve(std::size_t darts);
  /// Forgets all marks. O(1), except once in 2^32 times.
  void clear_marks() noexcept;
  /// Marks a dart; false if it was marked already.
  bool mark(Dart d, Index value) noexcept {
    if (stamp_[d] == epoch_) return false;
    stamp_[d] = epoch_;
    value_[d] = value;
    return true;
  }
  bool marked(Dart d) const noexcept { return d < room_ && stamp_[d] == epoch_; }
  /// The value that the dart was marked with; it must be marked.
  Index value(Dart d) const noexcept { return value_[d]; }
  /// An empty queue with room for every dart.
  std::vector<Dart>& queue() noexcept {
    queue_.clear();
    return queue_;
  }
  /// An empty list with room for every dart.
  std::vector<Handle>& handles() noexcept {
    handles_.clear();
    return handles_;
  }

  /// Begins an application: the pattern is empty, the columns of the last one may be used again.
  void begin() noexcept {
    pattern_.clear();
    used_ = 0;
  }
  /// P, while it is being closed: meet() adds a dart that is not marked, and marks it with its index. There must be room to
  /// mark every dart.
  std::vector<Dart> const& pattern() const noexcept { return pattern_; }
  void meet(Dart d) {
    if (mark(d, static_cast<Index>(pattern_.size()))) pattern_.push_back(d);
  }
  /// The same without marks, for those who know that it is not there yet.
  void append(Dart d) { pattern_.push_back(d); }
  /// A column of that size, its numbers unset. Valid until begin(). May throw std::bad_alloc.
  Index* column(std::size_t size);
  /// Gives the memory of all columns back. For what has made the map so much larger that they would hardly do again.
  void release_columns() noexcept { columns_.clear(); }

 private:
  void swap(Workspace& other) noexcept;

  // Stamps are zero at first, values unset; both for room_ darts.
  std::uint32_t* stamp_ = nullptr;
  Index* value_ = nullptr;
  std::size_t room_ = 0;
  std::uint32_t epoch_ = 1;
  std::vector<Dart> queue_;
  std::vector<Handle> handles_;
  std::vector<Dart> pattern_;
  std::vector<ColumnOf<Index>> columns_;
  std::size_t used_ = 0;  // of the columns
};

/// P: the closure of `hook` under the words and their conjugates, breadth first, the hook first. Leaves each dart of P marked
/// with its index. O(|P| · letters).
std::vector<Dart> close_pattern(Map const& map, Dart hook, std::span<Word const> words, Workspace& workspace);

/// The column of a word under which P is closed; P's darts must be marked with their indices. O(|P| · |w|).
Column column(Map const& map, std::vector<Dart> const& pattern, Word const& word, Workspace const& workspace, Threads threads = {});

/// A loop (w, d) of a further hook: m(u·w, b) = m(u, b)·d.
struct Loop {
  Index const* word;  ///< its column
  int dimension;
};
/// P where its darts lie on a circle or a path: in the order of close_pattern(), with its columns, and without marks.
struct LinePattern {
  std::span<Dart const> darts;
  Index *first, *second;  ///< columns of the workspace: where the two ways lead
};
/// Of two dimensions that are not oriented, by the map's columns of them; after Workspace::begin(). O(|P|). May throw
/// std::bad_alloc.
LinePattern dihedral_pattern(Dart const* first, Dart const* second, Dart hook, Workspace& workspace);
/// Of one oriented dimension: `first` forwards, `second` backwards.
LinePattern cycle_pattern(Dart const* forwards, Dart const* backwards, Dart hook, Workspace& workspace);

/// The match column of a further hook: P walked in step from `hook`, a column of the workspace. Empty if the loops do not
/// determine it for all of P. That each loop then holds everywhere is for the caller to check.
std::span<Dart const> walk_in_step(Map const& map, Dart hook, std::size_t pattern_size, std::span<Loop const> loops, Workspace& workspace);

/// Do the match columns name each dart once? If not, the first dart that is matched twice. Forgets P's marks.
std::optional<Dart> matched_twice(std::span<std::span<Dart const> const> matches, Workspace& workspace);

/// The orbits of P under columns: orbit_walk.h has simpler ones for few columns, and says what fill() does.
class PatternOrbits {
 public:
  /// The columns, and the array that lists them, must outlive it. May throw std::bad_alloc.
  PatternOrbits(std::size_t pattern_size, std::span<Index const* const> columns, Workspace& workspace)
      : columns_(columns), open_(workspace.column(pattern_size)) {}
  void fill(Index* numbers, Index k, Index number) const noexcept;

 private:
  std::span<Index const* const> columns_;
  Index* open_;  // indices whose neighbours are still to be met
};

/// The darts of the orbit, `d` first, in the workspace's queue; marks them. Nothing if `d` is marked already. The workspace
/// must have room for every dart; then it does not allocate.
std::span<Dart const> collect_orbit(Map const& map, OrbitType const& type, Dart d, Workspace& workspace) noexcept;

/// Commit: gives the whole orbit of `d` the value, unless its darts are marked (another representative came first).
void assign_orbit(Map& map, std::size_t embedding, Dart d, Handle value, Workspace& workspace) noexcept;
/// Commit: if the orbit of `d` holds several values or darts without one, gives it one: the only value, or the merge by the
/// embedding's policy, which is not MergePolicy::function (see trial.h). `reserve_values` must have made room for one value.
void merge_orbit(Map& map, std::size_t embedding, Dart d, Workspace& workspace) noexcept;
/// The same for the orbit of `d` if a dart of it, `other`, does not have the value.
inline void merge_orbit_at(Map& map, std::size_t embedding, Dart other, Handle value, Dart d, Workspace& workspace) noexcept {
  if (map.embedding(embedding).handle(other) != value) merge_orbit(map, embedding, d, workspace);
}

namespace detail {
void spread(Map& map, std::size_t embedding, Dart d, Handle value, Workspace& workspace) noexcept;
}
/// Commit: the same by MergePolicy::first for orbits of single letters, one of their darts in the pattern after the other: where `d`
/// does not have the value yet, what is around it takes that over, as far as other values reach. O(1) where nothing merges.
inline void join_orbit(Map& map, std::size_t embedding, Dart d, Handle value, Workspace& workspace) noexcept {
  if (map.embedding(embedding).handle(d) != value) detail::spread(map, embedding, d, value, workspace);
}

/// The values that these darts have, each once, in the order of the darts. Is there nothing to merge: no value at all, or
/// one that every dart has? `parts` must have room for them.
bool collect_values(Embedding const& embedding, std::span<Dart const> darts, std::vector<Handle>& parts) noexcept;

/// One dart for each ⟨by⟩-orbit inside ⟨type⟩(d): the darts of orbit() that are the first of their ⟨by⟩-orbit, in its order.
/// ⟨by⟩ must be a subgroup of ⟨type⟩. O(orbit · words).
std::vector<Dart> representatives(Map const& map, OrbitType const& type, OrbitType const& by, Dart d);

/// After the commit: drops the values that no dart refers to any more from the embeddings where Embedding::is_compaction_due(),
/// and so may renumber handles. Puts it off where memory is lacking. O(1) for each handle that was overwritten or value
/// added since it last did something, all at once; O(embeddings) if nothing is due.
void drop_unused_values(Map& map, Workspace& workspace, Threads threads = {}) noexcept;

/// Gives the whole orbit of `d` a new value; strong guarantee. Not part of a rule: for programs that change values by hand.
/// Ends with drop_unused_values().
void set_value(Map& map, std::size_t embedding, Dart d, Value const& value, Workspace& workspace);

/// Calls `apply` with the smallest dart of each ⟨type⟩-orbit, ascending, as numbered before the first call, unless an earlier
/// call has deleted it; where it is not applicable the map stays as it is. How often it was applied; the first refusal if
/// nowhere, or any other error at once.
Result<std::size_t> apply_everywhere(Map const& map, OrbitType const& type, std::function<Result<void>(Dart)> const& apply);

/// Nothing if the map is of this model and has these embeddings; else an error that says what differs.
Result<void> check_modeler(Map const& map, Model const& model, std::vector<EmbeddingSpec> const& embeddings);
/// The map itself after that check.
Result<Map> expect_modeler(Map map, Model const& model, std::vector<EmbeddingSpec> const& embeddings);

/// The errors of a rule that does not match.
Error not_a_dart(std::string_view rule, std::string_view hook, Dart d);
Error arc_differs(std::string_view rule, std::string_view source, int dimension, std::string_view target, Dart at, Dart leads_to,
                  Dart expected);
Error matched_twice_error(std::string_view rule, Dart d);
Error hook_not_determined(std::string_view rule, std::string_view hook);
struct HookDart {
  std::string_view hook;
  Dart dart;
};
/// `condition` as it is written; `hooks` where it does not hold, none if it is the same everywhere.
Error requirement_failed(std::string_view rule, std::string_view condition, std::vector<HookDart> const& hooks);
/// Also where there is no memory for its message: then that is a shorter one.
Error no_memory(std::string_view rule) noexcept;

}  // namespace jrule::rewrite
