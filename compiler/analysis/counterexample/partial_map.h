// Maps some of whose arcs are still missing, and what their model then says of the others.
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "jrule/map.h"

namespace jrule::analysis {

/// Closed under what the constraints imply: an arc of a non-oriented dimension comes with its reverse, three arcs of an
/// ijij-path with the fourth. Hence without missing arcs it is a map. Columns are the model's (Model::column).
class PartialMap {
 public:
  explicit PartialMap(Model model);

  Model const& model() const { return model_; }
  std::size_t columns() const { return out_.size(); }
  Dart size() const { return size_; }
  bool complete() const { return arcs_.size() == size_ * columns(); }

  /// no_dart where the arc is missing.
  Dart target(Dart d, std::size_t column) const { return out_[column][d]; }
  Dart source(Dart d, std::size_t column) const { return in_[column][d]; }
  /// d·w and d·w̄; the arcs must be there.
  Dart walk(Dart d, Word const& word) const;
  Dart walk_back(Dart d, Word const& word) const;

  Dart add_dart();
  /// Sets an arc and what follows from it. False if that contradicts an arc or the model: then undo.
  bool set(Dart from, std::size_t column, Dart to);

  struct Mark {
    std::size_t arcs;
    Dart size;
  };
  Mark mark() const { return {arcs_.size(), size_}; }
  /// Forgets the darts and arcs that are newer than the mark.
  void undo(Mark mark);

  /// Without missing arcs: the map; the map of the components of these darts alone, which are renumbered.
  Map to_map() const;
  PartialMap components_of(std::vector<Dart>& darts) const;

 private:
  struct Arc {
    Dart from;
    std::size_t column;
    Dart to;
  };
  void follow_square(Arc const& arc, std::size_t other);

  Model model_;
  std::vector<std::vector<std::size_t>> exchanged_;  // by column
  Dart size_ = 0;
  std::vector<std::vector<Dart>> out_, in_;  // by column
  std::vector<Arc> arcs_;                    // in the order in which they were set
  std::vector<Arc> open_;                    // to be set
};

}  // namespace jrule::analysis
