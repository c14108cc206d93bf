// Γ inside a right-angled Coxeter group.
//
// Suppose that the oriented dimensions O are of two classes, A and B, so that no exchangeable pair joins two of one class: the
// graph of the pairs of E inside O is bipartite. Let W be the right-angled Coxeter group on D ∪ {z} whose commuting pairs are
// those of E and {n, z} for n ∈ N. Then a ↦ a·z for a ∈ A ∪ N, b ↦ z·b for b ∈ B embeds Γ into W, as the subgroup of the words
// of even length.
//
// It respects the relations: (n·z)² = ε; for {a, n} ∈ E with n ∈ N, (a·z)(n·z) = a·n, whose square is ε, and for {b, n},
// (z·b)(n·z) = z·(b·n)·z; for {a, b} ∈ E, (a·z)(z·b) = a·b.
//
// It is injective. θ(i) = ī for i ∈ O, θ(n) = n for n ∈ N is an automorphism of Γ of order two: {i, n} ∈ E says that
// n·i·n = ī, hence n·ī·n = i and (ī·n)² = ε; {i, j} ∈ E inside O says (i·j)² = ε, hence (j̄·ī)² = ε and, conjugated, (ī·j̄)² = ε.
// In Γ ⋊ ⟨z⟩, where z·g·z = θ(g), let a' = a·z for a ∈ A ∪ N, b' = z·b for b ∈ B. Then a'² = a·θ(a) = ε and b'² = θ(b)·b = ε;
// z·n' = θ(n)·z² = n = n'·z for n ∈ N; for {a, n} ∈ E with n ∈ N, (a'·n')² = (a·θ(n))² = (a·n)² = ε, and for {b, n},
// (b'·n')² = (z·b·n·z)² = ε; for {a, b} ∈ E, (a'·b')² = (a·b)² = ε. So i ↦ i', z ↦ z is a homomorphism W → Γ ⋊ ⟨z⟩, and after
// Γ → W it sends a to a'·z = a and b to z·b' = b.
//
// It reaches all even words: i·z and z·i are i and ī or ī and i, and i·j = (i·z)(z·j) for i, j ∈ D.
//
// Back from W: a' = a·z, so a letter a after p other letters reads a in Γ if p is even and θ(a) if p is odd; b' = θ(b)·z, so for
// b it is the other way round; z reads nothing. The normal form of Γ is read so from that of W. It is shortest: a word of Γ has as many letters as its image
// has letters other than z, and reducing only deletes letters. z is W's least letter: it steps aside as early as it
// can, so that the dimensions come in lexicographic order.
#include "compiler/algebra/group.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <deque>
#include <set>
#include <stdexcept>

namespace jrule::algebra {

namespace {

using Generator = RightAngledCoxeterGroup::Generator;
using GeneratorSet = RightAngledCoxeterGroup::GeneratorSet;
using Element = RightAngledCoxeterGroup::Element;

constexpr Generator z = 0;
constexpr Generator generator_of(int dimension) { return static_cast<Generator>(dimension + 1); }
constexpr std::uint8_t dimension_of(Generator s) { return static_cast<std::uint8_t>(s - 1); }
static_assert(generator_of(max_dimension) < RightAngledCoxeterGroup::max_generators);

RightAngledCoxeterGroup coxeter_group(Model const& model) {
  RightAngledCoxeterGroup w;
  for (auto const& [i, j] : model.exchange) w.commute(generator_of(i), generator_of(j));
  for (int const d : model.dimensions) {
    if (!model.is_oriented(d)) w.commute(generator_of(d), z);
  }
  return w;
}

/// The class B, as bits; none if the graph of the exchangeable pairs of oriented dimensions is not bipartite. Each part of the
/// graph is coloured from its first dimension, which is in A.
std::optional<std::uint16_t> second_class(Model const& model) {
  std::array<std::optional<bool>, max_dimension + 1> in_second{};
  std::vector<int> open;
  std::uint16_t second = 0;
  for (int const first : model.dimensions) {
    if (!model.is_oriented(first) || in_second[static_cast<std::size_t>(first)]) continue;
    in_second[static_cast<std::size_t>(first)] = false;
    open.push_back(first);
    while (!open.empty()) {
      int const d = open.back();
      open.pop_back();
      bool const here = *in_second[static_cast<std::size_t>(d)];
      if (here) second = static_cast<std::uint16_t>(second | (1U << d));
      for (int const other : model.dimensions) {
        if (!model.is_oriented(other) || !model.exchanges(d, other)) continue;
        auto& there = in_second[static_cast<std::size_t>(other)];
        if (there == here) return {};
        if (!there) open.push_back(other);
        there = !here;
      }
    }
  }
  return second;
}

/// Γ in W.
struct Inclusion {
  Model const& model;
  RightAngledCoxeterGroup const& w;
  std::uint16_t second;  // the class B
  bool in_second(int d) const { return ((second >> d) & 1U) != 0; }
};

void multiply_by_word(Element& g, Word const& word, Inclusion const& e) {
  for (Letter const letter : word) {
    assert(e.model.has(letter.dimension));
    bool const backwards = (letter.conjugate && e.model.is_oriented(letter.dimension)) != e.in_second(letter.dimension);
    Generator const i = generator_of(letter.dimension);
    e.w.multiply(g, backwards ? z : i);
    e.w.multiply(g, backwards ? i : z);
  }
}

Element to_coxeter(Word const& word, Inclusion const& e) {
  Element g;
  multiply_by_word(g, word, e);
  return g;
}

/// z·g·z for the element g of a word.
Element to_coxeter_twisted(Word const& word, Inclusion const& e) {
  Element g{z};
  multiply_by_word(g, word, e);
  e.w.multiply(g, z);
  return g;
}

Word from_coxeter(Element const& g, Inclusion const& e) {
  Model const& model = e.model;
  Word word;
  bool odd = false;
  for (Generator const s : g) {
    if (s != z) {
      std::uint8_t const d = dimension_of(s);
      word.push_back({d, model.is_oriented(d) && odd != e.in_second(d)});
    }
    odd = !odd;
  }
  assert(!odd);
  return word;
}

/// If the elements are words of two letters whose pairs connect a set T of generators, then T; empty if all are ε.
///
/// They then generate the even words over T, since (a·b)(b·c) = a·c; and these are the even elements of W that have no
/// other generator in their normal form, since reducing only deletes letters.
std::optional<GeneratorSet> connected_pairs(std::vector<Element> const& elements) {
  std::vector<GeneratorSet> pairs;
  GeneratorSet all = 0;
  for (Element const& g : elements) {
    if (g.empty()) continue;
    if (g.size() != 2) return std::nullopt;
    pairs.push_back(RightAngledCoxeterGroup::support(g));
    all = static_cast<GeneratorSet>(all | pairs.back());
  }
  GeneratorSet reached = pairs.empty() ? GeneratorSet{0} : pairs.front();
  for (std::size_t round = 0; round < pairs.size(); ++round) {
    for (GeneratorSet const pair : pairs) {
      if ((pair & reached) != 0) reached = static_cast<GeneratorSet>(reached | pair);
    }
  }
  if (reached != all) return std::nullopt;
  return all;
}

/// Is `target` a product of generators, all of whose prefixes are at most `max_length` long? Gives up, with false,
/// after `max_elements`.
bool found_by_search(Group const& group, Word const& target, std::vector<Word> const& generators,
                     std::size_t max_length, std::size_t max_elements) {
  std::set<Word> seen{Word{}};
  std::deque<Word> frontier{Word{}};
  while (!frontier.empty() && !seen.contains(target) && seen.size() < max_elements) {
    Word const g = frontier.front();
    frontier.pop_front();
    for (Word const& generator : generators) {
      Word next = group.product(g, generator);
      if (next.size() <= max_length && seen.insert(next).second) frontier.push_back(std::move(next));
    }
  }
  return seen.contains(target);
}

}  // namespace

Word conjugate(Model const& model, Word const& word) {
  Word result(word.rbegin(), word.rend());
  for (Letter& letter : result) letter.conjugate = model.is_oriented(letter.dimension) && !letter.conjugate;
  return result;
}

Word concatenate(Word const& a, Word const& b) {
  Word result = a;
  result.insert(result.end(), b.begin(), b.end());
  return result;
}

std::optional<std::string> Group::undecided(Model const& model) {
  if (second_class(model)) return std::nullopt;
  std::string pairs;
  for (auto const& [i, j] : model.exchange) {
    if (!model.is_oriented(i) || !model.is_oriented(j)) continue;
    pairs += (pairs.empty() ? "(" : ", (") + std::to_string(i) + "," + std::to_string(j) + ")";
  }
  return "an odd number of the exchangeable pairs " + pairs + " of oriented dimensions form a circle";
}

Group::Group(Model model) : model_(std::move(model)), coxeter_(coxeter_group(model_)) {
  auto const second = second_class(model_);
  if (!second) throw std::invalid_argument(*undecided(model_));
  second_class_ = *second;
}

Word Group::normal_form(Word const& word) const {
  Inclusion const e{model_, coxeter_, second_class_};
  return from_coxeter(to_coxeter(word, e), e);
}

Word Group::product(Word const& a, Word const& b) const { return normal_form(concatenate(a, b)); }

Word Group::inverse(Word const& a) const { return normal_form(conjugate(model_, a)); }

// W = Γ ∪ Γ·z, and conjugation by z, which is θ, permutes the letters of Γ: an element is conjugate to a letter in Γ
// iff it is in W. There a letter is i·z or z·i, of least length among its conjugates; and all conjugates of least length
// of an element consist of the same generators.
bool Group::is_conjugate_to_letter(Word const& word) const {
  auto const least = coxeter_.cyclically_reduced(to_coxeter(word, {model_, coxeter_, second_class_}));
  return least.size() == 2 && (least[0] == z || least[1] == z);
}

// Dimensions are the pairs {i, z}, so a set S of them generates the even words over S ∪ {z}. In O-maps the vertex's
// words j·i (i < j) are z·(j·i)·z in W, for z commutes with j, and with i as well unless i = 1: conjugated by z they
// are pairs that connect D. So are the words i·j (i < j) of dual O-maps; i·j in O-maps and j·i in dual O-maps are pairs
// as they are.
bool Group::in_orbit(Word const& word, OrbitType const& orbit) const {
  for (auto const read : {to_coxeter, to_coxeter_twisted}) {
    std::vector<Element> elements;
    Inclusion const e{model_, coxeter_, second_class_};
    for (Word const& w : orbit.words) elements.push_back(read(w, e));
    if (auto const allowed = connected_pairs(elements)) {
      return (RightAngledCoxeterGroup::support(read(word, e)) & ~*allowed) == 0;
    }
  }
  Word const target = normal_form(word);
  std::size_t longest = target.size();
  std::vector<Word> generators;
  for (Word const& w : orbit.words) {
    generators.push_back(normal_form(w));
    generators.push_back(inverse(w));
    longest = std::max(longest, generators.back().size());
  }
  return found_by_search(*this, target, generators, longest + 4, 20'000);
}

}  // namespace jrule::algebra
