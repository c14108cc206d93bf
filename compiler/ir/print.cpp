#include <fmt/format.h>

#include <array>

#include "compiler/ir/rule_scheme.h"

namespace jrule::ir {

namespace {

constexpr auto spellings = std::to_array<std::string_view>({
    "+", "-", "*", "/", "-",
    "<", "<=", ">", ">=", "==", "!=", "and", "or", "not",
    "to_real",
    "Vec2", "Vec3", "Point2", "Point3", "Color",
    "x", "y", "z",
    "dot", "cross", "norm", "normalize", "midpoint", "lerp", "distance", "area_vector",
    "sqrt", "abs", "floor", "ceil", "sin", "cos", "tan", "atan2", "pow", "exp", "log",
    "mean", "sum", "min", "max", "count", "first", "all", "any",
});
static_assert(spellings.size() == static_cast<std::size_t>(Builtin::any) + 1);

std::string print_path(Word const& path) {
  return "@" + jrule::to_string(path);
}

std::string print_arc(RuleScheme const& rule, Arc const& arc) {
  std::string word = arc.word.empty() ? "" : "[";
  if (!arc.word.empty()) {
    for (std::size_t i = 0; i < arc.word.size(); ++i) {
      if (i != 0) word += ',';
      if (arc.word[i].conjugate) word += '~';
      word += static_cast<char>('0' + arc.word[i].dimension);
    }
    word += ']';
  }
  return fmt::format("{} -{}{}-> {}", rule.nodes[arc.source].name, arc.dimension, word, rule.nodes[arc.target].name);
}

}  // namespace

std::string_view spelling(Builtin builtin) { return spellings[static_cast<std::size_t>(builtin)]; }

std::string map_name(Model const& model) {
  if (model.name == "gmap") return fmt::format("{}-G-map", model.dimension);
  if (model.name == "omap") return fmt::format("{}-O-map", model.dimension);
  if (model.name == "dual_omap") return fmt::format("dual {}-O-map", model.dimension);
  if (model.name == "closed_gmap") return fmt::format("closed {}-G-map", model.dimension);
  return fmt::format("map of the model `{}`", model.name);
}

std::string to_string(ExprType const& type) {
  std::string const element = type.dart       ? "Dart"
                              : type.external ? type.external->name
                                              : jrule::to_string(type.element);
  return type.list ? "[" + element + "]" : element;
}

std::string signature(ExternFunction const& function) {
  std::string parameters;
  for (auto const& p : function.parameters) parameters += (parameters.empty() ? "" : ", ") + to_string(p.type);
  return fmt::format("({}) -> {}", parameters, to_string(function.result));
}

namespace {
// "(name argument …)", each argument printed by `print`.
template <class Print>
std::string print_call(std::string_view name, std::vector<ExprPtr> const& arguments, Print print) {
  std::string text = fmt::format("({}", name);
  for (ExprPtr const& argument : arguments) text += ' ' + print(*argument);
  return text + ')';
}

// A default that calls extern functions: it has no names but theirs.
std::string print_computed(Expr const& expr) { return print(expr, RuleScheme{}); }
}  // namespace

std::string print(Expr const& expr, RuleScheme const& rule) {
  struct Visitor {
    RuleScheme const& rule;
    std::string operator()(Constant const& c) const { return jrule::to_string(c.value); }
    std::string operator()(ParameterRef const& p) const { return rule.parameters[p.index].name; }
    std::string operator()(LetRef const& l) const { return rule.lets[l.index].name; }
    std::string operator()(NodeDart const& n) const { return rule.nodes[n.node].name; }
    std::string operator()(Bound const& b) const { return b.name; }
    std::string operator()(Walk const& w) const { return print(*w.from, rule) + print_path(w.path); }
    std::string operator()(Darts const& d) const {
      return fmt::format("{}({} by {})", jrule::to_string(d.orbit), print(*d.at, rule), jrule::to_string(d.by));
    }
    std::string operator()(ValueAt const& v) const {
      return fmt::format("{}.{}", print(*v.at, rule), rule.modeler->embeddings[v.embedding].name);
    }
    std::string operator()(Collect const& c) const {
      return fmt::format("{}.{}", (*this)(c.over), rule.modeler->embeddings[c.embedding].name);
    }
    std::string operator()(ForEach const& f) const {
      return fmt::format("({} for {} in {})", print(*f.element, rule), f.variable.name, (*this)(f.over));
    }
    std::string operator()(Apply const& a) const {
      return print_call(spelling(a.function), a.arguments, [&](Expr const& e) { return print(e, rule); });
    }
    std::string operator()(Call const& c) const {
      return print_call(c.function->name, c.arguments, [&](Expr const& e) { return print(e, rule); });
    }
    std::string operator()(Conditional const& c) const {
      return fmt::format("(if {} {} {})", print(*c.condition, rule), print(*c.then_value, rule),
                         print(*c.else_value, rule));
    }
    std::string operator()(VariableRef const& v) const { return v.name; }
    std::string operator()(CopyOf const& c) const {
      return fmt::format("{}.{}{}", c.result.name, c.node_name, c.at ? fmt::format("[{}]", print(*c.at, rule)) : "");
    }
  };
  return std::visit(Visitor{rule}, expr.value);
}

std::string print(Modeler const& modeler) {
  Model const& model = modeler.model;
  std::string text = fmt::format("modeler {} on {}({})\n  dimensions", modeler.name, model.name, model.dimension);
  for (int d : model.dimensions) text += fmt::format(" {}{}", d, model.is_oriented(d) ? " oriented" : "");
  text += "\n  exchange";
  for (auto [i, j] : model.exchange) text += fmt::format(" ({},{})", i, j);
  if (model.closed) text += "\n  closed";
  text += '\n';
  static constexpr std::string_view policies[] = {"none", "first", "mean", "min", "max"};
  for (std::size_t i = 0; i < modeler.embeddings.size(); ++i) {
    EmbeddingSpec const& e = modeler.embeddings[i];
    EmbeddingExterns const externs = modeler.externs_of(i);
    text += fmt::format("  embedding {} : {} -> {}", e.name, jrule::to_string(e.orbit), to_string(modeler.value_type(i)));
    if (e.default_value) text += fmt::format(" default {}", jrule::to_string(*e.default_value));
    if (externs.default_value) text += fmt::format(" default {}", print_computed(*externs.default_value));
    if (externs.merge) {
      text += fmt::format(" merge {}", externs.merge->name);
    } else if (e.merge != MergePolicy::none) {
      text += fmt::format(" merge {}", policies[static_cast<std::size_t>(e.merge)]);
    }
    text += '\n';
  }
  return text;
}

std::string print_parameter(Parameter const& p) {
  std::string text = fmt::format("  parameter {}: {}", p.name, to_string(p.value_type()));
  if (!p.unit.empty()) text += fmt::format(" [{}]", p.unit);
  if (p.default_value) text += fmt::format(" = {}", jrule::to_string(*p.default_value));
  if (p.computed_default) text += fmt::format(" = {}", print_computed(*p.computed_default));
  return text + '\n';
}

std::string print(RuleScheme const& rule) {
  std::string text = fmt::format("rule {} on {}\n", rule.name, rule.modeler->name);
  for (Parameter const& p : rule.parameters) text += print_parameter(p);
  if (!rule.hooks.empty()) {
    std::string type;
    for (Letter letter : rule.hook_type) {
      type += fmt::format("{}{}{}", type.empty() ? "" : ",", letter.conjugate ? "~" : "", letter.dimension);
    }
    text += fmt::format("  pattern <{}>\n", type);
  }
  for (Node const& node : rule.nodes) {
    text += fmt::format("  node {} {}", node.name, node.preserved() ? "preserved" : node.added() ? "added" : "deleted");
    if (node.hook) text += fmt::format(" hook {}", *node.hook);
    text += '\n';
  }
  for (auto const& [name, side] : {std::pair{"left", &rule.left}, std::pair{"right", &rule.right}}) {
    text += fmt::format("  {}\n", name);
    for (Arc const& arc : side->arcs) text += fmt::format("    {}\n", print_arc(rule, arc));
  }
  for (Let const& let : rule.lets) text += fmt::format("  let {} = {}\n", let.name, print(*let.value, rule));
  for (Requirement const& r : rule.requirements) text += fmt::format("  require {}\n", print(*r.condition, rule));
  for (Clause const& clause : rule.clauses) {
    text += fmt::format("  {}.{} = {}\n", rule.nodes[clause.node].name, rule.modeler->embeddings[clause.embedding].name,
                        print(*clause.value, rule));
  }
  for (Expectation const& e : rule.expectations) text += fmt::format("  expect {}' = {}\n", count_name(e.cell), to_string(e.count));
  return text;
}

}  // namespace jrule::ir
