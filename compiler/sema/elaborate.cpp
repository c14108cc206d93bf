#include "compiler/sema/elaborate.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>

#include "compiler/sema/models.h"
#include "compiler/sema/names.h"
#include "compiler/sema/rules.h"

namespace jrule::sema {

using source::Code;
using source::Diagnostics;

namespace {

// Modelers by name, each elaborated and reported once.
struct ModelerTable {
  Items const& items;
  Externs const& externs;
  std::map<std::string, std::shared_ptr<ir::Modeler const>> known;

  std::shared_ptr<ir::Modeler const> declared(ast::Modeler const& modeler, Diagnostics& diagnostics) {
    auto const [entry, fresh] = known.try_emplace(modeler.name.text);
    if (fresh) entry->second = elaborate_modeler(modeler, items, externs, diagnostics);
    return entry->second;
  }

  // The modeler that `on NAME` or `on gmap(2)` means: a bare model is a modeler without embeddings.
  std::shared_ptr<ir::Modeler const> resolve(ast::ModelRef const& ref, DimensionValues const& values, Diagnostics& diagnostics) {
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
};

// The parameter of a bare model's dimension, as in `on gmap(n)`: a name that is no dimension parameter of the rule.
std::optional<std::string> open_dimension(ast::Rule const& rule) {
  if (!rule.on.dimension) return {};
  for (ast::DimensionTerm const& term : rule.on.dimension->terms) {
    auto const* name = std::get_if<std::string>(&term.value);
    if (!name) continue;
    bool bound = false;
    for (ast::Name const& p : rule.dimension_parameters) bound = bound || p.text == *name;
    if (!bound) return *name;
  }
  return {};
}

ast::Name const* name_of(ast::Item const& item) {
  return std::visit(
      [](auto const& i) -> ast::Name const* {
        if constexpr (requires { i.name; }) {
          return &i.name;
        } else {
          return nullptr;
        }
      },
      item);
}

void report_duplicates(Module const& module, Diagnostics& diagnostics) {
  std::map<std::string, ast::Name const*> first;
  for (ast::Item const& item : module.ast.items) {
    ast::Name const* const name = name_of(item);
    if (!name) continue;
    auto const [entry, fresh] = first.try_emplace(name->text, name);
    if (!fresh) {
      diagnostics.add({.code = Code::duplicate_name, .span = name->span, .message = fmt::format("`{}` is declared twice", name->text),
                       .labels = {{entry->second->span, "first declared here"}}});
    }
  }
}

void report_unimplemented(ast::Item const& item, Diagnostics& diagnostics) {
  if (auto const* operation = std::get_if<ast::Operation>(&item)) {
    diagnostics.add({.code = Code::operation_not_implemented, .span = operation->name.span,
                     .message = fmt::format("the operation `{}` is parsed, but operations are not yet implemented", operation->name.text)});
  }
}

}  // namespace

ir::Program elaborate(Modules const& modules, Diagnostics& diagnostics) {
  ir::Program program;
  if (modules.all.empty()) return program;
  Module const& root = modules.all.back();
  program.module = root.name;
  Items const items(modules);
  Externs const externs = collect_externs(modules, diagnostics);
  ModelerTable modelers{items, externs, {}};
  report_duplicates(root, diagnostics);
  for (ast::Item const& item : root.ast.items) {
    if (auto const* model = std::get_if<ast::Model>(&item)) {
      check_model(*model, diagnostics);
    } else if (auto const* modeler = std::get_if<ast::Modeler>(&item)) {
      if (auto elaborated = modelers.declared(*modeler, diagnostics)) program.modelers.push_back(std::move(elaborated));
    } else {
      report_unimplemented(item, diagnostics);
    }
  }
  for (ast::Item const& item : root.ast.items) {
    auto const* rule = std::get_if<ast::Rule>(&item);
    if (!rule) continue;
    auto const open = open_dimension(*rule);
    if (!rule->dimension_parameters.empty() || open) {
      diagnostics.add({.code = Code::unelaborated_rule, .span = rule->name.span,
                       .message = fmt::format("`{}` stands for one rule in each dimension; each is checked where it is used", rule->name.text)});
      continue;
    }
    auto modeler = modelers.resolve(rule->on, {}, diagnostics);
    if (!modeler) continue;
    if (auto scheme = elaborate_rule(*rule, rule->name.text, root.name, std::move(modeler), {}, externs, diagnostics)) {
      program.rules.push_back(std::move(*scheme));
    }
  }
  return program;
}

std::optional<ir::RuleScheme> instantiate(Modules const& modules, std::string const& name, std::vector<int> const& dimensions,
                                          std::optional<int> n, Diagnostics& diagnostics) {
  Items const items(modules);
  ast::Rule const* const rule = items.rule(name);
  if (!rule) {
    ast::Name const unknown{name, {}};
    report_unknown(diagnostics, Code::unknown_value, unknown, "rule", items.names<ast::Rule>());
    return {};
  }
  if (rule->dimension_parameters.size() != dimensions.size()) {
    diagnostics.add({.code = Code::unknown_dimension, .span = rule->name.span,
                     .message = rule->dimension_parameters.empty()
                                    ? fmt::format("`{}` has no dimension parameters, but {} given", name, dimensions.size() == 1 ? "one is" : "some are")
                                    : fmt::format("`{}` needs {} dimension{}: `{}[{}]`", name, rule->dimension_parameters.size(),
                                                  rule->dimension_parameters.size() == 1 ? "" : "s", name,
                                                  rule->dimension_parameters.size() == 1 ? "2" : "1,2")});
    return {};
  }
  DimensionValues values;
  for (std::size_t i = 0; i < dimensions.size(); ++i) values[rule->dimension_parameters[i].text] = dimensions[i];
  if (auto const open = open_dimension(*rule); open && n) values[*open] = *n;
  Externs const externs = collect_externs(modules, diagnostics);
  ModelerTable modelers{items, externs, {}};
  auto modeler = modelers.resolve(rule->on, values, diagnostics);
  if (!modeler) return {};
  std::string const full = dimensions.empty() ? name : fmt::format("{}[{}]", name, fmt::join(dimensions, ","));
  return elaborate_rule(*rule, full, items.module_of(rule), std::move(modeler), values, externs, diagnostics);
}

}  // namespace jrule::sema
