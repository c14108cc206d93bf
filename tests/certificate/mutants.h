// Certificates that prove nothing: what a checker has to refuse.
#pragma once

#include <string>
#include <vector>

#include "compiler/analysis/certificate.h"

namespace jrule::certificate {

struct Mutant {
  std::string what;  ///< "relation 2: another word"
  analysis::Certificate certificate;
};

/// A right certificate with one thing wrong: an entry left out, another word, another arc, the other side, a step less, for every
/// place where that can be. `model` is that of the rule.
std::vector<Mutant> mutants(analysis::Certificate const& certificate, Model const& model);

}  // namespace jrule::certificate
