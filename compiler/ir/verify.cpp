#include <fmt/format.h>

#include "compiler/algebra/group.h"
#include "compiler/ir/rule_scheme.h"
#include "compiler/ir/verify_expr.h"

namespace jrule::ir {

namespace {

Fault verify_word(algebra::Group const& group, Word const& word) {
  for (Letter letter : word) {
    if (!group.model().has(letter.dimension)) return fmt::format("the word {} leaves the model", jrule::to_string(word));
  }
  if (group.normal_form(word) != word) return fmt::format("the word {} is not in normal form", jrule::to_string(word));
  return {};
}

Fault verify_side(RuleScheme const& rule, algebra::Group const& group, Side const& side, bool left) {
  for (Arc const& arc : side.arcs) {
    if (arc.source >= rule.nodes.size() || arc.target >= rule.nodes.size()) return "an arc's node is out of range";
    for (NodeId id : {arc.source, arc.target}) {
      Node const& node = rule.nodes[id];
      if (left ? node.added() : node.deleted()) {
        return fmt::format("an arc on the {} side meets `{}`, which is not there", left ? "left" : "right", node.name);
      }
    }
    if (rule.hooks.empty() && !arc.word.empty()) return "a rule without hooks has an arc with a word";
    if (!rule.model().has(arc.dimension)) return fmt::format("an arc's dimension {} is not the model's", arc.dimension);
    if (Fault fault = verify_word(group, arc.word)) return fault;
  }
  return {};
}

// Components of the left side, by the smallest node.
std::vector<NodeId> left_components(RuleScheme const& rule) {
  std::vector<NodeId> parent(rule.nodes.size());
  for (NodeId i = 0; i < parent.size(); ++i) parent[i] = i;
  auto find = [&](NodeId x) {
    while (parent[x] != x) x = parent[x] = parent[parent[x]];
    return x;
  };
  for (Arc const& arc : rule.left.arcs) {
    NodeId const a = find(arc.source), b = find(arc.target);
    parent[std::max(a, b)] = std::min(a, b);
  }
  for (NodeId i = 0; i < parent.size(); ++i) parent[i] = find(i);
  return parent;
}

struct ExprVisitor {
  RuleScheme const& rule;
  VisibleVariables const* variables;
  std::size_t depth;

  Fault part(ExprPtr const& expr) const { return verify_expr(rule, expr, variables, depth); }
  Fault dart(ExprPtr const& expr) const {
    if (Fault fault = part(expr)) return fault;
    return expr->type == dart_type ? Fault{} : "an expression reads the map at something that is no dart";
  }
  Fault embedding(std::size_t index) const {
    return index < rule.modeler->embeddings.size() ? Fault{} : "an expression reads an embedding that is not there";
  }

  Fault operator()(Constant const&) const { return {}; }
  Fault operator()(ParameterRef const& p) const {
    return p.index < rule.parameters.size() ? Fault{} : "an expression's parameter is out of range";
  }
  Fault operator()(LetRef const& l) const {
    return l.index < rule.lets.size() ? Fault{} : "an expression's let is out of range";
  }
  Fault operator()(NodeDart const& n) const {
    if (n.node < rule.nodes.size() && !rule.nodes[n.node].added()) return {};
    return "an expression reads a node that is not on the left";
  }
  Fault operator()(Bound const& b) const {
    return b.level < depth ? Fault{} : "an expression reads the dart of a comprehension that is not around it";
  }
  Fault operator()(Walk const& w) const { return dart(w.from); }
  Fault operator()(Darts const& d) const { return dart(d.at); }
  Fault operator()(ValueAt const& v) const {
    Fault const fault = embedding(v.embedding);
    return fault ? fault : dart(v.at);
  }
  Fault operator()(Collect const& c) const {
    Fault const fault = embedding(c.embedding);
    return fault ? fault : (*this)(c.over);
  }
  Fault operator()(ForEach const& f) const {
    if (f.variable.level != depth) return "a comprehension's variable is not of its level";
    if (Fault fault = (*this)(f.over)) return fault;
    if (Fault fault = verify_expr(rule, f.element, variables, depth + 1)) return fault;
    bool const one_value = !f.element->type.list && !f.element->type.dart;
    return one_value ? Fault{} : "the element of a comprehension is not one value";
  }
  Fault operator()(Apply const& a) const {
    for (ExprPtr const& argument : a.arguments) {
      if (Fault fault = part(argument)) return fault;
    }
    return {};
  }
  Fault operator()(Call const& c) const {
    if (!c.function || c.arguments.size() != c.function->parameters.size()) return "a call has not the arguments of its function";
    for (std::size_t i = 0; i < c.arguments.size(); ++i) {
      if (Fault fault = part(c.arguments[i])) return fault;
      if (c.arguments[i]->type != c.function->parameters[i].type) return "a call's argument is not of its parameter's type";
    }
    return {};
  }
  Fault operator()(Conditional const& c) const {
    for (ExprPtr const& branch : {c.condition, c.then_value, c.else_value}) {
      if (Fault fault = part(branch)) return fault;
    }
    return {};
  }
  Fault operator()(VariableRef const& v) const {
    if (!variables) return "an expression of a rule reads a variable of an operation";
    return v.index < variables->declared.size() && variables->declared[v.index] ? Fault{} : "an expression reads a variable before it is declared";
  }
  Fault operator()(CopyOf const& c) const {
    if (Fault fault = (*this)(c.result)) return fault;
    auto const result = variables->variables[c.result.index].result;
    if (!result || *result >= variables->rules.size()) return "an expression takes a copy from what is no result of a rule";
    RuleScheme const& called = variables->rules[*result];
    if (c.node >= called.nodes.size() || called.nodes[c.node].deleted()) return "an expression takes a copy of a node that is not on the right";
    if (!c.at) return {};
    if (called.hooks.empty() || called.nodes[called.hooks[0]].deleted()) return "an expression asks for a pattern dart where none is kept";
    return dart(c.at);
  }
};

}  // namespace

Fault verify_expr(RuleScheme const& rule, ExprPtr const& expr, VisibleVariables const* variables, std::size_t depth) {
  if (!expr) return "a part of an expression is missing";
  return std::visit(ExprVisitor{rule, variables, depth}, expr->value);
}

std::optional<std::string> verify(RuleScheme const& rule) {
  if (!rule.modeler) return "the rule has no modeler";
  algebra::Group const group(rule.model());
  if (Fault fault = verify_side(rule, group, rule.left, true)) return fault;
  if (Fault fault = verify_side(rule, group, rule.right, false)) return fault;

  std::vector<NodeId> const component = left_components(rule);
  std::vector<int> hooks(rule.nodes.size(), 0);
  for (std::size_t i = 0; i < rule.hooks.size(); ++i) {
    NodeId const id = rule.hooks[i];
    if (id >= rule.nodes.size() || rule.nodes[id].hook != i) return "the list of hooks and the nodes disagree";
    ++hooks[component[id]];
  }
  for (NodeId id = 0; id < rule.nodes.size(); ++id) {
    Node const& node = rule.nodes[id];
    if (!node.left_span && !node.right_span) return fmt::format("`{}` is on no side", node.name);
    if (!node.added() && component[id] == id && hooks[id] != 1) {
      return fmt::format("the left component of `{}` has {} hooks", node.name, hooks[id]);
    }
  }
  for (Clause const& clause : rule.clauses) {
    if (clause.node >= rule.nodes.size() || rule.nodes[clause.node].deleted()) return "a clause is on a deleted node";
    if (clause.embedding >= rule.modeler->embeddings.size()) return "a clause's embedding is out of range";
    if (clause.value->type != rule.modeler->value_type(clause.embedding)) return "a clause's type differs from its embedding's";
    if (Fault fault = verify_expr(rule, clause.value)) return fault;
  }
  for (Let const& let : rule.lets) {
    if (Fault fault = verify_expr(rule, let.value)) return fault;
  }
  for (Requirement const& requirement : rule.requirements) {
    if (requirement.condition->type != ExprType{Type::Bool, false, false}) return "a requirement is not a Bool";
    if (Fault fault = verify_expr(rule, requirement.condition)) return fault;
  }
  for (Expectation const& expectation : rule.expectations) {
    bool const named = !expectation.cell || (*expectation.cell >= 0 && *expectation.cell < static_cast<int>(Count::named_cells));
    if (!named || (expectation.cell && !cell_orbit(rule.model(), *expectation.cell))) return "an expectation is of cells that the model lacks";
    if (!expectation.count.fits()) return "a number in an expectation is out of range";
  }
  return {};
}

}  // namespace jrule::ir
