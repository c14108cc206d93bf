// The certificate of an accepted rule.
#pragma once

#include "compiler/analysis/certificate.h"

namespace jrule::analysis {

/// The rule must be accepted by analyze(); throws std::logic_error where it finds no proof of what that accepted. Of what the left
/// side says, only what the conditions need is in the certificate.
Certificate certify(ir::RuleScheme const& rule);

}  // namespace jrule::analysis
