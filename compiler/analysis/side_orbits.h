// The orbits that one side of a rule makes of its copies, and what of them outlives an application.
#pragma once

#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "compiler/algebra/group.h"
#include "compiler/analysis/relations.h"
#include "compiler/ir/rule_scheme.h"

namespace jrule::analysis {

/// The copies of these nodes that are of one orbit: (u, root) and (u·path, node), and (u, root) and (u·g, root) for each generator g.
struct SideOrbit {
  /// A dart that exists before and after the application: m(u·path, node)·tail, u being the root's pattern dart.
  struct Survivor {
    ir::NodeId node;
    Word tail;  ///< ε, or out of the rule by an arc that it does not match
    Word path;
  };
  std::vector<ir::NodeId> nodes;    ///< the root first
  std::vector<Survivor> survivors;  ///< none: all of the orbit's darts are of one side only
  std::vector<Word> generators;     ///< without what acts as ε on the pattern
  bool reaches_out = false;         ///< it may have darts that the rule does not match
};

class SideOrbits {
 public:
  /// Of the left side, or of the right. `rule` is completed; `words` and `group` must outlive this.
  SideOrbits(ir::RuleScheme const& rule, bool left, OrbitType const& orbit, algebra::Group const& group, PatternWords const& words);

  std::vector<SideOrbit> const& all() const { return orbits_; }

  /// Are the darts m(u·a, s)·tail and m(u·b, t)·tail, for each u, of one orbit by what this side says? `path` of the survivors
  /// stands for a and b. False may mean that it is not found.
  bool joins(SideOrbit::Survivor const& s, SideOrbit::Survivor const& t) const;

  /// Is the word in the subgroup that the words and what acts as ε on the pattern generate?
  bool generated(Word const& word, std::vector<Word> const& by) const;

 private:
  /// A survivor's orbit and its path there.
  struct Place {
    std::size_t orbit;
    Word path;
  };

  algebra::Group const& group_;
  PatternWords const& words_;
  std::vector<SideOrbit> orbits_;
  std::map<std::pair<ir::NodeId, Word>, Place> places_;  ///< by node and tail
};

}  // namespace jrule::analysis
