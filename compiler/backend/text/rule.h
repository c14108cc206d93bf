// Rules as text.
#pragma once

#include <string>
#include <vector>

#include "compiler/algebra/group.h"
#include "compiler/backend/text/print_jrule.h"

namespace jrule::text {

/// `///` lines, each with the indent; empty without documentation.
Spelled<std::string> spell_documentation(std::string const& doc, std::string const& indent);

/// `(side: Real = 1.0)`; empty if there are none.
Spelled<std::string> spell_parameters(std::vector<ir::Parameter> const& parameters, algebra::Group const& group);

/// The item `rule NAME(…) on MODELER { … }`, its name and modeler as given.
Spelled<std::string> spell_rule(ir::RuleScheme const& rule, std::string const& name, std::string const& modeler);

}  // namespace jrule::text
