// Models and modelers: built in, or declared by the user.
#pragma once

#include <memory>
#include <optional>

#include "compiler/ir/rule_scheme.h"
#include "compiler/sema/dimensions.h"
#include "compiler/sema/externs.h"
#include "compiler/sema/modules.h"

namespace jrule::sema {

/// Where names of items are looked up: every item of every loaded module, the root's last declaration first.
class Items {
 public:
  explicit Items(Modules const& modules) : modules_(&modules) {}
  ast::Model const* model(std::string const& name) const { return find<ast::Model>(name); }
  ast::Modeler const* modeler(std::string const& name) const { return find<ast::Modeler>(name); }
  ast::Rule const* rule(std::string const& name) const { return find<ast::Rule>(name); }
  ast::Operation const* operation(std::string const& name) const { return find<ast::Operation>(name); }
  /// The module that declares the item.
  template <class T>
  std::string module_of(T const* item) const {
    for (Module const& m : modules_->all) {
      for (ast::Item const& i : m.ast.items) {
        if (std::get_if<T>(&i) == item) return m.name;
      }
    }
    return {};
  }
  template <class T>
  std::vector<std::string> names() const {
    std::vector<std::string> all;
    for (Module const& m : modules_->all) {
      for (ast::Item const& item : m.ast.items) {
        if (auto const* t = std::get_if<T>(&item)) all.push_back(t->name.text);
      }
    }
    return all;
  }

 private:
  template <class T>
  T const* find(std::string const& name) const {
    for (auto m = modules_->all.rbegin(); m != modules_->all.rend(); ++m) {
      for (ast::Item const& item : m->ast.items) {
        if (auto const* t = std::get_if<T>(&item); t && t->name.text == name) return t;
      }
    }
    return nullptr;
  }
  Modules const* modules_;
};

/// The model that `gmap(2)` or a user's `m(3)` names; reported if unknown (J0202), of a bad dimension (J0223) or outside the
/// decided class (J0222).
std::optional<Model> resolve_model(ast::ModelRef const& ref, Items const& items, DimensionValues const& values,
                                   source::Diagnostics& diagnostics);

/// A declared modeler. None if its model is not good; an embedding that is not is reported and left out.
std::shared_ptr<ir::Modeler const> elaborate_modeler(ast::Modeler const& modeler, Items const& items,
                                                     Externs const& externs, source::Diagnostics& diagnostics);

/// Checks a user's `model` declaration on its own, for small n if it has a parameter.
void check_model(ast::Model const& model, source::Diagnostics& diagnostics);

}  // namespace jrule::sema
