#include "tests/text/difference.h"

#include <algorithm>
#include <cstring>
#include <tuple>

namespace jrule::tests {

namespace {

using Difference = std::optional<std::string>;

/// Of the first part that differs.
Difference first_of(std::initializer_list<std::pair<char const*, bool>> parts) {
  for (auto const& [what, same] : parts) {
    if (!same) return what;
  }
  return {};
}

// ---- Values: to the last bit, but any NaN is like another ----

bool same_number(double a, double b) { return (a != a && b != b) || std::memcmp(&a, &b, sizeof a) == 0; }

bool same_value(Value const& a, Value const& b) {
  if (type_of(a) != type_of(b)) return false;
  if (type_of(a) == Type::Int || type_of(a) == Type::Bool) return a == b;
  for (int k = 0; k < component_count(type_of(a)); ++k) {
    if (!same_number(component(a, k), component(b, k))) return false;
  }
  return true;
}
bool same_value(std::optional<Value> const& a, std::optional<Value> const& b) {
  return a.has_value() == b.has_value() && (!a || same_value(*a, *b));
}

// ---- C++ from outside: by content, since each elaboration makes its own ----

bool same_extern(ir::ExternTypePtr const& a, ir::ExternTypePtr const& b) {
  if (!a || !b) return !a && !b;
  return std::tie(a->name, a->doc, a->header, a->cpp_name) == std::tie(b->name, b->doc, b->header, b->cpp_name);
}

bool same_type(ir::ExprType const& a, ir::ExprType const& b) {
  return a.element == b.element && a.list == b.list && a.dart == b.dart && same_extern(a.external, b.external);
}

bool same_extern(ir::ExternFunctionPtr const& a, ir::ExternFunctionPtr const& b) {
  if (!a || !b) return !a && !b;
  auto const same_parameter = [](auto const& x, auto const& y) { return x.name == y.name && same_type(x.type, y.type); };
  return std::tie(a->name, a->doc, a->header, a->cpp_name) == std::tie(b->name, b->doc, b->header, b->cpp_name) &&
         std::equal(a->parameters.begin(), a->parameters.end(), b->parameters.begin(), b->parameters.end(), same_parameter) &&
         same_type(a->result, b->result);
}

// ---- Expressions ----

struct Expressions {
  ir::RuleScheme const& rule_a;
  ir::RuleScheme const& rule_b;

  bool same_node(ir::NodeId a, ir::NodeId b) const { return rule_a.nodes[a].name == rule_b.nodes[b].name; }

  bool same(ir::Expr const& a, ir::Expr const& b) const {
    if (!same_type(a.type, b.type) || a.value.index() != b.value.index()) return false;
    return std::visit([&](auto const& node) { return same(node, std::get<std::decay_t<decltype(node)>>(b.value)); }, a.value);
  }
  bool same(ir::Constant const& a, ir::Constant const& b) const { return same_value(a.value, b.value); }
  bool same(ir::ParameterRef const& a, ir::ParameterRef const& b) const { return a.index == b.index; }
  bool same(ir::LetRef const& a, ir::LetRef const& b) const { return a.index == b.index; }
  bool same(ir::NodeDart const& a, ir::NodeDart const& b) const { return same_node(a.node, b.node); }
  bool same(ir::Bound const& a, ir::Bound const& b) const { return a.level == b.level && a.name == b.name; }
  bool same(ir::Walk const& a, ir::Walk const& b) const { return same(*a.from, *b.from) && a.path == b.path; }
  bool same(ir::Darts const& a, ir::Darts const& b) const { return same(*a.at, *b.at) && a.orbit == b.orbit && a.by == b.by; }
  bool same(ir::ValueAt const& a, ir::ValueAt const& b) const { return a.embedding == b.embedding && same(*a.at, *b.at); }
  bool same(ir::Collect const& a, ir::Collect const& b) const { return a.embedding == b.embedding && same(a.over, b.over); }
  bool same(ir::ForEach const& a, ir::ForEach const& b) const {
    return same(a.variable, b.variable) && same(a.over, b.over) && same(*a.element, *b.element);
  }
  bool same(ir::Apply const& a, ir::Apply const& b) const {
    return a.function == b.function && std::equal(a.arguments.begin(), a.arguments.end(), b.arguments.begin(), b.arguments.end(),
                                                  [&](ir::ExprPtr const& x, ir::ExprPtr const& y) { return same(*x, *y); });
  }
  bool same(ir::Call const& a, ir::Call const& b) const {
    return same_extern(a.function, b.function) &&
           std::equal(a.arguments.begin(), a.arguments.end(), b.arguments.begin(), b.arguments.end(),
                      [&](ir::ExprPtr const& x, ir::ExprPtr const& y) { return same(*x, *y); });
  }
  bool same(ir::VariableRef const& a, ir::VariableRef const& b) const { return a.index == b.index && a.name == b.name; }
  bool same(ir::CopyOf const& a, ir::CopyOf const& b) const {
    bool const same_at = !a.at == !b.at && (!a.at || same(*a.at, *b.at));
    return same(a.result, b.result) && a.node_name == b.node_name && same_at;
  }
  bool same(ir::Conditional const& a, ir::Conditional const& b) const {
    return same(*a.condition, *b.condition) && same(*a.then_value, *b.then_value) && same(*a.else_value, *b.else_value);
  }
};

/// Of defaults, which read nothing.
bool same_default(ir::ExprPtr const& a, ir::ExprPtr const& b) {
  ir::RuleScheme const none;
  return a && b ? Expressions{none, none}.same(*a, *b) : !a && !b;
}

// ---- Nodes and arcs, told by names ----

using NodeKey = std::tuple<std::string, std::string, bool, bool, std::optional<std::size_t>>;
std::vector<NodeKey> nodes_of(ir::RuleScheme const& rule, Order order) {
  std::vector<NodeKey> keys;
  for (ir::Node const& n : rule.nodes) keys.emplace_back(n.name, n.doc, n.added(), n.deleted(), n.hook);
  if (order == Order::free) std::sort(keys.begin(), keys.end());
  return keys;
}

using ArcKey = std::tuple<std::string, int, Word, std::string>;
std::vector<ArcKey> arcs_of(ir::RuleScheme const& rule, ir::Side const& side, Order order) {
  std::vector<ArcKey> keys;
  for (ir::Arc const& arc : side.arcs) {
    keys.emplace_back(rule.nodes[arc.source].name, arc.dimension, arc.word, rule.nodes[arc.target].name);
  }
  if (order == Order::free) std::sort(keys.begin(), keys.end());
  return keys;
}

std::vector<std::string> hooks_of(ir::RuleScheme const& rule) {
  std::vector<std::string> names;
  for (ir::NodeId const id : rule.hooks) names.push_back(rule.nodes[id].name);
  return names;
}

template <class Vector, class Same>
bool all_same(Vector const& a, Vector const& b, Same same) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), same);
}

}  // namespace

Difference difference(ir::Modeler const& a, ir::Modeler const& b) {
  auto const same_embedding = [](EmbeddingSpec const& x, EmbeddingSpec const& y) {
    return x.name == y.name && x.orbit == y.orbit && x.type == y.type && x.extern_name == y.extern_name && x.merge == y.merge && same_value(x.default_value, y.default_value);
  };
  bool same_externs = a.embeddings.size() == b.embeddings.size();
  for (std::size_t e = 0; same_externs && e < a.embeddings.size(); ++e) {
    ir::EmbeddingExterns const x = a.externs_of(e), y = b.externs_of(e);
    same_externs = same_extern(x.type, y.type) && same_default(x.default_value, y.default_value) && same_extern(x.merge, y.merge);
  }
  return first_of({{"the modeler's name", a.name == b.name},
                   {"the modeler's documentation", a.doc == b.doc},
                   {"the model", a.model == b.model},
                   {"the embeddings", all_same(a.embeddings, b.embeddings, same_embedding)},
                   {"the embeddings' types, defaults and functions from outside", same_externs},
                   {"the embeddings' documentation", a.embedding_docs == b.embedding_docs}});
}

Difference difference(ir::RuleScheme const& a, ir::RuleScheme const& b, Order order) {
  if (auto modeler = difference(*a.modeler, *b.modeler)) return modeler;
  Expressions const expressions{a, b};
  auto const same_parameter = [](ir::Parameter const& x, ir::Parameter const& y) {
    return x.name == y.name && same_type(x.value_type(), y.value_type()) && same_value(x.default_value, y.default_value) &&
           same_default(x.computed_default, y.computed_default) && x.doc == y.doc && x.unit == y.unit;
  };
  auto const same_let = [&](ir::Let const& x, ir::Let const& y) { return x.name == y.name && expressions.same(*x.value, *y.value); };
  auto const same_clause = [&](ir::Clause const& x, ir::Clause const& y) {
    return expressions.same_node(x.node, y.node) && x.embedding == y.embedding && expressions.same(*x.value, *y.value);
  };
  return first_of({{"the documentation", a.doc == b.doc},
                   {"the parameters", all_same(a.parameters, b.parameters, same_parameter)},
                   {"the nodes", nodes_of(a, order) == nodes_of(b, order)},
                   {"the hooks", hooks_of(a) == hooks_of(b)},
                   {"the hook's type", a.hook_type == b.hook_type},
                   {"the left arcs", arcs_of(a, a.left, order) == arcs_of(b, b.left, order)},
                   {"the right arcs", arcs_of(a, a.right, order) == arcs_of(b, b.right, order)},
                   {"the lets", all_same(a.lets, b.lets, same_let)},
                   {"the requirements", all_same(a.requirements, b.requirements,
                                                 [&](ir::Requirement const& x, ir::Requirement const& y) { return expressions.same(*x.condition, *y.condition); })},
                   {"the clauses", all_same(a.clauses, b.clauses, same_clause)},
                   {"the expectations", all_same(a.expectations, b.expectations, [](ir::Expectation const& x, ir::Expectation const& y) {
                      return x.cell == y.cell && x.count == y.count;
                    })}});
}

}  // namespace jrule::tests
