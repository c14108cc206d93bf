#include "compiler/backend/cpp/module_names.h"

#include <fmt/format.h>

#include <map>
#include <set>
#include <utility>

namespace jrule::cpp {

namespace {

using source::Code;

struct Naming {
  ir::Program const& program;
  Options const& options;
  source::Diagnostics& diagnostics;

  ModuleNames names{};
  std::map<std::string, std::pair<std::string, source::Span>> taken{};  // names of the module's namespace, and of what

  std::string place(std::string const& module) const {
    return options.name_space.empty() ? namespace_of(module) : options.name_space;
  }

  void report(source::Span span, std::string message, std::vector<source::Label> labels = {}) {
    diagnostics.add({.code = Code::name_not_usable_in_cpp,
                     .span = span,
                     .message = std::move(message),
                     .labels = std::move(labels)});
  }

  void choose_namespace() {
    names.name_space = place(program.module);
    std::string_view rest = options.name_space;
    for (bool first = true; !rest.empty(); first = false) {
      std::size_t const end = rest.find("::");
      std::string_view const part = rest.substr(0, end);
      std::string why(unusable(part));
      if (part.empty() || identifier(part) != part) why = why.empty() ? "is not an identifier" : why;
      // Generated code has to reach these.
      if (part == "std" || (!first && (part == "jrule" || part == "tl")))
        why = "hides the namespace that generated code needs";
      if (!why.empty()) report({}, fmt::format("`{}` cannot be a namespace: `{}` {}", options.name_space, part, why));
      rest = end == std::string_view::npos ? std::string_view{} : rest.substr(end + 2);
      if (end != std::string_view::npos && rest.empty())
        report({}, fmt::format("`{}` cannot be a namespace", options.name_space));
    }
  }

  // Takes a name of the module's namespace; reports the rule or modeler if it cannot have it.
  void take(std::string const& name, std::string const& what, source::Span span) {
    auto const [known, fresh] = taken.try_emplace(name, what, span);
    if (fresh) return;
    std::vector<source::Label> labels;
    if (known->second.second.file != source::no_file)
      labels.push_back({known->second.second, fmt::format("{} has it first", known->second.first)});
    report(span, fmt::format("{} cannot be named in C++: `{}` is also a name of {}", what, name, known->second.first),
           std::move(labels));
  }

  void add_class(ir::Modeler const& modeler) {
    for (Class const& known : names.classes) {
      if (known.modeler->name == modeler.name && known.modeler->module == modeler.module) return;
    }
    bool const bare = modeler.module.empty();
    Class added{&modeler, bare ? names.name_space : place(modeler.module), identifier(modeler.name)};
    if (bare) added.name = camel_case(added.name);
    // A class of that name would hide the namespaces that its own members need.
    for (char const* needed : {"std", "jrule", "tl"}) {
      if (added.name == needed) added.name += '_';
    }
    if (added.name_space == names.name_space) {
      take(added.name, fmt::format("the modeler `{}`", modeler.name),
           modeler.embedding_spans.empty() ? source::Span{} : modeler.embedding_spans.front());
    }
    names.classes.push_back(std::move(added));
  }

  // Of a rule or operation: "Terrain.quad" gives "terrain_quad".
  std::string function_name(std::string const& name, std::string const& what, source::Span place) {
    if (std::string_view const why = unusable(name.substr(0, name.find('['))); !why.empty()) {
      report(place, fmt::format("{} cannot be a C++ function: its name {}", what, why));
    }
    std::size_t const dot = name.find('.');
    return dot == std::string::npos ? identifier(name) : identifier(snake_case(name.substr(0, dot)) + "_" + name.substr(dot + 1));
  }

  // The class that a rule or operation works on, as it is called here.
  std::string class_here(Class const& on) const {
    return on.name_space == names.name_space ? on.name : fmt::format("::{}::{}", on.name_space, on.name);
  }

  PublicNames name(ir::RuleScheme const& rule, bool within) {
    PublicNames result;
    std::string const what = fmt::format("the rule `{}`", rule.name);
    source::Span const place = rule.import ? *rule.import : rule.span;
    result.function = function_name(rule.name, what, place);
    if (within) result.within = result.function + "_within";
    result.result = camel_case(result.function) + "Result";
    if (rule.hooks.size() == 1) result.everywhere = result.function + "_everywhere";
    for (std::string const& taken_name : {result.function, result.everywhere, result.within, result.result}) {
      if (!taken_name.empty()) take(taken_name, what, place);
    }
    Class const& on = names.class_of(*rule.modeler);
    result.class_name = on.name;
    result.modeler = class_here(on);
    return result;
  }

  OperationPublicNames name(ir::Operation const& operation) {
    std::string const what = fmt::format("the operation `{}`", operation.name);
    source::Span const place = operation.import ? *operation.import : operation.span;
    Class const& on = names.class_of(*operation.modeler);
    std::string const function = function_name(operation.name, what, place);
    OperationPublicNames result{function, "run_" + function, class_here(on), on.name};
    take(result.function, what, place);
    take(result.run, what, place);
    return result;
  }

  ModuleNames run(std::vector<Rule> const& rules) {
    choose_namespace();
    for (auto const& modeler : program.modelers) add_class(*modeler);
    for (Rule const& rule : rules) add_class(*rule.scheme->modeler);
    for (ir::Operation const& operation : program.operations) add_class(*operation.modeler);
    std::set<ir::RuleScheme const*> within;
    for (std::size_t const rule : applied_within(program)) within.insert(&program.rules[rule]);
    for (Rule const& rule : rules) names.rules.push_back(name(*rule.scheme, within.contains(rule.scheme)));
    for (ir::Operation const& operation : program.operations) names.operations.push_back(name(operation));
    for (auto const& [name, what] : taken) names.taken.push_back(name);
    return std::move(names);
  }
};

}  // namespace

Class const& ModuleNames::class_of(ir::Modeler const& modeler) const {
  for (Class const& known : classes) {
    if (known.modeler->name == modeler.name && known.modeler->module == modeler.module) return known;
  }
  return classes.front();  // not reached: every rule's modeler was added
}

ModuleNames name_module(ir::Program const& program, std::vector<Rule> const& rules, Options const& options,
                        source::Diagnostics& diagnostics) {
  return Naming{program, options, diagnostics}.run(rules);
}

}  // namespace jrule::cpp
