// The Builder's operations and their statements.
#include "compiler/syntax/build.h"

namespace jrule::syntax {

using source::Code;

ast::Operation Builder::operation(JRuleParser::OperationItemContext* tree) {
  ast::Operation result;
  result.doc = doc(tree->getStart());
  result.name = name(tree->name());
  result.parameters = parameters(tree->parameters());
  result.on = model_reference(tree->modelReference());
  if (auto* type = tree->typeName()) result.result = type_name(type);
  result.body = block(tree->block());
  result.span = span(tree);
  return result;
}

ast::Block Builder::block(JRuleParser::BlockContext* tree) {
  ast::Block result;
  for (auto* t : tree->statement()) result.push_back(statement(t));
  return result;
}

std::shared_ptr<ast::Block const> Builder::shared_block(JRuleParser::BlockContext* tree) {
  return std::make_shared<ast::Block const>(block(tree));
}

ast::Statement Builder::statement(JRuleParser::StatementContext* tree) {
  if (auto* t = tree->let()) return {let(t), span(tree)};
  if (auto* t = tree->ifStatement()) return if_statement(t);
  if (tree->KW_APPLY_ALL() != nullptr) return apply_all(tree);

  auto const expressions = tree->expression();
  auto const blocks = tree->block();
  if (tree->KW_FOR() != nullptr) {
    return {ast::ForOrbit{name(tree->name()), expression(expressions[0]), shared_block(blocks[0])}, span(tree)};
  }
  if (tree->KW_WHILE() != nullptr) {
    return {ast::While{expression(expressions[0]), shared_block(blocks[0])}, span(tree)};
  }
  if (tree->KW_RETURN() != nullptr) {
    return {ast::Return{expressions.empty() ? nullptr : expression(expressions[0])}, span(tree)};
  }
  if (tree->KW_FAIL() != nullptr) return {ast::Fail{string(tree->STRING()->getSymbol())}, span(tree)};
  if (tree->KW_TRY() != nullptr) return {ast::Try{shared_block(blocks[0]), shared_block(blocks[1])}, span(tree)};
  auto target = disjunction(tree->disjunction()).expr;
  if (!expressions.empty()) return {ast::Assign{std::move(target), expression(expressions[0])}, span(tree)};
  return {ast::ExprStatement{std::move(target)}, span(tree)};
}

/// `else if` is an else block with one statement. Built from the end, since each step holds the one after it.
ast::Statement Builder::if_statement(JRuleParser::IfStatementContext* tree) {
  auto const branches = tree->elseBranch();
  if (branches.size() > nesting_limit) {
    error({.code = Code::nesting_too_deep,
           .span = parser_.span(branches[nesting_limit]->getStart()),
           .message = "more than " + std::to_string(nesting_limit) + " branches in one `if`"});
    return {ast::If{expression(tree->expression()), shared_block(tree->block()), nullptr}, span(tree)};
  }
  std::shared_ptr<ast::Block const> otherwise;
  for (auto i = branches.size(); i-- > 0;) {
    auto* branch = branches[i];
    auto* condition = branch->expression();
    auto body = shared_block(branch->block());
    if (condition != nullptr) {
      ast::Statement nested{ast::If{expression(condition), std::move(body), std::move(otherwise)},
                            parser_.span(branch->KW_IF()->getSymbol(), tree->getStop())};
      otherwise = std::make_shared<ast::Block const>(ast::Block{std::move(nested)});
      continue;
    }
    if (i + 1 < branches.size()) {
      error({.code = Code::syntax_error,
             .span = parser_.span(branches[i + 1]->getStart()),
             .message = "this `else` comes after the last branch of the `if`",
             .labels = {{parser_.span(branch->getStart()), "the last branch"}}});
    }
    otherwise = std::move(body);
  }
  return {ast::If{expression(tree->expression()), shared_block(tree->block()), otherwise}, span(tree)};
}

ast::Statement Builder::apply_all(JRuleParser::StatementContext* tree) {
  auto const expressions = tree->expression();
  auto const applied = expression(expressions[0]);
  auto orbit = expression(expressions[1]);
  if (auto const* call = std::get_if<ast::Call>(&applied->value)) return {ast::ApplyAll{*call, orbit}, span(tree)};
  error({.code = Code::syntax_error,
         .span = applied->span,
         .message = "expected the call of a rule after `apply_all`",
         .notes = {"a rule without parameters is called with empty parentheses: `apply_all round() on face(d);`"}});
  return {ast::ExprStatement{applied}, span(tree)};
}

}  // namespace jrule::syntax
