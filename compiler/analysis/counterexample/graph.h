// Arc-labelled graphs that need not be maps: what a rule that breaks the model leaves behind.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "jrule/map.h"

namespace jrule::analysis {

/// For each dart and dimension (by the model's column) the targets of its arcs. An erased dart is not in `darts`; an
/// arc from or to it is left dangling.
struct Graph {
  std::vector<std::vector<std::vector<Dart>>> targets;  ///< [dart][column], ascending
  std::vector<Dart> darts;                              ///< ascending
  bool contains(Dart d) const;
};

/// The arcs of a map, without its values.
Graph graph_of(Map const& map);

/// The first constraint of the model that the graph breaks, in the order of jrule::find_violation(Map).
std::optional<Violation> find_violation(Graph const& graph, Model const& model);

/// The graph as .jmap text (language reference, section 10), one line for each dart index: `-` where an arc is
/// missing, `3+7` where there are two, a comment after an erased dart. So it can be read back only if it is a map
/// without erased darts.
std::string print_graph(Graph const& graph, Model const& model);

}  // namespace jrule::analysis
