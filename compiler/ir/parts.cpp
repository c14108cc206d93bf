#include <algorithm>

#include "compiler/ir/rule_scheme.h"

namespace jrule::ir {

namespace {

struct Parts {
  using List = std::vector<ExprPtr>;
  List operator()(Constant const&) const { return {}; }
  List operator()(ParameterRef const&) const { return {}; }
  List operator()(LetRef const&) const { return {}; }
  List operator()(NodeDart const&) const { return {}; }
  List operator()(Bound const&) const { return {}; }
  List operator()(Walk const& walk) const { return {walk.from}; }
  List operator()(Darts const& darts) const { return {darts.at}; }
  List operator()(ValueAt const& read) const { return {read.at}; }
  List operator()(Collect const& read) const { return {read.over.at}; }
  List operator()(ForEach const& each) const { return {each.over.at, each.element}; }
  List operator()(Apply const& apply) const { return apply.arguments; }
  List operator()(Call const& call) const { return call.arguments; }
  List operator()(Conditional const& c) const { return {c.condition, c.then_value, c.else_value}; }
  List operator()(VariableRef const&) const { return {}; }
  List operator()(CopyOf const& copy) const { return copy.at ? List{copy.at} : List{}; }
};

/// `lets`: for each let, whether it starts at a left node.
bool starts_at_node(Expr const& expr, std::vector<bool> const& lets) {
  if (std::holds_alternative<NodeDart>(expr.value)) return true;
  if (auto const* let = std::get_if<LetRef>(&expr.value)) return lets[let->index];
  std::vector<ExprPtr> const all = parts(expr);
  return std::any_of(all.begin(), all.end(), [&](ExprPtr const& part) { return starts_at_node(*part, lets); });
}

}  // namespace

std::vector<ExprPtr> parts(Expr const& expr) { return std::visit(Parts{}, expr.value); }

bool depends_on_place(RuleScheme const& rule, Requirement const& requirement) {
  std::vector<bool> lets;  // each names only those before it
  for (Let const& let : rule.lets) lets.push_back(starts_at_node(*let.value, lets));
  return starts_at_node(*requirement.condition, lets);
}

}  // namespace jrule::ir
