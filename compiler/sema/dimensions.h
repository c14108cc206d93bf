// Dimensions, words and orbit types: from the user's spelling to values, with dimension parameters replaced.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "compiler/source/diagnostic.h"
#include "compiler/syntax/ast.h"
#include "compiler/ir/rule_scheme.h"
#include "jrule/model.h"

namespace jrule::sema {

/// The values of dimension parameters, by name.
using DimensionValues = std::map<std::string, int>;

/// The value of a sum such as `i-2`; none, reported (J0221), if a parameter is unknown or the value is out of int's range.
std::optional<int> evaluate(ast::Dimension const& dimension, DimensionValues const& values, source::Diagnostics& diagnostics);

/// The same, for a dimension that must be one of the model's (J0217).
std::optional<int> evaluate_in(Model const& model, ast::Dimension const& dimension, DimensionValues const& values,
                               source::Diagnostics& diagnostics);

/// A letter of the model; the conjugate of a non-oriented dimension is the dimension itself.
std::optional<Letter> evaluate_letter(Model const& model, ast::Letter const& letter, DimensionValues const& values,
                                      source::Diagnostics& diagnostics);
std::optional<Word> evaluate_word(Model const& model, ast::Word const& word, DimensionValues const& values,
                                  source::Diagnostics& diagnostics);

/// One position of a decoration, ranges spread out: removed, relabelled to a letter, or (in orbit types only) a word.
struct Position {
  std::variant<ast::Removed, Letter, Word> value;
  source::Span span;
};
/// All positions; none if one of them was reported.
std::optional<std::vector<Position>> evaluate_elements(Model const& model, std::vector<ast::OrbitElement> const& elements,
                                                       DimensionValues const& values, source::Diagnostics& diagnostics);

/// An orbit type of the model: `_` is not part of one, a cell must exist in the model (J0227).
std::optional<OrbitType> evaluate_orbit(Model const& model, ast::OrbitType const& orbit, DimensionValues const& values,
                                        source::Diagnostics& diagnostics);

}  // namespace jrule::sema
