#include "compiler/backend/cpp/operation.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "compiler/analysis/operations.h"
#include "compiler/backend/cpp/parts.h"
#include "compiler/backend/cpp/sections.h"
#include "compiler/backend/cpp/text.h"
#include "compiler/ir/extern_use.h"

namespace jrule::cpp {

namespace {

enum class Defaults { with, without };

std::string result_type(ir::Operation const& operation) { return operation.result ? type_name(*operation.result) : "void"; }

bool contains(std::vector<std::size_t> const& list, std::size_t element) { return std::find(list.begin(), list.end(), element) != list.end(); }

// `d = d;`, of which compilers warn, and which does nothing.
bool sets_to_itself(ir::Set const& s) {
  auto const* value = std::get_if<ir::ExprPtr>(&s.value);
  auto const* variable = value ? std::get_if<ir::VariableRef>(&(*value)->value) : nullptr;
  return variable && variable->index == s.variable;
}

// One operation: its names, then its text.
struct Emission {
  Operations const& all;
  std::size_t index;
  ir::Operation const& operation = all.program.operations[index];
  OperationPublicNames const& public_names = all.names[index];
  Scope scope = all.scope;
  OperationNames names{};
  std::string run{}, progress{}, call{}, undo{};
  std::vector<std::size_t> const assigned = ir::assigned_anywhere(operation.body);
  std::set<std::size_t> read{};  // variables
  Writer out{1};

  Emission(Operations const& a, std::size_t i) : all(a), index(i) {
    names.modeler = operation.modeler.get();
    names.operation = literal(operation.name);
    // First what the caller sees: it keeps its names, the rest gives way.
    for (ir::Parameter const& p : operation.parameters) names.variables.push_back(scope.take(p.name));
    names.object = scope.take(snake_case(public_names.class_name));
    progress = scope.take("progress");
    run = scope.take("run");
    call = scope.take("call");
    undo = scope.take("undo");
    names.map = scope.take("map");
    names.alive = scope.take("alive");
    names.at = scope.take("at");
    for (std::size_t v = operation.parameters.size(); v < operation.variables.size(); ++v) names.variables.push_back(scope.take(operation.variables[v].name));
    names.members.resize(operation.variables.size());
    for (std::size_t v = 0; v < operation.variables.size(); ++v) {
      if (auto const rule = operation.variables[v].result) names.members[v] = all.rules[*rule].members;
    }
    use(operation.body);
  }

  // ---- What is used ----

  void use(ir::Block const& block) {
    for (ir::Statement const& s : block) {
      if (auto const* set = std::get_if<ir::Set>(&s.value); set && sets_to_itself(*set)) continue;
      for (ir::ExprPtr const& expr : ir::expressions(s)) use(*expr);
      for (ir::Block const* inner : ir::blocks(s)) use(*inner);
    }
  }
  void use(ir::Expr const& expr) {
    if (auto const* v = std::get_if<ir::VariableRef>(&expr.value)) read.insert(v->index);
    if (auto const* c = std::get_if<ir::CopyOf>(&expr.value)) {
      read.insert(c->result.index);
      auto const key = std::pair(c->result.index, c->node);
      if (c->at && !names.copies.contains(key)) {
        names.copies[key] = scope.take(fmt::format("{}_{}", names.variables[key.first], names.members[key.first][key.second]));
      }
    }
    if (auto const* d = std::get_if<ir::Darts>(&expr.value)) use_walk(*d);
    if (auto const* c = std::get_if<ir::Collect>(&expr.value)) use_walk(c->over);
    if (auto const* e = std::get_if<ir::ForEach>(&expr.value)) {
      if (!names.bound.contains(e->variable.name)) names.bound[e->variable.name] = scope.take(e->variable.name);
      use_walk(e->over);
    }
    for (ir::ExprPtr const& part : ir::parts(expr)) use(*part);
  }
  void use_walk(ir::Darts const& over) {
    std::pair const key(over.orbit, over.by);
    if (!names.walks.contains(key)) names.walks[key] = scope.take(orbit_name("walk", over.orbit, over.by));
  }
  static std::string orbit_name(std::string name, OrbitType const& orbit, OrbitType const& by) {
    for (Word const& word : orbit.words) name += "_" + name_part(word);
    if (!by.words.empty()) name += "_by";
    for (Word const& word : by.words) name += "_" + name_part(word);
    return name;
  }

  // ---- Parts of statements ----

  std::string expr(ir::ExprPtr const& e) const { return expression(*e, names); }
  // As an argument: a value of a type from outside is read in place, where the callee may change it.
  std::string argument(ir::ExprPtr const& e) const {
    bool const in_place = e->type.external && !e->type.list && !std::holds_alternative<ir::VariableRef>(e->value);
    return in_place ? fmt::format("{}({})", type_name(e->type), expr(e)) : expr(e);
  }
  std::vector<std::string> arguments(std::vector<std::string> list, std::vector<ir::ExprPtr> const& more) const {
    for (ir::ExprPtr const& e : more) list.push_back(argument(e));
    return list;
  }

  std::string operator()(ir::ExprPtr const& e) const { return expr(e); }
  std::string operator()(ir::RuleCall const& c) const {
    std::vector<std::string> list = arguments(arguments({names.object}, c.darts), c.values);
    return fmt::format("{}.applied({}({}))", run, all.rules[c.rule].names.function, fmt::join(list, ", "));
  }
  std::string operator()(ir::OperationCall const& c) const {
    return fmt::format("{}({})", all.names[c.operation].run, fmt::join(arguments({names.object, run}, c.arguments), ", "));
  }
  std::string origin(ir::Origin const& o) const { return std::visit(*this, o); }
  void step(ir::Origin const& o) {
    if (std::holds_alternative<ir::RuleCall>(o)) out.line("{}.step();", run);
  }

  std::string type(std::size_t variable) const {
    ir::Variable const& v = operation.variables[variable];
    return v.result ? all.rules[*v.result].names.result : type_name(v.type);
  }

  // The copies of a rule's nodes that are chosen from, which the next application would overwrite.
  void keep_copies(std::size_t variable, bool declares) {
    for (auto const& [key, name] : names.copies) {
      if (key.first != variable) continue;
      Function const& rule = all.rules[*operation.variables[variable].result];
      std::string const &result = names.variables[variable], &hook = rule.members[rule.rule.hooks[0]], &node = rule.members[key.second];
      std::string const copies = fmt::format("({0}.copies.{1}, {0}.copies.{2})", result, hook, node);
      if (declares) {
        out.line("jrule::operation::Copies {}{};", name, copies);
      } else {
        out.line("{} = jrule::operation::Copies{};", name, copies);
      }
    }
  }

  // ---- Statements ----

  void block(ir::Block const& statements) {
    for (ir::Statement const& s : statements) {
      std::visit([&](auto const& statement) { write(statement); }, s.value);
    }
  }

  void write(ir::Set const& s) {
    if (sets_to_itself(s)) return;
    step(s.value);
    std::string const &name = names.variables[s.variable], value = origin(s.value);
    if (s.declares) {
      std::string const maybe = read.contains(s.variable) ? "" : "[[maybe_unused]] ";
      out.line("{}{}{} {} = {};", maybe, type(s.variable), contains(assigned, s.variable) ? "" : " const", name, value);
    } else {
      out.line("{} = {};", name, value);
    }
    keep_copies(s.variable, s.declares);
  }
  void write(ir::Do const& s) {
    step(s.call);
    out.line("{};", origin(s.call));
  }
  void write(ir::If const& s) {
    out.open("if ({}) {{", expr(s.condition));
    block(s.then_block);
    ir::Block const* rest = &s.else_block;
    while (rest->size() == 1) {
      auto const* next = std::get_if<ir::If>(&rest->front().value);
      if (!next) break;
      out.reopen("}} else if ({}) {{", expr(next->condition));
      block(next->then_block);
      rest = &next->else_block;
    }
    if (!rest->empty()) {
      out.reopen("}} else {{");
      block(*rest);
    }
    out.close();
  }
  void write(ir::For const& s) {
    std::string const by = s.over.by.words.empty() ? "{}" : orbit_expression(s.over.by);
    out.open("for (jrule::Dart{} {} : jrule::rewrite::representatives({}, {}, {}, {})) {{", contains(assigned, s.variable) ? "" : " const",
             names.variables[s.variable], names.map, orbit_expression(s.over.orbit), by, dart_in_map(*s.over.at, names));
    out.line("if (!{}.contains({})) continue;  // deleted meanwhile", names.map, names.variables[s.variable]);
    block(s.body);
    out.close();
  }
  void write(ir::While const& s) {
    out.open("while ({}) {{", expr(s.condition));
    out.line("{}.step();", run);
    block(s.body);
    out.close();
  }
  void write(ir::Return const& s) {
    if (s.value) step(*s.value);
    out.line("return{};", s.value ? " " + origin(*s.value) : "");
  }
  void write(ir::Fail const& s) { out.line("jrule::operation::fail({}, {});", names.operation, literal(s.message)); }
  void write(ir::Try const& s) {
    std::vector<std::pair<std::string, std::string>> before;  // a variable, and what it was
    for (std::size_t const variable : ir::assigned(s.body)) {
      before.emplace_back(names.variables[variable], scope.take(names.variables[variable] + "_before"));
      for (auto const& [key, name] : names.copies) {
        if (key.first == variable) before.emplace_back(name, scope.take(name + "_before"));
      }
    }
    for (auto const& [name, saved] : before) out.line("auto const {} = {};", saved, name);
    bool const copies = analysis::may_fail_after_change(s.body);
    std::string const failure = scope.take("failure");
    out.open("try {{");
    out.line("jrule::operation::Undo const {}({}, {}, jrule::operation::Undo::Of::{});", scope.take("undo"), run, names.map, copies ? "attempt" : "call");
    block(s.body);
    out.reopen("}} catch (jrule::operation::Failure const& {}) {{", failure);
    out.line("if (!{}.is_tried()) throw;", failure);
    for (auto const& [name, saved] : before) out.line("{} = {};", name, saved);
    block(s.otherwise);
    out.close();
  }
  void write(ir::ApplyAll const& s) {
    out.line("{}.step();", run);
    std::vector<std::string> const list = arguments({names.object, orbit_expression(s.orbit), dart_in_map(*s.at, names)}, s.values);
    out.line("{}.applied_everywhere({}({}));", run, all.rules[s.rule].names.within, fmt::join(list, ", "));
  }

  // ---- Functions ----

  // "double side = 1.0".
  std::vector<std::string> parameters(Defaults defaults, bool mark_unused) const {
    std::vector<std::string> list;
    // C++ has defaults only at the end.
    std::size_t first_default = operation.parameters.size();
    while (first_default > 0 && operation.parameters[first_default - 1].has_default()) --first_default;
    for (std::size_t p = 0; p < operation.parameters.size(); ++p) {
      ir::Parameter const& parameter = operation.parameters[p];
      bool const changes = mark_unused && contains(assigned, p);
      std::string text = fmt::format("{} {}", changes ? type_name(parameter.value_type()) : parameter_type(parameter.value_type()), names.variables[p]);
      if (defaults == Defaults::with && p >= first_default) text += " = " + default_of(parameter);
      if (mark_unused && !read.contains(p)) text.insert(0, "[[maybe_unused]] ");
      list.push_back(std::move(text));
    }
    return list;
  }
  std::vector<std::string> run_parameters(bool defines) const {
    std::vector<std::string> list{fmt::format("{}& {}", public_names.modeler, names.object), fmt::format("jrule::operation::Run& {}", run)};
    for (std::string& p : parameters(Defaults::without, defines)) list.push_back(std::move(p));
    return list;
  }
  std::vector<std::string> public_parameters(Defaults defaults) const {
    std::vector<std::string> list{fmt::format("{}& {}", public_names.modeler, names.object)};
    for (std::string& p : parameters(defaults, false)) list.push_back(std::move(p));
    list.push_back(fmt::format("jrule::operation::Progress const& {}{}", progress, defaults == Defaults::with ? " = {}" : ""));
    return list;
  }
  std::string public_start() const { return fmt::format("jrule::Result<{}> {}", result_type(operation), public_names.function); }
  std::string run_start() const { return fmt::format("static {} {}", result_type(operation), public_names.run); }

  void document(Writer& header) const {
    for (std::string const& line : documentation(operation.doc)) header.text(line.empty() ? "///" : "/// " + line);
    header.line("///");
    header.line("/// {}", place(all.sources, operation.span));
    for (std::size_t p = 0; p < operation.parameters.size(); ++p) header.text(document_parameter(operation.parameters[p], names.variables[p]));
    header.line("/// @param {}  asked before each application of a rule and each round of a `while`; false cancels", progress);
    if (ir::find_extern_use(operation, all.program)) {
      header.line("/// @throws what C++ from outside throws, and then nothing has changed; running out of memory is returned");
    }
    header.line("/// @return {}why it has failed, and then nothing has changed", operation.result ? "what it gives; or " : "");
  }

  std::vector<Local> locals() const {
    std::vector<Local> list{{names.map, fmt::format("jrule::Map& {} = {}.map();", names.map, names.object)},
                            {names.alive, fmt::format("auto const {} = [&](jrule::Dart {}) {{ return jrule::operation::alive({}, {}, {}); }};", names.alive,
                                                      names.at, names.map, names.at, names.operation)}};
    for (auto const& [types, name] : names.walks) {
      std::string const by = types.second.words.empty() ? "{}" : " = " + orbit_expression(types.second);
      list.push_back({name + "_type", fmt::format("static jrule::OrbitType const {}_type = {};", name, orbit_expression(types.first))});
      list.push_back({name + "_parts", fmt::format("static jrule::OrbitType const {}_parts{};", name, by)});
      list.push_back({name, fmt::format("jrule::rewrite::OrbitWalk const {0}({1}, {0}_type, {0}_parts);", name, names.map)});
    }
    return list;
  }

  std::string define() {
    if (analysis::may_fail_after_change(operation.body)) {
      out.line("jrule::operation::Undo const {}({}, {}, jrule::operation::Undo::Of::operation);", undo, run, names.map);
    }
    block(operation.body);
    Writer text;
    open_call(text, run_start(), run_parameters(true), " {", true);
    text.line("jrule::operation::Call const {}({}, {});", call, run, names.operation);
    write_with_locals(text, locals(), out.all());
    text.close();
    text.line();
    open_call(text, public_start(), public_parameters(Defaults::without), " try {", true);
    text.line("jrule::operation::Run {}({}, {});", run, names.operation, progress);
    std::vector<std::string> passed{names.object, run};
    for (std::size_t p = 0; p < operation.parameters.size(); ++p) passed.push_back(names.variables[p]);
    text.line("{}{}({});", operation.result ? "return " : "", public_names.run, fmt::join(passed, ", "));
    if (!operation.result) text.line("return {{}};");
    std::string const failure = scope.take("failure");
    text.reopen("}} catch (jrule::operation::Failure const& {}) {{", failure);
    text.line("return tl::unexpected({}.error);", failure);
    close_function(text, operation.name);
    return text.all();
  }
};

}  // namespace

std::string declare_operation(Operations const& all, std::size_t index) {
  Emission const emission(all, index);
  Writer header;
  emission.document(header);
  open_call(header, emission.public_start(), emission.public_parameters(Defaults::with), ";", false);
  return header.all();
}

std::string declare_run(Operations const& all, std::size_t index) {
  Emission const emission(all, index);
  Writer code;
  open_call(code, emission.run_start(), emission.run_parameters(false), ";", false);
  return code.all();
}

std::string define_operation(Operations const& all, std::size_t index) { return Emission(all, index).define(); }

namespace {

void collect_applied_within(ir::Block const& block, std::set<std::size_t>& rules) {
  for (ir::Statement const& s : block) {
    if (auto const* everywhere = std::get_if<ir::ApplyAll>(&s.value)) rules.insert(everywhere->rule);
    for (ir::Block const* inner : ir::blocks(s)) collect_applied_within(*inner, rules);
  }
}

}  // namespace

std::set<std::size_t> applied_within(ir::Program const& program) {
  std::set<std::size_t> rules;
  for (ir::Operation const& operation : program.operations) collect_applied_within(operation.body, rules);
  return rules;
}

}  // namespace jrule::cpp
