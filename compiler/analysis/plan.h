// How an accepted rule is applied, decided once for all applications: what both back ends execute or print.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compiler/ir/rule_scheme.h"

namespace jrule::analysis {

/// The match column of `node`, from that of a node matched before: m(u, node) = m(u·word, from)·letter.
struct MatchStep {
  ir::NodeId node;
  ir::NodeId from;
  Word word;
  Letter letter;
};

/// A left arc that has to be tested: m(u, source)·dimension = m(u·word, target) for all u in P. Arcs that hold in every map
/// are not in the plan.
struct MatchCheck {
  ir::NodeId source;
  int dimension;
  Word word;
  ir::NodeId target;
  source::Span span;
};

/// How a further hook's component is matched: P is walked in step along the hook's own loops.
struct FurtherHook {
  ir::NodeId node;
  struct Loop { Word word; int dimension; };
  std::vector<Loop> loops;
};

/// The right nodes whose copies lie in one π-orbit together (theory: section 5): a component of the right side under π's
/// words. (u, root) and (u·path, node) are of one orbit for every member, (u, root) and (u·g, root) for every generator g, and
/// nothing else of the right side is.
struct OrbitComponent {
  std::size_t embedding = 0;
  struct Member { ir::NodeId node; Word path; };
  std::vector<Member> members;    ///< the root first, its path ε
  std::vector<Word> generators;   ///< without ε; conjugates left out
  enum class Kind {
    fresh,    ///< no dart of it existed: one new value for each orbit, from the clause or the default
    inherit,  ///< added nodes take over the value of the orbit that they join
    assign,   ///< an existing orbit gets the clause's value, wherever it reaches
    merge,    ///< existing orbits may become one: the embedding's policy decides
  } kind = Kind::fresh;
  std::optional<std::size_t> clause;  ///< of the root; for fresh (none: the default) and assign
  /// inherit: (u, added) takes the handle of the dart m(u·word, preserved)·tail.
  struct Source { ir::NodeId added; Word word; ir::NodeId preserved; Word tail; };
  std::vector<Source> sources;
};

struct Plan {
  std::vector<Word> generators;  ///< P is closed under these and their conjugates; none is ε
  std::vector<FurtherHook> further_hooks;
  std::vector<MatchStep> steps;
  std::vector<MatchCheck> checks;
  bool test_injectivity = false;      ///< else one dart cannot be matched twice
  std::vector<ir::NodeId> deleted, added;
  std::vector<ir::Arc> writes;        ///< right arcs that are not on the left: (u, source)·dimension := (u·word, target)
  std::vector<OrbitComponent> orbits; ///< those that the application has to touch, by embedding, then kind
};

/// Of a component that merges orbits of single letters, by a policy of the language: the member whose values the others' are
/// compared with, of those that were there before the first in the rule. Where all are the same, nothing has to be walked, for every
/// dart of such an orbit hangs on one of the component's by arcs that have not changed; by MergePolicy::first the others take its
/// value over. Null for other components.
OrbitComponent::Member const* compared_with(ir::RuleScheme const& rule, OrbitComponent const& component);

/// The topological part of the plan. The rule must satisfy the incident-arcs condition.
Plan plan_application(ir::RuleScheme const& rule);

}  // namespace jrule::analysis
