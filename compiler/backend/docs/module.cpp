#include "compiler/backend/docs/module.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "compiler/sema/elaborate.h"
#include "compiler/sema/units.h"
#include "compiler/syntax/format.h"

namespace jrule::docs {

namespace {

using Kind = Section::Kind;

/// The last lines of spaces at its end are none of the text's.
std::string trimmed(std::string text) {
  text.erase(text.find_last_not_of(" \t\r\n") + 1);
  return text;
}

class Describer {
 public:
  Describer(source::Sources const& sources, sema::Modules const& modules, ir::Program const& program, std::vector<analysis::Verdict> const& verdicts)
      : sources_(sources), modules_(modules), program_(program), verdicts_(verdicts) {}

  Module describe() const {
    sema::Module const& root = modules_.all.back();
    Module module{program_.module, file_doc(root.ast), {}, {}};
    for (sema::Module::Import const& import : root.imports) {
      sema::Module const& imported = modules_.all[import.module];
      module.imports.push_back({imported.name, sources_.file(imported.ast.file).path});
    }
    for (ast::Item const& item : root.ast.items) {
      if (!std::holds_alternative<ast::Import>(item)) module.sections.push_back(std::visit([&](auto const& i) { return section(i); }, item));
    }
    return module;
  }

 private:
  // ---- Text ----

  std::string text(source::Span span) const { return std::string(sources_.text(span)); }
  std::string text(ast::TypeName const& type) const { return type.list ? "[" + type.name.text + "]" : type.name.text; }
  std::string text(ast::ExprPtr const& value) const { return value ? text(value->span) : ""; }
  /// An item alone is a text that parses.
  std::string source(source::Span span) const { return trimmed(syntax::format(text(span))); }

  /// The `///` lines that the file begins with, unless they are the documentation of its first item.
  std::string file_doc(ast::File const& file) const {
    std::string_view rest = sources_.file(file.file).text;
    std::string doc;
    bool any = false;
    for (;;) {
      rest.remove_prefix(std::min(rest.find_first_not_of(any ? " \t" : " \t\r\n"), rest.size()));
      if (!rest.starts_with("///") || rest.starts_with("////")) break;
      std::size_t const end = std::min(rest.find_first_of("\r\n"), rest.size());
      std::string_view line = rest.substr(3, end - 3);
      if (line.starts_with(' ')) line.remove_prefix(1);
      if (any) doc += '\n';
      doc += trimmed(std::string(line));
      any = true;
      rest.remove_prefix(end);
      if (rest.starts_with('\r')) rest.remove_prefix(1);
      if (rest.starts_with('\n')) rest.remove_prefix(1);
    }
    std::string const first = std::visit(
        [](auto const& item) -> std::string {
          if constexpr (requires { item.doc; }) {
            return item.doc;
          } else {
            return {};
          }
        },
        file.items.front());
    return doc == first ? "" : doc;
  }

  // ---- Parts ----

  std::vector<Parameter> parameters(std::vector<ast::Parameter> const& written) const {
    std::vector<Parameter> result;
    for (ast::Parameter const& p : written) {
      auto const [unit, doc] = sema::split_unit(p.doc);
      result.push_back({p.name.text, text(p.type), text(p.default_value), unit, doc});
    }
    return result;
  }

  static std::string spell(std::vector<Parameter> const& parameters) {
    std::vector<std::string> texts;
    for (Parameter const& p : parameters) {
      texts.push_back(fmt::format("{}: {}{}{}", p.name, p.type, p.default_value.empty() ? "" : " = ", p.default_value));
    }
    return texts.empty() ? "" : fmt::format("({})", fmt::join(texts, ", "));
  }

  void add_nodes(ast::Side const& side, std::vector<Node>& nodes) const {
    for (ast::SideItem const& item : side.items) {
      auto const* node = std::get_if<ast::Node>(&item);
      if (!node || (!node->hook && node->doc.empty())) continue;
      nodes.push_back({node->name.text, node->decoration ? text(node->decoration->span) : "", node->doc, node->hook});
    }
  }

  // ---- Items ----

  Section section(ast::Import const&) const { return {Kind::model, "", "", "", ""}; }  // there are none of these

  Section section(ast::Model const& model) const {
    return {Kind::model, model.name.text, model.parameter ? fmt::format("{}({})", model.name.text, model.parameter->text) : model.name.text, model.doc,
            source(model.span)};
  }

  Section section(ast::Modeler const& modeler) const {
    Section s{Kind::modeler, modeler.name.text, fmt::format("{} on {}", modeler.name.text, text(modeler.model.span)), modeler.doc, source(modeler.span)};
    for (ast::EmbeddingDecl const& e : modeler.embeddings) {
      auto const orbit = std::visit([](auto const& type) { return type.span; }, e.orbit.value);
      s.embeddings.push_back({e.name.text, text(orbit), text(e.type), text(e.default_value), e.merge ? e.merge->text : "", e.doc});
    }
    return s;
  }

  Section section(ast::Rule const& rule) const {
    Section s{Kind::rule, rule.name.text, "", rule.doc, source(rule.span)};
    s.parameters = parameters(rule.parameters);
    add_nodes(rule.left, s.nodes);
    add_nodes(rule.right, s.nodes);
    std::vector<std::string> dimensions;
    for (ast::Name const& name : rule.dimension_parameters) dimensions.push_back(name.text);
    s.signature = fmt::format("{}{}{} on {}", rule.name.text, dimensions.empty() ? "" : fmt::format("[{}]", fmt::join(dimensions, ",")),
                              spell(s.parameters), text(rule.on.span));
    for (std::size_t i = 0; i < program_.rules.size(); ++i) {
      if (program_.rules[i].import || program_.rules[i].name != rule.name.text) continue;
      s.rule = program_.rules[i];
      s.plan = verdicts_[i].plan;
      return s;
    }
    s.kind = Kind::family;
    find_example(rule, s);
    return s;
  }

  Section section(ast::Operation const& operation) const {
    Section s{Kind::operation, operation.name.text, "", operation.doc, source(operation.span)};
    s.parameters = parameters(operation.parameters);
    s.signature = fmt::format("{}{} on {}{}", operation.name.text, spell(s.parameters), text(operation.on.span),
                              operation.result ? " -> " + text(*operation.result) : "");
    for (std::size_t i = 0; i < program_.operations.size(); ++i) {
      if (!program_.operations[i].import && program_.operations[i].name == operation.name.text) s.operation = i;
    }
    return s;
  }

  Section section(ast::ExternType const& type) const {
    return {Kind::extern_type, type.name.text, type.name.text, type.doc, source(type.span)};
  }

  Section section(ast::ExternFunction const& function) const {
    Section s{Kind::extern_function, function.name.text, "", function.doc, source(function.span)};
    s.parameters = parameters(function.parameters);
    s.signature = fmt::format("{}{} -> {}", function.name.text, s.parameters.empty() ? "()" : spell(s.parameters), text(function.result));
    return s;
  }

  // ---- Families ----

  void find_example(ast::Rule const& rule, Section& s) const {
    for (int const n : {2, 3, 1}) {
      std::vector<int> dimensions(rule.dimension_parameters.size(), n);
      for (;;) {
        source::Diagnostics unseen;  // a family need not be right in all dimensions
        auto example = sema::instantiate(modules_, rule.name.text, dimensions, n, unseen);
        if (example && !unseen.has_errors()) {
          analysis::Verdict verdict = analysis::analyze(*example);
          if (verdict.accepted()) {
            s.rule = std::move(*example);
            s.plan = std::move(verdict.plan);
            return;
          }
        }
        // Downwards, the last one first.
        std::size_t at = dimensions.size();
        while (at > 0 && dimensions[at - 1] == 0) dimensions[--at] = n;
        if (at == 0) break;
        --dimensions[at - 1];
      }
    }
  }

  source::Sources const& sources_;
  sema::Modules const& modules_;
  ir::Program const& program_;
  std::vector<analysis::Verdict> const& verdicts_;
};

}  // namespace

Module describe(source::Sources const& sources, sema::Modules const& modules, ir::Program const& program,
                std::vector<analysis::Verdict> const& verdicts) {
  return Describer(sources, modules, program, verdicts).describe();
}

}  // namespace jrule::docs
