// A rule or an operation at work on a small surface.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compiler/analysis/analyze.h"
#include "compiler/ir/program.h"

namespace jrule::docs {

struct Demonstration {
  std::string call;   ///< "extrude_face(shift: Vec3(0, 0.5, 0))": the values of parameters that have no default
  std::string place;  ///< "at a face of a cube"; of what creates, "from nothing"
  std::string before; ///< an SVG; empty of what creates
  std::string after;
};

/// None where nothing can be shown: a model without surfaces, no positions, more than two hooks, C++ from outside, nowhere applicable
/// on a few small shapes, or a surface that stays as it is. `plan` is that of the accepted rule.
std::optional<Demonstration> demonstrate(ir::RuleScheme const& rule, analysis::Plan const& plan);

/// The same of `program.operations[operation]`; all rules are accepted. An operation that goes on too long is not shown.
std::optional<Demonstration> demonstrate(ir::Program const& program, std::vector<analysis::Verdict> const& verdicts, std::size_t operation);

}  // namespace jrule::docs
