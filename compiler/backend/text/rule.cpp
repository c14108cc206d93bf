#include "compiler/backend/text/rule.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <set>
#include <vector>

#include "compiler/backend/text/expression.h"
#include "compiler/sema/units.h"

namespace jrule::text {

namespace {

/// The loops of one node that its declaration spells: for each position of the hook's type, what the op-arcs become.
struct Decoration {
  bool written = false;
  std::vector<std::optional<Letter>> positions;  ///< none is `_`
  bool operator==(Decoration const&) const = default;
};

std::string spell_decoration(Decoration const& decoration) {
  std::vector<std::string> positions;
  for (auto const& letter : decoration.positions) positions.push_back(letter ? text::spell(*letter) : "_");
  return fmt::format("<{}>", fmt::join(positions, ","));
}

/// A side as it is written: nodes in this order, decorated, and arcs of their own.
struct WrittenSide {
  std::vector<ir::NodeId> order;
  std::vector<Decoration> decorations;  ///< of all nodes
  std::vector<ir::Arc> arcs;
};

class RuleSpeller {
 public:
  explicit RuleSpeller(ir::RuleScheme const& rule) : rule_(rule), group_(rule.model()) {}

  std::string spell(std::string const& name, std::string const& modeler) {
    check_names();
    check_hooks();
    check_repeated(rule_.left);
    check_repeated(rule_.right);
    WrittenSide const left = write_side(true), right = write_side(false);
    std::string text = documentation(rule_.doc, "");
    text += fmt::format("rule {}{} on {} {{\n  left {{\n", name, parameters(), modeler);
    for (ir::NodeId const id : left.order) text += left_node(id, left);
    text += arcs(left) + values() + "  }\n  right {\n";
    for (ir::NodeId const id : right.order) text += right_node(id, left, right);
    text += arcs(right) + "  }\n";
    for (ir::Expectation const& e : rule_.expectations) text += fmt::format("  expect {}' = {};\n", ir::count_name(e.cell), to_string(e.count));
    return text + "}\n\n";
  }

  std::string fault;

 private:
  void fail(std::string reason) {
    if (fault.empty()) fault = std::move(reason);
  }
  std::string take(Spelled<std::string> spelled) {
    if (!spelled) fail(std::move(spelled.error().reason));
    return spelled.value_or("");
  }
  std::string documentation(std::string const& doc, std::string const& indent) { return take(spell_documentation(doc, indent)); }

  // ---- What the language has, too, but only once ----

  void check_names() {
    std::set<std::string> nodes, values;
    for (ir::Node const& node : rule_.nodes) {
      if (!nodes.insert(node.name).second) fail(fmt::format("two nodes are called `{}`", node.name));
    }
    auto const add = [&](std::string const& name) {
      if (!values.insert(name).second) fail(fmt::format("two values are called `{}`", name));
    };
    for (ir::Parameter const& parameter : rule_.parameters) add(parameter.name);
    for (ir::Let const& let : rule_.lets) add(let.name);
  }

  void check_repeated(ir::Side const& side) {
    for (ir::Arc const& arc : side.arcs) {
      if (ir::find_same(side, arc) != &arc) {
        fail(fmt::format("the {}-arc from `{}` to `{}` stands twice on one side", arc.dimension, rule_.nodes[arc.source].name,
                         rule_.nodes[arc.target].name));
      }
    }
  }

  void check_hooks() {
    if (!std::is_sorted(rule_.hooks.begin(), rule_.hooks.end())) fail("the hooks are not in the order of the nodes");
    std::set<int> dimensions;
    for (Letter const letter : rule_.hook_type) {
      if (letter.conjugate || !dimensions.insert(letter.dimension).second) fail("the type of the hook is no list of dimensions");
    }
    if (rule_.hooks.empty() && !rule_.hook_type.empty()) fail("there is a type, but no hook");
    if (!rule_.hooks.empty() && !is_full(rule_.hooks[0])) {
      fail(fmt::format("the hook `{}` lacks a loop of its type", rule_.nodes[rule_.hooks[0]].name));
    }
  }

  // ---- Decorations ----

  /// What the arc is at position p of the node's decoration; none if it cannot stand there.
  std::optional<Letter> at_position(ir::Arc const& arc, ir::NodeId id, std::size_t p, bool left) const {
    Letter const op = rule_.hook_type[p];
    if (arc.source != id || arc.target != id || arc.word.size() != 1 || arc.word[0].dimension != op.dimension) return {};
    Model const& model = rule_.model();
    if (model.is_oriented(op.dimension) && !model.is_oriented(arc.dimension)) return {};
    Letter const letter{static_cast<std::uint8_t>(arc.dimension), arc.word[0].conjugate};
    if (left && rule_.nodes[id].hook == std::size_t{0} && letter != op) return {};
    return letter;
  }

  bool is_full(ir::NodeId hook) const {
    for (std::size_t p = 0; p < rule_.hook_type.size(); ++p) {
      if (std::none_of(rule_.left.arcs.begin(), rule_.left.arcs.end(), [&](ir::Arc const& a) { return at_position(a, hook, p, true).has_value(); })) {
        return false;
      }
    }
    return true;
  }

  /// Left nodes in their order, right ones in that of their places, unless that would renumber the added ones.
  std::vector<ir::NodeId> order(bool left) const {
    std::vector<ir::NodeId> ids;
    for (ir::NodeId id = 0; id < rule_.nodes.size(); ++id) {
      if (left ? !rule_.nodes[id].added() : !rule_.nodes[id].deleted()) ids.push_back(id);
    }
    if (left) return ids;
    std::vector<ir::NodeId> placed = ids, added;
    std::stable_sort(placed.begin(), placed.end(),
                     [&](ir::NodeId a, ir::NodeId b) { return rule_.nodes[a].right_span->begin < rule_.nodes[b].right_span->begin; });
    std::copy_if(placed.begin(), placed.end(), std::back_inserter(added), [&](ir::NodeId id) { return rule_.nodes[id].added(); });
    return std::is_sorted(added.begin(), added.end()) ? placed : ids;
  }

  WrittenSide write_side(bool left) const {
    auto const& arcs = (left ? rule_.left : rule_.right).arcs;
    WrittenSide side{order(left), std::vector<Decoration>(rule_.nodes.size(), Decoration{false, std::vector<std::optional<Letter>>(rule_.hook_type.size())}), {}};
    std::vector<bool> decorates(arcs.size(), false);
    // Decorations come first in a side's list of arcs, so all that they spell is a beginning of it.
    std::size_t next = 0;
    for (ir::NodeId const id : side.order) {
      Decoration& decoration = side.decorations[id];
      bool const is_hook = left && rule_.nodes[id].hook;
      if (is_hook && !is_full(id)) continue;  // a further one: its loops are written as arcs
      decoration.written = is_hook;
      for (std::size_t p = 0; p < rule_.hook_type.size() && next < arcs.size(); ++p) {
        decoration.positions[p] = at_position(arcs[next], id, p, left);
        if (!decoration.positions[p]) continue;
        decoration.written = true;
        decorates[next++] = true;
      }
    }
    // Hooks take their loops from elsewhere too.
    for (ir::NodeId const id : rule_.hooks) {
      Decoration& decoration = side.decorations[id];
      for (std::size_t p = 0; left && decoration.written && p < rule_.hook_type.size(); ++p) {
        for (std::size_t i = 0; i < arcs.size() && !decoration.positions[p]; ++i) {
          if (decorates[i]) continue;
          decoration.positions[p] = at_position(arcs[i], id, p, left);
          decorates[i] = decoration.positions[p].has_value();
        }
      }
    }
    for (std::size_t i = 0; i < arcs.size(); ++i) {
      if (!decorates[i]) side.arcs.push_back(arcs[i]);
    }
    return side;
  }

  // ---- Text ----

  std::string parameters() { return take(spell_parameters(rule_.parameters, group_)); }

  std::string left_node(ir::NodeId id, WrittenSide const& left) {
    ir::Node const& node = rule_.nodes[id];
    Decoration const& decoration = left.decorations[id];
    return fmt::format("{}    {}{}{};\n", documentation(node.doc, "    "), node.hook ? "hook " : "", node.name,
                       decoration.written ? " " + spell_decoration(decoration) : "");
  }

  std::string right_node(ir::NodeId id, WrittenSide const& left, WrittenSide const& right) {
    ir::Node const& node = rule_.nodes[id];
    Decoration const& decoration = right.decorations[id];
    // `a;` repeats the decoration of the left, if there is one.
    Decoration const& repeated = left.decorations[id];
    bool const explicitly = repeated.written ? decoration.positions != repeated.positions : decoration.written;
    std::string text = node.added() ? documentation(node.doc, "    ") : "";
    text += fmt::format("    {}{}", node.name, explicitly ? " " + spell_decoration(decoration) : "");
    std::string clauses;
    for (ir::Clause const& clause : rule_.clauses) {
      if (clause.node != id) continue;
      EmbeddingSpec const& embedding = rule_.modeler->embeddings[clause.embedding];
      clauses += fmt::format(" {} = {};", embedding.name, value(*clause.value, rule_.lets.size(), rule_.modeler->value_type(clause.embedding)));
    }
    return text + (clauses.empty() ? ";\n" : fmt::format(" {{{} }}\n", clauses));
  }

  /// One statement for each chain. An arc and its reverse are `-d-`, any other, also of a non-oriented dimension, is `-d->`.
  std::string arcs(WrittenSide const& side) const {
    std::string text;
    std::optional<ir::NodeId> end;  // of the chain that is being written; none after a loop
    for (std::size_t i = 0; i < side.arcs.size(); ++i) {
      ir::Arc const& arc = side.arcs[i];
      bool both = false;
      if (!rule_.model().is_oriented(arc.dimension)) {
        ir::Arc const reverse{arc.target, arc.dimension, group_.inverse(arc.word), arc.source, {}};
        bool const followed = i + 1 < side.arcs.size() && side.arcs[i + 1].same(reverse);
        both = reverse.same(arc) || followed;
        if (followed) ++i;
      }
      bool const loop = arc.source == arc.target;
      if (loop || end != arc.source) text += fmt::format("{}    {}", text.empty() ? "" : ";\n", rule_.nodes[arc.source].name);
      text += fmt::format(" -{}{}{} {}", arc.dimension, arc.word.empty() ? "" : spell_word(arc.word), both ? "-" : "->",
                          rule_.nodes[arc.target].name);
      end = loop ? std::optional<ir::NodeId>() : arc.target;
    }
    return text.empty() ? "" : text + ";\n";
  }

  std::string value(ir::Expr const& expr, std::size_t lets, std::optional<ir::ExprType> expected) {
    return take(text::spell(expr, rule_, group_, lets, expected));
  }

  /// Requirements stand as late as they can: a `let` behind one may have the name of a variable in it.
  std::string values() {
    std::size_t const all = rule_.lets.size();
    std::vector<std::string> requirements(all + 1);  // behind so many lets
    std::size_t lets = all;
    for (auto requirement = rule_.requirements.rbegin(); requirement != rule_.requirements.rend(); ++requirement) {
      auto const spell = [&](std::size_t count) { return text::spell(*requirement->condition, rule_, group_, count, ir::ExprType{Type::Bool}); };
      Spelled<std::string> const latest = spell(lets);
      Spelled<std::string> text = latest;
      while (!text && lets > 0) text = spell(--lets);
      std::string& there = requirements[lets];
      there = fmt::format("    require {};\n", take(text ? text : latest)) + there;
    }
    std::string text = requirements[0];
    for (std::size_t i = 0; i < all; ++i) {
      text += fmt::format("    let {} = {};\n", rule_.lets[i].name, value(*rule_.lets[i].value, i, {})) + requirements[i + 1];
    }
    return text;
  }

  ir::RuleScheme const& rule_;
  algebra::Group group_;
};

}  // namespace

Spelled<std::string> spell_documentation(std::string const& doc, std::string const& indent) {
  if (doc.empty()) return "";
  std::string text;
  std::size_t begin = 0;
  while (begin <= doc.size()) {
    std::size_t const end = std::min(doc.find('\n', begin), doc.size());
    std::string const line = doc.substr(begin, end - begin);
    if (line.find('\r') != std::string::npos || (!line.empty() && line.find_last_of(" \t\f") == line.size() - 1)) {
      return tl::unexpected(Unspellable{"a line of the documentation ends with white space"});
    }
    text += indent + (line.empty() ? "///" : "/// " + line) + "\n";
    begin = end + 1;
  }
  return text;
}

Spelled<std::string> spell_parameters(std::vector<ir::Parameter> const& parameters, algebra::Group const& group) {
  auto const unspellable = [](std::string reason) { return tl::unexpected(Unspellable{std::move(reason)}); };
  std::vector<std::string> texts;
  for (ir::Parameter const& p : parameters) {
    ir::ExprType const type = p.value_type();
    if (p.default_value && ir::ExprType{type_of(*p.default_value)} != type) return unspellable(fmt::format("the default of `{}` has another type", p.name));
    std::string const doc = p.unit.empty() ? p.doc : fmt::format("[{}]{}{}", p.unit, p.doc.empty() ? "" : " ", p.doc);
    auto const [unit, rest] = sema::split_unit(doc);
    if (unit != p.unit || rest != p.doc) return unspellable(fmt::format("the unit of `{}` is not told apart from its documentation", p.name));
    auto const lines = spell_documentation(doc, "    ");
    if (!lines) return lines;
    std::string text = fmt::format("{}{}{}: {}", doc.empty() ? "" : "\n", *lines, p.name, to_string(type));
    if (p.default_value) text += " = " + spell_constant(*p.default_value);
    if (p.computed_default) {
      auto const value = text::spell(*p.computed_default, ir::RuleScheme{}, group, 0, type);
      if (!value) return value;
      text += " = " + *value;
    }
    texts.push_back(std::move(text));
  }
  return texts.empty() ? "" : fmt::format("({})", fmt::join(texts, ", "));
}

Spelled<std::string> spell_rule(ir::RuleScheme const& rule, std::string const& name, std::string const& modeler) {
  RuleSpeller speller(rule);
  std::string text = speller.spell(name, modeler);
  if (!speller.fault.empty()) return tl::unexpected(Unspellable{fmt::format("rule `{}`: {}", rule.name, speller.fault)});
  return text;
}

}  // namespace jrule::text
