#include <fmt/format.h>
#include <fmt/ranges.h>

#include "compiler/backend/cpp/function.h"
#include "compiler/backend/cpp/sections.h"
#include "compiler/backend/cpp/text.h"

namespace jrule::cpp {

namespace {

std::string hook_type(ir::RuleScheme const& rule) {
  OrbitType type;
  for (Letter const letter : rule.hook_type) type.words.push_back({letter});
  return jrule::to_string(type);
}

std::string role(Function const& f, ir::Node const& node) {
  if (node.hook) return *node.hook == 0 ? "hook " + hook_type(f.rule) : "hook";
  return node.added() ? "added" : "kept";
}

// The first line of a documentation comment, to stand behind a few words; empty if there is none.
std::string remark(std::string const& doc) {
  auto const lines = documentation(doc);
  return lines.empty() ? "" : ": " + lines.front();
}

void declare_result(Writer& out, Function const& f) {
  out.line("/// The darts of the right side of `{}`{}.", f.rule.name, f.rule.hooks.empty() ? "" : ", as copied for the dart that the first hook is given");
  out.open("struct {} {{", f.names.result);
  std::vector<std::string> members;
  for (ir::NodeId id = 0; id < f.rule.nodes.size(); ++id) {
    ir::Node const& node = f.node(id);
    if (node.deleted()) continue;
    members.push_back(f.members[id]);
    out.line("jrule::Dart {} = jrule::no_dart;  ///< {}{}", f.members[id], role(f, node), remark(node.doc));
  }
  if (!members.empty() && !f.rule.hooks.empty()) {
    out.line("/// The same for every dart of the pattern, in one order for all nodes.");
    out.open("struct Copies {{");
    out.line("std::vector<jrule::Dart> {};", fmt::join(members, ", "));
    out.close("} copies;");
  }
  out.close("};");
}

// "Surface& surface, jrule::Dart a, jrule::Point3 apex".
std::string parameter_list(Function const& f, bool hooks, Defaults defaults, bool mark_unused) {
  std::vector<std::string> list{fmt::format("{}& {}", f.names.modeler, f.modeler)};
  if (hooks) {
    for (std::string const& hook : f.hooks) list.push_back("jrule::Dart " + hook);
  }
  // C++ has defaults only at the end.
  std::size_t first_default = f.parameters.size();
  while (first_default > 0 && f.rule.parameters[first_default - 1].default_value) --first_default;
  for (std::size_t p = 0; p < f.parameters.size(); ++p) {
    ir::Parameter const& parameter = f.rule.parameters[p];
    std::string text = fmt::format("{} {}", type_name(parameter.type), f.parameters[p]);
    if (defaults == Defaults::with && p >= first_default) text += " = " + literal(*parameter.default_value);
    if (mark_unused && !f.uses_parameter[p]) text.insert(0, "[[maybe_unused]] ");
    list.push_back(std::move(text));
  }
  return fmt::format("{}", fmt::join(list, ", "));
}

void define_everywhere(Writer& out, Function const& f) {
  OrbitType type;
  for (Letter const letter : f.rule.hook_type) type.words.push_back({letter});
  std::string const &orbit = f.local("orbit"), &applied = f.local("applied");
  std::vector<std::string> arguments{f.modeler, f.hooks[0]};
  arguments.insert(arguments.end(), f.parameters.begin(), f.parameters.end());
  out.line();
  out.open("jrule::Result<std::size_t> {}({}) try {{", f.names.everywhere, parameter_list(f, false, Defaults::without, false));
  out.line("static jrule::OrbitType const {} = {};", orbit, orbit_expression(type));
  out.open("return jrule::rewrite::apply_everywhere({}.map(), {}, [&](jrule::Dart {}) -> jrule::Result<void> {{", f.modeler, orbit, f.hooks[0]);
  out.line("auto const {} = {}({});", applied, f.names.function, fmt::join(arguments, ", "));
  out.line("if (!{0}) return tl::unexpected({0}.error());", applied);
  out.line("return {{}};");
  out.close("});");
  out.close(fmt::format("}} catch (std::bad_alloc const&) {{"));
}

void declare_catch(Writer& out, Function const& f) {
  out.line("  return tl::unexpected(jrule::rewrite::no_memory({}));", literal(f.rule.name));
  out.line("}}{}", "");
}

}  // namespace

std::string declare(Function const& f) {
  Writer out;
  declare_result(out, f);
  out.line();
  for (std::string const& line : documentation(f.rule.doc)) out.line("/// {}", line);
  return out.text();
}

}  // namespace jrule::cpp
