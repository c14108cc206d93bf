// What a rule does to cells, in words.
#pragma once

#include <string>
#include <vector>

#include "compiler/analysis/effects.h"

namespace jrule::analysis {

/// "vertices  new  `d`  one for each face"
struct EffectLine {
  std::string cells;               ///< "vertices"; empty if they are those of the line before
  std::string effect;              ///< "new", "deleted", "may be split", "may merge", "kept"
  std::vector<std::string> nodes;  ///< their names
  std::string number;              ///< "one", "one for each vertex", "at most one for each dart"
};

struct EffectsWording {
  std::string where;  ///< "creates", "applied to whole components", "its pattern is the orbit <0,1> of `a`"
  std::vector<EffectLine> lines;
  std::vector<std::string> counts;  ///< "V' = V + 1", with its condition, if it has one
};
EffectsWording describe(ir::RuleScheme const& rule, Effects const& effects);

}  // namespace jrule::analysis
