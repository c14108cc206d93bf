#include "compiler/sema/rules.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "compiler/algebra/group.h"
#include "compiler/sema/counts.h"
#include "compiler/sema/expressions.h"
#include "compiler/sema/names.h"
#include "compiler/sema/parameters.h"

namespace jrule::sema {

using source::Code;
using source::Diagnostic;
using source::Diagnostics;
using source::Span;

namespace {

struct RuleElaboration {
  ast::Rule const& declared;
  DimensionValues const& values;
  Externs const& externs;
  Diagnostics& diagnostics;
  ir::Modeler const* declared_on;  // null if that is the rule's modeler
  Model const& model;
  algebra::Group group;
  ir::RuleScheme rule;
  std::map<std::string, ir::NodeId> left_nodes, right_nodes;
  std::map<ir::NodeId, ast::Node const*> left_declarations;
  std::map<std::string, Span> values_declared;  // parameters and `let`s
  bool hook_type_known = false;  // else its error is reported, and nothing is said about positions
  std::set<std::pair<std::string, bool>> unknown_nodes;  // that arcs name, on the left?

  RuleElaboration(ast::Rule const& r, std::shared_ptr<ir::Modeler const> modeler, DimensionValues const& v, Externs const& e,
                  Diagnostics& d, ir::Modeler const* on)
      : declared(r), values(v), externs(e), diagnostics(d), declared_on(on), model(modeler->model), group(modeler->model) {
    rule.modeler = std::move(modeler);
  }

  void report(Code code, Span span, std::string message, std::vector<source::Label> labels = {},
              std::vector<std::string> notes = {}) {
    diagnostics.add({.code = code, .span = span, .message = std::move(message), .labels = std::move(labels), .notes = std::move(notes)});
  }

  // ---- Parameters ----

  void add_parameters() {
    rule.parameters = elaborate_parameters(declared.parameters, Darts::refused, externs, diagnostics);
    for (ast::Parameter const& p : declared.parameters) values_declared.emplace(p.name.text, p.name.span);
  }

  // ---- Nodes ----

  void declare_nodes(ast::Side const& side, bool left) {
    auto& names = left ? left_nodes : right_nodes;
    for (ast::SideItem const& item : side.items) {
      auto const* node = std::get_if<ast::Node>(&item);
      if (!node) continue;
      if (auto const known = names.find(node->name.text); known != names.end()) {
        ir::Node const& first = rule.nodes[known->second];
        report(Code::duplicate_name, node->name.span, fmt::format("the node `{}` is declared twice on the {} side", node->name.text, left ? "left" : "right"),
               {{left ? *first.left_span : *first.right_span, "first declared here"}});
        continue;
      }
      ir::NodeId id = 0;
      if (auto const both = left_nodes.find(node->name.text); !left && both != left_nodes.end()) {
        id = both->second;
      } else {
        id = static_cast<ir::NodeId>(rule.nodes.size());
        rule.nodes.push_back({node->name.text, node->doc, {}, {}, {}});
      }
      (left ? rule.nodes[id].left_span : rule.nodes[id].right_span) = node->name.span;
      names[node->name.text] = id;
      if (left) left_declarations[id] = node;
      if (node->hook && left) {
        rule.nodes[id].hook = rule.hooks.size();
        rule.hooks.push_back(id);
      } else if (node->hook) {
        report(Code::hook_on_right, node->name.span, fmt::format("`{}` is declared as a hook on the right side", node->name.text), {},
               {"hooks say where a rule is applied, so they stand on the left side"});
      }
    }
  }

  // The first hook's type ⟨o1,…,ok⟩, to which all decorations refer.
  void read_hook_type() {
    if (rule.hooks.empty()) {
      if (rule.nodes.empty() || rule.nodes.front().added()) return;  // an empty left side needs none
      report(Code::unhooked_component, *rule.nodes.front().left_span, "no node of the left side is a hook", {},
             {"each connected component of the left side needs exactly one hook: the dart that says where it is matched",
              fmt::format("declare `hook {} <…>;`", rule.nodes.front().name)});
      return;
    }
    ast::Node const& hook = *left_declarations.at(rule.hooks.front());
    if (!hook.decoration) {
      report(Code::hook_not_full, hook.name.span, fmt::format("the hook `{}` has no orbit type", hook.name.text), {},
             {"a hook says which orbit the rule matches: `hook a <0,1>;`, or `hook a <>;` for a single dart"});
      return;
    }
    auto const positions = evaluate_elements(model, hook.decoration->elements, values, diagnostics);
    if (!positions) return;
    for (Position const& p : *positions) {
      auto const* letter = std::get_if<Letter>(&p.value);
      if (!letter || letter->conjugate) {
        report(Code::hook_not_full, p.span, fmt::format("the type of the first hook `{}` lists dimensions only", hook.name.text), {},
               {"a hook's orbit is matched whole, so nothing is removed (`_`) or reversed (`~`) in it"});
        continue;
      }
      if (std::find(rule.hook_type.begin(), rule.hook_type.end(), *letter) != rule.hook_type.end()) {
        report(Code::repeated_dimension, p.span, fmt::format("dimension {} stands twice in the type of the hook `{}`", letter->dimension, hook.name.text));
        continue;
      }
      rule.hook_type.push_back(*letter);
    }
    hook_type_known = rule.hook_type.size() == positions->size();
  }

  bool creates() const { return rule.hooks.empty() && left_nodes.empty(); }

  // ---- Arcs ----

  void add_arc(ir::Side& side, ir::Arc arc) {
    arc.word = group.normal_form(arc.word);
    side.arcs.push_back(std::move(arc));
  }

  // The directed arcs that `s -d[w]- t` or `s -d[w]-> t` stands for.
  std::vector<ir::Arc> directed(ir::NodeId s, int d, Word const& w, ir::NodeId t, bool both, Span span) const {
    std::vector<ir::Arc> arcs{{s, d, group.normal_form(w), t, span}};
    if (both) {
      ir::Arc reverse{t, d, group.inverse(w), s, span};
      if (!reverse.same(arcs.front())) arcs.push_back(std::move(reverse));
    }
    return arcs;
  }

  // `a <e1,…,ek>` abbreviates the loops a -ep[op]- a.
  void add_decoration(ir::Side& side, ir::NodeId id, ast::ElementList const& decoration, Span at, bool repeated) {
    ir::Node const& node = rule.nodes[id];
    auto const positions = evaluate_elements(model, decoration.elements, values, diagnostics);
    if (!positions) return;
    if (creates()) {
      report(Code::decoration_without_hook, decoration.span, fmt::format("`{}` is decorated in a rule without hooks", node.name), {},
             {"a decoration says what happens to the orbit of the first hook; without a hook, nodes stand alone: `a;`"});
      return;
    }
    if (!hook_type_known) return;  // reported
    ast::Node const& hook = *left_declarations.at(rule.hooks.front());
    if (positions->size() != rule.hook_type.size()) {
      Diagnostic d{.code = Code::size_condition, .span = decoration.span,
                   .message = fmt::format("`{}` has {} position{}, but the type of the hook `{}` has {}", node.name, positions->size(),
                                          positions->size() == 1 ? "" : "s", hook.name.text, rule.hook_type.size()),
                   .labels = {{hook.decoration->span, "every copy says what happens to each of these"}},
                   .notes = {"position p of a decoration relabels the p-th dimension of the hook's type, or removes it with `_`"}};
      diagnostics.add(std::move(d));
      return;
    }
    bool const is_hook = node.hook.has_value();
    for (std::size_t p = 0; p < positions->size(); ++p) {
      Position const& position = (*positions)[p];
      Letter const o = rule.hook_type[p];
      if (std::holds_alternative<ast::Removed>(position.value)) {
        if (is_hook && &side == &rule.left) {
          report(Code::hook_not_full, position.span, fmt::format("the hook `{}` removes dimension {}", node.name, o.dimension), {},
                 {"a hook's orbit is matched whole: each position names a dimension"});
        }
        continue;
      }
      auto const* e = std::get_if<Letter>(&position.value);
      if (!e) {
        report(Code::hook_not_full, position.span, "a decoration lists dimensions and `_`, not words", {},
               {"write the loop as an arc: `a -1[2,1]-> a;`"});
        continue;
      }
      if (model.is_oriented(o.dimension) && !model.is_oriented(e->dimension)) {
        report(Code::oriented_under_non_oriented, position.span,
               fmt::format("the oriented dimension {} is relabelled to {}, which is not oriented", o.dimension, e->dimension),
               {{hook.decoration->span, fmt::format("position {} of this type is {}", p + 1, o.dimension)}},
               {fmt::format("in a {} the copies of {}-arcs would be {}-arcs without their reverse", ir::map_name(model), o.dimension, e->dimension)});
        continue;
      }
      Letter walked = o;
      if (e->conjugate && model.is_oriented(o.dimension)) walked.conjugate = true;
      Span const span = repeated ? at : position.span;
      for (ir::Arc& arc : directed(id, e->dimension, {walked}, id, !model.is_oriented(e->dimension), span)) add_arc(side, std::move(arc));
    }
  }

  void add_decorations(ast::Side const& side, bool left) {
    for (ast::SideItem const& item : side.items) {
      auto const* node = std::get_if<ast::Node>(&item);
      if (!node) continue;
      auto const& names = left ? left_nodes : right_nodes;
      ir::NodeId const id = names.at(node->name.text);
      ir::Node const& n = rule.nodes[id];
      if ((left ? n.left_span : n.right_span) != node->name.span) continue;  // a second declaration, reported
      if (node->decoration) {
        add_decoration(left ? rule.left : rule.right, id, *node->decoration, node->name.span, false);
      } else if (!left && n.preserved() && left_declarations.at(id)->decoration) {
        // `a;` on the right repeats the left's decoration; its errors were reported there.
        for (ir::Arc const& arc : decoration_arcs(rule.left, id)) {
          ir::Arc copy = arc;
          copy.span = node->name.span;
          add_arc(rule.right, std::move(copy));
        }
      }
    }
  }

  // Loops of the node whose places lie in its left decoration.
  std::vector<ir::Arc> decoration_arcs(ir::Side const& side, ir::NodeId id) const {
    Span const within = left_declarations.at(id)->decoration->span;
    std::vector<ir::Arc> arcs;
    for (ir::Arc const& arc : side.arcs) {
      if (arc.source == id && arc.target == id && arc.span.file == within.file && arc.span.begin >= within.begin && arc.span.end <= within.end) {
        arcs.push_back(arc);
      }
    }
    return arcs;
  }

  std::optional<ir::NodeId> find_node(ast::Name const& name, bool left) {
    auto const& names = left ? left_nodes : right_nodes;
    if (auto const known = names.find(name.text); known != names.end()) return known->second;
    if (!unknown_nodes.emplace(name.text, left).second) return {};  // reported where it is first named
    auto const& other = left ? right_nodes : left_nodes;
    if (auto const elsewhere = other.find(name.text); elsewhere != other.end()) {
      ir::Node const& node = rule.nodes[elsewhere->second];
      report(Code::unknown_node, name.span, fmt::format("the node `{}` is not declared on the {} side", name.text, left ? "left" : "right"),
             {{node.span(), fmt::format("it is declared on the {} side only", left ? "right" : "left")}},
             {left ? fmt::format("declare it with `{};` to match it; a node of the right side only is added by the rule", name.text)
                   : fmt::format("declare it with `{};` to keep it", name.text)});
      return {};
    }
    std::vector<std::string> known;
    for (auto const& [text, id] : names) known.push_back(text);
    report_unknown(diagnostics, Code::unknown_node, name, "node", known);
    return {};
  }

  void add_chain(ast::ArcChain const& chain, bool left) {
    ir::Side& side = left ? rule.left : rule.right;
    std::vector<std::optional<ir::NodeId>> ids;
    for (ast::Name const& name : chain.nodes) ids.push_back(find_node(name, left));
    for (std::size_t i = 0; i < chain.steps.size(); ++i) {
      ast::ArcStep const& step = chain.steps[i];
      auto const d = evaluate_in(model, step.dimension, values, diagnostics);
      std::optional<Word> word = Word{};
      if (step.word) word = evaluate_word(model, *step.word, values, diagnostics);
      if (!d || !word || !ids[i] || !ids[i + 1]) continue;
      if (!word->empty() && creates()) {
        report(Code::decoration_without_hook, step.word->span, "an arc carries a word in a rule without hooks", {},
               {"words are walked in the orbit of the first hook; without a hook there is none"});
        continue;
      }
      bool const backward = step.direction == ast::ArcStep::Direction::backward;
      ir::NodeId const s = backward ? *ids[i + 1] : *ids[i], t = backward ? *ids[i] : *ids[i + 1];
      bool const both = step.direction == ast::ArcStep::Direction::both;
      std::vector<ir::Arc> arcs = directed(s, *d, *word, t, both, step.span);
      bool duplicate = false;
      for (ir::Arc const& arc : arcs) {
        ir::Arc const* const same = ir::find_same(side, arc);
        if (!same || duplicate) continue;
        duplicate = true;
        Diagnostic diagnostic{.code = Code::duplicate_arc, .span = step.span,
                              .message = fmt::format("the {}-arc from `{}` to {} is written twice on the {} side", *d, rule.nodes[arc.source].name,
                                                     arc.source == arc.target ? "itself" : fmt::format("`{}`", rule.nodes[arc.target].name),
                                                     left ? "left" : "right"),
                              .labels = {{same->span, "first written here"}}};
        if (chain.steps.size() == 1) diagnostic.fixits.push_back({chain.span, "", "remove the second one"});
        diagnostics.add(std::move(diagnostic));
      }
      if (duplicate) continue;
      for (ir::Arc& arc : arcs) side.arcs.push_back(std::move(arc));
    }
  }

  // ---- Hooks and components of the left side ----

  void check_components() {
    std::vector<ir::NodeId> parent(rule.nodes.size());
    for (ir::NodeId i = 0; i < parent.size(); ++i) parent[i] = i;
    auto const find = [&](ir::NodeId x) {
      while (parent[x] != x) x = parent[x];
      return x;
    };
    for (ir::Arc const& arc : rule.left.arcs) {
      ir::NodeId const a = find(arc.source), b = find(arc.target);
      parent[std::max(a, b)] = std::min(a, b);
    }
    for (ir::NodeId root = 0; root < parent.size(); ++root) {
      if (rule.nodes[root].added() || find(root) != root) continue;
      std::vector<ir::NodeId> hooks;
      std::string members;
      for (ir::NodeId id = 0; id < parent.size(); ++id) {
        if (rule.nodes[id].added() || find(id) != root) continue;
        if (rule.nodes[id].hook) hooks.push_back(id);
        members += (members.empty() ? "`" : ", `") + rule.nodes[id].name + "`";
      }
      if (hooks.empty()) {
        report(Code::unhooked_component, *rule.nodes[root].left_span,
               members.find(',') == std::string::npos ? fmt::format("the left node {} is connected to no hook", members)
                                                      : fmt::format("the left nodes {} are connected to no hook", members),
               {}, {"each connected component of the left side needs exactly one hook: the dart that says where it is matched",
                    fmt::format("declare `hook {} <…>;`, or connect it with an arc", rule.nodes[root].name)});
      } else if (hooks.size() > 1) {
        report(Code::several_hooks, *rule.nodes[hooks[1]].left_span,
               fmt::format("the hooks `{}` and `{}` are in one component of the left side", rule.nodes[hooks[0]].name, rule.nodes[hooks[1]].name),
               {{*rule.nodes[hooks[0]].left_span, "the first hook already says where this component is matched"}},
               {"arcs lead from one to the other, so one dart determines both"});
      }
    }
  }

  // ---- Expressions ----

  void add_left_expressions() {
    for (ast::SideItem const& item : declared.left.items) {
      ExprContext const context{&rule, &group, &values, &externs};
      if (auto const* let = std::get_if<ast::Let>(&item)) {
        check_fresh_value_name(let->name);
        if (ir::ExprPtr value = check_expression(*let->value, context, {}, diagnostics)) {
          rule.lets.push_back({let->name.text, std::move(value)});
        }
      } else if (auto const* require = std::get_if<ast::Require>(&item)) {
        if (ir::ExprPtr value = check_expression(*require->condition, context, ir::ExprType{Type::Bool, false, false}, diagnostics)) {
          rule.requirements.push_back({std::move(value), require->text});
        }
      } else if (auto const* node = std::get_if<ast::Node>(&item); node && !node->clauses.empty()) {
        report(Code::misplaced_item, node->clauses.front().span, fmt::format("a value is given to `{}` on the left side", node->name.text), {},
               {"values after the application are given on the right side"});
      }
    }
  }

  void check_fresh_value_name(ast::Name const& name) {
    auto const [first, fresh] = values_declared.emplace(name.text, name.span);
    auto const node = left_nodes.find(name.text);
    if (fresh && node == left_nodes.end()) return;
    report(Code::duplicate_name, name.span, fmt::format("`{}` is declared twice", name.text),
           {{fresh ? *rule.nodes[node->second].left_span : first->second, "first declared here"}});
  }

  void add_clauses() {
    ExprContext const context{&rule, &group, &values, &externs};
    for (ast::SideItem const& item : declared.right.items) {
      if (auto const* let = std::get_if<ast::Let>(&item)) {
        report(Code::misplaced_item, let->span, "a `let` stands on the left side", {}, {"it is computed before anything changes, and is visible on the right side"});
      } else if (auto const* require = std::get_if<ast::Require>(&item)) {
        report(Code::misplaced_item, require->span, "a `require` stands on the left side", {}, {"it is tested before anything changes"});
      }
      auto const* node = std::get_if<ast::Node>(&item);
      if (!node) continue;
      ir::NodeId const id = right_nodes.at(node->name.text);
      for (ast::Clause const& clause : node->clauses) add_clause(id, clause, context);
    }
  }

  void add_clause(ir::NodeId id, ast::Clause const& clause, ExprContext const& context) {
    auto const& embeddings = rule.modeler->embeddings;
    auto const found = std::find_if(embeddings.begin(), embeddings.end(), [&](EmbeddingSpec const& e) { return e.name == clause.embedding.text; });
    if (found == embeddings.end()) {
      if (declared_on && declared_on->has_embedding(clause.embedding.text)) return;
      std::vector<std::string> known;
      for (EmbeddingSpec const& e : embeddings) known.push_back(e.name);
      report_unknown(diagnostics, Code::unknown_embedding, clause.embedding, "embedding", known);
      return;
    }
    auto const index = static_cast<std::size_t>(found - embeddings.begin());
    for (ir::Clause const& other : rule.clauses) {
      if (other.node == id && other.embedding == index) {
        report(Code::two_clauses, clause.span, fmt::format("`{}` of `{}` is given twice", found->name, rule.nodes[id].name), {{other.span, "first given here"}});
        return;
      }
    }
    if (ir::ExprPtr value = check_expression(*clause.value, context, rule.modeler->value_type(index), diagnostics)) {
      rule.clauses.push_back({id, index, std::move(value), clause.span});
    }
  }

  // ---- All of it ----

  std::optional<ir::RuleScheme> run(std::string const& name, std::string const& module) {
    std::size_t const errors_before = diagnostics.error_count();
    rule.name = name;
    rule.doc = declared.doc;
    rule.span = declared.name.span;
    rule.module = module;
    add_parameters();
    declare_nodes(declared.left, true);
    declare_nodes(declared.right, false);
    read_hook_type();
    add_decorations(declared.left, true);
    for (bool const left : {true, false}) {
      if (!left) add_decorations(declared.right, false);
      for (ast::SideItem const& item : (left ? declared.left : declared.right).items) {
        if (auto const* chain = std::get_if<ast::ArcChain>(&item)) add_chain(*chain, left);
      }
    }
    // Components are known only if every arc of the left side is: an arc that was reported may be the missing link.
    if (diagnostics.error_count() == errors_before) check_components();
    add_left_expressions();
    add_clauses();
    for (ast::Expectation const& expectation : declared.expectations) {
      if (auto expected = elaborate_expectation(expectation, model, diagnostics)) rule.expectations.push_back(*expected);
    }
    if (diagnostics.error_count() != errors_before) return {};
    return std::move(rule);
  }
};

}  // namespace

std::optional<ir::RuleScheme> elaborate_rule(ast::Rule const& rule, std::string const& name, std::string const& module,
                                             std::shared_ptr<ir::Modeler const> modeler, DimensionValues const& values,
                                             Externs const& externs, Diagnostics& diagnostics,
                                             ir::Modeler const* declared_on) {
  return RuleElaboration(rule, std::move(modeler), values, externs, diagnostics, declared_on).run(name, module);
}

}  // namespace jrule::sema
