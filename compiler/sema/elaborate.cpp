#include "compiler/sema/elaborate.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

#include "compiler/sema/callees.h"
#include "compiler/sema/imports.h"
#include "compiler/sema/modeler_table.h"
#include "compiler/sema/names.h"
#include "compiler/sema/operations.h"
#include "compiler/sema/rules.h"

namespace jrule::sema {

using source::Code;
using source::Diagnostics;

namespace {

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

// Does it stand for one rule in each dimension?
bool is_family(ast::Rule const& rule) {
  return !rule.dimension_parameters.empty() || open_dimension(rule.on, rule.dimension_parameters);
}

// A modeler of the root that takes an imported rule or operation: it is on that one's model.
struct Taker {
  ModelerPtr modeler;
  ModelerPtr declared_on;
  DimensionValues values;
};

// Elaborates imported rules on the modelers of the root.
struct ImportElaboration {
  Externs const& externs;
  ModelerTable& modelers;
  std::vector<ModelerPtr> const& own;

  std::vector<Taker> takers(ast::ModelRef const& on, std::vector<ast::Name> const& dimension_parameters, DimensionValues const& values) const {
    std::vector<Taker> takers;
    for (auto const& modeler : own) {
      DimensionValues with_open = values;
      if (auto const open = open_dimension(on, dimension_parameters)) with_open[*open] = modeler->model.dimension;
      Diagnostics unseen;  // what is wrong with its own modeler or dimensions is told in its file, or where it is used
      auto declared_on = modelers.resolve(on, with_open, unseen);
      if (declared_on && declared_on->model == modeler->model) takers.push_back({modeler, std::move(declared_on), std::move(with_open)});
    }
    return takers;
  }

  // `name` is the scheme's.
  std::optional<ir::RuleScheme> elaborate(ImportedRule const& imported, Taker const& taker, std::string const& name,
                                          Diagnostics& diagnostics) const {
    Diagnostics found;
    auto scheme = elaborate_rule(*imported.rule, name, imported.module, taker.modeler, taker.values, externs, found, taker.declared_on.get());
    for (source::Diagnostic const& d : found.all()) {
      diagnostics.add(told_at_import(d, imported.import, name, imported.module, taker.modeler->name));
    }
    if (scheme) scheme->import = imported.import;
    return scheme;
  }
};

// The operations of the root, then those that its modelers take from the modules that it imports.
void declare_operations(Modules const& modules, ImportElaboration const& imports, Callees& callees, Diagnostics& diagnostics) {
  Module const& root = modules.all.back();
  for (ast::Item const& item : root.ast.items) {
    auto const* operation = std::get_if<ast::Operation>(&item);
    if (!operation) continue;
    auto modeler = imports.modelers.resolve(operation->on, {}, diagnostics);
    if (modeler) callees.declare({operation, &root, {}, modeler}, operation->name.text, modeler, {}, diagnostics);
  }
  for (ImportedOperation const& imported : imported_operations(modules)) {
    std::string const& name = imported.operation->name.text;
    auto const takers = imports.takers(imported.operation->on, {}, {});
    for (Taker const& taker : takers) {
      callees.declare({imported.operation, imported.module, taker.values, taker.declared_on},
                      takers.size() == 1 ? name : qualified(*taker.modeler, name), taker.modeler, imported.import, diagnostics);
    }
  }
}

// `on` is the modeler that was named, if one was.
void report_takers(std::string const& rule, std::string const& on, std::vector<Taker> const& takers, Diagnostics& diagnostics) {
  std::vector<std::string> names;
  for (Taker const& taker : takers) names.push_back(qualified(*taker.modeler, rule));
  source::Diagnostic d{.code = Code::unknown_value, .span = {},
                       .message = on.empty() ? fmt::format("`{}` is a rule of several modelers", rule)
                                             : fmt::format("`{}` is not a rule of the modeler `{}`", rule, on)};
  if (!names.empty()) d.notes.push_back(fmt::format("known here: `{}`", fmt::join(names, "`, `")));
  diagnostics.add(std::move(d));
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
    if (auto const* model = std::get_if<ast::Model>(&item)) check_model(*model, diagnostics);
  }
  program.modelers = modelers.of(root, diagnostics);
  Callees callees(modules, externs, modelers, program);
  // The scheme becomes one of the program's, if there is one.
  auto const keep = [&](ast::Rule const& rule, ir::Modeler const& modeler, std::optional<ir::RuleScheme> scheme) {
    callees.add(rule, modeler, scheme ? std::optional(program.rules.size()) : std::nullopt);
    if (scheme) program.rules.push_back(std::move(*scheme));
  };
  for (ast::Item const& item : root.ast.items) {
    auto const* rule = std::get_if<ast::Rule>(&item);
    if (!rule) continue;
    if (is_family(*rule)) {
      diagnostics.add({.code = Code::unelaborated_rule, .span = rule->name.span,
                       .message = fmt::format("`{}` stands for one rule in each dimension; each is checked where it is used", rule->name.text)});
      continue;
    }
    auto modeler = modelers.resolve(rule->on, {}, diagnostics);
    if (!modeler) continue;
    keep(*rule, *modeler, elaborate_rule(*rule, rule->name.text, root.name, modeler, {}, externs, diagnostics));
  }
  ImportElaboration const imports{externs, modelers, program.modelers};
  for (ImportedRule const& imported : imported_rules(modules)) {
    if (is_family(*imported.rule)) continue;
    std::string const& name = imported.rule->name.text;
    auto const takers = imports.takers(imported.rule->on, imported.rule->dimension_parameters, {});
    for (Taker const& taker : takers) {
      auto scheme = imports.elaborate(imported, taker, takers.size() == 1 ? name : qualified(*taker.modeler, name), diagnostics);
      keep(*imported.rule, *taker.modeler, std::move(scheme));
    }
  }
  declare_operations(modules, imports, callees, diagnostics);
  std::vector<bool> good;
  for (std::size_t i = 0; i < callees.operations().size(); ++i) good.push_back(elaborate_body(i, program, callees, externs, diagnostics));
  ir::keep_operations(program, good);
  return program;
}

std::optional<ir::RuleScheme> instantiate(Modules const& modules, std::string const& reference, std::vector<int> const& dimensions,
                                          std::optional<int> n, Diagnostics& diagnostics) {
  Items const items(modules);
  std::size_t const dot = reference.rfind('.');
  std::string const on = dot == std::string::npos ? "" : reference.substr(0, dot);
  std::string const name = dot == std::string::npos ? reference : reference.substr(dot + 1);
  ast::Rule const* const rule = items.rule(name);
  if (!rule) {
    report_unknown(diagnostics, Code::unknown_value, ast::Name{name, {}}, "rule", items.names<ast::Rule>());
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
  std::string const full = dimensions.empty() ? name : fmt::format("{}[{}]", name, fmt::join(dimensions, ","));
  Externs const externs = collect_externs(modules, diagnostics);
  ModelerTable modelers{items, externs, {}};
  std::vector<ModelerPtr> const own = modelers.of(modules.all.back(), diagnostics);
  auto const imported = imported_rules(modules);
  auto const import = std::find_if(imported.begin(), imported.end(), [&](ImportedRule const& i) { return i.rule == rule; });
  std::vector<Taker> all;
  if (import != imported.end()) {
    ImportElaboration const imports{externs, modelers, own};
    all = imports.takers(rule->on, rule->dimension_parameters, values);
    auto takers = all;
    std::erase_if(takers, [&](Taker const& taker) {
      if (!on.empty()) return taker.modeler->name != on;
      return n && open_dimension(rule->on, rule->dimension_parameters) && taker.modeler->model.dimension != *n;
    });
    if (takers.size() == 1) {
      return imports.elaborate(*import, takers.front(), all.size() == 1 ? full : qualified(*takers.front().modeler, full), diagnostics);
    }
    if (takers.size() > 1) {
      report_takers(full, on, takers, diagnostics);
      return {};
    }
  }
  if (!on.empty() && on != rule->on.name.text) {
    report_takers(full, on, all, diagnostics);
    return {};
  }
  if (auto const open = open_dimension(rule->on, rule->dimension_parameters); open && n) values[*open] = *n;
  auto modeler = modelers.resolve(rule->on, values, diagnostics);
  if (!modeler) return {};
  return elaborate_rule(*rule, full, items.module_of(rule), std::move(modeler), values, externs, diagnostics);
}

}  // namespace jrule::sema
