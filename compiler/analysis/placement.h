// Where the left nodes lie: each is a fixed path away from its hook (theory: section 2).
#pragma once

#include <optional>
#include <vector>

#include "compiler/algebra/group.h"
#include "compiler/analysis/evidence.h"
#include "compiler/ir/rule_scheme.h"

namespace jrule::analysis {

/// For a left node s in the component of hook h, m(u, s) = m(u, h)·x_s. For the first hook m(u, h) = u. A further hook is
/// walked in step: m(u·o, h) = m(u, h)·e where its loop is (o, e), so a word w of the pattern becomes τ_h(w) there, defined
/// where w uses only letters that h's own loops carry.
class Placement {
 public:
  Placement(ir::RuleScheme const& rule, algebra::Group const& group);
  /// The hook (its position) of a left node's component.
  std::size_t hook(ir::NodeId node) const { return hook_[node]; }
  /// x_s; none if it depends on letters that a further hook does not carry.
  std::optional<Word> const& offset(ir::NodeId node) const { return offset_[node]; }
  /// How a node got its place; none for hooks and added nodes.
  std::optional<PlacementEvidence> const& evidence(ir::NodeId node) const { return evidence_[node]; }
  /// τ_h(w).
  std::optional<Word> translate(std::size_t hook, Word const& word) const;
  /// Does m(u, s)·d = m(u·w, t) hold in every map once the hooks are placed?
  bool holds_everywhere(ir::Arc const& arc) const;

 private:
  ir::RuleScheme const& rule_;
  algebra::Group const& group_;
  std::vector<std::size_t> hook_;
  std::vector<std::optional<Word>> offset_;
  std::vector<std::optional<PlacementEvidence>> evidence_;
};

}  // namespace jrule::analysis
