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
};

}  // namespace

std::vector<ExprPtr> parts(Expr const& expr) { return std::visit(Parts{}, expr.value); }

}  // namespace jrule::ir
