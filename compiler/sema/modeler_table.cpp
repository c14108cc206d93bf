#include "compiler/sema/modeler_table.h"

#include <fmt/format.h>

#include "compiler/sema/names.h"

namespace jrule::sema {

using source::Code;
using source::Diagnostics;

ModelerPtr ModelerTable::declared(ast::Modeler const& modeler, Diagnostics& diagnostics) {
  auto const [entry, fresh] = known.try_emplace(modeler.name.text);
  if (fresh) entry->second = elaborate_modeler(modeler, items, externs, diagnostics);
  return entry->second;
}

std::vector<ModelerPtr> ModelerTable::of(Module const& module, Diagnostics& diagnostics) {
  std::vector<ModelerPtr> all;
  for (ast::Item const& item : module.ast.items) {
    auto const* modeler = std::get_if<ast::Modeler>(&item);
    if (!modeler) continue;
    if (auto elaborated = declared(*modeler, diagnostics)) all.push_back(std::move(elaborated));
  }
  return all;
}

ModelerPtr ModelerTable::resolve(ast::ModelRef const& ref, DimensionValues const& values, Diagnostics& diagnostics) {
  if (!ref.dimension) {
    if (ast::Modeler const* const modeler = items.modeler(ref.name.text)) return declared(*modeler, diagnostics);
    if (!items.model(ref.name.text)) {
      report_unknown(diagnostics, Code::unknown_modeler, ref.name, "modeler", items.names<ast::Modeler>());
      return {};
    }
  }
  auto const model = resolve_model(ref, items, values, diagnostics);
  if (!model) return {};
  auto bare = std::make_shared<ir::Modeler>();
  bare->name = ref.dimension ? fmt::format("{}({})", ref.name.text, model->dimension) : ref.name.text;
  bare->model = *model;
  return bare;
}

bool is_same(ir::Modeler const& a, ir::Modeler const& b) { return a.name == b.name && a.module == b.module && a.model == b.model; }

std::optional<std::string> open_dimension(ast::ModelRef const& on, std::vector<ast::Name> const& dimension_parameters) {
  if (!on.dimension) return {};
  for (ast::DimensionTerm const& term : on.dimension->terms) {
    auto const* name = std::get_if<std::string>(&term.value);
    if (!name) continue;
    bool bound = false;
    for (ast::Name const& p : dimension_parameters) bound = bound || p.text == *name;
    if (!bound) return *name;
  }
  return {};
}

std::string qualified(ir::Modeler const& modeler, std::string const& name) {
  std::string on = modeler.name;
  std::erase_if(on, [](char c) { return c == '(' || c == ')'; });  // of a bare model
  return fmt::format("{}.{}", on, name);
}

}  // namespace jrule::sema
