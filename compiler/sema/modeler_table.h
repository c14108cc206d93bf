// The modelers that rules and operations are on.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "compiler/ir/rule_scheme.h"
#include "compiler/sema/models.h"

namespace jrule::sema {

using ModelerPtr = std::shared_ptr<ir::Modeler const>;

/// Modelers by name, each elaborated and reported once.
struct ModelerTable {
  Items const& items;
  Externs const& externs;
  std::map<std::string, ModelerPtr> known{};

  ModelerPtr declared(ast::Modeler const& modeler, source::Diagnostics& diagnostics);
  /// Those that the module declares, without those that have an error.
  std::vector<ModelerPtr> of(Module const& module, source::Diagnostics& diagnostics);
  /// The modeler that `on NAME` or `on gmap(2)` means: a bare model is a modeler without embeddings. Null, reported, if there is none.
  ModelerPtr resolve(ast::ModelRef const& ref, DimensionValues const& values, source::Diagnostics& diagnostics);
};

/// Is it the same modeler? Bare models are told apart by their names.
bool is_same(ir::Modeler const& a, ir::Modeler const& b);

/// The parameter of a bare model's dimension, as in `on gmap(n)`: a name that is none of the dimension parameters.
std::optional<std::string> open_dimension(ast::ModelRef const& on, std::vector<ast::Name> const& dimension_parameters);

/// "Surface.quad", on a bare model "gmap2.quad": of a rule or operation that several modelers take.
std::string qualified(ir::Modeler const& modeler, std::string const& name);

}  // namespace jrule::sema
