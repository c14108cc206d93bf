// The words that several refusals share.
#pragma once

#include <string>
#include <string_view>

#include "compiler/ir/rule_scheme.h"

namespace jrule::analysis {

using ir::map_name;
/// "a 2-arc from `a` to `c` with the word [1,~2]".
std::string describe(ir::RuleScheme const& rule, ir::Arc const& arc);
/// "`a -2[1,~2]- c`": how both directions of the arc are written.
std::string both_directions(ir::RuleScheme const& rule, ir::Arc const& arc);
/// "vertex", "vertices"; "orbit <0>", "orbits <0>" where the model has no such cells.
std::string orbit_name(Model const& model, OrbitType const& orbit);
std::string orbit_names(Model const& model, OrbitType const& orbit);
/// "the empty word", "the word [0,1]".
std::string describe(Word const& word);
/// "in a 2-G-map every dart has exactly one 2-arc (paper, Def. 22)"
std::string incident_arcs_note(Model const& model, int d);

}  // namespace jrule::analysis
