// The Builder's imports, models, modelers, rules and extern declarations.
#include <algorithm>
#include <string_view>

#include "compiler/syntax/build.h"

namespace jrule::syntax {

using source::Code;

namespace {

/// The text of a `///` line without its slashes, one space, and the white space at its end.
std::string doc_line(std::string_view text) {
  text.remove_prefix(3);
  if (text.starts_with(' ')) text.remove_prefix(1);
  text = text.substr(0, text.find_last_not_of(" \t\f") + 1);
  return std::string(text);
}

}  // namespace

void Builder::error(source::Diagnostic diagnostic) {
  has_failed_ = true;
  diagnostics_.add(std::move(diagnostic));
}

std::string Builder::doc(antlr4::Token* token) const {
  // The last run of `///` on consecutive lines; other comments between it and the token do no harm.
  auto const& tokens = parser_.tokens();
  std::vector<std::string> lines;
  std::size_t line_below = 0;
  for (auto i = token->getTokenIndex(); i-- > 0 && tokens[i]->getChannel() != antlr4::Token::DEFAULT_CHANNEL;) {
    bool const belongs = lines.empty() || tokens[i]->getLine() + 1 == line_below;
    if (tokens[i]->getType() != JRuleParser::DOC || !belongs) {
      if (lines.empty()) continue;
      break;
    }
    lines.push_back(doc_line(tokens[i]->getText()));
    line_below = tokens[i]->getLine();
  }
  std::string text;
  for (auto line = lines.rbegin(); line != lines.rend(); ++line) {
    if (line != lines.rbegin()) text += '\n';
    text += *line;
  }
  return text;
}

ast::Item Builder::item(JRuleParser::ItemContext* tree) {
  if (auto* t = tree->importItem()) return import_item(t);
  if (auto* t = tree->modelItem()) return model(t);
  if (auto* t = tree->modelerItem()) return modeler(t);
  if (auto* t = tree->ruleItem()) return rule(t);
  if (auto* t = tree->operationItem()) return operation(t);
  return extern_item(tree->externItem());
}

ast::Import Builder::import_item(JRuleParser::ImportItemContext* tree) {
  ast::Import result;
  for (auto* part : tree->moduleName()) result.path.push_back(name(part->getStart()));
  result.span = span(tree);
  return result;
}

// ---- Models and modelers ----

ast::Model Builder::model(JRuleParser::ModelItemContext* tree) {
  ast::Model result;
  result.doc = doc(tree->getStart());
  auto const names = tree->name();
  result.name = name(names[0]);
  if (names.size() > 1) result.parameter = name(names[1]);
  for (auto* statement : tree->modelStatement()) model_statement(statement, result);
  result.span = span(tree);
  return result;
}

void Builder::model_statement(JRuleParser::ModelStatementContext* tree, ast::Model& model) {
  if (tree->KW_EXCHANGE() != nullptr) {
    model.exchanges.push_back(exchange(tree));
  } else if (tree->KW_CLOSED() != nullptr) {
    model.closed = span(tree);
  } else {
    auto& into = tree->KW_DIMENSIONS() != nullptr ? model.dimensions : model.oriented;
    for (auto* range : tree->dimensionRange()) into.push_back(dimension_range(range));
  }
}

ast::Exchange Builder::exchange(JRuleParser::ModelStatementContext* tree) {
  std::vector<std::pair<ast::Dimension, ast::Dimension>> pairs;
  for (auto* pair : tree->dimensionPair()) {
    auto const dimensions = pair->dimension();
    pairs.emplace_back(dimension(dimensions[0]), dimension(dimensions[1]));
  }
  if (tree->KW_WHERE() == nullptr) return {ast::ExchangePairs{std::move(pairs)}, span(tree)};

  auto const bound_name = [this](ast::Dimension const& dimension) {
    auto const* text = std::get_if<std::string>(&dimension.terms[0].value);
    if (text != nullptr && dimension.terms.size() == 1) return ast::Name{*text, dimension.span};
    error({.code = Code::syntax_error,
           .span = dimension.span,
           .message = "expected a name: `where` speaks about the two dimensions by their names",
           .notes = {"for example `exchange (i, j) where i + 2 <= j;`"}});
    return ast::Name{{}, dimension.span};
  };
  auto i = bound_name(pairs[0].first);
  auto j = bound_name(pairs[0].second);
  return {ast::ExchangeWhere{std::move(i), std::move(j), expression(tree->expression())}, span(tree)};
}

ast::Modeler Builder::modeler(JRuleParser::ModelerItemContext* tree) {
  ast::Modeler result;
  result.doc = doc(tree->getStart());
  result.name = name(tree->name());
  result.model = model_reference(tree->modelReference());
  for (auto* declaration : tree->embedding()) result.embeddings.push_back(embedding(declaration));
  result.span = span(tree);
  return result;
}

ast::ModelRef Builder::model_reference(JRuleParser::ModelReferenceContext* tree) {
  ast::ModelRef result;
  result.name = name(tree->name());
  if (auto* d = tree->dimension()) result.dimension = dimension(d);
  result.span = span(tree);
  return result;
}

ast::EmbeddingDecl Builder::embedding(JRuleParser::EmbeddingContext* tree) {
  ast::EmbeddingDecl result;
  result.doc = doc(tree->getStart());
  result.name = name(tree->name());
  result.orbit = orbit_type(tree->orbitType());
  result.type = type_name(tree->typeName());
  for (auto* policy : tree->policy()) {
    bool const is_merge = policy->KW_MERGE() != nullptr;
    if (is_merge ? result.merge.has_value() : result.default_value != nullptr) {
      error({.code = Code::syntax_error,
             .span = span(policy),
             .message = std::string("a second `") + (is_merge ? "merge" : "default") + "` for the embedding `" +
                        result.name.text + "`"});
    } else if (is_merge) {
      result.merge = name(policy->name());
    } else {
      result.default_value = expression(policy->expression());
    }
  }
  result.span = span(tree);
  return result;
}

ast::TypeName Builder::type_name(JRuleParser::TypeNameContext* tree) {
  return {name(tree->name()), tree->LBRACKET() != nullptr};
}

// ---- Rules ----

ast::Rule Builder::rule(JRuleParser::RuleItemContext* tree) {
  ast::Rule result;
  result.doc = doc(tree->getStart());
  auto const names = tree->name();
  result.name = name(names[0]);
  for (std::size_t i = 1; i < names.size(); ++i) result.dimension_parameters.push_back(name(names[i]));
  result.parameters = parameters(tree->parameters());
  result.on = model_reference(tree->modelReference());
  auto const sides = tree->side();
  result.left = side(sides[0]);
  result.right = side(sides[1]);
  for (auto* expectation : tree->expectation()) {
    ast::Name count = name(expectation->COUNT()->getSymbol());
    count.text.pop_back();
    result.expectations.push_back({std::move(count), expression(expectation->expression()), span(expectation)});
  }
  result.span = span(tree);
  return result;
}

std::vector<ast::Parameter> Builder::parameters(JRuleParser::ParametersContext* tree) {
  std::vector<ast::Parameter> result;
  if (tree == nullptr) return result;
  for (auto* parameter : tree->parameter()) {
    auto* value = parameter->expression();
    result.push_back(
        {name(parameter->name()), type_name(parameter->typeName()), value == nullptr ? nullptr : expression(value),
         doc(parameter->getStart())});
  }
  return result;
}

ast::Side Builder::side(JRuleParser::SideContext* tree) {
  ast::Side result;
  auto const items = tree->sideItem();
  result.items.reserve(items.size());
  for (auto* item : items) result.items.push_back(side_item(item));
  result.span = span(tree);
  return result;
}

ast::SideItem Builder::side_item(JRuleParser::SideItemContext* tree) {
  if (tree->node() != nullptr) return node(tree);
  if (auto* t = tree->let()) return let(t);
  if (auto* condition = tree->expression()) return ast::Require{expression(condition), parser_.text(condition->getStart(), condition->getStop()), span(tree)};
  return arc_chain(tree);
}

ast::Node Builder::node(JRuleParser::SideItemContext* tree) {
  ast::Node result;
  result.doc = doc(tree->getStart());
  result.hook = tree->KW_HOOK() != nullptr;
  result.name = name(tree->name());
  auto* body = tree->node();
  if (auto* decoration = body->elementList()) result.decoration = element_list(decoration);
  for (auto* clause : body->clause()) {
    result.clauses.push_back({name(clause->name()), expression(clause->expression()), span(clause)});
  }
  result.span = span(tree);
  return result;
}

ast::ArcChain Builder::arc_chain(JRuleParser::SideItemContext* tree) {
  ast::ArcChain result;
  result.nodes.push_back(name(tree->name()));
  for (auto* arc : tree->arc()) {
    result.steps.push_back(arc_step(arc));
    result.nodes.push_back(name(arc->name()));
  }
  result.span = span(tree);
  return result;
}

ast::ArcStep Builder::arc_step(JRuleParser::ArcContext* tree) {
  using Direction = ast::ArcStep::Direction;
  ast::ArcStep result;
  result.direction = tree->LESS() != nullptr    ? Direction::backward
                     : tree->ARROW() != nullptr ? Direction::forward
                                                : Direction::both;
  auto* label = tree->arcDimension();
  if (auto* sum = label->dimension()) {
    result.dimension = dimension(sum);
  } else {
    result.dimension = {{dimension_term(label->getStart(), false)}, span(label)};
  }
  if (auto* w = tree->word()) result.word = word(w);
  auto* last = parser_.previous(tree->name()->getStart());
  result.span = parser_.span(tree->getStart(), last);
  return result;
}

ast::Let Builder::let(JRuleParser::LetContext* tree) {
  return {name(tree->name()), expression(tree->expression()), span(tree)};
}

// ---- C++ from outside ----

ast::Item Builder::extern_item(JRuleParser::ExternItemContext* tree) {
  auto const strings = tree->STRING();
  auto const header = string(strings[0]->getSymbol());
  auto const cpp_name = string(strings[1]->getSymbol());
  auto const header_span = parser_.span(strings[0]->getSymbol()), cpp_name_span = parser_.span(strings[1]->getSymbol());
  auto const text = doc(tree->getStart());
  if (tree->KW_TYPE() != nullptr) {
    return ast::ExternType{text, name(tree->name()), header, cpp_name, header_span, cpp_name_span, span(tree)};
  }
  return ast::ExternFunction{text,
                             name(tree->name()),
                             parameters(tree->parameters()),
                             type_name(tree->typeName()),
                             header,
                             cpp_name,
                             header_span,
                             cpp_name_span,
                             span(tree)};
}

}  // namespace jrule::syntax
