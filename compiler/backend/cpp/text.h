// Pieces of generated C++ that stand for values, types, words and places.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "compiler/ir/rule_scheme.h"
#include "compiler/source/source.h"

namespace jrule::cpp {

/// "double", "std::int64_t", "jrule::Point3". Not of Type::Extern.
std::string type_name(Type type);
/// The same, "::geo::Soil" for an extern type, and "std::vector<double>" for a list.
std::string type_name(ir::ExprType const& type);
/// As an element of a std::vector that gives references: "std::uint8_t" for a Bool.
std::string stored_type(ir::ExprType const& type);
/// As a parameter: an extern type and a list are passed as references to constants.
std::string parameter_type(ir::ExprType const& type);
/// A C++ expression of that type: "0.5", "std::int64_t{3}", "jrule::Point3{0.0, 1.0, 0.0}".
std::string literal(Value const& value);
std::string literal(double value);
/// With its quotes.
std::string literal(std::string_view text);

/// A jrule::Word: "{{2, false}, {1, true}}".
std::string initializer(Word const& word);
/// "jrule::orbit_of_dimensions({0, 1})", or the words written out.
std::string orbit_expression(OrbitType const& orbit);
/// For names: "2_1", "2_b1" for [2,~1].
std::string name_part(Word const& word);


/// The name of the file without its folder, and the line: "surface.jrule:12".
std::string place(source::Sources const& sources, source::Span span);
std::string file_name(source::Sources const& sources, source::Span span);
/// "a -2[1]-> b".
std::string arc_text(ir::RuleScheme const& rule, ir::NodeId source, int dimension, Word const& word, ir::NodeId target);

/// The lines of a documentation comment, fit to stand after `///`.
std::vector<std::string> documentation(std::string_view doc);

}  // namespace jrule::cpp
