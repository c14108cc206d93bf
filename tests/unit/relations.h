// The words of a model and what its relations make of them, one step at a time: the definition of the group's equality.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <map>
#include <random>
#include <utility>
#include <vector>

#include "compiler/algebra/group.h"

namespace jrule::test {

using algebra::conjugate;

inline Word word_of(std::vector<int> const& dimensions) {  // -d is ~d
  Word word;
  for (int const d : dimensions) word.push_back({static_cast<std::uint8_t>(std::abs(d)), d < 0});
  return word;
}

inline std::vector<Letter> letters_of(Model const& model) {
  std::vector<Letter> letters;
  for (int const d : model.dimensions) {
    letters.push_back({static_cast<std::uint8_t>(d), false});
    if (model.is_oriented(d)) letters.push_back({static_cast<std::uint8_t>(d), true});
  }
  return letters;
}

/// All words of at most that length, shorter ones first.
inline std::vector<Word> all_words(Model const& model, std::size_t max_length) {
  auto const letters = letters_of(model);
  std::vector<Word> words{{}};
  for (std::size_t k = 0; k < words.size() && words[k].size() < max_length; ++k) {
    for (Letter const letter : letters) {
      words.push_back(words[k]);
      words.back().push_back(letter);
    }
  }
  return words;
}

/// The greatest length such that there are not more than `limit` words.
inline std::size_t length_for(Model const& model, std::size_t limit) {
  std::size_t const letters = letters_of(model).size();
  std::size_t length = 0;
  for (std::size_t words = letters; words <= limit && length < 8; words *= letters) ++length;
  return length;
}

inline Word random_word(Model const& model, std::size_t max_length, std::mt19937& random) {
  auto const letters = letters_of(model);
  Word word(std::uniform_int_distribution<std::size_t>(0, max_length)(random));
  std::uniform_int_distribution<std::size_t> pick(0, letters.size() - 1);
  for (Letter& letter : word) letter = letters[pick(random)];
  return word;
}

inline Letter reverse_of(Model const& model, Letter letter) { return conjugate(model, {letter}).front(); }

/// The words of two letters equal to other such words: both halves of the relators (ij)² and of their conjugates.
inline std::map<Word, Word> halves(Model const& model) {
  std::map<Word, Word> equal;
  for (auto const& [a, b] : model.exchange) {
    for (auto const& [i, j] : {std::pair{a, b}, std::pair{b, a}}) {
      Word const half = word_of({i, j});
      equal[half] = conjugate(model, half);
      equal[conjugate(model, half)] = half;
    }
  }
  return equal;
}

/// The words that one use of a relation makes of a word without making it longer.
inline std::vector<Word> rewritten(Model const& model, std::map<Word, Word> const& equal, Word const& word) {
  std::vector<Word> results;
  for (std::size_t k = 0; k + 1 < word.size(); ++k) {
    auto const at = word.begin() + static_cast<std::ptrdiff_t>(k);
    Word result(word.begin(), at);
    if (word[k + 1] == reverse_of(model, word[k])) {
      result.insert(result.end(), at + 2, word.end());
      results.push_back(result);
    } else if (auto const found = equal.find({word[k], word[k + 1]}); found != equal.end()) {
      result.insert(result.end(), found->second.begin(), found->second.end());
      result.insert(result.end(), at + 2, word.end());
      results.push_back(result);
    }
  }
  return results;
}

/// A word made from another by random uses of the relations, in both directions.
inline Word random_equal_word(Model const& model, Word word, std::size_t max_length, std::mt19937& random) {
  auto const letters = letters_of(model);
  auto const equal = halves(model);
  auto const pick = [&random](std::size_t size) {
    return std::uniform_int_distribution<std::size_t>(0, size - 1)(random);
  };
  for (int step = 0; step < 60; ++step) {
    auto const results = rewritten(model, equal, word);
    if (word.size() + 2 <= max_length && pick(3) == 0) {
      Letter const letter = letters[pick(letters.size())];
      auto const at = word.begin() + static_cast<std::ptrdiff_t>(pick(word.size() + 1));
      word.insert(word.insert(at, letter) + 1, reverse_of(model, letter));
    } else if (!results.empty()) {
      word = results[pick(results.size())];
    }
  }
  return word;
}

}  // namespace jrule::test
