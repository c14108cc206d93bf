#include "compiler/algebra/cancellation.h"

#include <iterator>

#include "compiler/algebra/group.h"

namespace jrule::algebra {

namespace {

void turn(Model const& model, Letter& letter) {
  if (model.is_oriented(letter.dimension)) letter.conjugate = !letter.conjugate;
}

bool are_inverse(Model const& model, Letter a, Letter b) {
  return a.dimension == b.dimension && (!model.is_oriented(a.dimension) || a.conjugate != b.conjugate);
}

/// With which letter before it the one at `right` cancels; none if with none.
std::optional<std::size_t> partner_of(Model const& model, Word const& word, std::size_t right) {
  Letter moving = word[right];
  for (std::size_t k = right; k-- > 0;) {
    if (are_inverse(model, word[k], moving)) return k;
    if (!model.exchanges(word[k].dimension, moving.dimension)) return {};
    // (i·j)² = ε says i·j = j̄·ī, and so ī·j̄ = j·i; of i·j̄ it says nothing where both are oriented.
    bool const both = model.is_oriented(word[k].dimension) && model.is_oriented(moving.dimension);
    if (both && word[k].conjugate != moving.conjugate) return {};
    turn(model, moving);
  }
  return {};
}

}  // namespace

Word after(Model const& model, Word word, Cancellation step) {
  for (std::size_t k = step.left + 1; k < step.right; ++k) turn(model, word[k]);
  word.erase(std::next(word.begin(), static_cast<std::ptrdiff_t>(step.right)));
  word.erase(std::next(word.begin(), static_cast<std::ptrdiff_t>(step.left)));
  return word;
}

// Letters are cancelled as soon as they can, so what stands before `at` is always as short as its element allows: a letter more
// makes an element one longer, or one shorter, and then it cancels with a letter that only exchangeable ones separate from it.
// (In the Coxeter group of group.cpp, equal letters cancel that only commuting letters separate. z commutes with no oriented
// dimension, so between two oriented letters that cancel the z's cancel each other: they are even in number, which says that
// the letters turn into inverse ones on the way. That no z is left between an oriented letter and one of the other class that it
// passes says that their directions are equal.)
std::optional<Cancellations> cancel(Model const& model, Word word) {
  Cancellations steps;
  for (std::size_t at = 0; at < word.size();) {
    auto const partner = partner_of(model, word, at);
    if (partner) {
      steps.push_back({*partner, at});
      word = after(model, std::move(word), steps.back());
      --at;
    } else {
      ++at;
    }
  }
  if (!word.empty()) return {};
  return steps;
}

// A word of least length among the conjugates of g is reached by conjugating with single letters, each of which makes it
// shorter by two: so it is in the Coxeter group, and there z neither lengthens nor shortens what counts as a letter here.
std::optional<ConjugateOfLetter> conjugate_of_letter(Group const& group, Word const& word) {
  Word least = group.normal_form(word), by;
  bool shorter = true;
  while (shorter && least.size() > 1) {
    shorter = false;
    // Only a first letter of one of its shortest words can be taken away in front.
    for (Letter const letter : Word(least)) {
      for (bool const conjugate : {false, true}) {
        Letter const x{letter.dimension, conjugate && group.model().is_oriented(letter.dimension)};
        Word const next = group.product(group.product(group.inverse({x}), least), {x});
        if (next.size() >= least.size()) continue;
        least = next;
        by = group.product(by, {x});
        shorter = true;
        break;
      }
      if (shorter) break;
    }
  }
  if (least.size() != 1) return {};
  return ConjugateOfLetter{by, least.front()};
}

}  // namespace jrule::algebra
