#include <fmt/format.h>
#include <fmt/ranges.h>

#include "compiler/backend/cpp/expression.h"
#include "compiler/backend/cpp/function.h"
#include "compiler/backend/cpp/sections.h"
#include "compiler/backend/cpp/text.h"
#include "compiler/ir/extern_use.h"

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
  out.line("/// The darts of the right side of `{}`{}.", f.rule.name,
           f.rule.hooks.empty() ? "" : ", as copied for the dart that the first hook is given");
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

enum class Defaults { with, without };

std::string default_of(ir::Parameter const& parameter) {
  return parameter.default_value ? literal(*parameter.default_value) : constant_expression(*parameter.computed_default);
}

// "Surface& surface, jrule::Dart a, jrule::Point3 apex".
std::string parameter_list(Function const& f, bool hooks, Defaults defaults, bool mark_unused) {
  std::vector<std::string> list{fmt::format("{}& {}", f.names.modeler, f.modeler)};
  if (hooks) {
    for (std::string const& hook : f.hooks) list.push_back("jrule::Dart " + hook);
  }
  // C++ has defaults only at the end.
  std::size_t first_default = f.parameters.size();
  while (first_default > 0 && f.rule.parameters[first_default - 1].has_default()) --first_default;
  for (std::size_t p = 0; p < f.parameters.size(); ++p) {
    ir::Parameter const& parameter = f.rule.parameters[p];
    std::string text = fmt::format("{} {}", parameter_type(parameter.value_type()), f.parameters[p]);
    if (defaults == Defaults::with && p >= first_default) text += " = " + default_of(parameter);
    if (mark_unused && !f.uses_parameter[p]) text.insert(0, "[[maybe_unused]] ");
    list.push_back(std::move(text));
  }
  return fmt::format("{}", fmt::join(list, ", "));
}

void document(Writer& out, Function const& f, bool hooks) {
  if (hooks) {
    for (std::string const& line : documentation(f.rule.doc)) out.text(line.empty() ? "///" : "/// " + line);
  } else {
    out.line(
        "/// Applies `{}` once for each {}-orbit, in the order of their smallest darts; orbits where it is not "
        "applicable",
        f.names.function, hook_type(f.rule));
    out.line("/// stay as they are.");
  }
  out.line("///");
  out.line("/// {}", place(f.sources, f.rule.span));
  if (hooks) {
    for (std::size_t h = 0; h < f.hooks.size(); ++h) {
      ir::Node const& node = f.node(f.rule.hooks[h]);
      out.line("/// @param {}  {}{}", f.hooks[h], role(f, node), remark(node.doc));
    }
  }
  for (std::size_t p = 0; p < f.parameters.size(); ++p) {
    ir::Parameter const& parameter = f.rule.parameters[p];
    std::string const unit = parameter.unit.empty() ? "" : " in " + parameter.unit;
    std::string by_default;
    if (parameter.default_value) by_default = ", by default " + to_string(*parameter.default_value);
    if (parameter.computed_default) by_default = ", by default " + constant_expression(*parameter.computed_default);
    out.line("/// @param {}  {}{}{}{}", f.parameters[p], to_string(parameter.value_type()), unit, by_default, remark(parameter.doc));
  }
  if (ir::find_extern_use(f.rule)) {
    out.text(hooks ? "/// @throws what C++ from outside throws, and then nothing has changed; running out of memory is returned"
                   : "/// @throws what C++ from outside throws; what was applied before stays");
  }
  out.text(
      hooks ? "/// @return the darts of the right side; or why the rule is not applicable, and then nothing has changed"
            : "/// @return how often it was applied; the first refusal if nowhere, and then nothing has changed");
}

std::string signature(Function const& f, bool hooks, Defaults defaults, bool mark_unused) {
  return hooks ? fmt::format("jrule::Result<{}> {}({})", f.names.result, f.names.function,
                             parameter_list(f, true, defaults, mark_unused))
               : fmt::format("jrule::Result<std::size_t> {}({})", f.names.everywhere,
                             parameter_list(f, false, defaults, mark_unused));
}

// Functions are `try` blocks as a whole: whatever they allocate, running out of memory leaves the map as it was.
void close_function(Writer& out, Function const& f) {
  for (char const* error : {"bad_alloc", "length_error"}) {
    out.reopen("}} catch (std::{} const&) {{", error);
    out.line("return tl::unexpected(jrule::rewrite::no_memory({}));", literal(f.rule.name));
  }
  out.close();
}

void define_application(Writer& out, Function const& f) {
  out.open("{} try {{", signature(f, true, Defaults::without, true));
  bool const idle = f.rule.hooks.empty() && f.plan.added.empty();  // nothing on either side
  out.line("{}jrule::Map& {} = {}.map();", idle ? "[[maybe_unused]] " : "", f.map, f.modeler);
  if (!f.rule.hooks.empty()) out.line("jrule::rewrite::Workspace& {} = {}.workspace();", f.workspace, f.modeler);
  for (std::size_t e = 0; e < f.embeddings.size(); ++e) {
    if (f.uses_embedding[e]) out.line("jrule::Embedding& {} = {}.embedding({});", f.embeddings[e], f.map, e);
  }
  write_match(out, f);
  write_values(out, f);
  write_commit(out, f);
  close_function(out, f);
}

void define_everywhere(Writer& out, Function const& f) {
  OrbitType type;
  for (Letter const letter : f.rule.hook_type) type.words.push_back({letter});
  std::vector<std::string> arguments{f.modeler, f.hooks[0]};
  arguments.insert(arguments.end(), f.parameters.begin(), f.parameters.end());
  out.open("{} try {{", signature(f, false, Defaults::without, false));
  out.line("static jrule::OrbitType const {} = {};", f.local("orbit"), orbit_expression(type));
  out.open("return jrule::rewrite::apply_everywhere({}.map(), {}, [&](jrule::Dart {}) -> jrule::Result<void> {{",
           f.modeler, f.local("orbit"), f.hooks[0]);
  out.line("auto const {} = {}({});", f.local("applied"), f.names.function, fmt::join(arguments, ", "));
  out.line("if (!{0}) return tl::unexpected({0}.error());", f.local("applied"));
  out.line("return {{}};");
  out.close("});");
  close_function(out, f);
}

}  // namespace

std::string declare(Function const& f) {
  Writer out;
  declare_result(out, f);
  out.line();
  document(out, f, true);
  out.line("{};", signature(f, true, Defaults::with, false));
  if (f.names.everywhere.empty()) return out.all();
  out.line();
  document(out, f, false);
  out.line("{};", signature(f, false, Defaults::with, false));
  return out.all();
}

std::string define(Function const& f) {
  Writer out;
  define_application(out, f);
  if (f.names.everywhere.empty()) return out.all();
  out.line();
  define_everywhere(out, f);
  return out.all();
}

}  // namespace jrule::cpp
