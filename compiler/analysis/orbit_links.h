// How one side of a rule joins its copies into orbits, word by word.
#pragma once

#include <vector>

#include "compiler/algebra/group.h"
#include "compiler/ir/rule_scheme.h"

namespace jrule::analysis {

/// A step of an orbit's words: (u, from) and (u·word, to) are of one orbit.
struct OrbitLink {
  ir::NodeId from;
  Word word;
  ir::NodeId to;
  source::Span span;  ///< of the step's last arc
};

/// A dart that exists before and after the application and is of the orbit of (u, node): m(u·word, preserved)·tail. Where the tail
/// is not ε it begins with an arc that the rule does not match.
struct OrbitAnchor {
  ir::NodeId node;
  Word word;
  ir::NodeId preserved;
  Word tail;
};

struct OrbitLinks {
  std::vector<OrbitLink> links;      ///< each word forwards from each node of the side; backwards is the same read the other way
  std::vector<OrbitAnchor> anchors;  ///< each preserved node itself, and where the words leave and enter the rule
};

/// Of one side, of which `table` is the index: the left side joins darts as they are before, the right as they are afterwards.
/// The rule must be completed and satisfy the incident-arcs condition.
OrbitLinks orbit_links(ir::RuleScheme const& rule, bool left, ir::Table const& table, OrbitType const& orbit, algebra::Group const& group);

}  // namespace jrule::analysis
