#include "compiler/backend/cpp/externs.h"

#include <fmt/format.h>

#include <string_view>

#include "compiler/backend/cpp/names.h"

namespace jrule::cpp {

namespace {

struct Headers {
  std::set<std::string>& headers;
  source::Diagnostics& diagnostics;

  // An ir::ExternType or ir::ExternFunction.
  template <class Extern>
  void add(Extern const& declared, std::string_view what) {
    headers.insert(declared.header);
    for (std::string_view rest = declared.cpp_name; !rest.empty();) {
      std::size_t const end = rest.find("::");
      std::string_view const part = rest.substr(0, end);
      if (std::string_view const why = unusable(part); !why.empty()) {
        diagnostics.add({.code = source::Code::name_not_usable_in_cpp,
                         .span = declared.span,
                         .message = fmt::format("the extern {} `{}` cannot be `{}` in C++: `{}` {}", what,
                                                declared.name, declared.cpp_name, part, why)});
      }
      rest = end == std::string_view::npos ? std::string_view{} : rest.substr(end + 2);
    }
  }

  void add(ir::ExprType const& type) {
    if (type.external) add(*type.external, "type");
  }

  void add(ir::ExprPtr const& expr) {
    if (!expr) return;
    if (auto const* const call = std::get_if<ir::Call>(&expr->value)) add(*call->function, "function");
    for (ir::ExprPtr const& part : ir::parts(*expr)) add(part);
  }

  void add(std::vector<ir::Parameter> const& parameters) {
    for (ir::Parameter const& p : parameters) {
      add(p.value_type());
      add(p.computed_default);
    }
  }

  void add(ir::Block const& block) {
    for (ir::Statement const& statement : block) {
      for (ir::ExprPtr const& expr : ir::expressions(statement)) {
        add(expr->type);
        add(expr);
      }
      for (ir::Block const* inner : ir::blocks(statement)) add(*inner);
    }
  }
};

}  // namespace

void add_headers(ir::Modeler const& modeler, std::set<std::string>& headers, source::Diagnostics& diagnostics) {
  Headers result{headers, diagnostics};
  for (ir::EmbeddingExterns const& externs : modeler.externs) {
    if (externs.type) result.add(*externs.type, "type");
    if (externs.merge) result.add(*externs.merge, "function");
    result.add(externs.default_value);
  }
}

void add_headers(ir::RuleScheme const& rule, std::set<std::string>& headers, source::Diagnostics& diagnostics) {
  Headers result{headers, diagnostics};
  result.add(rule.parameters);
  for (ir::Let const& let : rule.lets) {
    result.add(let.value->type);
    result.add(let.value);
  }
  for (ir::Requirement const& requirement : rule.requirements) result.add(requirement.condition);
  for (ir::Clause const& clause : rule.clauses) result.add(clause.value);
}

void add_headers(ir::Operation const& operation, std::set<std::string>& headers, source::Diagnostics& diagnostics) {
  Headers result{headers, diagnostics};
  result.add(operation.parameters);
  if (operation.result) result.add(*operation.result);
  result.add(operation.body);
}

}  // namespace jrule::cpp
