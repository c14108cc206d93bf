#include "compiler/sema/types.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <stdexcept>

#include "compiler/ir/evaluate.h"
#include "compiler/ir/extern_use.h"
#include "compiler/sema/expressions.h"
#include "compiler/sema/names.h"
#include "compiler/sema/overloads.h"

namespace jrule::sema {

using ir::Builtin;
using ir::ExprPtr;
using ir::ExprType;
using source::Code;
using source::Diagnostics;

namespace {

constexpr std::array own_types{Type::Bool, Type::Int,    Type::Real,   Type::Vec2,
                               Type::Vec3, Type::Point2, Type::Point3, Type::Color};

}  // namespace

std::optional<Type> find_type(std::string const& name) {
  auto const found = std::find_if(own_types.begin(), own_types.end(), [&](Type t) { return to_string(t) == name; });
  return found == own_types.end() ? std::nullopt : std::optional(*found);
}

std::optional<ExprType> resolve_type(ast::TypeName const& type, Externs const& externs, Diagnostics& diagnostics) {
  std::string const& name = type.name.text;
  if (auto const own = find_type(name)) return ExprType{*own, type.list, false, {}};
  if (auto const known = externs.types.find(name); known != externs.types.end()) {
    if (!known->second) return {};
    return ExprType{Type::Extern, type.list, false, known->second};
  }
  if (name == "Dart") {
    diagnostics.add({.code = Code::unknown_type,
                     .span = type.name.span,
                     .message = "a `Dart` cannot be stored",
                     .notes = {"a rule gets darts at its hooks, an expression by the nodes of the left side"}});
    return {};
  }
  std::vector<std::string> known;
  for (Type const t : own_types) known.push_back(to_string(t));
  for (std::string& t : externs.type_names()) known.push_back(std::move(t));
  report_unknown(diagnostics, Code::unknown_type, type.name, "type", known);
  return {};
}

std::optional<ExprType> resolve_stored_type(ast::TypeName const& type, Externs const& externs,
                                            Diagnostics& diagnostics) {
  auto resolved = resolve_type(type, externs, diagnostics);
  if (!resolved || !resolved->list) return resolved;
  diagnostics.add(
      {.code = Code::list_not_implemented,
       .span = type.name.span,
       .message = fmt::format("values of the list type `{}` are not yet implemented", to_string(*resolved))});
  return {};
}

namespace {

struct Policy {
  std::string_view name;
  MergePolicy policy;
  Builtin aggregate;
};
constexpr std::array policies{
    Policy{"mean", MergePolicy::mean, Builtin::mean}, Policy{"min", MergePolicy::min, Builtin::min},
    Policy{"max", MergePolicy::max, Builtin::max}, Policy{"first", MergePolicy::first, Builtin::first}};

std::optional<Merge> merge_by(ast::Name const& name, ir::ExternFunctionPtr function, ExprType const& type,
                              Diagnostics& diagnostics) {
  if (!function) return {};  // reported
  ExprType list = type;
  list.list = true;
  std::vector<ExprType> parameters;
  for (auto const& p : function->parameters) parameters.push_back(p.type);
  bool const fits = parameters == std::vector{type, type} || parameters == std::vector{list};
  if (fits && function->result == type) return Merge{MergePolicy::function, std::move(function)};
  std::string const t = to_string(type);
  diagnostics.add(
      {.code = Code::bad_merge,
       .span = name.span,
       .message =
           fmt::format("`{}` is `{}` and cannot merge values of type `{}`", name.text, ir::signature(*function), t),
       .labels = {{function->span, "declared here"}},
       .notes = {fmt::format("a function that merges them is `({0}, {0}) -> {0}` or `([{0}]) -> {0}`", t)}});
  return {};
}

}  // namespace

std::optional<Merge> resolve_merge(ast::Name const& name, ExprType const& type, Externs const& externs,
                                   Diagnostics& diagnostics) {
  if (auto const function = externs.functions.find(name.text); function != externs.functions.end()) {
    return merge_by(name, function->second, type, diagnostics);
  }
  auto const row = std::find_if(policies.begin(), policies.end(), [&](Policy const& p) { return p.name == name.text; });
  if (row == policies.end()) {
    std::vector<std::string> known{"mean", "min", "max", "first"};
    for (std::string& f : externs.function_names()) known.push_back(std::move(f));
    report_unknown(diagnostics, Code::bad_merge, name, "merge policy", known);
    return {};
  }
  if (row->policy == MergePolicy::first) return Merge{row->policy};
  std::vector<std::string> merged;
  for (Signature const& s : signatures(row->aggregate)) {
    if (!s.parameters.front().list || s.parameters.front().element != s.result.element) continue;
    if (s.parameters.front().element == type.element) return Merge{row->policy};
    merged.push_back(to_string(s.parameters.front().element));
  }
  source::Diagnostic d{.code = Code::bad_merge,
                       .span = name.span,
                       .message = fmt::format("values of type `{}` have no `{}`", to_string(type), name.text),
                       .notes = {fmt::format("`{}` merges values of type {}", name.text, fmt::join(merged, ", "))}};
  if (type.external)
    d.notes.push_back(fmt::format(
        "those of an extern type are merged by `first` or by an extern function `({0}, {0}) -> {0}`", to_string(type)));
  diagnostics.add(std::move(d));
  return {};
}

std::optional<Default> evaluate_default(ast::Expr const& expr, ExprType const& type, Externs const& externs,
                                        Diagnostics& diagnostics) {
  ExprContext context;
  context.externs = &externs;
  ExprPtr value = check_expression(expr, context, type, diagnostics);
  if (!value) return {};
  if (ir::find_call(*value)) return Default{{}, std::move(value)};
  auto const leaf = [](ir::Expr const&) -> ir::Evaluated { throw std::logic_error("a constant reads"); };
  return Default{std::get<Value>(ir::evaluate(*value, leaf)), {}};
}

}  // namespace jrule::sema
