// Random maps of any model, grown from a few arcs: the constraints are followed arc by arc, what they leave open is drawn.
#pragma once

#include <optional>
#include <vector>

#include "jrule/map.h"
#include "tests/property/random.h"

namespace jrule::property {

/// A map some of whose arcs are still missing, closed under what its constraints imply: three arcs of an ijij-path give the
/// fourth, an arc of a non-oriented dimension its reverse.
class Growth {
 public:
  explicit Growth(Model const& model) : model_(&model), out_(model.dimensions.size()), in_(model.dimensions.size()) {}

  std::size_t size() const { return out_.empty() ? 0 : out_[0].size(); }
  Dart add_dart();
  /// no_dart if there is no such arc yet.
  Dart target(Dart d, int dimension) const { return out_[column(dimension)][d]; }
  Dart source(Dart d, int dimension) const { return in_[column(dimension)][d]; }
  /// Sets an arc and what follows from it; false if that contradicts an arc or the model, and then the growth is of no use.
  bool set(Dart from, int dimension, Dart to);
  /// Draws the missing arcs, with new darts up to `limit`; none if it ends in contradictions.
  std::optional<Map> complete(Random& random, std::size_t limit) const;

 private:
  std::size_t column(int dimension) const { return static_cast<std::size_t>(model_->column(dimension)); }
  struct Arc {
    Dart from;
    int dimension;
    Dart to;
  };
  void follow_square(Arc const& arc, int j, std::vector<Arc>& open) const;

  Model const* model_;
  std::vector<std::vector<Dart>> out_, in_;
};

}  // namespace jrule::property
