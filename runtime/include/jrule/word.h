// Path words and orbit types (paper, Def. 17): sequences of dimensions, each walked forwards or, conjugated, backwards.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace jrule {

/// One step of a path: along the outgoing arc of `dimension`, or against the incoming one if `conjugate`.
/// For a non-oriented dimension both are the same step; then `conjugate` is kept false.
struct Letter {
  std::uint8_t dimension = 0;
  bool conjugate = false;
  auto operator<=>(Letter const&) const = default;
};

/// A path word, read from the source to the target. The empty word is ε.
using Word = std::vector<Letter>;

/// An orbit type ⟨o⟩: the darts reachable by its words and their conjugates. A dimension is a word of length one.
struct OrbitType {
  std::vector<Word> words;
  auto operator<=>(OrbitType const&) const = default;
};

/// "ε", "2", "[2,~1]": the language's spelling, a single letter without brackets.
std::string to_string(Word const& word);
/// "<0,1>", "<[2,1]>".
std::string to_string(OrbitType const& orbit);
/// The orbit type of some dimensions.
OrbitType orbit_of_dimensions(std::vector<int> const& dimensions);

}  // namespace jrule
