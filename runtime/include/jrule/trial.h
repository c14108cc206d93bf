// Merging by functions that may throw (MergePolicy::function). What an orbit is merged from is known only when the new
// arcs are there, so they are written on trial: if a function throws, the map becomes again what it was.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "jrule/map.h"
#include "jrule/rewrite.h"

namespace jrule::rewrite {

/// The part of an application between its plan and its commit, in the order of the members. Unless keep() is called,
/// the destructor undoes all of it: the new darts and arcs, and every value that was added to the map since the
/// constructor.
class Trial {
 public:
  /// Room for so many calls of set_target(). May throw std::bad_alloc. The workspace must have room for every dart, the
  /// new ones too.
  Trial(Map& map, Workspace& workspace, std::size_t arcs);
  ~Trial();
  Trial(Trial const&) = delete;
  Trial& operator=(Trial const&) = delete;

  /// Map::add_darts, once.
  std::span<Dart const> add_darts(std::size_t count);
  void set_target(Dart from, int dimension, Dart to) noexcept;

  /// The merges of an embedding follow. Its new values are added to the map, but no dart has them yet.
  void begin_merges(std::size_t embedding) noexcept;
  /// The orbit of `d` gets a value from elsewhere: nothing is merged there.
  void exclude(Dart d) noexcept;
  /// If the orbit of `d` holds several values or darts without one: the value that it is to have, the only one or what
  /// the embedding's function makes of them. Throws what that throws.
  void merge(Dart d);

  void keep() noexcept { kept_ = true; }
  /// Commit: gives the merged orbits of an embedding their values. After keep().
  void commit_merges(std::size_t embedding) noexcept;

 private:
  struct Arc {
    Dart from;
    int dimension;
    Dart to, old_target, old_source;
  };
  struct Merged {
    std::size_t embedding;
    Dart dart;
    Handle value;
  };

  Map& map_;
  Workspace& workspace_;
  Dart limit_;                             // before add_darts
  std::vector<std::size_t> value_counts_;  // by embedding, before
  std::vector<Dart> added_;
  std::vector<Arc> arcs_;
  std::size_t embedding_ = 0;
  std::vector<Merged> merged_;
  bool kept_ = false;
};

}  // namespace jrule::rewrite
