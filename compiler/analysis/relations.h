// What the left side itself forces: words that act as ε on every pattern that it matches, though not in every map.
//
// A match is injective on darts, so whatever returns to its dart in the map returns in the pattern. These relations make
// rules safe that the definitions alone refuse (theory: section 4).
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "compiler/algebra/group.h"
#include "compiler/analysis/placement.h"

namespace jrule::analysis {

/// u·word = u for every pattern dart u of every match.
struct Relation {
  Word word;            ///< in normal form, not ε
  std::string reason;   ///< "the left arc from `a` to itself with dimension 2"
  source::Span span;    ///< of the arc, or of one of them
  RelationEvidence evidence;
};

/// How a word is shown to lead from each pattern dart where another does (ε, if it is shown to act as ε): from the one, step by
/// step, to the other. In each step the word is p·q, p leading from the pattern into the pattern; it becomes p·r·q in normal form, r
/// being a relation or its conjugate.
struct Derivation {
  struct Step {
    Word prefix;           ///< p
    std::size_t relation;  ///< index of r
    bool conjugate;
    Word result;
  };
  Word word;
  std::vector<Step> steps;  ///< none: the word is the other one in Γ
};

class PatternWords {
 public:
  /// The rule must have its hooks; `placement` is of the same rule. Both and `group` must outlive this.
  PatternWords(ir::RuleScheme const& rule, algebra::Group const& group, Placement const& placement);

  std::vector<Relation> const& relations() const { return relations_; }
  /// Is the pattern closed under this dimension?
  bool closed_under(int dimension) const { return ((closed_ >> dimension) & 1U) != 0; }
  /// Why, for each such dimension, in an order in which each needs only those before it.
  std::vector<ClosureEvidence> const& closure() const { return closure_; }
  /// A walk along `word`, or along a word equal to it in Γ, of which every step leads from the pattern into the pattern; none if
  /// none is found. Exact where each generator's letters are closed ones; else a best-first search with a bound.
  std::optional<std::vector<PatternStep>> walk_in_pattern(Word const& word) const;
  bool stays_in_pattern(Word const& word) const { return walk_in_pattern(word).has_value(); }

  /// A derivation of `word` = ε on the pattern; none if none is found: then the word may or may not act as ε. Exact for the
  /// empty set of relations; else a best-first search with a bound.
  std::optional<Derivation> derive(Word const& word) const;
  /// The same, of a word that leads on from the pattern as `word` does and that is conjugate to a letter.
  std::optional<Derivation> derive_conjugate_of_letter(Word const& word) const;
  bool trivial(Word const& word) const { return derive(word).has_value(); }
  bool equal(Word const& a, Word const& b) const { return trivial(group_.product(a, group_.inverse(b))); }

 private:
  void add(Word word, std::string reason, source::Span span, RelationEvidence evidence);
  void add_arcs(ir::RuleScheme const& rule, Placement const& placement);
  void add_cycles(ir::RuleScheme const& rule);
  void add_single_dart(ir::RuleScheme const& rule);
  void close();
  bool may_be_walked(Word const& word) const;
  std::optional<std::vector<PatternStep>> direct_walk(Word const& word) const;
  std::optional<Derivation> search(Word const& word, std::function<bool(Word const&)> const& goal) const;

  algebra::Group const& group_;
  struct GeneratorWord { Word word; Generator generator; };
  std::vector<GeneratorWord> generators_;  // without ε, in normal form
  struct Stride { Word before, core, after; PatternStep step; };
  std::vector<Stride> strides_;  // generators and their conjugates with letters that are not closed: core is from the first of them to the last
  std::vector<Relation> relations_;
  std::vector<ClosureEvidence> closure_;
  std::uint16_t closed_ = 0;  // bit d: P is closed under d
};

}  // namespace jrule::analysis
