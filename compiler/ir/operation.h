// Operations: programs that chain rules (language reference, section 7). Values only, as rule schemes are.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "compiler/ir/rule_scheme.h"

namespace jrule::ir {

/// A parameter, a `let`, or the dart of a `for`. Each declaration has one of its own; it is set before it is read.
struct Variable {
  std::string name;
  ExprType type;                        ///< means nothing if it holds a result
  std::optional<std::size_t> result{};  ///< it holds what a call of that rule gave, in Program::rules
  Span span{};
};

/// A rule applied at darts, one for each hook, with a value for each parameter.
struct RuleCall {
  std::size_t rule;  ///< in Program::rules
  std::vector<ExprPtr> darts, values;
  Span span;
};
struct OperationCall {
  std::size_t operation;  ///< in Program::operations
  std::vector<ExprPtr> arguments;  ///< one for each parameter
  Span span;
};
/// Where the value of a variable or a result comes from. A call is never within an expression.
using Origin = std::variant<ExprPtr, RuleCall, OperationCall>;

struct Statement;
using Block = std::vector<Statement>;

/// `let x = …;` and `x = …;`
struct Set { std::size_t variable; Origin value; bool declares; };
/// A call whose value is not used.
struct Do { Origin call; };
struct If { ExprPtr condition; Block then_block, else_block; };
/// For each of the darts, which are chosen before the first round; those that are deleted when their turn comes are left out.
struct For { std::size_t variable; Darts over; Block body; };
struct While { ExprPtr condition; Block body; };
/// `value` is given iff the operation has a result.
struct Return { std::optional<Origin> value; };
struct Fail { std::string message; };
/// `otherwise` runs if `body` fails, on the map and with the variables as they were before `body`.
struct Try { Block body, otherwise; };
/// An independent rule at all orbits of its hook inside ⟨orbit⟩(at), at once; the hook's type is inside ⟨orbit⟩.
struct ApplyAll { std::size_t rule; std::vector<ExprPtr> values; OrbitType orbit; ExprPtr at; Span span; };

struct Statement {
  std::variant<Set, Do, If, For, While, Return, Fail, Try, ApplyAll> value;
  Span span;
};

struct Operation {
  std::string name;
  std::string doc;
  Span span;  ///< of its name
  std::string module;
  std::optional<Span> import;  ///< of another module's operation that is taken on a modeler of the root: where it is imported
  std::shared_ptr<Modeler const> modeler;
  std::vector<Parameter> parameters;
  std::optional<ExprType> result;   ///< one value or a dart
  std::vector<Variable> variables;  ///< the parameters, then the others in the order of declaration
  Block body;

  Model const& model() const { return modeler->model; }
};

/// Can what follows the block never be reached: does each way through it return or fail?
bool ends(Block const& block);
bool ends(Statement const& statement);

/// The blocks that a statement is made of.
std::vector<Block const*> blocks(Statement const& statement);
/// The expressions of a statement itself, not of its blocks.
std::vector<ExprPtr> expressions(Statement const& statement);

/// What a statement itself calls; null if it calls nothing. `apply_all` is none of these.
Origin const* origin(Statement const& statement);
/// All rules and operations that the block calls, in the order of writing; `apply_all` too.
struct Called { bool is_rule; std::size_t index; Span span; };
std::vector<Called> calls(Block const& block);

/// The variables that the block gives another value, and that are declared outside it; ascending.
std::vector<std::size_t> assigned(Block const& block);
/// All that it gives another value than that of their declaration.
std::vector<std::size_t> assigned_anywhere(Block const& block);

/// An empty rule on the operation's modeler. The functions on expressions ask for the rule that they are of; an operation's mention
/// no nodes, parameters or lets of one.
RuleScheme expression_scope(Operation const& operation);

}  // namespace jrule::ir
