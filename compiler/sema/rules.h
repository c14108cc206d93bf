// Rules: from two sides as written to the table of a rule scheme (language reference, section 5).
#pragma once

#include <memory>
#include <optional>

#include "compiler/ir/rule_scheme.h"
#include "compiler/sema/dimensions.h"
#include "compiler/sema/externs.h"
#include "compiler/syntax/ast.h"

namespace jrule::sema {

/// The rule with its dimension parameters replaced by `values`, on that modeler. None if anything was reported. `name` is the
/// scheme's: "cone", "sew[2]". `declared_on` is the rule's own modeler if `modeler` is another one, which takes it by import;
/// then clauses for embeddings that only the former has are left out.
std::optional<ir::RuleScheme> elaborate_rule(ast::Rule const& rule, std::string const& name, std::string const& module,
                                             std::shared_ptr<ir::Modeler const> modeler, DimensionValues const& values,
                                             Externs const& externs, source::Diagnostics& diagnostics,
                                             ir::Modeler const* declared_on = nullptr);

}  // namespace jrule::sema
