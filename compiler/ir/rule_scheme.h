// The intermediate representation: everything after sema sees only these values.
//
// A rule scheme (paper, Def. 18) is a table: on each side, node s and dimension d lead by at most one arc to a word w and a
// node t, instantiated as (u, s)·d = (u·w, t) for every pattern dart u (theory: section 2 of the analyzer's
// specification). Until the incident-arcs condition is checked, a side may hold more than one such arc, so it is stored as
// a list of directed arcs, and Table is its indexed view. A non-oriented arc is two directed arcs.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "compiler/ir/count.h"
#include "compiler/source/source.h"
#include "jrule/embedding.h"
#include "jrule/model.h"

namespace jrule::ir {

using source::Span;
using NodeId = std::uint32_t;

// ---- C++ from outside ----

/// `extern type Soil in "geo/soil.hpp" as "geo::Soil";`
struct ExternType {
  std::string name, doc;
  std::string header, cpp_name;  ///< "geo/soil.hpp", "geo::Soil"
  Span span;                     ///< of its name
};
using ExternTypePtr = std::shared_ptr<ExternType const>;

/// A type of the language: one of the values or a dart, or a list of them.
struct ExprType {
  Type element = Type::Real;
  bool list = false;
  bool dart = false;
  ExternTypePtr external{};  ///< of Type::Extern: which one; else null
  bool operator==(ExprType const&) const = default;
};
inline ExprType const dart_type{Type::Real, false, true};  ///< `element` means nothing in it
inline ExprType const darts_type{Type::Real, true, true};
std::string to_string(ExprType const& type);

/// `extern fn hardness(x: Soil) -> Real in "geo/soil.hpp" as "geo::hardness";`
struct ExternFunction {
  std::string name, doc;
  struct Parameter {
    std::string name;
    ExprType type;
    Span span;
  };
  std::vector<Parameter> parameters;
  ExprType result;
  std::string header, cpp_name;
  Span span;  ///< of its name
};
using ExternFunctionPtr = std::shared_ptr<ExternFunction const>;
/// "(Soil, Real) -> Real".
std::string signature(ExternFunction const& function);

struct Expr;
using ExprPtr = std::shared_ptr<Expr const>;

// ---- Modelers ----

/// What of an embedding is C++ from outside; null what is not.
struct EmbeddingExterns {
  ExternTypePtr type;
  ExprPtr default_value;    ///< a default that calls extern functions; it reads nothing
  ExternFunctionPtr merge;  ///< of MergePolicy::function: (T, T) -> T or ([T]) -> T
};

struct Modeler {
  std::string name;
  std::string doc;
  Model model;
  std::vector<EmbeddingSpec> embeddings;
  std::vector<std::string> embedding_docs;
  std::vector<Span> embedding_spans;  ///< the names, where declared
  std::string module;                 ///< of the declaration; empty for a bare model
  std::vector<EmbeddingExterns> externs{};  ///< by embedding; none if that has nothing from outside

  EmbeddingExterns externs_of(std::size_t e) const { return e < externs.size() ? externs[e] : EmbeddingExterns{}; }
  ExprType value_type(std::size_t e) const { return {embeddings[e].type, false, false, externs_of(e).type}; }
  bool has_embedding(std::string const& wanted) const {
    for (EmbeddingSpec const& embedding : embeddings) {
      if (embedding.name == wanted) return true;
    }
    return false;
  }
  bool has_default(std::size_t e) const { return embeddings[e].default_value || externs_of(e).default_value; }
};

// ---- Expressions ----

enum class Builtin : std::uint8_t {
  add, subtract, multiply, divide, negate,
  less, less_equal, greater, greater_equal, equal, not_equal, logical_and, logical_or, logical_not,
  to_real,                                               // Int -> Real, the only implicit conversion
  vec2, vec3, point2, point3, color,                     // constructors
  component_0, component_1, component_2,                 // .x .y .z, .r .g .b
  dot, cross, norm, normalize, midpoint, lerp, distance, area_vector,
  sqrt, abs, floor, ceil, sin, cos, tan, atan2, pow, exp, log,
  mean, sum, min, max, count, first, all, any,           // aggregates of lists; min and max also of two numbers
};
/// The language's spelling: "+", "midpoint".
std::string_view spelling(Builtin builtin);

struct Constant { Value value; };
struct ParameterRef { std::size_t index; };
struct LetRef { std::size_t index; };
/// The dart of a left node: at the pattern dart for which the expression is evaluated, at the hooks in lets and requirements.
struct NodeDart { NodeId node; };
/// The dart that a comprehension binds: `level` comprehensions are around that one.
struct Bound { std::size_t level; std::string name; };
/// The dart where a path leads, before the rule is applied. `path` is in normal form and not ε, `from` is no Walk.
struct Walk { ExprPtr from; Word path; };
/// A list of darts: the first one of each ⟨by⟩-orbit, in the depth-first order of ⟨orbit⟩ from the dart `at`. ⟨by⟩ is inside ⟨orbit⟩.
struct Darts { ExprPtr at; OrbitType orbit, by; };
/// The value of an embedding at a dart (before the rule is applied).
struct ValueAt { std::size_t embedding; ExprPtr at; };
/// The list of its values at several darts.
struct Collect { std::size_t embedding; Darts over; };
/// The list of the values of `element`, evaluated at each of the darts as `variable`.
struct ForEach { Bound variable; Darts over; ExprPtr element; };
struct Apply { Builtin function; std::vector<ExprPtr> arguments; };
/// An extern function called: only generated code can.
struct Call { ExternFunctionPtr function; std::vector<ExprPtr> arguments; };
struct Conditional { ExprPtr condition, then_value, else_value; };
/// A variable of an operation (operation.h). Expressions of rules have none of these two.
struct VariableRef { std::size_t index; std::string name; };
/// A dart that a rule call gave: the copy of a right node, made for the hook's dart, or for the pattern dart `at` if that is given.
struct CopyOf { VariableRef result; NodeId node; std::string node_name; ExprPtr at; };

struct Expr {
  ExprType type;
  std::variant<Constant, ParameterRef, LetRef, NodeDart, Bound, Walk, Darts, ValueAt, Collect, ForEach, Apply, Call, Conditional,
               VariableRef, CopyOf>
      value;
  Span span;
};

/// The expressions that it is made of, in the order of writing; those of darts too.
std::vector<ExprPtr> parts(Expr const& expr);

// ---- Rules ----

struct Parameter {
  std::string name;
  Type type = Type::Real;
  std::optional<Value> default_value;
  std::string doc{};   ///< without the unit
  std::string unit{};  ///< "m" of `/// [m] how far up`; empty if none is given
  ExternTypePtr external{};    ///< of Type::Extern
  ExprPtr computed_default{};  ///< a default that calls extern functions; it reads nothing
  Span span{};
  bool dart = false;  ///< of an operation: a Dart, and `type` means nothing

  ExprType value_type() const { return dart ? dart_type : ExprType{type, false, false, external}; }
  bool has_default() const { return default_value || computed_default; }
};

struct Node {
  std::string name;
  std::string doc;
  std::optional<Span> left_span;   ///< its declaration on the left; none for an added node
  std::optional<Span> right_span;  ///< none for a deleted node
  std::optional<std::size_t> hook; ///< its position among the hooks

  bool added() const { return !left_span; }
  bool deleted() const { return !right_span; }
  bool preserved() const { return left_span && right_span; }
  Span span() const { return left_span ? *left_span : *right_span; }
};

struct Arc {
  NodeId source = 0;
  int dimension = 0;
  Word word;  ///< in Γ's normal form, read from source to target
  NodeId target = 0;
  Span span;  ///< where it is written: an arc's step, or the element of a decoration
  /// The same arc of the rule: span apart.
  bool same(Arc const& other) const {
    return source == other.source && dimension == other.dimension && word == other.word && target == other.target;
  }
};

struct Side {
  std::vector<Arc> arcs;  ///< in the order of writing; of `s -d- t` first s to t, then the reverse
};

struct Let {
  std::string name;
  ExprPtr value;
};
/// `require CONDITION;`, evaluated at the hooks before anything changes.
struct Requirement {
  ExprPtr condition;  ///< a Bool
  std::string text;   ///< the condition in the words of the source, on one line: for the message that it does not hold
};
struct Clause {
  NodeId node;
  std::size_t embedding;
  ExprPtr value;
  Span span;
};

struct RuleScheme {
  std::string name;  ///< "cone", "sew[2]"
  std::string doc;
  Span span;         ///< of its name
  std::string module;
  std::optional<Span> import;  ///< of another module's rule that is taken on a modeler of the root: where it is imported
  std::shared_ptr<Modeler const> modeler;
  std::vector<Parameter> parameters;
  std::vector<Node> nodes;       ///< left nodes in order of declaration, then added ones
  std::vector<NodeId> hooks;     ///< in order of declaration; empty iff the left side is empty
  std::vector<Letter> hook_type; ///< o1 … ok of the first hook's type ⟨o1,…,ok⟩
  Side left, right;
  std::vector<Requirement> requirements;
  std::vector<Let> lets;  ///< evaluated once, at the hooks
  std::vector<Clause> clauses;
  std::vector<Expectation> expectations{};  ///< what the rule says of the cells afterwards; proved, not tested

  Model const& model() const { return modeler->model; }
  /// ⟨o1,…,ok⟩: the darts of the first hook's orbit of this type are the pattern.
  OrbitType hook_orbit() const;
};

/// Does the requirement depend on where the rule is applied: does it, or a `let` that it names, start at a left node?
bool depends_on_place(RuleScheme const& rule, Requirement const& requirement);

/// An index of one side: the arcs that leave and enter each node by dimension. Holds pointers into the side, which must
/// outlive it and not grow.
class Table {
 public:
  Table(std::size_t node_count, Side const& side);
  /// The first d-arc that leaves (enters) the node; null if none.
  Arc const* out(NodeId node, int dimension) const;
  Arc const* in(NodeId node, int dimension) const;
  /// All of them.
  std::vector<Arc const*> const& all_out(NodeId node, int dimension) const { return out_[slot(node, dimension)]; }
  std::vector<Arc const*> const& all_in(NodeId node, int dimension) const { return in_[slot(node, dimension)]; }

 private:
  std::size_t slot(NodeId node, int dimension) const {
    return node * static_cast<std::size_t>(max_dimension + 1) + static_cast<std::size_t>(dimension);
  }
  std::vector<std::vector<Arc const*>> out_, in_;
};

/// The arc of `side` with the same ends, dimension and word; null if none.
Arc const* find_same(Side const& side, Arc const& arc);

/// How messages call a map of the model: "2-G-map", "3-O-map", "map of the model `m`".
std::string map_name(Model const& model);

/// The textual form, for `jrule emit ir`.
std::string print(RuleScheme const& rule);
std::string print(Modeler const& modeler);
std::string print_parameter(Parameter const& parameter);  ///< its line
std::string print(Expr const& expr, RuleScheme const& rule);

/// What the stages rely on and sema guarantees: ids in range, words in normal form over the model's letters, nodes on the
/// sides of their arcs, one hook for each component of the left, typed expressions. None if all holds; else what does not,
/// which is a fault of the compiler.
std::optional<std::string> verify(RuleScheme const& rule);

}  // namespace jrule::ir
