#include "compiler/backend/text/print_jrule.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "compiler/backend/text/expression.h"
#include "compiler/backend/text/externs.h"
#include "compiler/backend/text/model.h"
#include "compiler/backend/text/operation.h"
#include "compiler/backend/text/rule.h"
#include "compiler/source/diagnostic.h"
#include "compiler/syntax/format.h"
#include "compiler/syntax/parse.h"

namespace jrule::text {

namespace {

using ModelerPtr = std::shared_ptr<ir::Modeler const>;

tl::unexpected<Unspellable> unspellable(std::string reason) { return tl::unexpected(Unspellable{std::move(reason)}); }

// ---- Names ----

/// Reserved words have this shape too: those the parser finds.
bool has_shape_of_a_name(std::string const& text) {
  auto const is = [](auto test) { return [test](char c) { return c == '_' || test(static_cast<unsigned char>(c)) != 0; }; };
  bool const plain = std::all_of(text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 128; });
  return plain && !text.empty() && is([](int c) { return std::isalpha(c); })(text[0]) &&
         std::all_of(text.begin(), text.end(), is([](int c) { return std::isalnum(c); }));
}

/// The first name that is none; null if all are.
std::string const* find_bad_name(std::vector<ModelerPtr> const& modelers, ir::Program const& program, Externs const& externs) {
  auto const bad = [](auto const& things) -> std::string const* {
    auto const found = std::find_if(things.begin(), things.end(), [](auto const& t) { return !has_shape_of_a_name(t.name); });
    return found == things.end() ? nullptr : &found->name;
  };
  for (ModelerPtr const& modeler : modelers) {
    if (!has_shape_of_a_name(modeler->model.name)) return &modeler->model.name;
    if (!is_bare(*modeler) && !has_shape_of_a_name(modeler->name)) return &modeler->name;
    if (auto const* name = bad(modeler->embeddings)) return name;
  }
  for (auto const& type : externs.types) {
    if (!has_shape_of_a_name(type->name)) return &type->name;
  }
  for (auto const& function : externs.functions) {
    if (!has_shape_of_a_name(function->name)) return &function->name;
    if (auto const* name = bad(function->parameters)) return name;
  }
  for (ir::Operation const& operation : program.operations) {
    if (auto const* name = bad(operation.variables)) return name;
  }
  for (ir::RuleScheme const& rule : program.rules) {
    if (auto const* name = bad(rule.nodes)) return name;
    if (auto const* name = bad(rule.parameters)) return name;
    if (auto const* name = bad(rule.lets)) return name;
  }
  return nullptr;
}

/// `sew_2` for the instance `sew[2]`: names of items hold no brackets.
std::string item_name(std::string const& name) {
  std::string text = name;
  if (text.ends_with(']')) {
    text.pop_back();
    std::replace_if(text.begin(), text.end(), [](char c) { return c == '[' || c == ','; }, '_');
  }
  std::replace(text.begin(), text.end(), '.', '_');
  return text;
}

/// The names of rules or operations, all different; none, if an item has the name of another one.
template <class Item>
Spelled<std::vector<std::string>> name_items(std::vector<Item> const& items, std::set<std::string>& taken) {
  std::vector<std::string> names(items.size());
  for (bool const instances : {false, true}) {
    for (std::size_t i = 0; i < items.size(); ++i) {
      std::string name = item_name(items[i].name);
      if ((name != items[i].name) != instances) continue;
      if (!has_shape_of_a_name(name)) return unspellable(fmt::format("`{}` is no name of the language", items[i].name));
      while (instances && taken.contains(name)) name += '_';
      if (!taken.insert(name).second) return unspellable(fmt::format("two items are called `{}`", name));
      names[i] = std::move(name);
    }
  }
  return names;
}

// ---- Modelers ----

bool same(ir::Modeler const& a, ir::Modeler const& b) {
  return a.name == b.name && a.model == b.model && a.embeddings == b.embeddings && a.module == b.module;
}

/// All modelers of the program, each once: its own, then those that only its rules and operations name.
std::vector<ModelerPtr> modelers_of(ir::Program const& program) {
  std::vector<ModelerPtr> all = program.modelers;
  auto const add = [&](ModelerPtr const& modeler) {
    if (std::none_of(all.begin(), all.end(), [&](ModelerPtr const& m) { return same(*m, *modeler); })) all.push_back(modeler);
  };
  for (ir::RuleScheme const& rule : program.rules) {
    add(rule.modeler);
  }
  for (ir::Operation const& operation : program.operations) add(operation.modeler);
  return all;
}

Spelled<std::string> spell_policies(ir::Modeler const& modeler, std::size_t e) {
  static constexpr std::string_view merges[] = {"", "first", "mean", "min", "max"};  // as MergePolicy
  EmbeddingSpec const& embedding = modeler.embeddings[e];
  ir::EmbeddingExterns const externs = modeler.externs_of(e);
  std::string text;
  if (embedding.default_value && ir::ExprType{type_of(*embedding.default_value)} != modeler.value_type(e)) {
    return unspellable(fmt::format("the default of `{}` has another type", embedding.name));
  }
  if (embedding.default_value) text += fmt::format(" default {};", spell_constant(*embedding.default_value));
  if (externs.default_value) {
    auto const value = spell(*externs.default_value, ir::RuleScheme{}, algebra::Group(modeler.model), 0, modeler.value_type(e));
    if (!value) return value;
    text += fmt::format(" default {};", *value);
  }
  if (externs.merge) {
    text += fmt::format(" merge {};", externs.merge->name);
  } else if (embedding.merge != MergePolicy::none) {
    text += fmt::format(" merge {};", merges[static_cast<std::size_t>(embedding.merge)]);
  }
  return text.empty() ? ";" : fmt::format(" {{{} }}", text);
}

Spelled<std::string> spell_modeler(ir::Modeler const& modeler, ModelDeclarations const& models) {
  auto const doc = spell_documentation(modeler.doc, "");
  if (!doc) return doc;
  std::string text = fmt::format("{}modeler {} on {}", *doc, modeler.name, spell(modeler.model, models));
  if (modeler.embeddings.empty()) return text + ";\n\n";
  text += " {\n";
  for (std::size_t i = 0; i < modeler.embeddings.size(); ++i) {
    EmbeddingSpec const& embedding = modeler.embeddings[i];
    auto const lines = spell_documentation(i < modeler.embedding_docs.size() ? modeler.embedding_docs[i] : "", "  ");
    if (!lines) return lines;
    auto const policies = spell_policies(modeler, i);
    if (!policies) return policies;
    text += fmt::format("{}  embedding {} : {} -> {}{}\n", *lines, embedding.name, spell(embedding.orbit), to_string(modeler.value_type(i)),
                        *policies);
  }
  return text + "}\n\n";
}

// ---- The file ----

/// The text in canonical layout, if it is one of the language: reserved words and the parser's limits are found here.
Spelled<std::string> canonical(std::string text) {
  source::Sources sources;
  source::Diagnostics diagnostics;
  syntax::parse(sources, sources.add("", text), diagnostics);
  if (diagnostics.has_errors()) return unspellable(diagnostics.sorted().front().message);
  return syntax::format(text);
}

}  // namespace

Spelled<std::string> print_jrule(ir::Program const& program) {
  std::vector<ModelerPtr> const modelers = modelers_of(program);
  if (modelers.empty()) return unspellable("there is no modeler and no rule, and a file has at least one item");
  Externs const externs = externs_of(modelers, program);
  if (auto const* name = find_bad_name(modelers, program, externs)) return unspellable(fmt::format("`{}` is no name of the language", *name));
  auto const models = declare_models(modelers);
  if (!models) return tl::unexpected(models.error());

  std::string text;
  std::set<std::string> taken;
  auto const add_externs = [&](auto const& items) -> std::optional<Unspellable> {
    for (auto const& item : items) {
      if (!taken.insert(item->name).second) return Unspellable{fmt::format("two items are called `{}`", item->name)};
      auto const spelled = spell(*item);
      if (!spelled) return spelled.error();
      text += *spelled;
    }
    return {};
  };
  if (auto fault = add_externs(externs.types)) return tl::unexpected(std::move(*fault));
  if (auto fault = add_externs(externs.functions)) return tl::unexpected(std::move(*fault));
  for (auto const& [name, declaration] : *models) {
    if (!declaration.text.empty() && !taken.insert(name).second) return unspellable(fmt::format("two items are called `{}`", name));
    text += declaration.text;
  }
  for (ModelerPtr const& modeler : modelers) {
    if (is_bare(*modeler)) continue;
    if (!taken.insert(modeler->name).second) return unspellable(fmt::format("two items are called `{}`", modeler->name));
    auto const item = spell_modeler(*modeler, *models);
    if (!item) return item;
    text += *item;
  }
  auto const rules = name_items(program.rules, taken);
  if (!rules) return tl::unexpected(rules.error());
  auto const operations = name_items(program.operations, taken);
  if (!operations) return tl::unexpected(operations.error());
  ItemNames const names{*rules, *operations};
  auto const on = [&](ir::Modeler const& modeler) { return is_bare(modeler) ? spell(modeler.model, *models) : modeler.name; };
  for (std::size_t i = 0; i < program.rules.size(); ++i) {
    auto const item = spell_rule(program.rules[i], names.rules[i], on(*program.rules[i].modeler));
    if (!item) return item;
    text += *item;
  }
  for (std::size_t i = 0; i < program.operations.size(); ++i) {
    auto const item = spell_operation(program, i, names, on(*program.operations[i].modeler));
    if (!item) return item;
    text += *item;
  }
  return canonical(std::move(text));
}

Spelled<std::string> print_jrule(ir::RuleScheme const& rule) { return print_jrule(ir::Program{rule.module, {}, {rule}}); }

}  // namespace jrule::text
