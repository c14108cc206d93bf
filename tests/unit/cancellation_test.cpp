// Traces of cancellations against the word problem, replayed by the relations themselves: one exchange at a time.
#include "compiler/algebra/cancellation.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <random>

#include "compiler/algebra/group.h"
#include "relations.h"

namespace jrule::algebra {
namespace {

using test::letters_of;
using test::random_word;
using test::word_of;

Model mixed() {
  Model model{"mixed", 3, {0, 1, 2, 3}, 0, {{0, 1}, {0, 3}, {2, 3}}, false};
  model.oriented = 0b0110;  // 1 and 2
  return model;
}

Model oriented_path() {
  Model model{"oriented_path", 3, {0, 1, 2, 3}, 0, {{0, 2}, {0, 3}, {1, 2}, {2, 3}}, false};
  model.oriented = 0b1110;
  return model;
}

std::vector<Model> tested_models() { return {oriented_path(), gmap(1), gmap(2), gmap(3), gmap(4), omap(2), omap(3), omap(4), dual_omap(2), dual_omap(3), mixed()}; }

/// What the steps leave of the word, by single uses of x·y = ȳ·x̄ and x·x̄ = ε; none if one of them is no such use.
std::optional<Word> replay(Model const& model, Word word, Cancellations const& steps) {
  auto const halves = test::halves(model);
  for (Cancellation const step : steps) {
    if (step.left >= step.right || step.right >= word.size()) return {};
    for (std::size_t k = step.right; k > step.left + 1; --k) {
      auto const exchanged = halves.find({word[k - 1], word[k]});
      if (exchanged == halves.end()) return {};
      word[k - 1] = exchanged->second[0];
      word[k] = exchanged->second[1];
    }
    auto const at = word.begin() + static_cast<std::ptrdiff_t>(step.left);
    if (*(at + 1) != test::reverse_of(model, *at)) return {};
    word.erase(at, at + 2);
  }
  return word;
}

class Cancelling : public testing::TestWithParam<Model> {
 protected:
  Model const model = GetParam();
  Group const group{model};
  std::mt19937 random{20221107};
};

TEST_P(Cancelling, FindsATraceExactlyForTrivialWords) {
  auto const words = rc::gen::container<Word>(rc::gen::elementOf(letters_of(model)));
  bool const holds = rc::check([&] {
    Word const word = *words;
    auto const steps = cancel(model, word);
    RC_ASSERT(steps.has_value() == group.is_identity(word));
    if (steps) RC_ASSERT(replay(model, word, *steps) == Word{});
  });
  EXPECT_TRUE(holds);
}

TEST_P(Cancelling, EmptiesWordsMadeTrivialByRelations) {
  int long_ones = 0;
  for (int round = 0; round < 400; ++round) {
    Word const a = random_word(model, 12, random);
    Word const b = test::random_equal_word(model, a, 30, random);
    Word const word = concatenate(a, conjugate(model, b));
    auto const steps = cancel(model, word);
    ASSERT_TRUE(steps) << to_string(word);
    ASSERT_EQ(replay(model, word, *steps), Word{}) << to_string(word);
    ASSERT_EQ(steps->size() * 2, word.size());
    if (word.size() > 12) ++long_ones;
    // One letter more, and it is no longer trivial.
    for (Letter const letter : letters_of(model)) ASSERT_FALSE(cancel(model, concatenate(word, {letter}))) << to_string(word);
  }
  EXPECT_GE(long_ones, 100);
}

TEST_P(Cancelling, EachStepLeavesAWordOfTheSameElement) {
  for (int round = 0; round < 300; ++round) {
    Word const a = random_word(model, 10, random);
    Word word = concatenate(a, conjugate(model, test::random_equal_word(model, a, 24, random)));
    auto const steps = cancel(model, word);
    ASSERT_TRUE(steps) << to_string(word);
    for (Cancellation const step : *steps) {
      std::size_t const length = word.size();
      word = after(model, word, step);
      ASSERT_EQ(word.size() + 2, length);
      ASSERT_TRUE(group.is_identity(word)) << to_string(word);
    }
    ASSERT_EQ(word, Word{});
  }
}

TEST_P(Cancelling, ConjugatesOfLetters) {
  auto const letters = letters_of(model);
  int found = 0;
  for (int round = 0; round < 600; ++round) {
    Word word = random_word(model, round % 2 == 0 ? 5 : 8, random);
    if (round % 2 == 0) {
      word = concatenate(concatenate(word, {letters[static_cast<std::size_t>(round / 2) % letters.size()]}), conjugate(model, word));
    }
    auto const conjugation = conjugate_of_letter(group, word);
    ASSERT_EQ(conjugation.has_value(), group.is_conjugate_to_letter(word)) << to_string(word);
    if (!conjugation) continue;
    ++found;
    Word const again = concatenate(concatenate(conjugation->by, {conjugation->letter}), conjugate(model, conjugation->by));
    ASSERT_TRUE(group.equal(again, word)) << to_string(word);
  }
  EXPECT_GE(found, 300);
}

INSTANTIATE_TEST_SUITE_P(Models, Cancelling, testing::ValuesIn(tested_models()), [](auto const& instance) {
  return instance.param.name + std::to_string(instance.param.dimension);
});

// In an O-map 1 is oriented and 3 exchangeable with it: passing turns it round.
TEST(Cancellation, AnOrientedLetterTurnsWhereItPasses) {
  EXPECT_EQ(cancel(omap(3), word_of({1, 3, 1, 3})), (Cancellations{{0, 2}, {0, 1}}));
  EXPECT_EQ(cancel(omap(3), word_of({1, 3, -1, 3})), std::nullopt);
  EXPECT_EQ(cancel(omap(3), word_of({3, 1, 3, 1})), (Cancellations{{0, 2}, {0, 1}}));
  EXPECT_EQ(after(omap(3), word_of({3, 1, 3, 1}), {0, 2}), word_of({-1, 1}));
  EXPECT_EQ(cancel(omap(3), word_of({1, 1})), std::nullopt);
  EXPECT_EQ(cancel(gmap(2), word_of({0, 1, 0, 1})), std::nullopt);
}

}  // namespace
}  // namespace jrule::algebra
