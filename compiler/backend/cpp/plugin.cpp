#include "compiler/backend/cpp/plugin.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "compiler/backend/cpp/expression.h"
#include "compiler/backend/cpp/module_names.h"
#include "compiler/backend/cpp/text.h"
#include "compiler/backend/cpp/writer.h"

namespace jrule::cpp {

namespace {

// One line of a table: text for people, without the ends of its lines' layout.
std::string doc_literal(std::string const& doc) {
  return literal(fmt::format("{}", fmt::join(documentation(doc), "\n")));
}

std::string type_code(Type type) {
  std::string code = "JRULE_" + (type == Type::Extern ? "EXTERN" : to_string(type));
  std::transform(code.begin(), code.end(), code.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return code;
}

// The last two members of an embedding or a parameter.
std::string default_members(std::optional<Value> const& value, bool computed) {
  if (computed) return "JRULE_COMPUTED_DEFAULT, {}";
  if (!value) return "JRULE_NO_DEFAULT, {}";
  Type const type = type_of(*value);
  std::string integer = "0", numbers;
  if (auto const* b = std::get_if<bool>(&*value)) {
    integer = *b ? "1" : "0";
  } else if (std::holds_alternative<std::int64_t>(*value)) {
    integer = literal(*value);
  } else {
    for (int k = 0; k < component_count(type); ++k) numbers += (k == 0 ? "" : ", ") + literal(component(*value, k));
  }
  return fmt::format("JRULE_VALUE_DEFAULT, {{{}, 0, {}, {{{}}}}}", type_code(type), integer, numbers);
}

// A further hook is written with dimensions of its own, which its loops have: m(u·o, b) = m(u, b)·d.
std::string hook_orbit(ir::RuleScheme const& rule, ir::NodeId hook) {
  OrbitType type;
  for (Letter const letter : rule.hook_type) {
    Letter own = letter;
    for (ir::Arc const& arc : rule.left.arcs) {
      if (arc.source != hook || arc.target != hook || arc.word.size() != 1) continue;
      if (arc.word.front() == letter) own = {static_cast<std::uint8_t>(arc.dimension), false};
    }
    type.words.push_back({own});
  }
  return jrule::to_string(type);
}

std::string not_callable(std::vector<ir::Parameter> const& parameters) {
  for (ir::Parameter const& parameter : parameters) {
    if (parameter.external)
      return literal(
          fmt::format("its parameter `{}` is of the C++ type `{}`", parameter.name, parameter.external->name));
  }
  return "nullptr";
}

bool is_callable(std::vector<ir::Parameter> const& parameters) {
  return std::none_of(parameters.begin(), parameters.end(),
                      [](ir::Parameter const& p) { return p.external != nullptr; });
}

// An array of a table; none, but a null pointer, if it has no elements.
struct Array {
  std::string type, name;
  std::vector<std::string> elements;
  std::string reference() const { return elements.empty() ? "nullptr" : name; }
};

void write(Writer& out, Array const& array) {
  if (array.elements.empty()) return;
  out.open("constexpr {} {}[] = {{", array.type, array.name);
  for (std::string const& element : array.elements) out.text(element + ',');
  out.close("};");
}

struct PluginRule {
  Function function;
  std::string name_space;
  std::string modeler;  // "::surface::Surface"
  std::size_t modeler_index;
  std::string module;
};

struct PluginOperation {
  ir::Operation const* operation;
  std::string function;  // "::surface::house"
  std::string modeler;
  std::size_t modeler_index;
  std::string module;
};

struct PluginModeler {
  ir::Modeler const* modeler;
  std::string name;
};

// "std::get<jrule::Point3>(arguments[0])".
std::string argument(ir::Parameter const& parameter, std::size_t p) {
  return fmt::format("std::get<{}>(arguments[{}])", type_name(parameter.type), p);
}

void write_call(Writer& out, PluginRule const& rule, bool everywhere) {
  Function const& f = rule.function;
  std::vector<std::string> arguments{fmt::format("as<{}>(map)", rule.modeler)};
  if (!everywhere) {
    for (std::size_t h = 0; h < f.hooks.size(); ++h) arguments.push_back(fmt::format("hooks[{}]", h));
  }
  for (std::size_t p = 0; p < f.parameters.size(); ++p) arguments.push_back(argument(f.rule.parameters[p], p));
  out.line("{} ::{}::{}({});", everywhere ? "return" : "auto const applied =", rule.name_space,
           everywhere ? f.names.everywhere : f.names.function, fmt::join(arguments, ", "));
}

void write_apply(Writer& out, PluginRule const& rule, std::size_t number) {
  Function const& f = rule.function;
  out.line();
  out.line("// {}: `{}`.", rule.module, f.rule.name);
  out.open(
      "Result<void> apply_{}(AnyMap& map, [[maybe_unused]] Dart const* hooks, [[maybe_unused]] Value const* arguments, "
      "[[maybe_unused]] Dart* darts) {{",
      number);
  write_call(out, rule, false);
  out.line("if (!applied) return tl::unexpected(applied.error());");
  std::size_t node = 0;
  for (std::string const& member : f.members) {
    if (!member.empty()) out.line("darts[{}] = applied->{};", node++, member);
  }
  out.line("return {{}};");
  out.close();
  if (!f.independent) return;
  out.open("Result<void> apply_{}_at_once(AnyMap& map, [[maybe_unused]] Value const* arguments) {{", number);
  write_call(out, rule, true);
  out.close();
}

void write_computed_defaults(Writer& out, std::vector<ir::Parameter> const& parameters, std::size_t number) {
  out.open("Value computed_default_{}(std::size_t parameter) {{", number);
  for (std::size_t p = 0; p < parameters.size(); ++p) {
    ir::Parameter const& parameter = parameters[p];
    if (parameter.computed_default) {
      out.line("if (parameter == {}) return Value(std::in_place_type<{}>, {});", p, type_name(parameter.type),
               constant_expression(*parameter.computed_default));
    }
  }
  out.line("throw std::out_of_range(\"no computed default\");");
  out.close();
}

bool has_computed_default(std::vector<ir::Parameter> const& parameters) {
  return std::any_of(parameters.begin(), parameters.end(),
                     [](ir::Parameter const& p) { return p.computed_default != nullptr; });
}

// A RuleCode; the functions that it names are written before.
std::string write_code(Writer& out, PluginRule const& rule, std::size_t number) {
  Function const& f = rule.function;
  if (!is_callable(f.rule.parameters)) return "{}";
  write_apply(out, rule, number);
  if (has_computed_default(f.rule.parameters)) write_computed_defaults(out, f.rule.parameters, number);
  return fmt::format("{{apply_{}, {}, {}, {}}}", number,
                     f.independent ? fmt::format("apply_{}_at_once", number) : "nullptr",
                     f.rule.hooks.size() == 1 ? fmt::format("[] {{ return {}; }}", orbit_expression(f.rule.hook_orbit())) : "nullptr",
                     has_computed_default(f.rule.parameters) ? fmt::format("computed_default_{}", number) : "nullptr");
}

// A jrule_modeler; its embeddings are written before.
std::string write_modeler(Writer& out, ir::Modeler const& modeler, std::size_t number) {
  Array embeddings{"jrule_embedding", fmt::format("embeddings_{}", number), {}};
  for (std::size_t e = 0; e < modeler.embeddings.size(); ++e) {
    EmbeddingSpec const& spec = modeler.embeddings[e];
    std::string const doc = e < modeler.embedding_docs.size() ? modeler.embedding_docs[e] : "";
    embeddings.elements.push_back(fmt::format(
        "{{{}, {}, {}, {}, {}}}", literal(spec.name), doc_literal(doc), literal(jrule::to_string(spec.orbit)),
        type_code(spec.type), default_members(spec.default_value, modeler.externs_of(e).default_value != nullptr)));
  }
  write(out, embeddings);
  return fmt::format("{{{}, {}, {}, {}, {}, {}, {}}}", literal(modeler.name), literal(modeler.module),
                     doc_literal(modeler.doc), literal(modeler.model.name), modeler.model.dimension,
                     embeddings.elements.size(), embeddings.reference());
}

Array parameter_array(std::vector<ir::Parameter> const& all, std::size_t number) {
  Array parameters{"jrule_parameter", fmt::format("parameters_{}", number), {}};
  for (ir::Parameter const& p : all) {
    parameters.elements.push_back(fmt::format("{{{}, {}, {}, {}, {}}}", literal(p.name), doc_literal(p.doc),
                                              literal(p.unit), type_code(p.type),
                                              default_members(p.default_value, p.computed_default != nullptr)));
  }
  return parameters;
}

// The parameters that are values.
std::vector<ir::Parameter> value_parameters(ir::Operation const& operation) {
  std::vector<ir::Parameter> values = operation.parameters;
  std::erase_if(values, [](ir::Parameter const& p) { return p.dart; });
  return values;
}

// A jrule_rule that is an operation; what it points to is written before.
std::string write_operation(Writer& out, PluginOperation const& entry, std::size_t number) {
  ir::Operation const& operation = *entry.operation;
  Array darts{"jrule_hook", fmt::format("hooks_{}", number), {}}, nodes{"jrule_node", fmt::format("nodes_{}", number), {}};
  for (ir::Parameter const& p : operation.parameters) {
    if (p.dart) darts.elements.push_back(fmt::format("{{{}, {}, {}}}", literal(p.name), doc_literal(p.doc), literal("<>")));
  }
  Array const parameters = parameter_array(value_parameters(operation), number);
  if (operation.result == ir::dart_type) nodes.elements.push_back("{\"result\", \"\"}");
  for (Array const* array : {static_cast<Array const*>(&darts), &parameters, static_cast<Array const*>(&nodes)}) write(out, *array);
  return fmt::format("{{{}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}}}", literal(operation.name), literal(entry.module), doc_literal(operation.doc),
                     not_callable(operation.parameters), entry.modeler_index, darts.elements.size(), darts.reference(), parameters.elements.size(),
                     nodes.elements.size(), parameters.reference(), nodes.reference());
}

// A RuleCode of an operation; the functions that it names are written before.
std::string write_operation_code(Writer& out, PluginOperation const& entry, std::size_t number) {
  ir::Operation const& operation = *entry.operation;
  if (!is_callable(operation.parameters)) return "{}";
  std::vector<ir::Parameter> const values = value_parameters(operation);
  std::vector<std::string> list{fmt::format("as<{}>(map)", entry.modeler)};
  std::size_t dart = 0, value = 0;
  for (ir::Parameter const& p : operation.parameters) {
    list.push_back(p.dart ? fmt::format("darts[{}]", dart++) : argument(p, value++));
  }
  list.push_back("progress");
  out.line();
  out.line("// {}: the operation `{}`.", entry.module, operation.name);
  out.open("Result<void> run_{}(AnyMap& map, [[maybe_unused]] Dart const* darts, [[maybe_unused]] Value const* arguments, "
           "operation::Progress const& progress, [[maybe_unused]] Dart* result) {{", number);
  out.line("auto const done = {}({});", entry.function, fmt::join(list, ", "));
  out.line("if (!done) return tl::unexpected(done.error());");
  if (operation.result == ir::dart_type) out.line("*result = *done;");
  out.line("return {{}};");
  out.close();
  if (has_computed_default(values)) write_computed_defaults(out, values, number);
  return fmt::format("{{nullptr, nullptr, nullptr, {}, run_{}}}", has_computed_default(values) ? fmt::format("computed_default_{}", number) : "nullptr", number);
}

// A jrule_rule; what it points to is written before.
std::string write_rule(Writer& out, PluginRule const& entry, std::size_t number) {
  ir::RuleScheme const& rule = entry.function.rule;
  Array hooks{"jrule_hook", fmt::format("hooks_{}", number), {}};
  for (ir::NodeId const hook : rule.hooks) {
    ir::Node const& node = rule.nodes[hook];
    hooks.elements.push_back(
        fmt::format("{{{}, {}, {}}}", literal(node.name), doc_literal(node.doc), literal(hook_orbit(rule, hook))));
  }
  Array const parameters = parameter_array(rule.parameters, number);
  Array nodes{"jrule_node", fmt::format("nodes_{}", number), {}};
  for (ir::Node const& node : rule.nodes) {
    if (!node.deleted()) nodes.elements.push_back(fmt::format("{{{}, {}}}", literal(node.name), doc_literal(node.doc)));
  }
  for (Array const* array : {static_cast<Array const*>(&hooks), &parameters, static_cast<Array const*>(&nodes)}) write(out, *array);
  return fmt::format("{{{}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}}}", literal(rule.name), literal(entry.module),
                     doc_literal(rule.doc), not_callable(rule.parameters), entry.modeler_index, hooks.elements.size(),
                     hooks.reference(), parameters.elements.size(), nodes.elements.size(), parameters.reference(),
                     nodes.reference());
}

struct PluginTables {
  std::vector<PluginModeler> modelers;
  std::vector<PluginRule> rules;
  std::vector<PluginOperation> operations;

  // Modules share the modelers that they import.
  std::size_t add(ir::Modeler const& modeler, Class const& in_cpp) {
    std::string const name = fmt::format("::{}::{}", in_cpp.name_space, in_cpp.name);
    for (std::size_t m = 0; m < modelers.size(); ++m) {
      if (modelers[m].name == name) return m;
    }
    modelers.push_back({&modeler, name});
    return modelers.size() - 1;
  }

  void add(PluginModule const& module, Options const& options) {
    ModuleNames const names = name_module(module.program, module.rules, options, module.diagnostics);
    for (Class const& c : names.classes) add(*c.modeler, c);
    Scope scope;
    for (std::string const& name : names.taken) scope.reserve(name);
    for (std::size_t i = 0; i < module.rules.size(); ++i) {
      std::size_t const modeler =
          add(*module.rules[i].scheme->modeler, names.class_of(*module.rules[i].scheme->modeler));
      rules.push_back({Function(module.rules[i], module.sources, names.rules[i], scope), names.name_space,
                       modelers[modeler].name, modeler, module.program.module});
    }
    for (std::size_t i = 0; i < module.program.operations.size(); ++i) {
      ir::Operation const& operation = module.program.operations[i];
      std::size_t const modeler = add(*operation.modeler, names.class_of(*operation.modeler));
      operations.push_back({&operation, fmt::format("::{}::{}", names.name_space, names.operations[i].function), modelers[modeler].name, modeler,
                            module.program.module});
    }
  }

  std::string write_all(std::string const& plugin) const {
    Writer out;
    Array modeler_table{"jrule_modeler", "modelers", {}};
    Array modeler_codes{"ModelerCode", "modeler_codes", {}};
    for (std::size_t m = 0; m < modelers.size(); ++m) {
      modeler_table.elements.push_back(write_modeler(out, *modelers[m].modeler, m));
      modeler_codes.elements.push_back(fmt::format("modeler_code<{}>", modelers[m].name));
    }
    Array rule_table{"jrule_rule", "rules", {}};
    Array rule_codes{"RuleCode", "rule_codes", {}};
    for (std::size_t r = 0; r < rules.size(); ++r) rule_table.elements.push_back(write_rule(out, rules[r], r));
    for (std::size_t r = 0; r < rules.size(); ++r) rule_codes.elements.push_back(write_code(out, rules[r], r));
    for (std::size_t o = 0; o < operations.size(); ++o) rule_table.elements.push_back(write_operation(out, operations[o], rules.size() + o));
    for (std::size_t o = 0; o < operations.size(); ++o) rule_codes.elements.push_back(write_operation_code(out, operations[o], rules.size() + o));
    out.line();
    for (Array const* array : {&modeler_table, &modeler_codes, &rule_table, &rule_codes}) write(out, *array);
    auto const span = [](Array const& array) { return array.elements.empty() ? "{}" : array.name; };
    out.line("constexpr Table table{{{}, {}, {}, {}, {}, {}}};", literal(plugin), span(modeler_table), span(modeler_codes),
             span(rule_table), span(rule_codes), rules.size());
    return out.all();
  }
};

}  // namespace

std::optional<GeneratedFile> emit_plugin(std::string const& name, std::vector<PluginModule> const& modules,
                                         Options const& options) {
  PluginTables tables;
  for (PluginModule const& module : modules) {
    std::size_t const errors_before = module.diagnostics.error_count();
    tables.add(module, options);
    if (module.diagnostics.error_count() != errors_before) return {};
  }

  Writer out;
  std::vector<std::string> files;
  for (PluginModule const& module : modules) files.push_back(module.program.module + ".jrule");
  out.line("// Generated by jrule from {}: changes will be lost.", fmt::join(files, ", "));
  out.line("#include <cstddef>");
  out.line("#include <cstdint>");
  out.line("#include <limits>");
  out.line("#include <stdexcept>");
  out.line("#include <utility>");
  out.line("#include <variant>");
  out.line();
  out.line("#include <jrule/plugin_support.h>");
  out.line();
  for (PluginModule const& module : modules) {
    out.line("#include \"{}{}.h\"", options.header_prefix.empty() ? "" : options.header_prefix + "/",
             module.program.module);
  }
  out.line();
  out.line("namespace jrule::plugin {{");
  out.line("namespace {{");
  out.line();
  out.lines(tables.write_all(name));
  out.line();
  out.line("}}  // namespace");
  out.line("}}  // namespace jrule::plugin");
  out.line();
  out.line("extern \"C\" {{");
  out.line("extern JRULE_PLUGIN_EXPORT jrule_plugin const jrule_plugin_entry;");
  out.line("constinit jrule_plugin const jrule_plugin_entry = jrule::plugin::entry<jrule::plugin::table>();");
  out.line("}}");
  return GeneratedFile{name + "_plugin.cpp", out.all()};
}

}  // namespace jrule::cpp
