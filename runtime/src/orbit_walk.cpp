#include "jrule/orbit_walk.h"

#include <utility>

namespace jrule::rewrite {

namespace {

/// The dimension, if the word is one letter of a non-oriented one; else -1.
int involution(Model const& model, Word const& word) {
  return word.size() == 1 && !model.is_oriented(word.front().dimension) ? word.front().dimension : -1;
}

}  // namespace

OrbitWalk::OrbitWalk(Model const& model, OrbitType type, OrbitType by) : type_(std::move(type)), by_words_(std::move(by)) {
  bool const each = by_words_.words.empty();
  if (type_.words.empty() || type_ == by_words_) {
    shape_ = Shape::dart;
  } else if (type_.words.size() == 1) {
    if (each) shape_ = Shape::cycle;
  } else if (type_.words.size() == 2) {
    one_ = involution(model, type_.words[0]);
    two_ = involution(model, type_.words[1]);
    if (by_words_.words.size() == 1) by_ = involution(model, by_words_.words[0]);
    if (one_ >= 0 && two_ >= 0 && (each || (by_ >= 0 && (by_ == one_ || by_ == two_)))) shape_ = Shape::dihedral;
  }
}

}  // namespace jrule::rewrite
