// What calls in operations mean: rules and operations by name, elaborated where they are first used.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "compiler/ir/program.h"
#include "compiler/sema/modeler_table.h"

namespace jrule::sema {

/// Where an operation of the program comes from: `operations[i]` of Callees is that of Program::operations[i].
struct OperationItem {
  ast::Operation const* declared;
  Module const* module;  ///< that declares it
  DimensionValues values;  ///< n of `on gmap(n)`
  ModelerPtr declared_on;  ///< its own modeler; another one may have taken it
};

/// What a call names: an index into Program::rules or Program::operations.
struct Callee {
  bool is_rule;
  std::size_t index;
};

class Callees {
 public:
  Callees(Modules const& modules, Externs const& externs, ModelerTable& modelers, ir::Program& program)
      : modules_(modules), externs_(externs), modelers_(modelers), program_(program) {}

  /// A rule of the program that calls may mean, or that is known to have an error.
  void add(ast::Rule const& rule, ir::Modeler const& modeler, std::optional<std::size_t> index);
  /// Declares an operation: all but its body. `import`: where the root imports it from another module. None if something was
  /// reported.
  std::optional<std::size_t> declare(OperationItem item, std::string const& name, ModelerPtr modeler, std::optional<source::Span> import,
                                     source::Diagnostics& diagnostics);

  std::vector<OperationItem> const& operations() const { return operations_; }

  /// Does the name mean a rule or an operation in the module: its own, or one of a module that it imports?
  bool knows(Module const& module, std::string const& name) const { return find_item(module, name) != nullptr; }
  std::vector<std::string> names(Module const& module) const;
  /// What a call in the body of that operation means: on its modeler. None, reported, if that is nothing.
  std::optional<Callee> find(std::size_t caller, ast::Call const& call, source::Diagnostics& diagnostics);

 private:
  ast::Item const* find_item(Module const& module, std::string const& name, Module const** declaring = nullptr) const;
  std::string fresh_name(std::string const& name, std::string const& module, ir::Modeler const& modeler) const;
  /// May an operation that was declared on `caller`'s modeler call what is declared on that one, in that module? Reported if not.
  bool is_callable(std::size_t caller, ast::Name const& name, std::string_view kind, source::Span declared, ir::Modeler const& on, Module const& module,
                   source::Diagnostics& diagnostics);
  std::optional<Callee> find_rule(std::size_t caller, ast::Call const& call, ast::Rule const& rule, Module const& module, source::Diagnostics& diagnostics);
  std::optional<Callee> find_operation(std::size_t caller, ast::Call const& call, ast::Operation const& operation, Module const& module,
                                       source::Diagnostics& diagnostics);
  std::optional<std::size_t> instantiate(ast::Rule const& rule, std::vector<int> const& dimensions, DimensionValues const& values, Module const& module,
                                         ModelerPtr const& modeler, ir::Modeler const& declared_on, source::Span call,
                                         source::Diagnostics& diagnostics);

  using Key = std::tuple<void const*, std::vector<int>, std::string>;  // the declaration, its dimensions, the modeler
  Modules const& modules_;
  Externs const& externs_;
  ModelerTable& modelers_;
  ir::Program& program_;
  std::map<Key, std::optional<std::size_t>> known_;  // none: it has an error, which is reported
  std::vector<OperationItem> operations_;
};

}  // namespace jrule::sema
