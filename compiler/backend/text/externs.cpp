#include "compiler/backend/text/externs.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "compiler/backend/text/rule.h"
#include "compiler/sema/overloads.h"
#include "compiler/sema/types.h"

namespace jrule::text {

namespace {

bool same(ir::ExternType const& a, ir::ExternType const& b) {
  return a.name == b.name && a.header == b.header && a.cpp_name == b.cpp_name;
}
bool same(ir::ExternFunction const& a, ir::ExternFunction const& b) {
  return a.name == b.name && a.header == b.header && a.cpp_name == b.cpp_name && signature(a) == signature(b);
}

template <class Pointer>
bool insert(std::vector<Pointer>& items, Pointer const& item) {
  if (!item || std::any_of(items.begin(), items.end(), [&](Pointer const& known) { return same(*known, *item); })) return false;
  items.push_back(item);
  return true;
}

// Recursive, as the checker is.
struct Collection {
  Externs found{};

  void add(ir::ExternTypePtr const& type) { insert(found.types, type); }
  void add(ir::ExternFunctionPtr const& function) {
    if (!insert(found.functions, function)) return;
    for (auto const& parameter : function->parameters) add(parameter.type.external);
    add(function->result.external);
  }
  void add(ir::ExprPtr const& expr) {
    if (!expr) return;
    if (auto const* const call = std::get_if<ir::Call>(&expr->value)) add(call->function);
    for (ir::ExprPtr const& part : ir::parts(*expr)) add(part);
  }
  void add(std::vector<ir::Parameter> const& parameters) {
    for (ir::Parameter const& parameter : parameters) {
      add(parameter.external);
      add(parameter.computed_default);
    }
  }
  void add(ir::Block const& block) {
    for (ir::Statement const& statement : block) {
      for (ir::ExprPtr const& expr : ir::expressions(statement)) add(expr);
      for (ir::Block const* inner : ir::blocks(statement)) add(*inner);
    }
  }
};

Spelled<std::string> spell_place(std::string const& header, std::string const& cpp_name) {
  for (std::string const& text : {header, cpp_name}) {
    if (text.find_first_of("\"\\\n\r") != std::string::npos) {
      return tl::unexpected(Unspellable{fmt::format("`{}` is no name or header of C++", text)});
    }
  }
  return fmt::format("in \"{}\" as \"{}\";\n\n", header, cpp_name);
}

Unspellable already(std::string const& name) { return {fmt::format("`{}` is a name of the language already", name)}; }

}  // namespace

Externs externs_of(std::vector<std::shared_ptr<ir::Modeler const>> const& modelers, ir::Program const& program) {
  Collection collection;
  for (auto const& modeler : modelers) {
    for (ir::EmbeddingExterns const& embedding : modeler->externs) {
      collection.add(embedding.type);
      collection.add(embedding.default_value);
      collection.add(embedding.merge);
    }
  }
  for (ir::RuleScheme const& rule : program.rules) {
    collection.add(rule.parameters);
    for (ir::Let const& let : rule.lets) collection.add(let.value);
    for (ir::Requirement const& requirement : rule.requirements) collection.add(requirement.condition);
    for (ir::Clause const& clause : rule.clauses) collection.add(clause.value);
  }
  for (ir::Operation const& operation : program.operations) {
    collection.add(operation.parameters);
    if (operation.result) collection.add(operation.result->external);
    collection.add(operation.body);
  }
  return std::move(collection.found);
}

Spelled<std::string> spell(ir::ExternType const& type) {
  if (type.name == "Dart" || sema::find_type(type.name)) return tl::unexpected(already(type.name));
  auto const doc = spell_documentation(type.doc, "");
  auto const place = spell_place(type.header, type.cpp_name);
  if (!doc) return doc;
  if (!place) return place;
  return fmt::format("{}extern type {} {}", *doc, type.name, *place);
}

Spelled<std::string> spell(ir::ExternFunction const& function) {
  if (sema::find_function(function.name)) return tl::unexpected(already(function.name));
  auto const doc = spell_documentation(function.doc, "");
  auto const place = spell_place(function.header, function.cpp_name);
  if (!doc) return doc;
  if (!place) return place;
  std::vector<std::string> parameters;
  for (auto const& parameter : function.parameters) parameters.push_back(fmt::format("{}: {}", parameter.name, to_string(parameter.type)));
  return fmt::format("{}extern fn {}({}) -> {} {}", *doc, function.name, fmt::join(parameters, ", "), to_string(function.result), *place);
}

}  // namespace jrule::text
