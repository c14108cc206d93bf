// The values of orbits that an application changes: found, given, merged, dropped.
#include <algorithm>
#include <cassert>
#include <iterator>
#include <new>
#include <utility>

#include "jrule/rewrite.h"

namespace jrule::rewrite {

namespace {

/// The map's columns that lead to the neighbours of a dart in its orbit.
class Neighbours {
 public:
  /// None if the orbit has words of several letters: these lead through darts that are not of it.
  Neighbours(Map const& map, OrbitType const& type) noexcept {
    bool const are_columns = type.words.size() <= std::size(columns_) / 2 &&
                             std::all_of(type.words.begin(), type.words.end(), [](Word const& word) { return word.size() == 1; });
    if (!are_columns) return;
    for (Word const& word : type.words) {
      int const d = word.front().dimension;
      columns_[count_++] = map.targets(d).data();
      if (map.model().is_oriented(d)) columns_[count_++] = map.sources(d).data();
      // As the words lead: what an orbit's darts are met in is seen by those who merge their values.
      if (map.model().is_oriented(d) && word.front().conjugate) std::swap(columns_[count_ - 1], columns_[count_ - 2]);
    }
  }
  bool empty() const noexcept { return count_ == 0; }
  Dart const* const* begin() const noexcept { return columns_; }
  Dart const* const* end() const noexcept { return columns_ + count_; }

 private:
  Dart const* columns_[2 * (max_dimension + 1)];
  std::size_t count_ = 0;
};

}  // namespace

std::span<Dart const> collect_orbit(Map const& map, OrbitType const& type, Dart d, Workspace& workspace) noexcept {
  std::vector<Dart>& queue = workspace.queue();
  if (!workspace.mark(d, 0)) return {};
  queue.push_back(d);
  if (Neighbours const neighbours(map, type); !neighbours.empty()) {
    for (std::size_t next = 0; next < queue.size(); ++next) {
      Dart const at = queue[next];
      for (Dart const* const column : neighbours) {
        if (workspace.mark(column[at], 0)) queue.push_back(column[at]);
      }
    }
    return queue;
  }
  for (std::size_t next = 0; next < queue.size(); ++next) {
    Dart const at = queue[next];
    for (Word const& word : type.words) {
      for (Dart const to : {map.walk(at, word), map.walk_back(at, word)}) {
        if (workspace.mark(to, 0)) queue.push_back(to);
      }
    }
  }
  return queue;
}

void assign_orbit(Map& map, std::size_t embedding, Dart d, Handle value, Workspace& workspace) noexcept {
  Embedding& e = map.embedding(embedding);
  for (Dart const member : collect_orbit(map, e.spec().orbit, d, workspace)) e.set_handle(member, value);
}

bool collect_values(Embedding const& embedding, std::span<Dart const> darts, std::vector<Handle>& parts) noexcept {
  bool complete = true;
  for (Dart const d : darts) {
    Handle const h = embedding.handle(d);
    if (h == no_handle) {
      complete = false;
    } else if (std::find(parts.begin(), parts.end(), h) == parts.end()) {
      parts.push_back(h);
    }
  }
  return parts.empty() || (complete && parts.size() == 1);
}

void merge_orbit(Map& map, std::size_t embedding, Dart d, Workspace& workspace) noexcept {
  Embedding& e = map.embedding(embedding);
  std::span<Dart const> const members = collect_orbit(map, e.spec().orbit, d, workspace);
  if (members.empty()) return;
  std::vector<Handle>& parts = workspace.handles();
  if (collect_values(e, members, parts)) return;
  bool const is_known = parts.size() == 1 || e.spec().merge == MergePolicy::first;
  Handle const value = is_known ? parts.front() : e.add(e.merge(parts));
  for (Dart const member : members) e.set_handle(member, value);
}

void detail::spread(Map& map, std::size_t embedding, Dart d, Handle value, Workspace& workspace) noexcept {
  Embedding& e = map.embedding(embedding);
  Neighbours const neighbours(map, e.spec().orbit);
  assert(!neighbours.empty() || e.spec().orbit.words.empty());
  std::vector<Dart>& queue = workspace.queue();
  auto const join = [&](Dart at) {
    if (e.handle(at) == value) return;
    e.set_handle(at, value);
    queue.push_back(at);
  };
  join(d);
  for (std::size_t next = 0; next < queue.size(); ++next) {
    Dart const at = queue[next];
    for (Dart const* const column : neighbours) join(column[at]);
  }
}

void drop_unused_values(Map& map, Workspace& workspace, Threads threads) noexcept {
  for (std::size_t e = 0; e < map.embedding_count(); ++e) {
    Embedding& embedding = map.embedding(e);
    if (!embedding.is_compaction_due()) continue;
    try {
      embedding.compact(workspace.handles(), threads);
    } catch (std::bad_alloc const&) {
      // It stays due: the next application tries again.
    }
  }
}

void set_value(Map& map, std::size_t embedding, Dart d, Value const& value, Workspace& workspace) {
  workspace.reserve(map.dart_limit());
  workspace.clear_marks();
  assign_orbit(map, embedding, d, map.embedding(embedding).add(value), workspace);
  drop_unused_values(map, workspace);
}

}  // namespace jrule::rewrite
