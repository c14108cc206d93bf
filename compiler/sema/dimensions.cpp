#include "compiler/sema/dimensions.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <limits>

namespace jrule::sema {

using source::Code;
using source::Diagnostics;

std::optional<int> evaluate(ast::Dimension const& dimension, DimensionValues const& values, Diagnostics& diagnostics) {
  std::int64_t sum = 0;
  for (ast::DimensionTerm const& term : dimension.terms) {
    std::int64_t value = 0;
    if (auto const* number = std::get_if<std::int64_t>(&term.value)) {
      value = *number;
    } else {
      std::string const& name = std::get<std::string>(term.value);
      auto const known = values.find(name);
      if (known == values.end()) {
        diagnostics.add({.code = Code::unknown_dimension,
                         .span = term.span,
                         .message = fmt::format("`{}` is not a dimension parameter here", name),
                         .notes = {"a dimension is a number, or a parameter of the rule or model: `rule sew[i] on …`"}});
        return {};
      }
      value = known->second;
    }
    sum += term.negative ? -value : value;
    if (sum > std::numeric_limits<int>::max() || sum < std::numeric_limits<int>::min()) {
      diagnostics.add({.code = Code::unknown_dimension, .span = dimension.span, .message = "this dimension is out of range"});
      return {};
    }
  }
  return static_cast<int>(sum);
}

std::optional<int> evaluate_in(Model const& model, ast::Dimension const& dimension, DimensionValues const& values,
                               Diagnostics& diagnostics) {
  std::optional<int> const d = evaluate(dimension, values, diagnostics);
  if (!d || model.has(*d)) return d;
  diagnostics.add({.code = Code::dimension_not_in_model,
                   .span = dimension.span,
                   .message = fmt::format("a {} has no dimension {}", ir::map_name(model), *d),
                   .notes = {fmt::format("its dimensions are {}", fmt::join(model.dimensions, ", "))}});
  return {};
}

std::optional<Letter> evaluate_letter(Model const& model, ast::Letter const& letter, DimensionValues const& values,
                                      Diagnostics& diagnostics) {
  std::optional<int> const d = evaluate_in(model, letter.dimension, values, diagnostics);
  if (!d) return {};
  return Letter{static_cast<std::uint8_t>(*d), letter.conjugate && model.is_oriented(*d)};
}

std::optional<Word> evaluate_word(Model const& model, ast::Word const& word, DimensionValues const& values,
                                  Diagnostics& diagnostics) {
  Word result;
  bool good = true;
  for (ast::Letter const& letter : word.letters) {
    std::optional<Letter> const l = evaluate_letter(model, letter, values, diagnostics);
    good = good && l;
    if (l) result.push_back(*l);
  }
  return good ? std::optional(result) : std::nullopt;
}

std::optional<std::vector<Position>> evaluate_elements(Model const& model, std::vector<ast::OrbitElement> const& elements,
                                                       DimensionValues const& values, Diagnostics& diagnostics) {
  std::vector<Position> positions;
  bool good = true;
  for (ast::OrbitElement const& element : elements) {
    if (std::holds_alternative<ast::Removed>(element.value)) {
      positions.push_back({ast::Removed{}, element.span});
    } else if (auto const* letter = std::get_if<ast::Letter>(&element.value)) {
      std::optional<Letter> const l = evaluate_letter(model, *letter, values, diagnostics);
      good = good && l;
      if (l) positions.push_back({*l, element.span});
    } else if (auto const* word = std::get_if<ast::Word>(&element.value)) {
      std::optional<Word> const w = evaluate_word(model, *word, values, diagnostics);
      good = good && w;
      if (w) positions.push_back({*w, element.span});
    } else {
      auto const& range = std::get<ast::Range>(element.value);
      std::optional<int> const first = evaluate(range.first, values, diagnostics);
      std::optional<int> const last = evaluate(range.last, values, diagnostics);
      good = good && first && last;
      if (!first || !last || *first > *last) continue;  // `0..i-2` for i = 1 is empty, and so means no position
      // Only the ends can be reported at their place; between them every dimension must be the model's too.
      for (int d = *first; d <= *last; ++d) {
        if (!model.has(d)) {
          diagnostics.add({.code = Code::dimension_not_in_model,
                           .span = element.span,
                           .message = fmt::format("a {} has no dimension {}", ir::map_name(model), d),
                           .notes = {fmt::format("its dimensions are {}", fmt::join(model.dimensions, ", "))}});
          good = false;
          break;
        }
        positions.push_back({Letter{static_cast<std::uint8_t>(d), false}, element.span});
      }
    }
  }
  return good ? std::optional(std::move(positions)) : std::nullopt;
}

namespace {

std::optional<OrbitType> evaluate_cell(Model const& model, ast::CellName const& cell, DimensionValues const& values,
                                       Diagnostics& diagnostics) {
  int dimension = 0;
  switch (cell.kind) {
    case ast::CellName::Kind::connected: return component_orbit(model);
    case ast::CellName::Kind::vertex: dimension = 0; break;
    case ast::CellName::Kind::edge: dimension = 1; break;
    case ast::CellName::Kind::face: dimension = 2; break;
    case ast::CellName::Kind::volume: dimension = 3; break;
    case ast::CellName::Kind::cell: {
      std::optional<int> const d = evaluate(*cell.dimension, values, diagnostics);
      if (!d) return {};
      dimension = *d;
      break;
    }
  }
  std::optional<OrbitType> orbit = cell_orbit(model, dimension);
  if (!orbit) {
    diagnostics.add({.code = Code::no_such_cell,
                     .span = cell.span,
                     .message = fmt::format("a {} has no {}-cells", ir::map_name(model), dimension)});
  }
  return orbit;
}

}  // namespace

std::optional<OrbitType> evaluate_orbit(Model const& model, ast::OrbitType const& orbit, DimensionValues const& values,
                                        Diagnostics& diagnostics) {
  if (auto const* cell = std::get_if<ast::CellName>(&orbit.value)) return evaluate_cell(model, *cell, values, diagnostics);
  auto const positions =
      evaluate_elements(model, std::get<ast::ElementList>(orbit.value).elements, values, diagnostics);
  if (!positions) return {};
  OrbitType result;
  for (Position const& position : *positions) {
    if (auto const* letter = std::get_if<Letter>(&position.value)) {
      result.words.push_back({*letter});
    } else if (auto const* word = std::get_if<Word>(&position.value)) {
      result.words.push_back(*word);
    } else {
      diagnostics.add({.code = Code::no_such_cell,
                       .span = position.span,
                       .message = "an orbit type lists dimensions; `_` has a meaning only where a node is decorated"});
      return {};
    }
  }
  return result;
}

}  // namespace jrule::sema
