#include "compiler/backend/cpp/modeler.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <set>

#include "compiler/backend/cpp/expression.h"
#include "compiler/backend/cpp/names.h"
#include "compiler/backend/cpp/text.h"
#include "compiler/backend/cpp/writer.h"

namespace jrule::cpp {

namespace {

std::string model_expression(Model const& model) {
  if (builtin_model(model.name, model.dimension) == model)
    return fmt::format("jrule::{}({})", model.name, model.dimension);
  std::vector<std::string> pairs;
  for (auto const& [i, j] : model.exchange) pairs.push_back(fmt::format("{{{}, {}}}", i, j));
  return fmt::format("{{{}, {}, {{{}}}, 0x{:x}, {{{}}}, {}}}", literal(model.name), model.dimension,
                     fmt::join(model.dimensions, ", "), model.oriented, fmt::join(pairs, ", "), model.closed);
}

void write_externs(Writer& out, ir::EmbeddingExterns const& externs, std::string const& type) {
  if (externs.type) {
    out.line("&jrule::make_pool<{}>,", type);
  } else {
    out.line("nullptr,");
  }
  if (externs.default_value) {
    out.open("[](jrule::Embedding& embedding) {{");
    out.line("return jrule::rewrite::add<{}>(embedding, {});", type, constant_expression(*externs.default_value));
    out.close("},");
  } else {
    out.line("nullptr,");
  }
  if (!externs.merge) {
    out.line("nullptr,");
    return;
  }
  // A lambda, since the function may be one of several of its name.
  bool const pairwise = externs.merge->parameters.size() == 2;
  out.open("[](jrule::Embedding& embedding, std::span<jrule::Handle const> parts) {{");
  out.line("auto const merge = [](auto const&{}) {{ return ::{}({}); }};", pairwise ? " a, auto const& b" : " list",
           externs.merge->cpp_name, pairwise ? "a, b" : "list");
  out.line("return jrule::rewrite::{}<{}>(embedding, parts, merge);", pairwise ? "add_folded" : "add_merged_list", type);
  out.close("},");
}

void write_spec(Writer& out, ir::Modeler const& modeler, std::size_t e) {
  static constexpr std::string_view policies[] = {"none", "first", "mean", "min", "max", "function"};
  EmbeddingSpec const& spec = modeler.embeddings[e];
  ir::EmbeddingExterns const externs = modeler.externs_of(e);
  std::string const known = fmt::format(
      "{{{}, {}, jrule::Type::{}, {}, jrule::MergePolicy::{}", literal(spec.name), orbit_expression(spec.orbit),
      spec.type == Type::Extern ? "Extern" : to_string(spec.type),
      spec.default_value ? fmt::format("jrule::Value({})", literal(*spec.default_value)) : "std::nullopt",
      policies[static_cast<std::size_t>(spec.merge)]);
  if (!externs.type && !externs.default_value && !externs.merge) {
    out.text(known + "},");
    return;
  }
  out.open("{}, {},", known, literal(spec.extern_name));
  out.open("{{");
  write_externs(out, externs, type_name(modeler.value_type(e)));
  out.close("}");
  out.close("},");
}

void check_names(ir::Modeler const& modeler, std::string const& class_name, source::Diagnostics& diagnostics) {
  std::set<std::string> taken{class_name, "read",      "write", "from_map", "model",     "embeddings",
                              "map",      "workspace", "cells", "map_",     "workspace_"};
  for (std::size_t e = 0; e < modeler.embeddings.size(); ++e) {
    std::string const& name = modeler.embeddings[e].name;
    std::string why(unusable(name));
    for (std::string const& member : {name, "set_" + name}) {
      if (!taken.insert(member).second && why.empty())
        why = fmt::format("is a name of the generated class: it has another member `{}`", member);
    }
    if (why.empty()) continue;
    diagnostics.add(
        {.code = source::Code::name_not_usable_in_cpp,
         .span = e < modeler.embedding_spans.size() ? modeler.embedding_spans[e] : source::Span{},
         .message = fmt::format("the embedding `{}` cannot be a member function of the C++ class `{}`: its name {}",
                                name, class_name, why)});
  }
}

void write_accessors(Writer& out, ir::Modeler const& modeler, std::size_t e) {
  EmbeddingSpec const& spec = modeler.embeddings[e];
  ir::ExprType const value_type = modeler.value_type(e);
  std::string const type = type_name(value_type);
  bool const is_extern = value_type.external != nullptr;
  out.line();
  if (e < modeler.embedding_docs.size()) {
    for (std::string const& line : documentation(modeler.embedding_docs[e]))
      out.text(line.empty() ? "///" : "/// " + line);
  }
  out.line("/// The value of the {}-orbit of a dart{}.", jrule::to_string(spec.orbit),
           is_extern ? "; valid until a value is set or a rule applied" : "");
  out.line("{0} {1}(jrule::Dart dart) const {{ return jrule::rewrite::Values<{2}>(map_.embedding({3}))[dart]; }}",
           is_extern ? fmt::format("jrule::rewrite::Read<{}>", type) : type, spec.name, type, e);
  out.line("/// Gives the whole {}-orbit of a dart a new value. May throw std::bad_alloc; then nothing has changed.",
           jrule::to_string(spec.orbit));
  if (is_extern) {
    out.open("void set_{}(jrule::Dart dart, {} value) {{", spec.name, type);
    out.line("jrule::rewrite::set_extern_value<{}>(map_, {}, dart, std::move(value), workspace_);", type, e);
    out.close();
    return;
  }
  out.line(
      "void set_{}(jrule::Dart dart, {} value) {{ jrule::rewrite::set_value(map_, {}, dart, value, workspace_); }}",
      spec.name, type, e);
}

void write_statics(Writer& out, ir::Modeler const& modeler, std::string const& name) {
  out.line("static jrule::Model model() {{ return {}; }}", model_expression(modeler.model));
  if (modeler.embeddings.empty()) {
    out.line("static std::vector<jrule::EmbeddingSpec> embeddings() {{ return {{}}; }}");
  } else {
    out.open("static std::vector<jrule::EmbeddingSpec> embeddings() {{");
    out.open("return {{");
    for (std::size_t e = 0; e < modeler.embeddings.size(); ++e) write_spec(out, modeler, e);
    out.close("};");
    out.close();
  }
  out.line();
  out.line("/// An empty map.");
  out.line("{}() : map_(model(), embeddings()) {{}}", name);
  out.line("/// Reads a mesh (.obj .off .ply .stl) or a map (.jmap).");
  out.open("static jrule::Result<{}> read(std::string const& path) {{", name);
  out.line("auto map = jrule::read_map(path, model(), embeddings());");
  out.line("if (!map) return tl::unexpected(std::move(map).error());");
  out.line("return {}(std::move(*map));", name);
  out.close();
  out.line("/// Takes a map over, which must be one of this model with these embeddings.");
  out.open("static jrule::Result<{}> from_map(jrule::Map map) {{", name);
  out.line("auto checked = jrule::rewrite::expect_modeler(std::move(map), model(), embeddings());");
  out.line("if (!checked) return tl::unexpected(std::move(checked).error());");
  out.line("return {}(std::move(*checked));", name);
  out.close();
  out.line("/// Writes it in the format of the path's suffix; the file appears whole or not at all.");
  out.line("jrule::Result<void> write(std::string const& path) const {{ return jrule::write_map(map_, path); }}");
}

}  // namespace

std::string modeler_class(ir::Modeler const& modeler, std::string const& name, source::Diagnostics& diagnostics) {
  check_names(modeler, name, diagnostics);
  Writer out;
  for (std::string const& line : documentation(modeler.doc)) out.text(line.empty() ? "///" : "/// " + line);
  if (modeler.doc.empty())
    out.line("/// A {}{}.", ir::map_name(modeler.model), modeler.embeddings.empty() ? "" : " and its embeddings");
  out.open("class {} {{", name);
  out.lines(" public:\n");
  write_statics(out, modeler, name);
  out.line();
  out.line("jrule::Map const& map() const {{ return map_; }}");
  out.line("jrule::Map& map() {{ return map_; }}");
  out.line("/// Scratch memory of the rules.");
  out.line("jrule::rewrite::Workspace& workspace() {{ return workspace_; }}");
  out.line("/// One dart of each cell of that dimension, the smallest, in ascending order.");
  out.line("std::vector<jrule::Dart> cells(int dimension) const {{ return jrule::cells(map_, dimension); }}");
  for (std::size_t e = 0; e < modeler.embeddings.size(); ++e) write_accessors(out, modeler, e);
  out.line();
  out.lines(" private:\n");
  out.line("explicit {}(jrule::Map map) : map_(std::move(map)) {{}}", name);
  out.line();
  out.line("jrule::Map map_;");
  out.line("jrule::rewrite::Workspace workspace_;");
  out.close("};");
  return out.all();
}

}  // namespace jrule::cpp
