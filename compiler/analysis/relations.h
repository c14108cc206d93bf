// What the left side itself forces: words that act as ε on every pattern that it matches, though not in every map.
//
// A match is injective on darts, so whatever returns to its dart in the map returns in the pattern. These relations make
// rules safe that the definitions alone refuse (theory: section 4).
#pragma once

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

/// How a word is shown to act as ε on the pattern: from it, step by step, to ε. In each step the word is p·q, p leading from
/// the pattern into the pattern; it becomes p·r·q in normal form, r being a relation or its conjugate.
struct Derivation {
  struct Step {
    Word prefix;           ///< p
    std::size_t relation;  ///< index of r
    bool conjugate;
    Word result;
  };
  Word word;
  std::vector<Step> steps;  ///< none: the word is ε in Γ
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
  /// Is every letter of the word such a dimension? Then it leads from the pattern into the pattern.
  bool stays_in_pattern(Word const& word) const;

  /// A derivation of `word` = ε on the pattern; none if none is found: then the word may or may not act as ε. Exact for the
  /// empty set of relations; else a best-first search with a bound.
  std::optional<Derivation> derive(Word const& word) const;
  bool trivial(Word const& word) const { return derive(word).has_value(); }
  bool equal(Word const& a, Word const& b) const { return trivial(group_.product(a, group_.inverse(b))); }

 private:
  void add(Word word, std::string reason, source::Span span, RelationEvidence evidence);
  void add_arcs(ir::RuleScheme const& rule, Placement const& placement);
  void add_cycles(ir::RuleScheme const& rule);
  void close(ir::RuleScheme const& rule);

  algebra::Group const& group_;
  std::vector<Relation> relations_;
  std::vector<ClosureEvidence> closure_;
  std::uint16_t closed_ = 0;  // bit d: P is closed under d
};

}  // namespace jrule::analysis
