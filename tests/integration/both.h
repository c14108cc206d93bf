// A rule applied by the interpreter and by its generated function, to equal maps: do they agree?
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "compiler/analysis/analyze.h"
#include "compiler/ir/rule_scheme.h"
#include "compiler/sema/modules.h"
#include "jrule/io.h"
#include "jrule/rewrite.h"

namespace jrule::test {

/// The rules of a module, accepted, with their plans.
class Module {
 public:
  explicit Module(std::string const& path);
  struct Rule {
    ir::RuleScheme scheme;
    analysis::Plan plan;
  };
  /// Fails the test if there is none of that name.
  Rule const& rule(std::string const& name) const;
  std::size_t size() const { return rules_.size(); }
  std::vector<Rule> const& rules() const { return rules_; }

 private:
  std::vector<Rule> rules_;
};

/// What an application came to, in a form that can be compared.
struct Outcome {
  std::string error{};                      ///< empty if it was applied
  std::vector<std::vector<Dart>> copies{};  ///< of the right nodes, in the order of the rule's nodes
  std::size_t count = 0;                    ///< how often everywhere; not told by generated code, not compared
  std::string map{};                        ///< the result as .jmap text
  bool operator==(Outcome const& other) const { return error == other.error && copies == other.copies && map == other.map; }
};
void PrintTo(Outcome const& outcome, std::ostream* out);

Outcome interpret(Module::Rule const& rule, Map map, std::vector<Dart> const& hooks,
                  std::vector<Value> const& arguments);
/// At all orbits of the hook at once if the rule is independent, else in turn.
Outcome interpret_everywhere(Module::Rule const& rule, Map map, std::vector<Value> const& arguments);

/// Gives every orbit of every embedding a value of its own, so that equal values cannot hide a mistake.
void number_values(Map& map);

/// The columns of a result, which are valid until the next application.
inline std::vector<std::vector<Dart>> lists(std::vector<std::span<Dart const>> const& columns) {
  std::vector<std::vector<Dart>> all;
  for (std::span<Dart const> const column : columns) all.emplace_back(column.begin(), column.end());
  return all;
}

/// Applies `call` to a copy of the map. Class is a generated modeler; `copies` picks the columns of its result.
template <class Class, class Call, class Copies>
Outcome generated(Map const& start, Call call, Copies copies) {
  auto modeler = Class::from_map(start);
  if (!modeler) return {.error = modeler.error().message};
  Outcome outcome;
  if (auto const result = call(*modeler)) {
    outcome.copies = copies(*result);
  } else {
    outcome.error = to_string(result.error());
  }
  outcome.map = print_jmap(modeler->map());
  return outcome;
}

/// The same for a function that applies everywhere.
template <class Class, class Call>
Outcome generated_everywhere(Map const& start, Call call) {
  auto modeler = Class::from_map(start);
  if (!modeler) return {.error = modeler.error().message};
  Outcome outcome;
  if (auto const applied = call(*modeler); !applied) outcome.error = to_string(applied.error());
  outcome.map = print_jmap(modeler->map());
  return outcome;
}

}  // namespace jrule::test
