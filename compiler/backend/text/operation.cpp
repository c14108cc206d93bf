#include "compiler/backend/text/operation.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "compiler/backend/text/expression.h"
#include "compiler/backend/text/rule.h"

namespace jrule::text {

namespace {

std::string quoted(std::string const& message) {
  std::string text = "\"";
  for (char const c : message) {
    if (c == '"' || c == '\\') text += '\\';
    text += c == '\n' ? "\\n" : std::string(1, c);
  }
  return text + '"';
}

class OperationSpeller {
 public:
  OperationSpeller(ir::Program const& program, std::size_t index, ItemNames const& names)
      : program_(program), operation_(program.operations[index]), names_(names), group_(operation_.model()), scope_(ir::expression_scope(operation_)) {}

  std::string spell(std::string const& name, std::string const& modeler) {
    text_ = take(spell_documentation(operation_.doc, ""));
    text_ += fmt::format("operation {}{} on {}{} {{\n", name, take(spell_parameters(operation_.parameters, group_)), modeler,
                         operation_.result ? " -> " + to_string(*operation_.result) : "");
    block(operation_.body);
    return std::move(text_) + "}\n\n";
  }

  std::string fault;

 private:
  std::string take(Spelled<std::string> spelled) {
    if (!spelled && fault.empty()) fault = std::move(spelled.error().reason);
    return spelled.value_or("");
  }
  std::string expr(ir::ExprPtr const& e, std::optional<ir::ExprType> expected = {}) { return take(text::spell(*e, scope_, group_, 0, expected)); }

  // Darts first, then a value for each parameter.
  std::string arguments(std::vector<ir::ExprPtr> const& darts, std::vector<ir::ExprPtr> const& values, std::vector<ir::Parameter> const& parameters) {
    std::vector<std::string> all;
    for (ir::ExprPtr const& d : darts) all.push_back(expr(d, ir::dart_type));
    for (std::size_t i = 0; i < values.size(); ++i) all.push_back(expr(values[i], parameters[i].value_type()));
    return fmt::format("({})", fmt::join(all, ", "));
  }
  std::string origin(ir::Origin const& o, std::optional<ir::ExprType> expected) {
    if (auto const* e = std::get_if<ir::ExprPtr>(&o)) return expr(*e, expected);
    if (auto const* call = std::get_if<ir::RuleCall>(&o)) {
      return names_.rules[call->rule] + arguments(call->darts, call->values, program_.rules[call->rule].parameters);
    }
    auto const& call = std::get<ir::OperationCall>(o);
    return names_.operations[call.operation] + arguments({}, call.arguments, program_.operations[call.operation].parameters);
  }
  std::string orbit(OrbitType const& type, ir::ExprPtr const& at, OrbitType const& by) {
    return fmt::format("{}({}){}", text::spell(type), expr(at), by.words.empty() ? "" : " by " + text::spell(by));
  }

  void block(ir::Block const& statements) {
    for (ir::Statement const& s : statements) {
      std::visit([&](auto const& statement) { write(statement); }, s.value);
    }
  }
  void line(std::string const& words) { text_ += words + "\n"; }

  void write(ir::Set const& s) {
    ir::Variable const& variable = operation_.variables[s.variable];
    bool const typed = !s.declares && !variable.result;  // a declaration has the type of its value
    line(fmt::format("{}{} = {};", s.declares ? "let " : "", variable.name, origin(s.value, typed ? std::optional(variable.type) : std::nullopt)));
  }
  void write(ir::Do const& s) { line(origin(s.call, {}) + ";"); }
  void write(ir::If const& s) {
    line(fmt::format("if {} {{", expr(s.condition, ir::ExprType{Type::Bool})));
    block(s.then_block);
    if (!s.else_block.empty()) {
      line("} else {");
      block(s.else_block);
    }
    line("}");
  }
  void write(ir::For const& s) {
    line(fmt::format("for {} in {} {{", operation_.variables[s.variable].name, orbit(s.over.orbit, s.over.at, s.over.by)));
    block(s.body);
    line("}");
  }
  void write(ir::While const& s) {
    line(fmt::format("while {} {{", expr(s.condition, ir::ExprType{Type::Bool})));
    block(s.body);
    line("}");
  }
  void write(ir::Return const& s) { line(s.value ? fmt::format("return {};", origin(*s.value, operation_.result)) : "return;"); }
  void write(ir::Fail const& s) { line(fmt::format("fail {};", quoted(s.message))); }
  void write(ir::Try const& s) {
    line("try {");
    block(s.body);
    line("} else {");
    block(s.otherwise);
    line("}");
  }
  void write(ir::ApplyAll const& s) {
    line(fmt::format("apply_all {}{} on {};", names_.rules[s.rule], arguments({}, s.values, program_.rules[s.rule].parameters), orbit(s.orbit, s.at, {})));
  }

  ir::Program const& program_;
  ir::Operation const& operation_;
  ItemNames const& names_;
  algebra::Group const group_;
  ir::RuleScheme const scope_;
  std::string text_;
};

}  // namespace

Spelled<std::string> spell_operation(ir::Program const& program, std::size_t index, ItemNames const& names, std::string const& modeler) {
  OperationSpeller speller(program, index, names);
  std::string text = speller.spell(names.operations[index], modeler);
  if (!speller.fault.empty()) return tl::unexpected(Unspellable{fmt::format("operation `{}`: {}", program.operations[index].name, speller.fault)});
  return text;
}

}  // namespace jrule::text
