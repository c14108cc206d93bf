// All rules of the library, found in its files, and what they are applied to.
#pragma once

#include <string>
#include <vector>

#include "compiler/syntax/ast.h"
#include "tests/stdlib/application.h"
#include "tests/stdlib/subjects.h"

namespace jrule::test {

/// The files of the library, without `.jrule`, in order.
std::vector<std::string> modules();
/// The rules that one of them declares, as written.
std::vector<ast::Rule> declared_rules(std::string const& module);

/// The rules of a module, accepted; of std.basic, what its rules stand for on gmap(1) to gmap(3): "sew[2] on gmap(3)".
struct Rules {
  std::vector<Module::Rule> rules;
  std::size_t declared = 0;
};
Rules rules_of(std::string const& module);
std::vector<Module::Rule> const& all_rules();
/// "sew" of "sew[2] on gmap(3)".
std::string family_of(std::string const& name);

std::vector<Subject> const& subjects_for(ir::RuleScheme const& rule);
/// Its defaults, and where there is none, numbers that differ.
std::vector<Value> some_arguments(ir::RuleScheme const& rule);
/// All darts of a map, those that follow one another far apart.
std::vector<Dart> spread(Map const& map);

}  // namespace jrule::test
