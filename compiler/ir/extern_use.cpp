#include "compiler/ir/extern_use.h"

#include <fmt/format.h>

#include <set>

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

Found use_in(std::vector<Parameter> const& parameters) {
  for (Parameter const& p : parameters) {
    if (Found use = use_of(p.external, p.span, fmt::format("the parameter `{}`", p.name))) return use;
    if (Found use = use_in(p.computed_default, fmt::format("the default of `{}`", p.name))) return use;
  }
  return {};
}

Found use_in(Block const& block) {
  for (Statement const& statement : block) {
    for (ExprPtr const& expr : expressions(statement)) {
      if (Found use = use_in(expr, "a statement")) return use;
    }
    for (Block const* inner : blocks(statement)) {
      if (Found use = use_in(*inner)) return use;
    }
  }
  return {};
}

// `seen`: the operations that were searched already.
Found use_in(Operation const& operation, Program const& program, std::set<std::size_t>& seen) {
  if (Found use = use_in(operation.parameters)) return use;
  if (Found use = use_in(operation.body)) return use;
  for (Called const& called : calls(operation.body)) {
    Found use;
    if (called.is_rule) {
      use = find_extern_use(program.rules[called.index]);
    } else if (seen.insert(called.index).second) {
      use = use_in(program.operations[called.index], program, seen);
    }
    if (use) return use;
  }
  return {};
}

}  // namespace

std::optional<ExternUse> find_extern_use(Operation const& operation, Program const& program) {
  if (Found use = use_in(*operation.modeler)) return use;
  std::set<std::size_t> seen;
  return use_in(operation, program, seen);
}

Expr const* find_call(Expr const& expr) {
  if (std::holds_alternative<Call>(expr.value)) return &expr;
  for (ExprPtr const& part : parts(expr)) {
    if (Expr const* const call = find_call(*part)) return call;
  }
  return nullptr;
}

std::optional<ExternUse> find_extern_use(RuleScheme const& rule) {
  if (Found use = use_in(*rule.modeler)) return use;
  if (Found use = use_in(rule.parameters)) return use;
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
