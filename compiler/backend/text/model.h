// Models as text: a reference to a built-in one, or a declaration for all models of one name.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "compiler/backend/text/print_jrule.h"

namespace jrule::text {

struct ModelDeclaration {
  std::string text;               ///< `model m(n) { … }`; empty if the model is built in
  bool takes_dimension = false;   ///< is it named with its dimension, `m(2)`?
};
/// By the models' names.
using ModelDeclarations = std::map<std::string, ModelDeclaration>;

/// A modeler that stands for its model: a rule is `on gmap(2)` then.
bool is_bare(ir::Modeler const& modeler);

/// The models of these modelers.
Spelled<ModelDeclarations> declare_models(std::vector<std::shared_ptr<ir::Modeler const>> const& modelers);

/// `gmap(2)`, `walls`
std::string spell(Model const& model, ModelDeclarations const& declarations);

}  // namespace jrule::text
