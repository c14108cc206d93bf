// Pictures: rules as DOT graphs, surfaces and counterexamples as SVG.
#pragma once

#include <string>
#include <vector>

#include "compiler/analysis/counterexample/counterexample.h"
#include "compiler/ir/rule_scheme.h"
#include "jrule/map.h"
#include "jrule/result.h"

namespace jrule::draw {

/// The rule as a Graphviz graph: left and right side as two clusters; preserved nodes black, deleted and added ones
/// red, the hook doubled; a non-oriented arc is one undirected edge, words in brackets, as in the paper's figures.
std::string rule_dot(ir::RuleScheme const& rule);

/// The rule as a standalone SVG in the manner of the papers' figures: left and right side, nodes that are on both at one place; hooks
/// have a double ring, deleted nodes are red, added ones green. Under its name a node says what becomes of each dimension of
/// the hook's type, `_` if its arcs go. 0-arcs are black, 1-arcs red and dashed, 2-arcs blue and double, 3-arcs green and dotted; an
/// arc without a reverse has a tip, and a small ring is at the end from which a word is read. Equal rules, equal bytes.
std::string rule_svg(ir::RuleScheme const& rule);

/// A surface seen from a fixed direction (from +x, +y and +z, y up), lit, hidden faces painted over, edges drawn: a
/// standalone SVG of at most `width` x `width` pixels. Needs an embedding of type Point3 (or Point2, then seen from +z)
/// on vertices; another embedding of type Color on faces colours them. An error for a map without darts, an open face
/// or a position that is missing or not finite. Cost: O(faces · log faces).
Result<std::string> surface_svg(Map const& map, int width = 800);

/// The same of several maps in one frame, so that pictures of a surface before and after can be compared: they are of one size, seen from
/// where the first one is, and what is at one place lies at one place. Vertices are dotted if asked for, so that one on a straight edge is seen. An error if one
/// of them has no picture.
Result<std::vector<std::string>> surface_svgs(std::vector<Map const*> const& maps, int width, bool with_vertices);

/// The map before and the graph after, side by side: darts as numbered dots, the hooks ringed, arcs coloured and labelled by
/// dimension, an arrow on those without a reverse, what breaks the model highlighted: a standalone SVG.
std::string graph_svg(ir::RuleScheme const& rule, analysis::Counterexample const& example);

}  // namespace jrule::draw
