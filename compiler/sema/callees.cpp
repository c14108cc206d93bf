#include "compiler/sema/callees.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "compiler/sema/imports.h"
#include "compiler/sema/names.h"
#include "compiler/sema/operations.h"
#include "compiler/sema/rules.h"

namespace jrule::sema {

using source::Code;
using source::Diagnostic;
using source::Diagnostics;
using source::Span;

namespace {

ast::Name const* callable_name(ast::Item const& item) {
  if (auto const* rule = std::get_if<ast::Rule>(&item)) return &rule->name;
  if (auto const* operation = std::get_if<ast::Operation>(&item)) return &operation->name;
  return nullptr;
}

std::string key_of(ir::Modeler const& modeler) { return modeler.module + "/" + modeler.name; }

}  // namespace

void Callees::add(ast::Rule const& rule, ir::Modeler const& modeler, std::optional<std::size_t> index) {
  known_.emplace(Key{&rule, {}, key_of(modeler)}, index);
}

std::optional<std::size_t> Callees::declare(OperationItem item, std::string const& name, ModelerPtr modeler, std::optional<Span> import,
                                            Diagnostics& diagnostics) {
  Key const key{item.declared, {}, key_of(*modeler)};
  Diagnostics found;
  auto operation = declare_operation(*item.declared, name, item.module->name, modeler, externs_, found);
  for (Diagnostic const& d : found.all()) {
    diagnostics.add(import ? told_at_import(d, *import, name, item.module->name, modeler->name) : d);
  }
  if (!operation) {
    known_[key] = std::nullopt;
    return {};
  }
  operation->import = import;
  program_.operations.push_back(std::move(*operation));
  operations_.push_back(std::move(item));
  known_[key] = operations_.size() - 1;
  return known_[key];
}

ast::Item const* Callees::find_item(Module const& module, std::string const& name, Module const** declaring) const {
  auto const find = [&](Module const& m) -> ast::Item const* {
    // The last one of a name counts, as elsewhere; that there are two is reported.
    for (auto item = m.ast.items.rbegin(); item != m.ast.items.rend(); ++item) {
      ast::Name const* const n = callable_name(*item);
      if (!n || n->text != name) continue;
      if (declaring) *declaring = &m;
      return &*item;
    }
    return nullptr;
  };
  if (auto const* own = find(module)) return own;
  for (Module::Import const& import : module.imports) {
    if (auto const* imported = find(modules_.all[import.module])) return imported;
  }
  return nullptr;
}

std::vector<std::string> Callees::names(Module const& module) const {
  std::vector<std::string> all;
  auto const add = [&](Module const& m) {
    for (ast::Item const& item : m.ast.items) {
      if (ast::Name const* const name = callable_name(item)) all.push_back(name->text);
    }
  };
  add(module);
  for (Module::Import const& import : module.imports) add(modules_.all[import.module]);
  return all;
}

std::optional<Callee> Callees::find(std::size_t caller, ast::Call const& call, Diagnostics& diagnostics) {
  Module const* declaring = nullptr;
  ast::Item const* const item = find_item(*operations_[caller].module, call.function.text, &declaring);
  if (!item) {
    report_unknown(diagnostics, Code::unknown_function, call.function, "rule or operation", names(*operations_[caller].module));
    return {};
  }
  if (auto const* rule = std::get_if<ast::Rule>(item)) return find_rule(caller, call, *rule, *declaring, diagnostics);
  return find_operation(caller, call, std::get<ast::Operation>(*item), *declaring, diagnostics);
}

bool Callees::is_callable(std::size_t caller, ast::Name const& name, std::string_view kind, Span declared, ir::Modeler const& on, Module const& module,
                          Diagnostics& diagnostics) {
  ir::Operation const& operation = program_.operations[caller];
  OperationItem const& item = operations_[caller];
  bool const same = is_same(on, *item.declared_on);
  bool const taken = on.module.empty() || &module != item.module;
  if (same || (taken && on.model == operation.model())) return true;
  diagnostics.add({.code = Code::other_modeler, .span = name.span,
                    .message = fmt::format("`{}` is {} on `{}`, but `{}` is on `{}`", name.text, kind, on.name, operation.name, operation.modeler->name),
                    .labels = {{declared, "declared here"}},
                    .notes = {"an operation calls what is on its own modeler, on its model (`on gmap(2)`), or in an imported module on that model"}});
  return false;
}

// The rule's name, unless the program has another one of that name.
std::string Callees::fresh_name(std::string const& name, std::string const& module, ir::Modeler const& modeler) const {
  auto const is_taken = [&](std::string const& n) {
    auto const has_name = [&](auto const& thing) { return thing.name == n; };
    return std::any_of(program_.rules.begin(), program_.rules.end(), has_name) ||
           std::any_of(program_.operations.begin(), program_.operations.end(), has_name) ||
           (n == name && module != program_.module && knows(modules_.all.back(), n));
  };
  if (!is_taken(name)) return name;
  std::string const on = qualified(modeler, name);
  return is_taken(on) ? fmt::format("{}.{}", module, on) : on;
}

std::optional<Callee> Callees::find_rule(std::size_t caller, ast::Call const& call, ast::Rule const& rule, Module const& module, Diagnostics& diagnostics) {
  ModelerPtr const modeler = program_.operations[caller].modeler;
  std::size_t const expected = rule.dimension_parameters.size();
  if (expected != call.dimensions.size()) {
    std::vector<std::string> names;
    for (ast::Name const& p : rule.dimension_parameters) names.push_back(p.text);
    diagnostics.add({.code = Code::unknown_dimension, .span = call.function.span,
                      .message = expected == 0 ? fmt::format("`{}` has no dimension parameters", rule.name.text)
                                               : fmt::format("`{0}` needs {1} dimension{2}: `{0}[{3}](…)`", rule.name.text, expected,
                                                             expected == 1 ? "" : "s", fmt::join(names, ",")),
                      .labels = {{rule.name.span, "declared here"}}});
    return {};
  }
  DimensionValues values;
  std::vector<int> dimensions;
  for (std::size_t i = 0; i < expected; ++i) {
    auto const value = evaluate(call.dimensions[i], operations_[caller].values, diagnostics);
    if (!value) return {};
    dimensions.push_back(*value);
    values[rule.dimension_parameters[i].text] = *value;
  }
  if (auto const open = open_dimension(rule.on, rule.dimension_parameters)) values[*open] = modeler->model.dimension;
  ModelerPtr const declared_on = modelers_.resolve(rule.on, values, diagnostics);
  if (!declared_on || !is_callable(caller, call.function, "a rule", rule.name.span, *declared_on, module, diagnostics)) return {};
  Key const key{&rule, dimensions, key_of(*modeler)};
  if (!known_.contains(key)) known_[key] = instantiate(rule, dimensions, values, module, modeler, *declared_on, call.function.span, diagnostics);
  std::optional<std::size_t> const index = known_[key];
  return index ? std::optional(Callee{true, *index}) : std::nullopt;
}

std::optional<std::size_t> Callees::instantiate(ast::Rule const& rule, std::vector<int> const& dimensions, DimensionValues const& values, Module const& module,
                                                ModelerPtr const& modeler, ir::Modeler const& declared_on, Span call,
                                                Diagnostics& diagnostics) {
  std::string const written = dimensions.empty() ? rule.name.text : fmt::format("{}[{}]", rule.name.text, fmt::join(dimensions, ","));
  std::string const name = fresh_name(written, module.name, *modeler);
  bool const taken = !is_same(declared_on, *modeler);
  bool const foreign = &module != &modules_.all.back();
  Diagnostics found;
  auto scheme = elaborate_rule(rule, name, module.name, modeler, values, externs_, found, taken ? &declared_on : nullptr);
  for (Diagnostic d : found.all()) {
    if (foreign) {
      diagnostics.add(told_at_import(std::move(d), call, written, module.name, modeler->name));
    } else {
      d.labels.push_back({call, fmt::format("`{}` is used here", written)});
      diagnostics.add(std::move(d));
    }
  }
  if (!scheme) return {};
  if (foreign) scheme->import = call;
  program_.rules.push_back(std::move(*scheme));
  return program_.rules.size() - 1;
}

std::optional<Callee> Callees::find_operation(std::size_t caller, ast::Call const& call, ast::Operation const& operation, Module const& module,
                                              Diagnostics& diagnostics) {
  if (!call.dimensions.empty()) {
    diagnostics.add({.code = Code::unknown_dimension, .span = call.function.span,
                      .message = fmt::format("`{}` is an operation, which has no dimension parameters", operation.name.text),
                      .labels = {{operation.name.span, "declared here"}}});
    return {};
  }
  ModelerPtr const modeler = program_.operations[caller].modeler;
  DimensionValues values;
  if (auto const open = open_dimension(operation.on, {})) values[*open] = modeler->model.dimension;
  ModelerPtr const declared_on = modelers_.resolve(operation.on, values, diagnostics);
  if (!declared_on || !is_callable(caller, call.function, "an operation", operation.name.span, *declared_on, module, diagnostics)) return {};
  Key const key{&operation, {}, key_of(*modeler)};
  if (!known_.contains(key)) {
    bool const foreign = &module != &modules_.all.back();
    std::string const name = fresh_name(operation.name.text, module.name, *modeler);
    declare({&operation, &module, values, declared_on}, name, modeler, foreign ? std::optional(call.function.span) : std::nullopt, diagnostics);
  }
  std::optional<std::size_t> const index = known_[key];
  return index ? std::optional(Callee{false, *index}) : std::nullopt;
}

}  // namespace jrule::sema
