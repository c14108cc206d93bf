// The values that the orbits of a result may have, literally as the language says it (theory: section 5) and nothing clever:
// the oracle for embeddings, as engine.h is for topology. Expressions are evaluated here from the language reference alone.
#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include "compiler/ir/rule_scheme.h"
#include "jrule/value.h"
#include "tests/reference/engine.h"

namespace jrule::reference {

/// Of each embedding, the value at each dart.
using PlainValues = std::vector<std::map<Dart, Value>>;

/// A π-orbit of the result.
struct OrbitValues {
  enum class Source { clause, kept, merged, fresh } source = Source::fresh;
  std::size_t embedding = 0;
  std::vector<Dart> darts;
  std::vector<Value> allowed;  ///< it has one of these; none where no value is given
  /// What a clause gives to darts that the right side's own arcs hold together: its value at each pattern dart whose copy of its
  /// node is among them. An orbit may consist of several such parts, which meet beyond the rule.
  struct Part {
    std::size_t clause;
    std::vector<Value> values;  ///< one for each pattern dart
  };
  std::vector<Part> parts{};
};

/// Of every orbit of every embedding, on the result of a derivation from `before`. For rules without parameters, lets and C++ from
/// outside, whose values are of the types Bool, Int and Real; throws std::invalid_argument for others.
std::vector<OrbitValues> orbit_values(ir::RuleScheme const& rule, PlainMap const& before, PlainValues const& values,
                                      Derivation const& derivation);

}  // namespace jrule::reference
