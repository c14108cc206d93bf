#include "compiler/sema/models.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "compiler/algebra/group.h"
#include "compiler/sema/names.h"
#include "compiler/sema/types.h"

namespace jrule::sema {

using source::Code;
using source::Diagnostics;

namespace {

std::vector<std::string> const builtin_names = {"gmap", "omap", "dual_omap", "closed_gmap"};

// A condition over dimensions, `i + 2 <= j`: integers, + - *, comparisons, and or not.
struct Where {
  DimensionValues const& values;
  Diagnostics& diagnostics;
  bool good = true;

  std::int64_t fail(ast::Expr const& expr) {
    if (good) {
      diagnostics.add({.code = Code::bad_exchange,
                       .span = expr.span,
                       .message = "this is not part of a condition on two dimensions",
                       .notes = {"a condition is made of the two names, numbers, `+ - *`, comparisons and `and or not`"}});
    }
    good = false;
    return 0;
  }

  std::int64_t evaluate(ast::Expr const& expr) {
    if (auto const* number = std::get_if<ast::IntLiteral>(&expr.value)) return number->value;
    if (auto const* name = std::get_if<ast::NameExpr>(&expr.value)) {
      auto const known = values.find(name->name);
      return known == values.end() ? fail(expr) : known->second;
    }
    if (auto const* unary = std::get_if<ast::Unary>(&expr.value)) {
      std::int64_t const x = evaluate(*unary->operand);
      return unary->op == ast::UnaryOp::negate ? -x : static_cast<std::int64_t>(x == 0);
    }
    auto const* binary = std::get_if<ast::Binary>(&expr.value);
    if (!binary) return fail(expr);
    // Dimensions are small, but a literal need not be: unsigned arithmetic wraps instead of overflowing.
    auto const a = evaluate(*binary->left), b = evaluate(*binary->right);
    auto const ua = static_cast<std::uint64_t>(a), ub = static_cast<std::uint64_t>(b);
    switch (binary->op) {
      case ast::BinaryOp::add: return static_cast<std::int64_t>(ua + ub);
      case ast::BinaryOp::subtract: return static_cast<std::int64_t>(ua - ub);
      case ast::BinaryOp::multiply: return static_cast<std::int64_t>(ua * ub);
      case ast::BinaryOp::divide: return fail(expr);
      case ast::BinaryOp::less: return a < b;
      case ast::BinaryOp::less_equal: return a <= b;
      case ast::BinaryOp::greater: return a > b;
      case ast::BinaryOp::greater_equal: return a >= b;
      case ast::BinaryOp::equal: return a == b;
      case ast::BinaryOp::not_equal: return a != b;
      case ast::BinaryOp::logical_and: return a != 0 && b != 0;
      case ast::BinaryOp::logical_or: return a != 0 || b != 0;
    }
    return fail(expr);
  }
};

std::optional<std::vector<int>> evaluate_dimensions(std::vector<ast::OrbitElement> const& elements,
                                                    DimensionValues const& values, Diagnostics& diagnostics) {
  std::vector<int> result;
  auto const add = [&](int d, source::Span span) {
    if (d < 0 || d > max_dimension) {
      diagnostics.add({.code = Code::bad_model_dimension,
                       .span = span,
                       .message = fmt::format("dimension {} is out of range: dimensions are 0 to {}", d, max_dimension)});
      return false;
    }
    if (std::find(result.begin(), result.end(), d) == result.end()) result.push_back(d);
    return true;
  };
  for (ast::OrbitElement const& element : elements) {
    if (auto const* letter = std::get_if<ast::Letter>(&element.value); letter && !letter->conjugate) {
      auto const d = evaluate(letter->dimension, values, diagnostics);
      if (!d || !add(*d, element.span)) return {};
    } else if (auto const* range = std::get_if<ast::Range>(&element.value)) {
      auto const first = evaluate(range->first, values, diagnostics);
      auto const last = evaluate(range->last, values, diagnostics);
      if (!first || !last) return {};
      for (int d = *first; d <= *last; ++d) {
        if (!add(d, element.span)) return {};
      }
    } else {
      diagnostics.add({.code = Code::bad_model_dimension, .span = element.span, .message = "expected a dimension or a range"});
      return {};
    }
  }
  std::sort(result.begin(), result.end());
  return result;
}

bool add_exchange(Model& model, ast::Exchange const& exchange, DimensionValues const& values, Diagnostics& diagnostics) {
  auto const add = [&](int i, int j) {
    std::pair<int, int> const pair{std::min(i, j), std::max(i, j)};
    if (!model.exchanges(i, j)) model.exchange.push_back(pair);
  };
  if (auto const* where = std::get_if<ast::ExchangeWhere>(&exchange.value)) {
    for (int i : model.dimensions) {
      for (int j : model.dimensions) {
        if (i >= j) continue;
        DimensionValues inner = values;
        inner[where->i.text] = i;
        inner[where->j.text] = j;
        Where condition{inner, diagnostics};
        bool const holds = condition.evaluate(*where->condition) != 0;
        if (!condition.good) return false;
        if (holds) add(i, j);
      }
    }
    return true;
  }
  for (auto const& [first, second] : std::get<ast::ExchangePairs>(exchange.value).pairs) {
    auto const i = evaluate_in(model, first, values, diagnostics);
    auto const j = evaluate_in(model, second, values, diagnostics);
    if (!i || !j) return false;
    if (*i == *j) {
      diagnostics.add({.code = Code::bad_exchange,
                       .span = join(first.span, second.span),
                       .message = fmt::format("a pair of exchangeable dimensions needs two of them, not {} twice", *i)});
      return false;
    }
    add(*i, *j);
  }
  return true;
}

std::optional<Model> elaborate_model(ast::Model const& declared, std::optional<int> n, Diagnostics& diagnostics) {
  DimensionValues values;
  if (declared.parameter) values[declared.parameter->text] = *n;
  auto const dimensions = evaluate_dimensions(declared.dimensions, values, diagnostics);
  auto const oriented = evaluate_dimensions(declared.oriented, values, diagnostics);
  if (!dimensions || !oriented) return {};
  if (dimensions->empty()) {
    diagnostics.add({.code = Code::bad_model_dimension, .span = declared.name.span,
                     .message = fmt::format("the model `{}` has no dimensions", declared.name.text)});
    return {};
  }
  Model model;
  model.name = declared.name.text;
  model.dimension = dimensions->back();
  model.dimensions = *dimensions;
  model.closed = declared.closed.has_value();
  for (int d : *oriented) {
    if (!model.has(d)) {
      diagnostics.add({.code = Code::dimension_not_in_model, .span = join(declared.oriented.front().span, declared.oriented.back().span),
                       .message = fmt::format("the model `{}` orients {}, which is none of its dimensions", model.name, d)});
      return {};
    }
    model.oriented = static_cast<std::uint16_t>(model.oriented | (1U << d));
  }
  for (ast::Exchange const& exchange : declared.exchanges) {
    if (!add_exchange(model, exchange, values, diagnostics)) return {};
  }
  std::sort(model.exchange.begin(), model.exchange.end());
  if (auto const why = algebra::Group::undecided(model)) {
    diagnostics.add({.code = Code::undecided_model, .span = declared.name.span,
                     .message = fmt::format("rules on the model `{}` cannot be analysed: {}", model.name, *why),
                     .notes = {"paths are compared in the group of the model, which is decided for all other models"}});
    return {};
  }
  return model;
}

}  // namespace

std::optional<Model> resolve_model(ast::ModelRef const& ref, Items const& items, DimensionValues const& values,
                                   Diagnostics& diagnostics) {
  bool const builtin = std::find(builtin_names.begin(), builtin_names.end(), ref.name.text) != builtin_names.end();
  ast::Model const* const declared = items.model(ref.name.text);
  if (!declared && !builtin) {
    std::vector<std::string> known = items.names<ast::Model>();
    known.insert(known.end(), builtin_names.begin(), builtin_names.end());
    report_unknown(diagnostics, Code::unknown_model, ref.name, "model", known);
    return {};
  }
  std::optional<int> n;
  if (ref.dimension) {
    n = evaluate(*ref.dimension, values, diagnostics);
    if (!n) return {};
  }
  bool const takes_dimension = !declared || declared->parameter;
  if (takes_dimension != n.has_value()) {
    diagnostics.add({.code = Code::bad_model_dimension, .span = ref.span,
                     .message = takes_dimension ? fmt::format("`{}` needs its dimension: `{}(2)`", ref.name.text, ref.name.text)
                                                : fmt::format("`{}` takes no dimension", ref.name.text)});
    return {};
  }
  if (declared) return elaborate_model(*declared, n, diagnostics);
  std::optional<Model> model = builtin_model(ref.name.text, *n);
  if (!model) {
    diagnostics.add({.code = Code::bad_model_dimension, .span = ref.span,
                     .message = fmt::format("there is no `{}({})`: the dimension is at least {} and at most {}", ref.name.text, *n,
                                            ref.name.text == "gmap" || ref.name.text == "closed_gmap" ? 0 : 1, max_dimension)});
  }
  return model;
}

void check_model(ast::Model const& model, Diagnostics& diagnostics) {
  if (!model.parameter) {
    (void)elaborate_model(model, {}, diagnostics);
    return;
  }
  // A model may make sense for some n only; it is checked where it is used. Here: is there any n at all?
  std::optional<Diagnostics> first;
  for (int n = 0; n <= max_dimension; ++n) {
    Diagnostics trial;
    if (elaborate_model(model, n, trial)) return;
    if (n == 2) first = trial;
  }
  for (source::Diagnostic const& d : first->all()) diagnostics.add(d);
}

std::shared_ptr<ir::Modeler const> elaborate_modeler(ast::Modeler const& declared, Items const& items, Externs const& externs,
                                                     Diagnostics& diagnostics) {
  std::optional<Model> model = resolve_model(declared.model, items, {}, diagnostics);
  if (!model) return {};
  auto modeler = std::make_shared<ir::Modeler>();
  modeler->name = declared.name.text;
  modeler->doc = declared.doc;
  modeler->model = std::move(*model);
  modeler->module = items.module_of(&declared);
  for (ast::EmbeddingDecl const& e : declared.embeddings) {
    if (auto const same = std::find_if(modeler->embeddings.begin(), modeler->embeddings.end(),
                                       [&](EmbeddingSpec const& other) { return other.name == e.name.text; });
        same != modeler->embeddings.end()) {
      auto const at = static_cast<std::size_t>(same - modeler->embeddings.begin());
      diagnostics.add({.code = Code::duplicate_name, .span = e.name.span,
                       .message = fmt::format("the embedding `{}` is declared twice", e.name.text),
                       .labels = {{modeler->embedding_spans[at], "first declared here"}}});
      continue;
    }
    auto const orbit = evaluate_orbit(modeler->model, e.orbit, {}, diagnostics);
    auto const type = resolve_stored_type(e.type, externs, diagnostics);
    if (!orbit || !type) continue;
    if (std::any_of(orbit->words.begin(), orbit->words.end(), [](Word const& word) { return word.size() > 2; })) {
      // Along a longer word, a rule can join two orbits that both lie outside of what it matches.
      diagnostics.add({.code = Code::long_orbit_word, .span = e.orbit.span,
                       .message = fmt::format("`{}` is on an orbit with a word of more than two letters", e.name.text),
                       .notes = {"a rule can join such orbits without touching a dart of them, which is not analysed",
                                 "every cell is an orbit of words of one or two letters"}});
      continue;
    }
    EmbeddingSpec spec;
    spec.name = e.name.text;
    spec.orbit = *orbit;
    spec.type = type->element;
    if (type->external) spec.extern_name = type->external->cpp_name;
    ir::EmbeddingExterns from_outside{type->external, {}, {}};
    if (e.default_value) {
      auto const value = evaluate_default(*e.default_value, *type, externs, diagnostics);
      if (!value && type->external) continue;
      // After an error any value will do: rules may use the embedding, and must not be told that they lack a value.
      constexpr std::array zero{0.0, 0.0, 0.0};
      spec.default_value = value ? value->value : from_components(type->element, zero);
      if (value) from_outside.default_value = value->computed;
    }
    if (e.merge) {
      auto const merge = resolve_merge(*e.merge, *type, externs, diagnostics);
      spec.merge = merge ? merge->policy : MergePolicy::first;
      if (merge) from_outside.merge = merge->function;
    }
    modeler->embeddings.push_back(std::move(spec));
    modeler->externs.push_back(std::move(from_outside));
    modeler->embedding_docs.push_back(e.doc);
    modeler->embedding_spans.push_back(e.name.span);
  }
  return modeler;
}

}  // namespace jrule::sema
