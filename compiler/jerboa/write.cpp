#include "compiler/jerboa/write.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <string_view>

#include "compiler/jerboa/names.h"
#include "compiler/jerboa/translate.h"

namespace jrule::jerboa {

namespace {

using Code = source::Code;

std::string spell(Orbit const& orbit) {
  std::string text;
  for (int const dimension : orbit) {
    if (!text.empty()) text += ',';
    text += dimension == removed ? "_" : std::to_string(dimension);
  }
  return "<" + text + ">";
}

/// The lines, without blank ones at both ends, each behind the prefix.
std::string lines(std::string_view text, std::string const& prefix) {
  std::string result;
  std::string blank;
  while (!text.empty()) {
    std::size_t const end = std::min(text.find_first_of("\r\n"), text.size());
    std::string_view line = text.substr(0, end);
    line = line.substr(0, line.find_last_not_of(" \t\f") + 1);
    std::string const written = line.empty() ? prefix : fmt::format("{} {}", prefix, line);
    if (line.empty()) {
      if (!result.empty()) blank += written + "\n";
    } else {
      result += blank + written + "\n";
      blank.clear();
    }
    text.remove_prefix(text.substr(end).starts_with("\r\n") ? end + 2 : std::min(end + 1, text.size()));
  }
  return result;
}

bool takes_one_dart(std::string const& multiplicity) {
  return multiplicity.empty() || multiplicity == "1" || multiplicity == "{1}" || multiplicity == "{1,1}";
}

class Writer {
 public:
  Writer(Modeler const& modeler, source::Diagnostics& diagnostics) : modeler_(modeler), diagnostics_(diagnostics) {}

  std::string run(std::string const& origin);

 private:
  void report(Code code, Span span, std::string message, std::vector<std::string> notes = {}) {
    diagnostics_.add({.code = code, .span = span, .message = std::move(message), .notes = std::move(notes)});
  }
  std::string take(Names& names, Name const& wanted, std::string_view what);
  std::string keep(Snippet const& code, std::string const& what, Span span, std::string const& reason);
  std::string keep_process(Snippet const& code, std::string const& what, std::string const& reason);
  std::string documentation(Snippet const& comment) const { return lines(comment.text, "///"); }

  std::string modeler_item();
  std::string embedding(Embedding const& embedding);
  std::string rule_item(Rule const& rule);
  std::string parameters(Rule const& rule, Names& names, Scope& scope);
  std::string left_side(Rule const& rule, Scope const& scope);
  std::string right_side(Rule const& rule, Scope const& scope);
  std::string clauses(Rule const& rule, Node const& node, Scope const& scope, std::string& comments);
  std::string arcs(Side const& side) const;

  Modeler const& modeler_;
  source::Diagnostics& diagnostics_;
  Names items_;
  std::string modeler_name_;
  std::map<std::string, Scope::Known, std::less<>> embeddings_;
  std::map<std::string, std::string, std::less<>> nodes_;  ///< of the rule that is written, both sides
};

// ---- Names, and what is kept as comments ----

std::string Writer::take(Names& names, Name const& wanted, std::string_view what) {
  std::string const name = names.take(wanted.text);
  if (name != wanted.text) report(Code::renamed, wanted.span, fmt::format("the {} `{}` is called `{}`", what, wanted.text, name));
  return name;
}

std::string Writer::keep(Snippet const& code, std::string const& what, Span span, std::string const& reason) {
  report(Code::untranslated_code, span, fmt::format("{} is not translated: {}", what, reason), {"it is kept as a comment"});
  return lines(fmt::format("Not translated: {}", what), "//") + lines(code.text, "//  ");
}

std::string Writer::keep_process(Snippet const& code, std::string const& what, std::string const& reason) {
  return code.blank() ? "" : keep(code, what, code.place(), reason);
}

// ---- The modeler ----

std::string Writer::embedding(Embedding const& embedding) {
  auto const type = type_of(embedding, modeler_.dimension);
  if (!type) {
    report(Code::left_out, embedding.type.span,
           fmt::format("the embedding `{}` is left out: its type `{}` is not known", embedding.name.text, embedding.type.text),
           {"an `extern type` can stand for a class of C++"});
    return lines(fmt::format("Left out: embedding {} : {} -> {}", embedding.name.text, spell(embedding.orbit), embedding.type.text), "//");
  }
  std::string const& name = embeddings_.at(embedding.name.text).name;
  std::string text, policy;
  if (!embedding.default_code.blank()) {
    auto const value = translate(embedding.default_code.text, {}, *type);
    if (value) {
      policy = fmt::format(" {{ default {}; }}", *value);
    } else {
      text += keep(embedding.default_code, fmt::format("the default value of `{}`", embedding.name.text),
                   embedding.default_code.place(value.error().begin, value.error().end), value.error().reason);
    }
  }
  return text + documentation(embedding.comment) + fmt::format("embedding {} : {} -> {}{}\n", name, spell(embedding.orbit), name_of(*type), policy.empty() ? ";" : policy);
}

std::string Writer::modeler_item() {
  modeler_name_ = take(items_, modeler_.name, "modeler");
  Names names;
  for (Embedding const& embedding : modeler_.embeddings) {
    auto const type = type_of(embedding, modeler_.dimension);
    if (type) embeddings_.emplace(embedding.name.text, Scope::Known{take(names, embedding.name, "embedding"), *type});
  }
  std::string text = keep_process(modeler_.header, "the header of the modeler", "it is for the program that Jerboa generates");
  text += documentation(modeler_.comment);
  text += fmt::format("modeler {} on gmap({})", modeler_name_, modeler_.dimension);
  if (modeler_.embeddings.empty()) return text + ";\n";
  text += " {\n";
  for (Embedding const& each : modeler_.embeddings) text += embedding(each);
  return text + "}\n";
}

// ---- Rules ----

std::string Writer::parameters(Rule const& rule, Names& names, Scope& scope) {
  std::string text;
  for (Parameter const& parameter : rule.parameters) {
    auto const type = type_of(parameter.type.text);
    if (!type) {
      report(Code::left_out, parameter.type.span,
             fmt::format("the parameter `{}` of the rule `{}` is left out: its type `{}` is not known", parameter.name.text, rule.name.text, parameter.type.text));
      continue;
    }
    std::string const name = take(names, parameter.name, "parameter");
    scope.parameters.emplace(parameter.name.text, Scope::Known{name, *type});
    text += fmt::format("{}{}: {}", text.empty() ? "" : ", ", name, name_of(*type));
    if (parameter.default_code.blank()) continue;
    if (auto const value = translate(parameter.default_code.text, {}, *type)) {
      text += fmt::format(" = {}", *value);
    } else {
      report(Code::untranslated_code, parameter.default_code.place(value.error().begin, value.error().end),
             fmt::format("the default value of the parameter `{}` of the rule `{}` is not translated: {}", parameter.name.text, rule.name.text, value.error().reason));
    }
  }
  return text.empty() ? "" : "(" + text + ")";
}

/// Chains, in the order of the arcs, then the loops, those of one dimension in one line.
std::string Writer::arcs(Side const& side) const {
  std::string text;
  std::optional<std::string> end;  // of the chain that is written; a node's name may be empty
  for (Arc const& arc : side.arcs) {
    if (arc.a == arc.b) continue;
    if (end == arc.a || end == arc.b) {
      end = end == arc.a ? arc.b : arc.a;
      text += fmt::format(" -{}- {}", arc.dimension, nodes_.at(*end));
      continue;
    }
    if (end) text += ";\n";
    text += fmt::format("{} -{}- {}", nodes_.at(arc.a), arc.dimension, nodes_.at(arc.b));
    end = arc.b;
  }
  if (end) text += ";\n";
  for (int dimension = 0; dimension <= 9; ++dimension) {
    std::string loops;
    for (Arc const& arc : side.arcs) {
      if (arc.a != arc.b || arc.dimension != dimension) continue;
      loops += fmt::format("{}{} -{}- {};", loops.empty() ? "" : " ", nodes_.at(arc.a), dimension, nodes_.at(arc.a));
    }
    if (!loops.empty()) text += loops + "\n";
  }
  return text;
}

std::string Writer::left_side(Rule const& rule, Scope const& scope) {
  std::vector<Node const*> nodes;
  for (Node const& node : rule.left.nodes) nodes.push_back(&node);
  // An application takes a dart for each hook, in the order in which the rule has them.
  auto const place = [&](Node const* node) {
    auto const found = std::find(rule.hooks.begin(), rule.hooks.end(), node->name.text);
    return node->hook ? found - rule.hooks.begin() : static_cast<std::ptrdiff_t>(rule.hooks.size()) + 1;
  };
  std::stable_sort(nodes.begin(), nodes.end(), [&](Node const* a, Node const* b) { return place(a) < place(b); });

  std::string text;
  for (Node const* node : nodes) {
    if (!takes_one_dart(node->multiplicity.text)) {
      report(Code::several_darts, node->multiplicity.span,
             fmt::format("the node `{}` stands for {} darts; in the written rule for one", node->name.text, node->multiplicity.text),
             {"a rule takes one dart for each of its hooks; an `operation` can apply it at several"});
    }
    text += keep_process(node->precondition, fmt::format("the precondition of the node `{}` of the rule `{}`", node->name.text, rule.name.text),
                         "a rule has preconditions as a whole only, `require`");
    text += fmt::format("{}{}", node->hook ? "hook " : "", nodes_.at(node->name.text));
    if (node->hook || !node->orbit.empty()) text += " " + spell(node->orbit);
    text += ";\n";
  }
  text += arcs(rule.left);
  if (!rule.precondition.blank()) {
    std::string const what = fmt::format("the precondition of the rule `{}`", rule.name.text);
    auto const condition = translate(rule.precondition.text, scope, Type::boolean);
    text += condition ? fmt::format("require {};\n", *condition)
                      : keep(rule.precondition, what, rule.precondition.place(condition.error().begin, condition.error().end), condition.error().reason);
  }
  return text;
}

std::string Writer::clauses(Rule const& rule, Node const& node, Scope const& scope, std::string& comments) {
  std::string text;
  for (Clause const& clause : node.clauses) {
    std::string const what = fmt::format("the value of `{}` at the node `{}` of the rule `{}`", clause.embedding.text, node.name.text, rule.name.text);
    auto const embedding = embeddings_.find(clause.embedding.text);
    if (embedding == embeddings_.end()) {
      comments += keep(clause.code, what, clause.embedding.span, fmt::format("there is no embedding `{}` here", clause.embedding.text));
      continue;
    }
    auto const value = translate(clause.code.text, scope, embedding->second.type);
    if (value) {
      text += fmt::format("{}{} = {};", text.empty() ? "" : " ", embedding->second.name, *value);
    } else {
      comments += keep(clause.code, what, clause.code.place(value.error().begin, value.error().end), value.error().reason);
    }
  }
  return text;
}

std::string Writer::right_side(Rule const& rule, Scope const& scope) {
  bool const has_hook = std::any_of(rule.left.nodes.begin(), rule.left.nodes.end(), [](Node const& node) { return node.hook && !node.orbit.empty(); });
  std::string text;
  for (Node const& node : rule.right.nodes) {
    auto const same = [&](Node const& other) { return other.name.text == node.name.text; };
    auto const left = std::find_if(rule.left.nodes.begin(), rule.left.nodes.end(), same);
    // On the right, a preserved node without a decoration repeats that of the left.
    bool const repeats = left != rule.left.nodes.end() && left->orbit == node.orbit;
    std::string comments;
    std::string const values = clauses(rule, node, scope, comments);
    text += comments + nodes_.at(node.name.text);
    if (!repeats && (has_hook || !node.orbit.empty())) text += " " + spell(node.orbit);
    text += values.empty() ? ";\n" : fmt::format(" {{ {} }}\n", values);
  }
  return text + arcs(rule.right);
}

std::string Writer::rule_item(Rule const& rule) {
  Names names;
  Scope scope;
  scope.embeddings = embeddings_;
  nodes_.clear();
  // Two nodes of one name on one side stay so: it is for the compiler to refuse them.
  for (Side const* side : {&rule.left, &rule.right}) {
    for (Node const& node : side->nodes) {
      if (!nodes_.contains(node.name.text)) nodes_.emplace(node.name.text, take(names, node.name, "node"));
      if (side == &rule.left) scope.nodes.emplace(node.name.text, nodes_.at(node.name.text));
    }
  }
  std::string const name = take(items_, rule.name, "rule");
  std::string const of = fmt::format(" of the rule `{}`", rule.name.text);
  std::string text = keep_process(rule.header, "the header" + of, "it is for the program that Jerboa generates");
  text += keep_process(rule.preprocess, "what is done before an application" + of, "a rule changes the map and nothing else");
  text += keep_process(rule.midprocess, "what is done between match and application" + of, "a rule changes the map and nothing else");
  text += keep_process(rule.postprocess, "what is done after an application" + of, "a rule changes the map and nothing else");
  text += documentation(rule.comment);
  text += fmt::format("rule {}{} on {} {{\n", name, parameters(rule, names, scope), modeler_name_);
  text += "left {\n" + left_side(rule, scope) + "}\n";
  text += "right {\n" + right_side(rule, scope) + "}\n";
  return text + "}\n";
}

std::string Writer::run(std::string const& origin) {
  std::string text = lines(fmt::format("From {}, by jrule import-jerboa.", origin), "//") + "\n";
  text += modeler_item();
  for (Rule const& rule : modeler_.rules) text += "\n" + rule_item(rule);
  for (Script const& script : modeler_.scripts) {
    report(Code::skipped_script, script.name.span,
           fmt::format("the script `{}` is not taken over: it is a program that calls rules, in a language of Jerboa's own", script.name.text),
           {"it is kept as a comment; what it does can be written as an `operation`"});
    text += "\n" + lines(fmt::format("Not translated: the script `{}`. What it does can be written as an operation.", script.name.text), "//");
    text += lines(script.content.text, "//  ");
  }
  return text;
}

}  // namespace

std::string write(Modeler const& modeler, std::string const& origin, source::Diagnostics& diagnostics) {
  return Writer(modeler, diagnostics).run(origin);
}

}  // namespace jrule::jerboa
