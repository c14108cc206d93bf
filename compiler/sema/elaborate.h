// Names resolved, types checked, dimension parameters replaced: from modules to rule schemes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compiler/ir/program.h"
#include "compiler/sema/modules.h"

namespace jrule::sema {

/// The modelers and rules of the root module, then the rules of the modules that it imports, each on every modeler of the root
/// that is on its model: elaborated again with that modeler's embeddings, called `Modeler.rule` if several take it. Every item
/// with an error is reported and left out, the others are complete. A rule with dimension parameters is elaborated where it is
/// used (see instantiate); J0229 says so of the root's.
ir::Program elaborate(Modules const& modules, source::Diagnostics& diagnostics);

/// One rule of the loaded modules with its dimension parameters replaced: `sew[2]` is ("sew", {2}). An imported one is on the
/// modeler of the root that takes it, if any does; `Modeler.sew` says which. On a bare model whose dimension is a parameter
/// (`on gmap(n)`), that takes the value `n`. None if anything was reported.
std::optional<ir::RuleScheme> instantiate(Modules const& modules, std::string const& name, std::vector<int> const& dimensions,
                                          std::optional<int> n, source::Diagnostics& diagnostics);

}  // namespace jrule::sema
