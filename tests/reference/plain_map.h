// Maps as the paper writes them: a set of darts and a set of labelled arcs (Def. 6), nothing indexed, nothing implied.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "jrule/map.h"

namespace jrule::reference {

/// Any graph: a dart may have no d-arc or several, as the result of an unsound rule has.
struct PlainMap {
  std::vector<int> dimensions;
  std::map<Dart, std::map<int, std::vector<Dart>>> targets;  ///< of every dart and dimension, the outgoing arcs
  bool operator==(PlainMap const&) const = default;
};

/// The arcs of a map, without its values.
PlainMap plain(Map const& map);

/// The constraint of the model (Def. 9, and no loops if it is closed) that fails, and where; none if it is a map of the model.
std::optional<std::string> violation(PlainMap const& map, Model const& model);

/// Is there an isomorphism that maps each dart of `fixed` to its partner and keeps colours? Darts without a colour have none.
bool isomorphic(PlainMap const& a, PlainMap const& b, std::map<Dart, Dart> const& fixed,
                std::map<Dart, unsigned> const& colour_a, std::map<Dart, unsigned> const& colour_b);

}  // namespace jrule::reference
