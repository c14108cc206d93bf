#include "compiler/backend/cpp/emit.h"

#include <fmt/format.h>

#include <map>
#include <optional>
#include <set>

#include "compiler/backend/cpp/externs.h"
#include "compiler/backend/cpp/function.h"
#include "compiler/backend/cpp/modeler.h"
#include "compiler/backend/cpp/text.h"
#include "compiler/backend/cpp/writer.h"

namespace jrule::cpp {

namespace {

using source::Code;

struct Class {
  ir::Modeler const* modeler;
  std::string name_space;
  std::string name;
};

struct Emission {
  ir::Program const& program;
  source::Sources const& sources;
  Options const& options;
  source::Diagnostics& diagnostics;

  std::string name_space{};
  std::vector<Class> classes{};
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
    name_space = place(program.module);
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
    for (Class const& known : classes) {
      if (known.modeler->name == modeler.name && known.modeler->module == modeler.module) return;
    }
    bool const bare = modeler.module.empty();
    Class added{&modeler, bare ? name_space : place(modeler.module), identifier(modeler.name)};
    if (bare) added.name = camel_case(added.name);
    // A class of that name would hide the namespaces that its own members need.
    for (char const* needed : {"std", "jrule", "tl"}) {
      if (added.name == needed) added.name += '_';
    }
    if (added.name_space == name_space) {
      take(added.name, fmt::format("the modeler `{}`", modeler.name),
           modeler.embedding_spans.empty() ? source::Span{} : modeler.embedding_spans.front());
    }
    classes.push_back(std::move(added));
  }

  Class const& class_of(ir::Modeler const& modeler) const {
    for (Class const& known : classes) {
      if (known.modeler->name == modeler.name && known.modeler->module == modeler.module) return known;
    }
    return classes.front();  // not reached: every rule's modeler was added
  }

  PublicNames name(ir::RuleScheme const& rule) {
    PublicNames names;
    // "Terrain.quad" gives "terrain_quad".
    std::size_t const dot = rule.name.find('.');
    names.function = dot == std::string::npos ? identifier(rule.name) : identifier(snake_case(rule.name.substr(0, dot)) + "_" + rule.name.substr(dot + 1));
    std::string const what = fmt::format("the rule `{}`", rule.name);
    source::Span const place = rule.import ? *rule.import : rule.span;
    if (std::string_view const why = unusable(rule.name.substr(0, rule.name.find('['))); !why.empty()) {
      report(place, fmt::format("{} cannot be a C++ function: its name {}", what, why));
    }
    names.result = camel_case(names.function) + "Result";
    if (rule.hooks.size() == 1) names.everywhere = names.function + "_everywhere";
    for (std::string const& taken_name : {names.function, names.everywhere, names.result}) {
      if (!taken_name.empty()) take(taken_name, what, place);
    }
    Class const& on = class_of(*rule.modeler);
    names.class_name = on.name;
    names.modeler = on.name_space == name_space ? on.name : fmt::format("::{}::{}", on.name_space, on.name);
    return names;
  }

  std::string title() const {
    return fmt::format("// Generated by jrule from {}.jrule: changes will be lost.", program.module);
  }

  void write_class(Writer& out, Class const& c) {
    std::string guard = "JRULE_MODELER";
    for (char const ch : "_" + c.name_space + "_" + c.name) {
      if (ch != ':')
        guard += static_cast<char>(std::toupper(static_cast<unsigned char>(ch)));
      else if (guard.back() != '_')
        guard += '_';
    }
    out.line();
    out.line("// The header of every module that uses the modeler defines it.");
    out.line("#ifndef {}", guard);
    out.line("#define {}", guard);
    out.line("namespace {} {{", c.name_space);
    out.line();
    out.lines(modeler_class(*c.modeler, c.name, diagnostics));
    out.line();
    out.line("}}  // namespace {}", c.name_space);
    out.line("#endif");
  }

  std::vector<GeneratedFile> run(std::vector<Rule> const& rules) {
    std::size_t const errors_before = diagnostics.error_count();
    choose_namespace();
    for (auto const& modeler : program.modelers) add_class(*modeler);
    for (Rule const& rule : rules) add_class(*rule.scheme->modeler);
    std::vector<PublicNames> names;
    for (Rule const& rule : rules) names.push_back(name(*rule.scheme));

    Writer header;
    header.line("{}", title());
    header.line("#pragma once");
    header.line();
    for (char const* file : {"cstddef", "cstdint", "limits", "optional", "span", "string", "utility", "vector"})
      header.line("#include <{}>", file);
    header.line();
    for (char const* file : {"bulk", "io", "map", "result", "rewrite", "trial", "typed", "value"})
      header.line("#include <jrule/{}.h>", file);
    std::set<std::string> outside;
    for (Class const& c : classes) add_headers(*c.modeler, outside, diagnostics);
    for (Rule const& rule : rules) add_headers(*rule.scheme, outside, diagnostics);
    if (!outside.empty()) header.line();
    for (std::string const& file : outside) header.line("#include \"{}\"", file);
    for (Class const& c : classes) write_class(header, c);

    Writer code;
    code.line("{}", title());
    code.line("#include \"{}{}.h\"", options.header_prefix.empty() ? "" : options.header_prefix + "/", program.module);
    code.line();
    for (char const* file : {"cmath", "new", "stdexcept"}) code.line("#include <{}>", file);

    for (Writer* out : {&header, &code}) {
      out->line();
      out->line("namespace {} {{", name_space);
    }
    Scope scope;
    for (auto const& [name, what] : taken) scope.reserve(name);
    for (std::size_t i = 0; i < rules.size(); ++i) {
      Function const function(rules[i], sources, names[i], scope);
      header.line();
      header.lines(declare(function));
      code.line();
      code.lines(define(function));
    }
    for (Writer* out : {&header, &code}) {
      out->line();
      out->line("}}  // namespace {}", name_space);
    }
    if (diagnostics.error_count() != errors_before) return {};
    return {{program.module + ".h", header.all()}, {program.module + ".cpp", code.all()}};
  }
};

}  // namespace

std::vector<GeneratedFile> emit(ir::Program const& program, std::vector<Rule> const& rules,
                                source::Sources const& sources, Options const& options,
                                source::Diagnostics& diagnostics) {
  return Emission{program, sources, options, diagnostics}.run(rules);
}

}  // namespace jrule::cpp
