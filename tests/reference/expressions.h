// Expressions on plain maps: an evaluator written from the language reference.
#pragma once

#include <variant>
#include <vector>

#include "tests/reference/values.h"

namespace jrule::reference {

/// The orbits of these words: every dart of the map in one of them, in ascending order.
std::vector<std::vector<Dart>> orbits(PlainMap const& map, OrbitType const& type);

/// Where a word leads from a dart of a map that satisfies the incident-arcs constraint.
Dart walk(PlainMap const& map, Dart d, Word const& word);

/// The map before the application, its values, and where the left side lies in it.
struct Ground {
  PlainMap const& map;
  PlainValues const& values;
  std::map<Copy, Dart> const& match;
};

/// The value of an expression that is neither a list nor a dart, at the pattern dart u.
Value value_at(ir::Expr const& expr, Ground const& ground, Dart u);

}  // namespace jrule::reference
