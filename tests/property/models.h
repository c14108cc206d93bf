// The models that random cases are drawn from.
#pragma once

#include <memory>
#include <vector>

#include "compiler/ir/rule_scheme.h"

namespace jrule::property {

/// G-maps, O-maps, their duals and closed G-maps of small dimensions, and models of other shapes.
std::vector<Model> const& models();

/// A modeler without embeddings.
std::shared_ptr<ir::Modeler const> bare(Model const& model);
/// One with an Int on each cell, and on orbits of some dimensions and of a word of two letters; each has a default and merges by
/// `first`.
std::shared_ptr<ir::Modeler const> embedded(Model const& model);
/// The same orbits, with values that merge by `mean` (Reals), `min`, `max`, `first` (Ints), or not at all; each has a default.
std::shared_ptr<ir::Modeler const> merging(Model const& model);

}  // namespace jrule::property
