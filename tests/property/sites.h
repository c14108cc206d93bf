// Maps to apply a rule to, and darts of them for its hooks.
#pragma once

#include <optional>
#include <vector>

#include "compiler/ir/rule_scheme.h"
#include "tests/property/growth.h"
#include "tests/property/random.h"

namespace jrule::property {

/// Polygons, polyhedra, grids, with the other dimensions drawn; random maps; unions and products of such. All valid.
std::vector<Map> random_maps(Model const& model, std::size_t count, Random& random);

struct Site {
  Map map;
  std::vector<Dart> hooks;
};
/// A map grown around an instance of the left side, so that the rule matches there; none if that ends in contradictions, as it
/// does for a left side that nothing can match.
std::optional<Site> grow_site(ir::RuleScheme const& rule, Random& random);

}  // namespace jrule::property
