// What the parts of a rule's function share: the rule, and the C++ names of all that it mentions.
#pragma once

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "compiler/analysis/plan.h"
#include "compiler/backend/cpp/emit.h"
#include "compiler/backend/cpp/names.h"

namespace jrule::cpp {

/// The names that a rule brings into its namespace.
struct PublicNames {
  std::string function;    ///< "cone"
  std::string everywhere;  ///< "cone_everywhere"; empty unless the rule has one hook
  std::string within;      ///< "cone_within", if an operation applies it everywhere in an orbit
  std::string result;      ///< "ConeResult"
  std::string modeler;     ///< the class that it works on, as it is called here: "Surface", "::base::Surface"
  std::string class_name;  ///< the same without its namespace
};

/// How the darts of the pattern are held.
enum class Form {
  one,     ///< in columns, in the function that has matched them
  listed,  ///< in columns, as parameters of a function: of one application or of all
  dense,   ///< they are all darts of the map, each its own index
};

struct Function {
  ir::RuleScheme const& rule;
  analysis::Plan const& plan;
  source::Sources const& sources;
  PublicNames names;
  bool independent;  ///< may all orbits of the hook be rewritten at once?
  Form form = Form::one;

  // Parameters.
  std::string modeler;             ///< "surface"
  std::vector<std::string> hooks;  ///< in order of declaration
  std::vector<std::string> parameters;
  // Local variables.
  std::string map, workspace, threads, size, index;        ///< "map", "workspace", "threads", "n", "k"
  std::vector<std::string> darts;                          ///< by node: its copies; of an added one, if dense, the first
  std::map<std::string, std::string, std::less<>> locals;  ///< further ones, by what they hold: "expected"
  std::map<Word, std::string> columns;                     ///< of the words that are used, without ε
  std::set<Word> copied;                                   ///< if dense: those that are written before they are read
  std::vector<ir::Arc const*> writes;                      ///< those of the plan, in the order in which they are made
  std::vector<std::string> arcs, arc_sources;              ///< by dimension: the map's columns
  std::vector<std::string> lets, let_lists;                ///< of one application, of all
  std::vector<std::string> embeddings, values, new_values;
  std::vector<std::string> dart_handles;            ///< by embedding: the map's column
  std::map<Letter, std::string> steps;              ///< the map's columns by the letter that they follow: "to_0", "from_1"
  std::map<std::pair<OrbitType, OrbitType>, std::string> walks;  ///< that expressions range over, with their `by`
  std::map<std::string, std::string> variables;     ///< of comprehensions; those of one name are never within each other
  std::vector<std::string> hook_loops;              ///< by hook
  std::map<std::vector<Word>, std::string> orbits;  ///< of the pattern, by their generators
  std::map<std::vector<Word>, std::string> firsts;  ///< by generators: by pattern dart, the first one of its orbit
  std::vector<std::string> handles;                 ///< by component of the plan
  std::vector<std::vector<std::string>> inherited;  ///< by component, then source
  std::vector<std::string> members;                 ///< by node: its name in the result

  // What of these is used.
  std::vector<bool> adds_values;
  std::vector<bool> uses_parameter, uses_let;

  Scope scope;

  Function(Rule const& rule, source::Sources const& sources, PublicNames names, Scope scope);

  ir::Node const& node(ir::NodeId id) const { return rule.nodes[id]; }
  EmbeddingSpec const& spec(std::size_t e) const { return rule.modeler->embeddings[e]; }
  std::string const& local(std::string_view name) const { return locals.find(name)->second; }
  /// "match_a[k]", "match_a[at_2[k]]"; if dense, "k", "at_2[k]".
  std::string dart(ir::NodeId id, Word const& word = {}) const;
  /// The same in a loop of stream(): as an index of the map's columns, and as what is written there. If dense,
  /// "added_b + at_2[k]" and "static_cast<jrule::Dart>(added_b + at_2[k])".
  std::string place(ir::NodeId id, Word const& word = {}) const;
  std::string written(ir::NodeId id, Word const& word = {}) const;
  /// The index of u_k·word: "k", "at_2[k]".
  std::string at(Word const& word) const;
  /// The dart where a word leads, in the map as it is before the commit: "to_2[from_1[a]]".
  std::string walk(std::string const& dart, Word const& word) const;
  /// The pattern's orbits that the component needs, and the column of their first darts; empty if each dart is its own.
  std::string orbits_of(analysis::OrbitComponent const& component) const;
  std::string first(analysis::OrbitComponent const& component) const;
  /// Does merging orbits of that embedding, or of any, call a function that may throw?
  bool merges_on_trial(std::size_t embedding) const;
  bool merges_on_trial() const;
  /// "for (std::size_t k = 0; k < n; ++k)".
  std::string loop() const;
  /// The statement for each index, on several threads if they may be taken: what it writes, nothing else reads or writes.
  std::string each(std::string const& statement) const;
  /// The loop of a stream, where columns are written one after the other. Where threads may be taken it stands in a body that has a
  /// part of the indices, from `begin` to `end`. If dense, the index is one that compilers make streams of.
  std::string stream() const;
  /// May threads be taken? Applications at one orbit have no use for them.
  bool takes_threads() const { return form != Form::one; }
  /// Is the word its own inverse as it stands: one letter of a dimension that is not oriented?
  bool is_involution(Word const& word) const { return word.size() == 1 && !rule.model().is_oriented(word.front().dimension); }
  /// Is the word's column the map's own?
  bool is_aliased(Word const& word) const { return form == Form::dense && word.size() == 1 && !copied.contains(word); }
  /// Can all darts of a map be rewritten at once, without columns of their own?
  bool can_be_dense() const;
  /// The same function in another form.
  Function in(Form other) const;

 private:
  void use(ir::Expr const& expr);
  void name_walk(ir::Darts const& over);
  void order_writes();
  void name_columns();
  void name_values();
};

/// The declaration of the rule's result and functions.
std::string declare(Function const& f);
/// Their definitions. `within`: and that of a function which applies an independent rule inside an orbit, for operations.
std::string define(Function const& f, bool within);

}  // namespace jrule::cpp
