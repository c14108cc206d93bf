#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "compiler/backend/cpp/expression.h"
#include "compiler/backend/cpp/function.h"
#include "compiler/backend/cpp/parts.h"
#include "compiler/backend/cpp/sections.h"
#include "compiler/backend/cpp/text.h"
#include "compiler/ir/extern_use.h"

namespace jrule::cpp {

namespace {

std::string role(Function const& f, ir::Node const& node) {
  if (node.hook) return *node.hook == 0 ? "hook " + jrule::to_string(f.rule.hook_orbit()) : "hook";
  return node.added() ? "added" : "kept";
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
    out.line("/// The same for every dart of the pattern, in one order for all nodes. Valid until the next application.");
    out.open("struct Copies {{");
    out.line("std::span<jrule::Dart const> {};", fmt::join(members, ", "));
    out.close("} copies;");
  }
  out.close("};");
}

enum class Defaults { with, without };

// "Surface& surface, jrule::Dart a, jrule::Point3 apex"; where all orbits are rewritten at once, ", jrule::Threads threads".
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
  if (!hooks && f.independent) list.push_back(fmt::format("jrule::Threads {}{}", f.threads, defaults == Defaults::with ? " = {}" : ""));
  return fmt::format("{}", fmt::join(list, ", "));
}

void document(Writer& out, Function const& f, bool hooks) {
  if (hooks) {
    for (std::string const& line : documentation(f.rule.doc)) out.text(line.empty() ? "///" : "/// " + line);
  } else {
    out.line("/// Applies `{}` at each {}-orbit, {}; orbits where it is not applicable stay as they are.", f.names.function,
             jrule::to_string(f.rule.hook_orbit()), f.independent ? "all at once" : "one after the other in the order of their smallest darts");
  }
  out.line("///");
  out.line("/// {}", place(f.sources, f.rule.span));
  if (hooks) {
    for (std::size_t h = 0; h < f.hooks.size(); ++h) {
      ir::Node const& node = f.node(f.rule.hooks[h]);
      out.line("/// @param {}  {}{}", f.hooks[h], role(f, node), remark(node.doc));
    }
  }
  for (std::size_t p = 0; p < f.parameters.size(); ++p) out.text(document_parameter(f.rule.parameters[p], f.parameters[p]));
  if (!hooks && f.independent) out.line("/// @param {}  how many threads it may take; the result is the same for any number", f.threads);
  if (ir::find_extern_use(f.rule)) {
    out.text(hooks ? "/// @throws what C++ from outside throws, and then nothing has changed; running out of memory is returned"
                   : f.independent ? "/// @throws what C++ from outside throws, and then nothing has changed"
                                       : "/// @throws what C++ from outside throws; what was applied before stays");
  }
  out.text(
      hooks ? "/// @return the darts of the right side; or why the rule is not applicable, and then nothing has changed"
            : "/// @return the first refusal if it is applicable nowhere, and then nothing has changed");
}

std::string signature(Function const& f, bool hooks, Defaults defaults, bool mark_unused) {
  return hooks ? fmt::format("jrule::Result<{}> {}({})", f.names.result, f.names.function,
                             parameter_list(f, true, defaults, mark_unused))
               : fmt::format("jrule::Result<void> {}({})", f.names.everywhere,
                             parameter_list(f, false, defaults, mark_unused));
}

void close_function(Writer& out, Function const& f) { close_function(out, f.rule.name); }

// A function whose text is written last, and that declares what it needs.
template <class Write>
void write_body(Writer& out, Function const& f, bool views, Write write) {
  Writer body(out.depth());
  write(body);
  std::vector<Local> locals = map_locals(f);
  if (views) {
    for (Local& local : view_locals(f)) locals.push_back(std::move(local));
  }
  write_with_locals(out, locals, body.all());
}

void write_plan_title(Writer& out) {
  out.line();
  out.line("// ---- Plan: conditions and new values, read from the map as it is ----");
  out.line();
}

bool has_plan(Function const& f) {
  return !f.rule.lets.empty() || !f.rule.requirements.empty() ||
         std::any_of(f.adds_values.begin(), f.adds_values.end(), [](bool adds) { return adds; }) || !f.firsts.empty() ||
         std::any_of(f.plan.orbits.begin(), f.plan.orbits.end(), [](auto const& c) { return !c.sources.empty(); });
}

bool passes_lets(Function const& f) { return std::find(f.uses_let.begin(), f.uses_let.end(), true) != f.uses_let.end(); }

// What `listed` gets: types and names.
std::vector<std::pair<std::string, std::string>> listed_parameters(Function const& f) {
  std::vector<std::pair<std::string, std::string>> list{{f.names.modeler + "&", f.modeler}, {"std::size_t", f.size}};
  for (ir::NodeId id = 0; id < f.rule.nodes.size(); ++id) {
    if (!f.node(id).added()) list.emplace_back("jrule::Dart const*", f.darts[id]);
  }
  for (auto const& [word, name] : f.columns) list.emplace_back("jrule::rewrite::Index const*", name);
  list.emplace_back("jrule::rewrite::Index const*", f.local("number"));
  for (std::size_t l = 0; l < f.rule.lets.size(); ++l) {
    list.emplace_back(fmt::format("std::vector<{}> const&", stored_type(f.rule.lets[l].value->type)), f.let_lists[l]);
  }
  for (std::size_t p = 0; p < f.parameters.size(); ++p) list.emplace_back(parameter_type(f.rule.parameters[p].value_type()), f.parameters[p]);
  list.emplace_back("jrule::Threads", f.threads);
  return list;
}

// Plan and commit of an independent rule, at one orbit of its hook or at all: a function of its own.
struct Listed {
  std::string body;
  std::vector<std::pair<std::string, std::string>> parameters;  // those that the body mentions
};

Listed list(Function const& rule) {
  Function const f = rule.in(Form::listed);
  Writer out(1);
  write_body(out, f, true, [&](Writer& body) {
    write_values(body, f);
    write_commit(body, f);
    write_result(body, f);
  });
  Listed listed{out.all(), listed_parameters(f)};
  std::erase_if(listed.parameters, [&](auto const& parameter) { return !mentions(listed.body, parameter.second); });
  return listed;
}

void define_listed(Writer& out, Function const& f, Listed const& listed) {
  std::vector<std::string> parameters;
  for (auto const& [type, name] : listed.parameters) parameters.push_back(type + ' ' + name);
  out.line("// What `{}` does where it has matched.", f.names.function);
  open_call(out, fmt::format("static {} {}", f.names.result, f.local("listed")), parameters, " {", true);
  out.lines(listed.body);
  out.close();
  out.line();
}

// "rewrite_cone(surface, n, match_a.data(), at_0, apex)"; in a function for all applications columns are vectors.
void call_listed(Writer& out, Function const& f, Listed const& listed, std::string const& start, bool all) {
  std::vector<std::string> arguments;
  for (auto const& [type, name] : listed.parameters) {
    bool const is_hook = name == f.darts[f.rule.hooks[0]];
    bool const is_column = std::any_of(f.columns.begin(), f.columns.end(), [&, &n = name](auto const& c) { return c.second == n; });
    bool const is_number = all && name == f.local("number");
    arguments.push_back(name == f.threads && !all            ? "jrule::Threads{}"
                        : is_number                          ? f.local("all") + ".number.data()"
                        : is_hook || (all && is_column) ? name + ".data()"
                                                          : name);
  }
  open_call(out, start + f.local("listed"), arguments, ";", false);
}

// `listed`: of an independent rule.
void define_application(Writer& out, Function const& f, Listed const* listed) {
  out.open("{} try {{", signature(f, true, Defaults::without, true));
  write_body(out, f, false, [&](Writer& body) {
    write_match(body, f);
    Writer plan(body.depth());
    write_conditions(plan, f);
    if (!listed) write_values(plan, f);
    Writer rest(body.depth());
    if (listed) {
      rest.line();
      if (passes_lets(f)) {
        rest.line("jrule::rewrite::Index* const {} = {}.column({});", f.local("number"), f.workspace, f.size);
        rest.line("{} {}[{}] = 0;", f.loop(), f.local("number"), f.index);
      }
      for (std::size_t l = 0; l < f.rule.lets.size(); ++l) {
        if (!f.uses_let[l]) continue;
        rest.line("std::vector<{}> const {}{{{}}};", stored_type(f.rule.lets[l].value->type), f.let_lists[l], f.lets[l]);
      }
      call_listed(rest, f, *listed, "return ", false);
    } else {
      write_commit(rest, f);
      write_result(rest, f);
    }
    if (!plan.all().empty()) write_plan_title(body);
    write_with_locals(body, view_locals(f), plan.all() + rest.all());
  });
  close_function(out, f);
}

std::vector<std::string> arguments(Function const& f, std::vector<std::string> first) {
  first.insert(first.end(), f.parameters.begin(), f.parameters.end());
  return first;
}

void write_orbit_type(Writer& out, Function const& f) {
  out.line("static jrule::OrbitType const {} = {};", f.local("orbit"), orbit_expression(f.rule.hook_orbit()));
}

void define_in_turn(Writer& out, Function const& f) {
  out.open("{} try {{", signature(f, false, Defaults::without, false));
  write_orbit_type(out, f);
  out.open("auto const {} = jrule::rewrite::apply_everywhere({}.map(), {}, [&](jrule::Dart {}) -> jrule::Result<void> {{",
           f.local("kept"), f.modeler, f.local("orbit"), f.hooks[0]);
  out.line("auto const {} = {}({});", f.local("applied"), f.names.function, fmt::join(arguments(f, {f.modeler, f.hooks[0]}), ", "));
  out.line("if (!{0}) return tl::unexpected({0}.error());", f.local("applied"));
  out.line("return {{}};");
  out.close("});");
  out.line("if (!{0}) return tl::unexpected({0}.error());", f.local("kept"));
  out.line("return {{}};");
  close_function(out, f);
}

// All darts of a map are rewritten in place, if none is missing among their indices and the rule is applicable everywhere.
void define_dense(Writer& out, Function const& rule) {
  Function const f = rule.in(Form::dense);
  out.line("// `{}` at all darts of a map without erased ones: each dart is its own place in the pattern. False if it is not", f.names.function);
  out.line("// applicable everywhere, and then nothing has changed.");
  std::vector<std::string> parameters{fmt::format("{}& {}", f.names.modeler, f.modeler)};
  for (std::size_t p = 0; p < f.parameters.size(); ++p) {
    parameters.push_back(fmt::format("{}{} {}", f.uses_parameter[p] ? "" : "[[maybe_unused]] ", parameter_type(f.rule.parameters[p].value_type()), f.parameters[p]));
  }
  parameters.push_back("[[maybe_unused]] jrule::Threads " + f.threads);
  open_call(out, fmt::format("static bool {}", f.local("dense")), parameters, " {", true);
  write_body(out, f, false, [&](Writer& body) {
    Writer plan(body.depth());
    write_dense_checks(plan, f);
    if (has_plan(f)) write_plan_title(plan);
    write_values(plan, f);
    write_commit(plan, f);
    if (!f.plan.added.empty()) plan.line("{}.release_columns();", f.workspace);
    plan.line("return true;");
    Writer rest(body.depth());
    write_with_locals(rest, view_locals(f), plan.all());
    std::vector<Local> locals{{f.size, fmt::format("jrule::Dart const {} = {}.dart_limit();", f.size, f.map)}};
    for (auto const& [word, name] : f.columns) {
      if (f.is_aliased(word)) {
        locals.push_back({name, fmt::format("jrule::rewrite::Index const* {} = {}.{}({}).data();", name, f.map,
                                            word.front().conjugate ? "sources" : "targets", word.front().dimension)});
      } else {
        locals.push_back({name, fmt::format("jrule::rewrite::Index* const {} = {}.column({});", name, f.workspace, f.size)});
        locals.push_back({name, f.each(fmt::format("{}[{}] = {};", name, f.index, f.walk(f.index, word)))});
      }
    }
    body.line("{}.begin();", f.workspace);
    write_with_locals(body, locals, rest.all());
  });
  out.close();
  out.line();
}

void define_at_once(Writer& out, Function const& f, Listed const& listed) {
  out.open("{} try {{", signature(f, false, Defaults::without, false));
  write_body(out, f, true, [&](Writer& body) {
    if (f.can_be_dense()) {
      std::vector<std::string> at_once = arguments(f, {f.modeler});
      at_once.push_back(f.threads);
      body.line("if (!{}.has_erased_darts() && {}({})) return {{}};", f.map, f.local("dense"), fmt::join(at_once, ", "));
    }
    body.line("if ({}.dart_count() == 0) return {{}};", f.map);
    write_orbit_type(body, f);
    Writer rest(body.depth());
    rest.open("if ({}.count() == 0) {{", f.local("all"));
    rest.line("// Why not: what the first orbit alone says.");
    rest.line("auto const {} = {}({});", f.local("applied"), f.names.function,
              fmt::join(arguments(f, {f.modeler, fmt::format("{}.darts().front()", f.map)}), ", "));
    rest.line("if (!{0}) return tl::unexpected({0}.error());", f.local("applied"));
    rest.line("return {{}};");
    rest.close();
    call_listed(rest, f, listed, "", true);
    rest.line("return {{}};");
    write_all_matches(body, f.in(Form::listed), fmt::format("jrule::rewrite::all_applications({}, {})", f.map, f.local("orbit")), rest.all());
  });
  close_function(out, f);
}

// The same inside an orbit, for operations. How often it was applied.
void define_within(Writer& out, Function const& f, Listed const& listed) {
  std::vector<std::string> parameters{fmt::format("{}& {}", f.names.modeler, f.modeler), fmt::format("jrule::OrbitType const& {}", f.local("type")),
                                      fmt::format("jrule::Dart {}", f.hooks[0])};
  for (std::size_t p = 0; p < f.parameters.size(); ++p) {
    parameters.push_back(fmt::format("{}{} {}", f.uses_parameter[p] ? "" : "[[maybe_unused]] ", parameter_type(f.rule.parameters[p].value_type()), f.parameters[p]));
  }
  out.line("// `{}` at each {}-orbit inside ⟨{}⟩({}), all at once.", f.names.function, jrule::to_string(f.rule.hook_orbit()), f.local("type"), f.hooks[0]);
  open_call(out, fmt::format("static jrule::Result<std::size_t> {}", f.names.within), parameters, " try {", true);
  write_body(out, f, true, [&](Writer& body) {
    write_orbit_type(body, f);
    body.line("[[maybe_unused]] jrule::Threads const {}{{}};", f.threads);
    std::string const &all = f.local("all"), &first = f.local("from");
    Writer rest(body.depth());
    rest.open("if ({}.count() == 0) {{", all);
    rest.line("// Why not: what the first orbit alone says.");
    rest.line("auto const {} = {}({});", f.local("applied"), f.names.function, fmt::join(arguments(f, {f.modeler, first}), ", "));
    rest.line("if (!{0}) return tl::unexpected({0}.error());", f.local("applied"));
    rest.close();
    call_listed(rest, f, listed, "", true);
    rest.line("return {}.count();", all);
    std::string const find = fmt::format("jrule::rewrite::applications_within({}, {}, {}, {})", f.map, f.local("orbit"), f.local("type"), f.hooks[0]);
    write_all_matches(body, f.in(Form::listed), fmt::format("{};\n  jrule::Dart const {} = {}.pattern.front()", find, first, all), rest.all());
  });
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

std::string define(Function const& f, bool within) {
  Writer out;
  if (f.independent) {  // of rules with one hook
    Listed const listed = list(f);
    define_listed(out, f, listed);
    define_application(out, f, &listed);
    out.line();
    if (f.can_be_dense()) define_dense(out, f);
    define_at_once(out, f, listed);
    if (within) {
      out.line();
      define_within(out, f, listed);
    }
    return out.all();
  }
  define_application(out, f, nullptr);
  if (f.names.everywhere.empty()) return out.all();
  out.line();
  define_in_turn(out, f);
  return out.all();
}

}  // namespace jrule::cpp
