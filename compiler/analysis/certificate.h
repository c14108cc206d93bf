// The proof that an accepted rule turns maps of its model into maps: plain data, to be read, and to be checked again by a program
// that shares nothing with the analyzer.
//
// What is proved of the rule with its implied arcs: the conditions on incident arcs, on non-orientation and on cycles
// (paper, Def. 22, 24 and 27), and for closed models that no added arc is a loop. From this the theorems of the paper conclude.
// Embeddings are no part of it.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "compiler/algebra/cancellation.h"
#include "compiler/analysis/evidence.h"

namespace jrule::analysis {

/// A word that is ε in Γ, and how.
struct Vanishing {
  Word word;
  algebra::Cancellations steps;  ///< empty it
};

/// A word leads from the pattern into the pattern: each of the steps does.
struct Walk {
  std::vector<PatternStep> steps;
  Vanishing trace;  ///< of the steps' words times the conjugate of the word
};

/// A word acts as ε on the pattern: for all pattern darts u, u·word = u. Each step multiplies it in front by p·r·p̄, which acts as
/// ε since p leads from the pattern into the pattern and r is a relation, or the conjugate of one.
struct Proof {
  struct Step {
    Word prefix;               ///< p
    Walk walk;                 ///< along p
    std::size_t relation = 0;  ///< r
    bool conjugate = false;
    Word result;      ///< = p·r·p̄·word in Γ,
    Vanishing trace;  ///< for p·r·p̄·word·(conjugate of the result) vanishes
  };
  Word word;
  std::vector<Step> steps;
  Vanishing trace;  ///< of the last result; of the word, if there are no steps
};

struct Certificate {
  // What the left side says about any match. Each entry needs only those before it.

  /// m(u, node) = u·offset, in the component of the first hook, whose own offset is ε.
  struct Placement {
    PlacementEvidence evidence;
    Word offset;
    Vanishing trace;  ///< of the word that the arc gives, w̄·x_s·d or w·x_t·d̄, times the conjugate of the offset
  };
  /// u·word = u.
  struct Relation {
    RelationEvidence evidence;
    Word word;
    Vanishing trace;  ///< of the word that the arcs give, x_s·d·x̄_t·w̄ or the product of theirs, times the conjugate of `word`
  };
  /// An arc of the map between matched darts. No rule that leaves it out deletes it, so it is on both sides.
  struct ImpliedArc {
    ir::Arc arc;
    ImpliedEvidence evidence;
    Vanishing trace;  ///< of x_s·d·x̄_t·w̄ for a placement; else of the product of the words of the evidence and its own
    Walk walk;        ///< along its word, for a placement
  };
  std::vector<Placement> placements;
  std::vector<Relation> relations;
  std::vector<ClosureEvidence> closure;
  std::vector<ImpliedArc> implied;

  // The conditions.

  /// I(d) at a node: the arc that leaves it (enters it) on each side.
  struct IncidentArcs {
    struct Direction { std::optional<ArcIndex> left, right; };
    ir::NodeId node = 0;
    int dimension = 0;
    Direction out, in;
  };
  /// O(d) for an added or deleted arc and its reverse, which may be itself: reverse·arc acts as ε.
  struct Reverse {
    bool added = false;
    ArcIndex arc = 0, reverse = 0;
    Proof proof;
  };
  /// C(i,j) for the changed arcs in an ijij-cycle: of the right side, whose word acts as ε, or of the left side, which any match has.
  struct Cycle {
    bool added = false;
    std::array<ArcIndex, 4> arcs{};
    std::optional<Proof> proof;  ///< on the right
  };
  /// C(i,j) for a maximal path of deleted arcs and the maximal path of added ones that replaces it: left·(conjugate of right) acts as ε.
  struct Paths {
    std::array<int, 2> pair{};  ///< i < j
    std::vector<ArcIndex> left, right;
    Proof proof;
  };
  /// Of a closed model, an added arc from a node to itself is no loop: its word leads where by·letter·b̄y does, and single letters
  /// fix no dart.
  struct NoLoop {
    ArcIndex arc = 0;
    algebra::ConjugateOfLetter conjugation;
    Proof proof;  ///< of the arc's word times by·(conjugate of the letter)·b̄y
  };
  std::vector<IncidentArcs> incident_arcs;
  std::vector<Reverse> reverses;
  std::vector<Cycle> cycles;
  std::vector<Paths> paths;
  std::vector<NoLoop> no_loops;
};

/// One fact a line. Arcs are named L1, L2, … and R1, R2, … in the order of the sides, implied ones I1, I2, …, relations F1, F2, …
std::string print(Certificate const& certificate, ir::RuleScheme const& rule, source::Sources const& sources);

}  // namespace jrule::analysis
