// What the analysis concludes from, as plain data: positions of the arcs that a conclusion rests on.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "compiler/ir/rule_scheme.h"

namespace jrule::analysis {

/// A position among the arcs of one side: those that are written, then those that completion adds.
using ArcIndex = std::size_t;

/// The written left arc that says where a node lies: it leads from a placed node to `node`, or from `node` to a placed one.
struct PlacementEvidence {
  ir::NodeId node = 0;
  ArcIndex arc = 0;
  bool forwards = true;  ///< it leads to `node`
};

/// A word under which the pattern is closed by its definition: a letter of the hook's type or the word of a written arc.
struct Generator {
  enum class Kind { hook_type, left_word, right_word } kind = Kind::hook_type;
  std::size_t index = 0;  ///< of the letter or arc
};

/// Why a word acts as ε on the pattern. All arcs are written left arcs.
struct RelationEvidence {
  enum class Kind {
    arc,              ///< of the first hook's component: u·x_s·d = u·w·x_t
    arc_and_reverse,  ///< of a non-oriented dimension, (u, s) to (u·w, t) to (u·w·w', s), which is (u, s)
    cycle,            ///< an ijij-cycle: (u, s) to (u·w, s), which is (u, s)
    single_dart,      ///< a generator's word: a further hook without loops determines one dart, so the pattern has only one
  } kind = Kind::arc;
  std::vector<ArcIndex> arcs;  ///< none for a single dart
  std::size_t hook = 0;        ///< of a single dart, the further hook's position
  Generator generator{};       ///< of a single dart
};

/// Why the pattern is closed under a dimension: it occurs once in a word under which the pattern is closed, or which acts as ε
/// there, and it is closed under all other letters of that word.
struct ClosureEvidence {
  int dimension = 0;
  std::optional<std::size_t> relation;  ///< the word is this relation's
  Generator generator{};                ///< else this generator's
};

/// A walk from the pattern into the pattern, step by step: along a dimension under which it is closed, or along the word of an arc.
struct PatternStep {
  std::optional<Letter> letter;
  Generator generator{};   ///< where there is no letter
  bool backwards = false;  ///< along the generator's conjugate
};

/// Why an arc that is not written is there wherever the left side matches. Its arcs are left arcs, written or implied before.
struct ImpliedEvidence {
  enum class Kind {
    reverse,    ///< of a non-oriented arc
    cycle,      ///< it closes an ijij-cycle of which the left side has three arcs
    placement,  ///< between nodes of the first hook's component: u·x_s·d = u·w·x_t in every map
  } kind = Kind::reverse;
  std::vector<ArcIndex> arcs;
};

}  // namespace jrule::analysis
