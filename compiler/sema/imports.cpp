#include "compiler/sema/imports.h"

#include <fmt/format.h>

#include <algorithm>

#include "compiler/sema/models.h"

namespace jrule::sema {

std::vector<ImportedRule> imported_rules(Modules const& modules) {
  Items const items(modules);
  std::vector<ImportedRule> rules;
  for (Module::Import const& import : modules.all.back().imports) {
    Module const& module = modules.all[import.module];
    for (ast::Item const& item : module.ast.items) {
      auto const* const rule = std::get_if<ast::Rule>(&item);
      if (rule && items.rule(rule->name.text) == rule) rules.push_back({rule, module.name, import.span});
    }
  }
  return rules;
}

std::vector<ImportedOperation> imported_operations(Modules const& modules) {
  Items const items(modules);
  std::vector<ImportedOperation> operations;
  for (Module::Import const& import : modules.all.back().imports) {
    Module const& module = modules.all[import.module];
    for (ast::Item const& item : module.ast.items) {
      auto const* const operation = std::get_if<ast::Operation>(&item);
      if (operation && items.operation(operation->name.text) == operation) operations.push_back({operation, &module, import.span});
    }
  }
  return operations;
}

source::Diagnostic told_at_import(source::Diagnostic found, source::Span import, std::string const& rule, std::string const& module,
                                  std::string const& modeler) {
  std::string const plain = rule.starts_with(modeler + ".") ? rule.substr(modeler.size() + 1) : rule;
  found.message = fmt::format("`{}`, imported for `{}`: {}", plain, modeler, found.message);
  bool const labelled = std::any_of(found.labels.begin(), found.labels.end(), [&](source::Label const& label) { return label.span == found.span; });
  if (found.span.file != source::no_file && !labelled) found.labels.insert(found.labels.begin(), {found.span, "in the imported rule"});
  found.span = import;
  found.notes.push_back(fmt::format("each rule of `{}` on a model of `{}` is checked again with the embeddings of `{}`", module, modeler, modeler));
  found.fixits.clear();  // they would change the imported file
  return found;
}

}  // namespace jrule::sema
