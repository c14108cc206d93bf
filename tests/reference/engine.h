// The application of a rule scheme, literally as the paper writes it (sections 2.2, 6.1 to 6.3) and nothing clever: the oracle
// that the interpreter and generated code are held against. It shares nothing with them but the rule.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include <tl/expected.hpp>

#include "compiler/ir/rule_scheme.h"
#include "tests/reference/plain_map.h"

namespace jrule::reference {

/// A node (u, s) of an instantiated side: a copy of the scheme's node s at the pattern dart u.
using Copy = std::pair<Dart, ir::NodeId>;

struct Derivation {
  PlainMap result;              ///< H of G ⇒ H
  std::map<Copy, Dart> copies;  ///< m': where the nodes of ι(R, P) lie in H
  std::map<Copy, Dart> match;   ///< m: where the nodes of ι(L, P) lie in G
};

/// The direct derivation G ⇒ H at these darts, one for each hook; else why there is none. `map` must satisfy the incident-arcs
/// constraint. Any rule will do, sound or not. Requirements, clauses and embeddings are left out.
tl::expected<Derivation, std::string> derive(ir::RuleScheme const& rule, PlainMap const& map,
                                             std::vector<Dart> const& hooks);

}  // namespace jrule::reference
