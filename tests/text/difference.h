// Structural comparison of rules: every field but spans and the names of modules.
#pragma once

#include <optional>
#include <string>

#include "compiler/ir/rule_scheme.h"

namespace jrule::tests {

/// Are nodes and arcs compared in their order, or are the nodes told by their names, and arcs in any order?
enum class Order { kept, free };

/// The first thing in which the rules differ, their own names apart; none if there is no such thing.
std::optional<std::string> difference(ir::RuleScheme const& a, ir::RuleScheme const& b, Order order);
std::optional<std::string> difference(ir::Modeler const& a, ir::Modeler const& b);

}  // namespace jrule::tests
