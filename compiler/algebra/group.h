// The group Γ of a model and its word problem: when do two paths lead to the same dart in every map?
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compiler/algebra/coxeter.h"
#include "jrule/model.h"

namespace jrule::algebra {

/// The conjugate of a word (paper, Def. 17): reversed, each letter conjugated. Letters of non-oriented dimensions are
/// their own conjugates.
Word conjugate(Model const& model, Word const& word);
Word concatenate(Word const& a, Word const& b);

/// Γ = ⟨ D | i² (i ∈ N), (ij)² ({i,j} ∈ E) ⟩: a map is a set of darts on which Γ acts from the right, and two words
/// lead to the same dart in every map iff they are equal in Γ.
class Group {
 public:
  /// Why the word problem of a model is not decided here; none if it is. It is unless an odd number of exchangeable pairs of
  /// oriented dimensions form a circle; generalized and oriented maps have no such pair at all.
  static std::optional<std::string> undecided(Model const& model);

  /// `model` must be decided (see above); throws std::invalid_argument otherwise.
  explicit Group(Model model);
  Model const& model() const { return model_; }

  /// The unique shortest representative of the word's element whose dimensions come first in lexicographic order: equal
  /// in Γ iff same normal form.
  /// Its letters have `conjugate` false for non-oriented dimensions. O(|w|²).
  Word normal_form(Word const& word) const;
  bool equal(Word const& a, Word const& b) const { return normal_form(a) == normal_form(b); }
  bool is_identity(Word const& word) const { return normal_form(word).empty(); }
  /// normal_form(a·b), normal_form(ā).
  Word product(Word const& a, Word const& b) const;
  Word inverse(Word const& a) const;

  /// Is the element conjugate in Γ to a single letter? In a closed map such an element fixes no dart.
  bool is_conjugate_to_letter(Word const& word) const;

  /// Is the element in the subgroup that the words of an orbit type generate? Decided for sets of dimensions and for
  /// the cells of the built-in models; for other sets of words a bounded search, so `false` may mean "not found".
  bool in_orbit(Word const& word, OrbitType const& orbit) const;

 private:
  Model model_;
  RightAngledCoxeterGroup coxeter_;  ///< W ⊃ Γ, in which everything is decided
  std::uint16_t second_class_ = 0;   ///< the oriented dimensions that lie in W the other way round, as bits
};

}  // namespace jrule::algebra
