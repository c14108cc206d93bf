// Why a word is ε in Γ, step by step: what a reader, or a program that knows nothing of normal forms, can follow.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "jrule/model.h"

namespace jrule::algebra {

class Group;

/// One step on the way to ε: of the word as it stands, the letter at `right` is moved left, past the letters between, to stand
/// beside the one at `left`, with which it cancels. It passes exchangeable letters only. From (xy)² = ε, x·y = ȳ·x̄: of an
/// exchangeable pair an oriented letter turns round where the two change places. If both are oriented, they change places only if both are
/// conjugates or neither is.
struct Cancellation {
  std::size_t left = 0, right = 0;
  bool operator==(Cancellation const&) const = default;
};
using Cancellations = std::vector<Cancellation>;

/// Cancellations that empty the word; none if it is not ε in Γ. The model must be one that Group decides. O(|w|²).
std::optional<Cancellations> cancel(Model const& model, Word word);

/// The word after one step. The step must be one that `cancel` gives for it.
Word after(Model const& model, Word word, Cancellation step);

/// word = by·letter·b̄y in Γ.
struct ConjugateOfLetter {
  Word by;
  Letter letter;
};
/// None if the word is not conjugate to a single letter.
std::optional<ConjugateOfLetter> conjugate_of_letter(Group const& group, Word const& word);

}  // namespace jrule::algebra
