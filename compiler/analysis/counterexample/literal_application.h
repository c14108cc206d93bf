// The application of any rule, sound or not, as the paper writes it (sections 6.1 to 6.3): arcs of the left that are
// not on the right are deleted, arcs of the right that are not on the left added, unmatched arcs stay.
#pragma once

#include <vector>

#include "compiler/analysis/counterexample/graph.h"
#include "compiler/analysis/counterexample/partial_map.h"
#include "compiler/ir/rule_scheme.h"

namespace jrule::analysis {

class LiteralApplication {
 public:
  /// The rule must outlive this.
  explicit LiteralApplication(ir::RuleScheme const& rule);

  enum class Outcome {
    no_match,
    map,           ///< the result is a map of the model
    doubled_arcs,  ///< it is one, but for arcs that are there twice
    broken,
  };
  /// Applies the rule to a map without missing arcs, one dart for each hook. Unmatched arcs of a deleted dart stay
  /// too: where the dangling condition fails, the result shows why. What follows is of the last application.
  Outcome apply(PartialMap const& map, std::vector<Dart> const& hooks);

  Graph result() const;
  /// By node, in the order of the pattern; see Counterexample::copies.
  std::vector<std::vector<Dart>> const& copies() const { return copies_; }

 private:
  struct ArcUse {
    ir::NodeId source;
    std::size_t column;
    std::size_t word;  // index in words_
    ir::NodeId target;
    bool changed;  // not on the other side
  };
  struct Placing {
    ArcUse arc;
    bool forwards;  // the target is placed from the source
  };

  std::size_t word_index(Word const& word);
  std::vector<ArcUse> arcs_of(ir::Side const& side, ir::Side const& other);
  void plan_placing();

  bool match(PartialMap const& map, std::vector<Dart> const& hooks);
  bool match_hooks(PartialMap const& map, std::vector<Dart> const& hooks);
  void rewrite(PartialMap const& map);
  Outcome judge() const;
  bool is_map_but_for_doubled() const;

  ir::RuleScheme const& rule_;
  bool contradictory_ = false;  // two left arcs of one dimension at one dart: nothing matches
  std::vector<Word> words_;     // P is closed under them
  std::vector<ArcUse> left_, right_;
  std::vector<Placing> placing_;

  // Of the last application. The result: each dart's arcs, but for those that are not alone.
  std::vector<std::vector<Dart>> steps_;  // by word: the index of u·w
  std::vector<std::vector<Dart>> copies_;
  std::vector<bool> live_;
  std::vector<std::vector<Dart>> out_;  // by column
  struct Extra {
    Dart from;
    std::size_t column;
    Dart to;
  };
  std::vector<Extra> extras_;
  mutable std::vector<Dart> incoming_;
};

}  // namespace jrule::analysis
