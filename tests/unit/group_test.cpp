// The word problem against three references that share nothing with it: rewriting with the relations (what is found
// equal is equal), permutations of finite maps (what acts differently is different), and the Tits representation.
#include "compiler/algebra/group.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <numeric>
#include <ostream>
#include <random>
#include <set>
#include <stdexcept>
#include <tuple>

#include "finite_action.h"
#include "relations.h"

namespace jrule {

void PrintTo(Model const& model, std::ostream* out) { *out << model.name << '(' << model.dimension << ')'; }

}  // namespace jrule

namespace jrule::algebra {
namespace {

using test::all_words;
using test::FiniteAction;
using test::length_for;
using test::letters_of;
using test::random_word;
using test::word_of;

Model user_model(std::string name, std::vector<int> dimensions, std::vector<int> const& oriented,
                 std::vector<std::pair<int, int>> exchange) {
  Model model;
  model.name = std::move(name);
  model.dimension = dimensions.back();
  model.dimensions = std::move(dimensions);
  for (int const d : oriented) model.oriented = static_cast<std::uint16_t>(model.oriented | (1U << d));
  model.exchange = std::move(exchange);
  return model;
}

std::vector<Model> tested_models() {
  return {gmap(0),
          gmap(1),
          gmap(2),
          gmap(3),
          gmap(4),
          omap(1),
          omap(2),
          omap(3),
          omap(4),
          dual_omap(2),
          dual_omap(3),
          user_model("two_commute", {0, 1, 2}, {}, {{0, 1}, {1, 2}}),
          user_model("two_oriented", {0, 1, 2}, {1, 2}, {{0, 1}, {0, 2}}),
          user_model("one_of_two_oriented", {0, 1, 2, 3}, {1, 2}, {{0, 1}, {0, 3}, {2, 3}}),
          user_model("free", {1, 2}, {1, 2}, {}),
          user_model("oriented_squares", {1, 2}, {1, 2}, {{1, 2}}),
          user_model("oriented_path", {0, 1, 2, 3}, {1, 2, 3}, {{0, 2}, {0, 3}, {1, 2}, {2, 3}}),
          user_model("oriented_circle", {0, 1, 2, 3}, {0, 1, 2, 3}, {{0, 1}, {0, 3}, {1, 2}, {2, 3}}),
          user_model("gaps", {0, 3, 9}, {3}, {{0, 9}, {3, 9}})};
}

/// The elements of at most that length, as normal forms.
std::set<Word> ball(Group const& group, std::size_t radius) {
  std::set<Word> elements;
  for (Word const& word : all_words(group.model(), radius)) elements.insert(group.normal_form(word));
  return elements;
}

/// Where a word leads from each dart of each map.
std::vector<int> effect(std::vector<FiniteAction> const& actions, Word const& word) {
  std::vector<int> ends;
  for (FiniteAction const& action : actions) {
    for (int dart = 0; dart < action.darts(); ++dart) ends.push_back(action.walk(dart, word));
  }
  return ends;
}

class EveryModel : public testing::TestWithParam<Model> {
 protected:
  Model const model = GetParam();
  Group const group{model};
  std::mt19937 random{20220704};
  std::vector<FiniteAction> actions(std::size_t count, int max_darts) {
    return test::random_actions(model, count, max_darts, random);
  }
};

TEST_P(EveryModel, FiniteActionsAreMaps) {
  for (FiniteAction const& action : actions(10, 12)) {
    for (int dart = 0; dart < action.darts(); ++dart) {
      for (int const d : model.dimensions) {
        auto const letter = static_cast<std::uint8_t>(d);
        ASSERT_EQ(action.walk(dart, {{letter, false}, {letter, true}}), dart);
        if (!model.is_oriented(d)) { ASSERT_EQ(action.walk(dart, word_of({d, d})), dart); }
      }
      for (auto const& [i, j] : model.exchange) ASSERT_EQ(action.walk(dart, word_of({i, j, i, j})), dart);
    }
  }
}

TEST_P(EveryModel, NormalFormLeadsToTheSameDarts) {
  auto const maps = actions(10, 16);
  for (int round = 0; round < 1500; ++round) {
    Word const word = random_word(model, 24, random);
    ASSERT_EQ(effect(maps, word), effect(maps, group.normal_form(word))) << to_string(word);
  }
}

TEST_P(EveryModel, RelationsKeepTheNormalForm) {
  for (int round = 0; round < 500; ++round) {
    Word const word = random_word(model, 20, random);
    Word const other = test::random_equal_word(model, word, 40, random);
    ASSERT_EQ(group.normal_form(word), group.normal_form(other)) << to_string(word) << " = " << to_string(other);
  }
}

// Of the words that lead to the same darts in many maps, the normal form is the shortest whose dimensions come first:
// whatever the maps do not separate would make it fail, so this also shows that different normal forms are different.
TEST_P(EveryModel, NormalFormIsTheFirstShortestWord) {
  auto const maps = actions(40, 20);
  auto const key = [](Word const& word) {
    std::vector<std::uint8_t> dimensions;
    for (Letter const letter : word) dimensions.push_back(letter.dimension);
    return std::tuple{word.size(), dimensions, word};
  };
  std::map<std::vector<int>, Word> first;
  auto const words = all_words(model, length_for(model, 1500));
  for (Word const& word : words) {
    auto const [found, inserted] = first.try_emplace(effect(maps, word), word);
    if (!inserted && key(word) < key(found->second)) found->second = word;
  }
  for (Word const& word : words) ASSERT_EQ(group.normal_form(word), first.at(effect(maps, word))) << to_string(word);
}

// Conversely, rewriting links every short word with its normal form by words that are hardly longer.
TEST_P(EveryModel, ShortWordsAreEqualExactlyIfRelationsLinkThem) {
  auto const words = all_words(model, length_for(model, 5000));
  std::map<Word, std::size_t> position;
  for (std::size_t k = 0; k < words.size(); ++k) position[words[k]] = k;
  std::vector<std::size_t> parent(words.size());
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  auto const root = [&parent](std::size_t k) {
    while (parent[k] != k) k = parent[k] = parent[parent[k]];
    return k;
  };
  auto const equal = test::halves(model);
  for (std::size_t k = 0; k < words.size(); ++k) {
    for (Word const& other : test::rewritten(model, equal, words[k])) parent[root(k)] = root(position.at(other));
  }
  std::map<Word, std::size_t> class_of;
  std::set<std::size_t> classes;
  for (std::size_t k = 0; k < words.size(); ++k) {
    auto const [found, inserted] = class_of.try_emplace(group.normal_form(words[k]), root(k));
    ASSERT_EQ(found->second, root(k)) << to_string(words[k]);
    if (inserted) { ASSERT_TRUE(classes.insert(root(k)).second) << to_string(words[k]); }
  }
}

TEST_P(EveryModel, ProductsAndInverses) {
  auto const words = rc::gen::container<Word>(rc::gen::elementOf(letters_of(model)));
  auto const holds = rc::check([&] {
    Word const a = *words, b = *words, c = *words;
    RC_ASSERT(group.normal_form(group.normal_form(a)) == group.normal_form(a));
    RC_ASSERT(group.normal_form(a).size() <= a.size());
    RC_ASSERT((a.size() - group.normal_form(a).size()) % 2 == 0);
    RC_ASSERT(group.product(group.product(a, b), c) == group.product(a, group.product(b, c)));
    RC_ASSERT(group.product(a, b) == group.product(group.normal_form(a), group.normal_form(b)));
    RC_ASSERT(group.is_identity(group.product(a, group.inverse(a))));
    RC_ASSERT(group.is_identity(group.product(group.inverse(a), a)));
    RC_ASSERT(group.inverse(group.product(a, b)) == group.product(group.inverse(b), group.inverse(a)));
    RC_ASSERT(conjugate(model, conjugate(model, a)) == a);
    for (Letter const l : group.normal_form(a)) RC_ASSERT(!l.conjugate || model.is_oriented(l.dimension));
  });
  EXPECT_TRUE(holds);
}

TEST_P(EveryModel, ConjugatesOfLetters) {
  auto const conjugators = ball(group, length_for(model, 200));
  Model closed = model;
  closed.closed = true;
  auto const closed_maps = test::random_actions(closed, 20, 12, random);
  std::size_t found_some = 0;
  for (Word const& g : ball(group, std::min<std::size_t>(length_for(model, 1000), 5))) {
    bool const found = std::any_of(conjugators.begin(), conjugators.end(), [&](Word const& h) {
      return group.product(conjugate(model, h), group.product(g, h)).size() == 1;
    });
    ASSERT_EQ(group.is_conjugate_to_letter(g), found) << to_string(g);
    if (!found) continue;
    ++found_some;
    for (FiniteAction const& map : closed_maps) {
      for (int dart = 0; dart < map.darts(); ++dart) ASSERT_NE(map.walk(dart, g), dart) << to_string(g);
    }
  }
  EXPECT_GE(found_some, letters_of(model).size());
  for (int round = 0; round < 300; ++round) {
    Word const h = random_word(model, 12, random);
    Word const letter{letters_of(model)[static_cast<std::size_t>(round) % letters_of(model).size()]};
    EXPECT_TRUE(group.is_conjugate_to_letter(concatenate(concatenate(conjugate(model, h), letter), h)));
  }
  EXPECT_FALSE(group.is_conjugate_to_letter({}));
}

/// All words i·j for i < j, and all words j·i: with one oriented dimension, one of the two is a cell.
std::vector<OrbitType> orbits_of_pairs(Model const& model) {
  OrbitType ascending, descending;
  for (int const i : model.dimensions) {
    for (int const j : model.dimensions) {
      if (i < j) ascending.words.push_back(word_of({i, j}));
      if (i < j) descending.words.push_back(word_of({j, i}));
    }
  }
  return {ascending, descending};
}

/// The elements of at most `max_length` letters met by multiplying generators, never leaving that length.
std::set<Word> products(Group const& group, OrbitType const& orbit, std::size_t max_length) {
  std::vector<Word> frontier{Word{}};
  std::set<Word> elements{Word{}};
  while (!frontier.empty()) {
    Word const g = frontier.back();
    frontier.pop_back();
    for (Word const& w : orbit.words) {
      for (Word const& step : {w, conjugate(group.model(), w)}) {
        Word const next = group.product(g, step);
        if (next.size() <= max_length && elements.insert(next).second) frontier.push_back(next);
      }
    }
  }
  return elements;
}

/// Does the word lead out of an orbit in one of the maps? Then its element is not in the orbit's subgroup.
bool leaves_orbit(std::vector<FiniteAction> const& maps, OrbitType const& orbit, Word const& word) {
  for (FiniteAction const& map : maps) {
    std::vector<int> components(static_cast<std::size_t>(map.darts()), -1);
    auto const component = [&components](int dart) -> int& { return components[static_cast<std::size_t>(dart)]; };
    for (int start = 0; start < map.darts(); ++start) {
      if (component(start) >= 0) continue;
      std::vector<int> stack{start};
      component(start) = start;
      while (!stack.empty()) {
        int const dart = stack.back();
        stack.pop_back();
        for (Word const& w : orbit.words) {
          // A word permutes the darts of a finite map, so its conjugate reaches nothing new.
          int const next = map.walk(dart, w);
          if (component(next) >= 0) continue;
          component(next) = start;
          stack.push_back(next);
        }
      }
    }
    for (int dart = 0; dart < map.darts(); ++dart) {
      if (component(dart) != component(map.walk(dart, word))) return true;
    }
  }
  return false;
}

void expect_orbit_decided(Group const& group, OrbitType const& orbit, std::vector<FiniteAction> const& maps,
                          std::size_t radius) {
  auto const inside = products(group, orbit, radius + 2);
  for (Word const& g : ball(group, radius)) {
    if (group.in_orbit(g, orbit)) {
      ASSERT_TRUE(inside.contains(g)) << to_string(g) << " in " << to_string(orbit);
      ASSERT_FALSE(leaves_orbit(maps, orbit, g)) << to_string(g) << " in " << to_string(orbit);
    } else {
      ASSERT_TRUE(leaves_orbit(maps, orbit, g)) << to_string(g) << " not in " << to_string(orbit);
    }
  }
}

TEST_P(EveryModel, OrbitsOfDimensions) {
  auto const maps = actions(400, 12);
  auto const& dims = model.dimensions;
  for (std::size_t subset = 0; subset < (std::size_t{1} << dims.size()); ++subset) {
    std::vector<int> chosen;
    for (std::size_t k = 0; k < dims.size(); ++k) {
      if (((subset >> k) & 1U) != 0) chosen.push_back(dims[k]);
    }
    expect_orbit_decided(group, orbit_of_dimensions(chosen), maps, std::min<std::size_t>(length_for(model, 200), 4));
  }
}

TEST_P(EveryModel, OrbitsOfAscendingAndDescendingPairs) {
  auto const maps = actions(400, 12);
  for (OrbitType const& orbit : orbits_of_pairs(model)) {
    expect_orbit_decided(group, orbit, maps, std::min<std::size_t>(length_for(model, 200), 4));
  }
}

INSTANTIATE_TEST_SUITE_P(Models, EveryModel, testing::ValuesIn(tested_models()), [](auto const& instance) {
  return instance.param.name + std::to_string(instance.param.dimension);
});

// Too long for a search: each of these words is in the orbit by construction.
TEST(Group, LongWords) {
  std::mt19937 random{1};
  for (Model const& model : {gmap(3), omap(2), omap(3), omap(4), dual_omap(2), dual_omap(3), dual_omap(4)}) {
    Group const group(model);
    auto orbits = orbits_of_pairs(model);
    for (int i = 0; i <= model.dimension; ++i) orbits.push_back(cell_orbit(model, i).value());
    for (OrbitType const& orbit : orbits) {
      ASSERT_FALSE(orbit.words.empty());
      for (int round = 0; round < 20; ++round) {
        Word word;
        for (int k = 0; k < 100; ++k) {
          Word const& step = orbit.words[std::uniform_int_distribution<std::size_t>(0, orbit.words.size() - 1)(random)];
          word = concatenate(word, k % 3 == 0 ? conjugate(model, step) : step);
        }
        ASSERT_TRUE(group.in_orbit(word, orbit)) << model.name << " " << to_string(orbit);
      }
    }
  }
}

TEST(Group, CellsOfOrientedMaps) {
  std::mt19937 random{2};
  for (Model const& model : {omap(2), omap(3), dual_omap(2), dual_omap(3)}) {
    Group const group(model);
    auto const maps = test::random_actions(model, 400, 12, random);
    for (int i = 0; i <= model.dimension; ++i) expect_orbit_decided(group, cell_orbit(model, i).value(), maps, 4);
  }
}

// Sets of words that are no cells are searched.
TEST(Group, OtherOrbitsAreSearched) {
  std::mt19937 random{3};
  Group const surface(gmap(2));
  auto const maps = test::random_actions(gmap(2), 200, 16, random);
  for (OrbitType const& orbit : {OrbitType{{word_of({0, 1}), word_of({2})}}, OrbitType{{word_of({0, 1, 2})}},
                                 OrbitType{{word_of({0, 1, 0, 1})}}, OrbitType{{word_of({1, 0, 1}), word_of({2})}}}) {
    expect_orbit_decided(surface, orbit, maps, 4);
  }
  EXPECT_TRUE(surface.in_orbit(word_of({0, 1, 2, 1, 0, 2}), OrbitType{{word_of({0, 1}), word_of({2})}}));
}

/// The columns of the matrix of a word in the Tits representation of a right-angled Coxeter group: s(v) = v - 2B(v, s)s
/// with B(s, s) = 1, B(s, t) = 0 if s and t commute, else -1. It is faithful, and exact for words this short.
std::vector<std::vector<std::int64_t>> tits_matrix(Model const& model, Word const& word) {
  std::size_t const size = model.dimensions.size();
  std::vector<std::vector<std::int64_t>> columns(size, std::vector<std::int64_t>(size, 0));
  for (std::size_t k = 0; k < size; ++k) columns[k][k] = 1;
  for (Letter const letter : word) {
    auto const s = static_cast<std::size_t>(model.column(letter.dimension));
    for (auto& v : columns) {
      std::int64_t change = -2 * v[s];
      for (std::size_t t = 0; t < size; ++t) {
        if (t != s && !model.exchanges(letter.dimension, model.dimensions[t])) change += 2 * v[t];
      }
      v[s] += change;
    }
  }
  return columns;
}

TEST(Group, AgreesWithTheTitsRepresentation) {
  std::mt19937 random{4};
  for (Model const& model : tested_models()) {
    if (model.oriented != 0) continue;
    Group const group(model);
    std::map<std::vector<std::vector<std::int64_t>>, Word> element;
    std::set<Word> normal_forms;
    for (int round = 0; round < 3000; ++round) {
      Word const word = random_word(model, 16, random);
      Word const normal = group.normal_form(word);
      ASSERT_EQ(element.try_emplace(tits_matrix(model, word), normal).first->second, normal) << to_string(word);
      normal_forms.insert(normal);
    }
    EXPECT_EQ(normal_forms.size(), element.size());
  }
}

TEST(Group, Examples) {
  Group const two_commute(user_model("two_commute", {0, 1, 2}, {}, {{0, 1}, {1, 2}}));
  EXPECT_TRUE(two_commute.equal(word_of({2, 0}), word_of({1, 2, 0, 1})));
  EXPECT_FALSE(two_commute.equal(word_of({2, 0}), word_of({0, 2})));

  Group const surface(gmap(2));
  EXPECT_EQ(to_string(surface.normal_form(word_of({2, 1, 2, 0, 1, 1}))), "[2,1,0,2]");
  EXPECT_EQ(to_string(surface.normal_form({{0, true}, {1, true}})), "[0,1]");
  EXPECT_TRUE(surface.is_identity(word_of({0, 2, 0, 2})));
  EXPECT_FALSE(surface.is_identity(word_of({0, 1, 0, 1})));
  EXPECT_TRUE(surface.is_conjugate_to_letter(word_of({1, 0, 2, 0, 1})));
  EXPECT_FALSE(surface.is_conjugate_to_letter(word_of({0, 2})));

  Group const volume(omap(3));
  EXPECT_TRUE(volume.equal(word_of({3, 1}), word_of({-1, 3})));
  EXPECT_EQ(to_string(volume.normal_form(word_of({3, 1}))), "[~1,3]");
  EXPECT_EQ(to_string(volume.inverse(word_of({1, 2}))), "[2,~1]");
  EXPECT_TRUE(volume.in_orbit(word_of({2, 3}), cell_orbit(omap(3), 0).value()));
  EXPECT_FALSE(volume.in_orbit(word_of({1, 2}), cell_orbit(omap(3), 0).value()));
}

TEST(Group, RefusesOddCirclesOfExchangeableOrientedDimensions) {
  Model const triangle = user_model("triangle", {0, 1, 2, 3}, {0, 1, 2}, {{0, 1}, {0, 2}, {0, 3}, {1, 2}});
  EXPECT_EQ(Group::undecided(triangle), "an odd number of the exchangeable pairs (0,1), (0,2), (1,2) of oriented dimensions form a circle");
  EXPECT_THROW(Group{triangle}, std::invalid_argument);
  for (Model const& model : tested_models()) EXPECT_EQ(Group::undecided(model), std::nullopt);
}

}  // namespace
}  // namespace jrule::algebra
