// Parse tree -> AST. Also refuses what the grammar lets through so that it can stay within one token of lookahead.
#pragma once

#include <initializer_list>
#include <string>

#include "compiler/source/diagnostic.h"
#include "compiler/syntax/ast.h"
#include "compiler/syntax/item_parser.h"
#include "compiler/syntax/split.h"

namespace jrule::syntax {

/// The longest path in the tree of an expression: later stages may recurse over it. A sum of n terms has a path of n.
inline constexpr int depth_limit = 2 * static_cast<int>(nesting_limit);

/// Builds one item. After an error it goes on, for the sake of further errors; the item is then not to be used.
class Builder {
 public:
  Builder(ItemParser const& parser, source::Diagnostics& diagnostics) : parser_(parser), diagnostics_(diagnostics) {}

  ast::Item item(JRuleParser::ItemContext* tree);
  bool has_failed() const { return has_failed_; }

 private:
  /// An expression with the length of the longest path in its tree.
  struct Built {
    ast::ExprPtr expr;
    int depth = 1;
  };

  // build_item.cpp
  ast::Import import_item(JRuleParser::ImportItemContext* tree);
  ast::Model model(JRuleParser::ModelItemContext* tree);
  void model_statement(JRuleParser::ModelStatementContext* tree, ast::Model& model);
  ast::Exchange exchange(JRuleParser::ModelStatementContext* tree);
  ast::Modeler modeler(JRuleParser::ModelerItemContext* tree);
  ast::EmbeddingDecl embedding(JRuleParser::EmbeddingContext* tree);
  ast::ModelRef model_reference(JRuleParser::ModelReferenceContext* tree);
  ast::Rule rule(JRuleParser::RuleItemContext* tree);
  ast::Side side(JRuleParser::SideContext* tree);
  ast::SideItem side_item(JRuleParser::SideItemContext* tree);
  ast::Node node(JRuleParser::SideItemContext* tree);
  ast::ArcChain arc_chain(JRuleParser::SideItemContext* tree);
  ast::ArcStep arc_step(JRuleParser::ArcContext* tree);
  ast::Let let(JRuleParser::LetContext* tree);
  ast::Item extern_item(JRuleParser::ExternItemContext* tree);
  std::vector<ast::Parameter> parameters(JRuleParser::ParametersContext* tree);
  ast::TypeName type_name(JRuleParser::TypeNameContext* tree);

  // build_operation.cpp
  ast::Operation operation(JRuleParser::OperationItemContext* tree);
  ast::Block block(JRuleParser::BlockContext* tree);
  std::shared_ptr<ast::Block const> shared_block(JRuleParser::BlockContext* tree);
  ast::Statement statement(JRuleParser::StatementContext* tree);
  ast::Statement if_statement(JRuleParser::IfStatementContext* tree);
  ast::Statement apply_all(JRuleParser::StatementContext* tree);

  // build_expression.cpp
  ast::ExprPtr expression(JRuleParser::ExpressionContext* tree) { return built(tree).expr; }
  Built built(JRuleParser::ExpressionContext* tree);
  Built disjunction(JRuleParser::DisjunctionContext* tree);
  Built conjunction(JRuleParser::ConjunctionContext* tree);
  Built negation(JRuleParser::NegationContext* tree);
  Built comparison(JRuleParser::ComparisonContext* tree);
  Built addition(JRuleParser::AdditionContext* tree);
  Built multiplication(JRuleParser::MultiplicationContext* tree);
  Built unary(JRuleParser::UnaryContext* tree);
  Built postfix(JRuleParser::PostfixContext* tree);
  Built suffix(Built base, antlr4::Token* first, JRuleParser::SuffixContext* tree);
  Built call(JRuleParser::PostfixContext* tree, JRuleParser::SuffixContext* dimensions,
             JRuleParser::SuffixContext* arguments);
  Built primary(JRuleParser::PrimaryContext* tree);
  Built binary(Built left, antlr4::Token* op, Built right, antlr4::Token* first, antlr4::Token* last);
  Built deeper(ast::Expr expr, std::initializer_list<Built const*> parts);
  ast::Word walk(JRuleParser::SuffixContext* tree);
  ast::Dimension dimension_of(ast::Expr const& expr);
  std::string string(antlr4::Token* token);
  std::int64_t integer(antlr4::Token* token);
  double real(antlr4::Token* token);

  // build_expression.cpp: dimensions, words, orbit types
  ast::Name name(antlr4::Token* token) const { return {token->getText(), parser_.span(token)}; }
  ast::Name name(JRuleParser::NameContext* tree) const { return name(tree->getStart()); }
  ast::DimensionTerm dimension_term(antlr4::Token* token, bool negative);
  ast::Dimension dimension(JRuleParser::DimensionContext* tree);
  ast::Word word(JRuleParser::WordContext* tree);
  ast::OrbitElement dimension_range(JRuleParser::DimensionRangeContext* tree);
  ast::OrbitElement orbit_element(JRuleParser::OrbitElementContext* tree);
  ast::ElementList element_list(JRuleParser::ElementListContext* tree);
  ast::OrbitType orbit_type(JRuleParser::OrbitTypeContext* tree);

  source::Span span(antlr4::ParserRuleContext* tree) const { return parser_.span(tree->getStart(), tree->getStop()); }
  /// The documentation before a token.
  std::string doc(antlr4::Token* token) const;
  void error(source::Diagnostic diagnostic);

  ItemParser const& parser_;
  source::Diagnostics& diagnostics_;
  bool has_failed_ = false;
  bool is_too_deep_ = false;  ///< said once: a long chain passes the limit again and again
};

}  // namespace jrule::syntax
