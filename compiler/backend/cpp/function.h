// What the parts of a rule's function share: the rule, and the C++ names of all that it mentions.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "compiler/analysis/plan.h"
#include "compiler/backend/cpp/emit.h"
#include "compiler/backend/cpp/names.h"

namespace jrule::cpp {

/// The names that a rule brings into its namespace.
struct PublicNames {
  std::string function;    ///< "cone"
  std::string everywhere;  ///< "cone_everywhere"; empty unless the rule has one hook
  std::string result;      ///< "ConeResult"
  std::string modeler;     ///< the class that it works on, as it is called here: "Surface", "::base::Surface"
  std::string class_name;  ///< the same without its namespace
};

struct Function {
  ir::RuleScheme const& rule;
  analysis::Plan const& plan;
  source::Sources const& sources;
  PublicNames names;

  // Parameters.
  std::string modeler;             ///< "surface"
  std::vector<std::string> hooks;  ///< in order of declaration
  std::vector<std::string> parameters;
  // Local variables.
  std::string map, workspace, size, index;                 ///< "map", "workspace", "n", "k"
  std::vector<std::string> darts;                          ///< by node: the vector of its copies
  std::map<std::string, std::string, std::less<>> locals;  ///< further ones, by what they hold: "expected"
  std::map<Word, std::string> columns;                     ///< of the words that are used, without ε
  std::vector<std::string> lets;
  std::vector<std::string> embeddings, values, new_values;
  std::map<OrbitType, std::string> orbit_types;     ///< those that expressions range over
  std::map<std::string, std::string> variables;     ///< of comprehensions; those of one name are never within each other
  std::vector<std::string> hook_loops;              ///< by hook
  std::map<std::vector<Word>, std::string> firsts;  ///< by generators: by pattern dart, the first one of its orbit
  std::vector<std::string> handles;                 ///< by component of the plan
  std::vector<std::vector<std::string>> inherited;  ///< by component, then source
  std::vector<std::string> members;                 ///< by node: its name in the result

  // What of these is used.
  std::vector<bool> reads_embedding, uses_embedding, adds_values;
  std::vector<bool> uses_parameter, uses_let;

  Scope scope;

  Function(Rule const& rule, source::Sources const& sources, PublicNames names, Scope scope);

  ir::Node const& node(ir::NodeId id) const { return rule.nodes[id]; }
  EmbeddingSpec const& spec(std::size_t e) const { return rule.modeler->embeddings[e]; }
  std::string const& local(std::string_view name) const { return locals.find(name)->second; }
  /// "match_a[k]", "match_a[at_2[k]]".
  std::string dart(ir::NodeId id, Word const& word = {}) const;
  /// The index of u_k·word: "k", "at_2[k]".
  std::string at(Word const& word) const;
  /// The column of the pattern's orbits that the component needs; empty if each dart is its own.
  std::string first(analysis::OrbitComponent const& component) const;
  /// Does merging orbits of that embedding, or of any, call a function that may throw?
  bool merges_on_trial(std::size_t embedding) const;
  bool merges_on_trial() const;
  /// "for (std::size_t k = 0; k < n; ++k)".
  std::string loop() const;

 private:
  void use(ir::Expr const& expr);
  void use_orbit_type(OrbitType const& type);
  void name_columns();
  void name_values();
};

/// The declaration of the rule's result and functions.
std::string declare(Function const& f);
/// Their definitions.
std::string define(Function const& f);

}  // namespace jrule::cpp
