// The AST as an indented tree. No positions: two texts with one meaning have one dump.
#include <fmt/format.h>

#include "compiler/syntax/dump_expression.h"
#include "compiler/syntax/format.h"

namespace jrule::syntax {

namespace {

class Dumper {
 public:
  std::string take() { return std::move(text_); }

  void operator()(ast::Import const& item) {
    std::string path;
    for (auto const& part : item.path) {
      if (!path.empty()) path += '.';
      path += part.text;
    }
    line(fmt::format("import {}", path));
  }

  void operator()(ast::Model const& item) {
    line(fmt::format("model {}{}", item.name.text, item.parameter ? fmt::format("({})", item.parameter->text) : ""));
    Inside inside(*this);
    doc(item.doc);
    if (!item.dimensions.empty()) line(fmt::format("dimensions {}", text_of(item.dimensions)));
    if (!item.oriented.empty()) line(fmt::format("oriented {}", text_of(item.oriented)));
    for (auto const& exchange : item.exchanges) line(text(exchange));
    if (item.closed) line("closed");
  }

  void operator()(ast::Modeler const& item) {
    line(fmt::format("modeler {} on {}", item.name.text, text_of(item.model)));
    Inside inside(*this);
    doc(item.doc);
    for (auto const& embedding : item.embeddings) {
      line(fmt::format("embedding {} : {} -> {}", embedding.name.text, text_of(embedding.orbit),
                       text_of(embedding.type)));
      Inside policies(*this);
      doc(embedding.doc);
      if (embedding.default_value) line(fmt::format("default {}", text_of(*embedding.default_value)));
      if (embedding.merge) line(fmt::format("merge {}", embedding.merge->text));
    }
  }

  void operator()(ast::Rule const& item) {
    line(fmt::format("rule {} on {}", item.name.text, text_of(item.on)));
    Inside inside(*this);
    doc(item.doc);
    for (auto const& name : item.dimension_parameters) line(fmt::format("dimension {}", name.text));
    parameters(item.parameters);
    side("left", item.left);
    side("right", item.right);
    for (auto const& e : item.expectations) line(fmt::format("expect {} = {}", e.count.text, text_of(*e.value)));
  }

  void operator()(ast::Operation const& item) {
    line(fmt::format("operation {} on {}{}", item.name.text, text_of(item.on),
                     item.result ? fmt::format(" -> {}", text_of(*item.result)) : ""));
    Inside inside(*this);
    doc(item.doc);
    parameters(item.parameters);
    block("body", item.body);
  }

  void operator()(ast::ExternType const& item) {
    line(fmt::format("extern type {} in {} as {}", item.name.text, quoted(item.header), quoted(item.cpp_name)));
    Inside inside(*this);
    doc(item.doc);
  }

  void operator()(ast::ExternFunction const& item) {
    line(fmt::format("extern fn {} -> {} in {} as {}", item.name.text, text_of(item.result), quoted(item.header),
                     quoted(item.cpp_name)));
    Inside inside(*this);
    doc(item.doc);
    parameters(item.parameters);
  }

  // ---- What stands in a side ----

  void operator()(ast::Node const& node) {
    line(fmt::format("{} {}{}", node.hook ? "hook" : "node", node.name.text,
                     node.decoration ? fmt::format(" <{}>", text_of(node.decoration->elements)) : ""));
    Inside inside(*this);
    doc(node.doc);
    for (auto const& clause : node.clauses) line(fmt::format("{} = {}", clause.embedding.text, text_of(*clause.value)));
  }

  void operator()(ast::ArcChain const& chain) {
    auto text = fmt::format("arcs {}", chain.nodes[0].text);
    for (std::size_t i = 0; i < chain.steps.size(); ++i) {
      auto const& step = chain.steps[i];
      text += step.direction == ast::ArcStep::Direction::backward ? " <-" : " -";
      auto const label = text_of(step.dimension);
      text += step.dimension.terms.size() > 1 ? fmt::format("({})", label) : label;
      if (step.word) text += text_of(*step.word);
      text += step.direction == ast::ArcStep::Direction::forward ? "-> " : "- ";
      text += chain.nodes[i + 1].text;
    }
    line(text);
  }

  void operator()(ast::Let const& let) { line(fmt::format("let {} = {}", let.name.text, text_of(*let.value))); }
  void operator()(ast::Require const& require) { line(fmt::format("require {}", text_of(*require.condition))); }

  // ---- Statements ----

  void operator()(ast::Assign const& s) { line(fmt::format("assign {} = {}", text_of(*s.target), text_of(*s.value))); }
  void operator()(ast::If const& s) {
    line(fmt::format("if {}", text_of(*s.condition)));
    Inside inside(*this);
    block("then", *s.then_block);
    if (s.else_block) block("else", *s.else_block);
  }
  void operator()(ast::ForOrbit const& s) {
    line(fmt::format("for {} in {}", s.variable.text, text_of(*s.orbit)));
    statements(*s.body);
  }
  void operator()(ast::While const& s) {
    line(fmt::format("while {}", text_of(*s.condition)));
    statements(*s.body);
  }
  void operator()(ast::Return const& s) { line(s.value ? fmt::format("return {}", text_of(*s.value)) : "return"); }
  void operator()(ast::Fail const& s) { line(fmt::format("fail {}", quoted(s.message))); }
  void operator()(ast::Try const& s) {
    line("try");
    Inside inside(*this);
    block("body", *s.body);
    block("else", *s.otherwise);
  }
  void operator()(ast::ApplyAll const& s) {
    line(fmt::format("apply_all {} on {}", text_of(s.call), text_of(*s.orbit)));
  }
  void operator()(ast::ExprStatement const& s) { line(fmt::format("do {}", text_of(*s.value))); }

 private:
  /// Lines written while it lives are one level deeper.
  struct Inside {
    explicit Inside(Dumper& dumper) : dumper_(dumper) { ++dumper_.level_; }
    Inside(Inside const&) = delete;
    Inside& operator=(Inside const&) = delete;
    ~Inside() { --dumper_.level_; }
    Dumper& dumper_;
  };

  void line(std::string const& text) {
    text_.append(2 * level_, ' ');
    text_ += text;
    text_ += '\n';
  }

  void doc(std::string const& text) {
    if (!text.empty()) line(fmt::format("doc {}", quoted(text)));
  }

  static std::string text(ast::Exchange const& exchange) {
    if (auto const* where = std::get_if<ast::ExchangeWhere>(&exchange.value)) {
      return fmt::format("exchange ({},{}) where {}", where->i.text, where->j.text, text_of(*where->condition));
    }
    std::string result = "exchange";
    for (auto const& [i, j] : std::get<ast::ExchangePairs>(exchange.value).pairs) {
      result += fmt::format(" ({},{})", text_of(i), text_of(j));
    }
    return result;
  }

  void parameters(std::vector<ast::Parameter> const& parameters) {
    for (auto const& parameter : parameters) {
      line(fmt::format("parameter {}: {}{}", parameter.name.text, text_of(parameter.type),
                       parameter.default_value ? fmt::format(" = {}", text_of(*parameter.default_value)) : ""));
      Inside inside(*this);
      doc(parameter.doc);
    }
  }

  void side(std::string const& title, ast::Side const& side) {
    line(title);
    Inside inside(*this);
    for (auto const& item : side.items) std::visit(*this, item);
  }

  void statements(ast::Block const& block) {
    Inside inside(*this);
    for (auto const& statement : block) std::visit(*this, statement.value);
  }

  void block(std::string const& title, ast::Block const& block) {
    line(title);
    statements(block);
  }

  std::string text_;
  std::size_t level_ = 0;
};

}  // namespace

std::string dump(ast::File const& file) {
  Dumper dumper;
  for (auto const& item : file.items) std::visit(dumper, item);
  return dumper.take();
}

}  // namespace jrule::syntax
