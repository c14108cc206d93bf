// Checks a certificate against its rule, from the definitions: shares no code with the analysis and the algebra, only their data.
#pragma once

#include <optional>
#include <string>

#include "compiler/analysis/certificate.h"

namespace jrule::certificate {

/// What is wrong with the certificate; none if it proves the rule. `rule` must satisfy ir::verify.
std::optional<std::string> fault(analysis::Certificate const& certificate, ir::RuleScheme const& rule);

}  // namespace jrule::certificate
