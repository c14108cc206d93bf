#include "compiler/sema/parameters.h"

#include <fmt/format.h>

#include <map>

#include "compiler/sema/types.h"
#include "compiler/sema/units.h"

namespace jrule::sema {

using source::Code;

namespace {

void set_type(ir::Parameter& parameter, ast::Parameter const& declared, Externs const& externs, source::Diagnostics& diagnostics) {
  auto const type = resolve_stored_type(declared.type, externs, diagnostics);
  if (!type) return;
  parameter.type = type->element;
  parameter.external = type->external;
  if (!declared.default_value) return;
  auto const value = evaluate_default(*declared.default_value, *type, externs, diagnostics);
  parameter.default_value = value ? value->value : std::nullopt;
  parameter.computed_default = value ? value->computed : nullptr;
}

}  // namespace

std::vector<ir::Parameter> elaborate_parameters(std::vector<ast::Parameter> const& parameters, Darts darts, Externs const& externs,
                                                source::Diagnostics& diagnostics) {
  std::vector<ir::Parameter> all;
  std::map<std::string, source::Span> first;
  for (ast::Parameter const& p : parameters) {
    auto const [known, fresh] = first.emplace(p.name.text, p.name.span);
    if (!fresh) {
      diagnostics.add({.code = Code::duplicate_name, .span = p.name.span,
                       .message = fmt::format("the parameter `{}` is declared twice", p.name.text),
                       .labels = {{known->second, "first declared here"}}});
    }
    auto [unit, doc] = split_unit(p.doc);
    ir::Parameter parameter{
        .name = p.name.text, .default_value = {}, .doc = std::move(doc), .unit = std::move(unit), .span = p.name.span};
    parameter.dart = darts == Darts::allowed && p.type.name.text == "Dart" && !p.type.list;
    if (!parameter.dart) {
      set_type(parameter, p, externs, diagnostics);
    } else if (p.default_value) {
      diagnostics.add({.code = Code::unknown_value, .span = p.default_value->span,
                       .message = fmt::format("the dart `{}` has no default", p.name.text),
                       .notes = {"which darts there are depends on the map"}});
    }
    all.push_back(std::move(parameter));
  }
  return all;
}

}  // namespace jrule::sema
