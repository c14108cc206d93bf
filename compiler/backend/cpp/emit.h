// IR -> C++: one header and one source for each module, one function for each rule and operation.
#pragma once

#include <string>
#include <vector>

#include "compiler/analysis/analyze.h"
#include "compiler/ir/program.h"
#include "compiler/source/diagnostic.h"

namespace jrule::cpp {

struct Options {
  std::string name_space;     ///< "my::ops"; empty: the module's name
  std::string header_prefix;  ///< "my/ops": the source includes "my/ops/surface.h"; empty: "surface.h"
};

/// An accepted rule with its plan.
struct Rule {
  ir::RuleScheme const* scheme;
  analysis::Plan const* plan;
};

struct GeneratedFile {
  std::string name;  ///< "surface.h", "surface.cpp"
  std::string text;
};

/// The module's header and source. A program with operations needs all its rules, in their order. Equal inputs give equal bytes: no dates, no absolute paths. The code includes only
/// runtime/include, is reentrant, and compiles without warnings. A name that C++ cannot use is reported (J0901) and
/// then nothing is returned.
std::vector<GeneratedFile> emit(ir::Program const& program, std::vector<Rule> const& rules,
                                source::Sources const& sources, Options const& options,
                                source::Diagnostics& diagnostics);

}  // namespace jrule::cpp
