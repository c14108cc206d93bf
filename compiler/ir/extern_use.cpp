#include "compiler/ir/extern_use.h"

#include <fmt/format.h>

namespace jrule::ir {

namespace {

using Found = std::optional<ExternUse>;

Found use_in(ExprPtr const& expr, std::string const& user) {
  Expr const* const call = expr ? find_call(*expr) : nullptr;
  if (!call) return {};
  ExternFunction const& function = *std::get<Call>(call->value).function;
  return ExternUse{call->span, fmt::format("{} calls the extern function `{}`", user, function.name), function.span};
}

Found use_of(ExternTypePtr const& type, Span span, std::string const& user) {
  if (!type) return {};
  return ExternUse{span, fmt::format("{} has the extern type `{}`", user, type->name), type->span};
}

Found use_in(Modeler const& modeler) {
  for (std::size_t e = 0; e < modeler.externs.size(); ++e) {
    EmbeddingExterns const& externs = modeler.externs[e];
    std::string const& name = modeler.embeddings[e].name;
    Span const span = modeler.embedding_spans[e];
    if (Found use = use_of(externs.type, span, fmt::format("the embedding `{}`", name))) return use;
    if (Found use = use_in(externs.default_value, fmt::format("the default of `{}`", name))) return use;
    if (externs.merge) {
      return ExternUse{
          span, fmt::format("the embedding `{}` is merged by the extern function `{}`", name, externs.merge->name),
          externs.merge->span};
    }
  }
  return {};
}

}  // namespace

Expr const* find_call(Expr const& expr) {
  if (std::holds_alternative<Call>(expr.value)) return &expr;
  for (ExprPtr const& part : parts(expr)) {
    if (Expr const* const call = find_call(*part)) return call;
  }
  return nullptr;
}

std::optional<ExternUse> find_extern_use(RuleScheme const& rule) {
  if (Found use = use_in(*rule.modeler)) return use;
  for (Parameter const& p : rule.parameters) {
    if (Found use = use_of(p.external, p.span, fmt::format("the parameter `{}`", p.name))) return use;
    if (Found use = use_in(p.computed_default, fmt::format("the default of `{}`", p.name))) return use;
  }
  for (Let const& let : rule.lets) {
    if (Found use = use_in(let.value, fmt::format("`{}`", let.name))) return use;
  }
  for (Requirement const& requirement : rule.requirements) {
    if (Found use = use_in(requirement.condition, "a requirement")) return use;
  }
  for (Clause const& clause : rule.clauses) {
    std::string const& embedding = rule.modeler->embeddings[clause.embedding].name;
    if (Found use = use_in(clause.value, fmt::format("`{}` of `{}`", embedding, rule.nodes[clause.node].name)))
      return use;
  }
  return {};
}

}  // namespace jrule::ir
