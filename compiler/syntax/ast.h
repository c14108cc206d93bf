// The abstract syntax of a .jrule file: what the user wrote, with its place, and nothing decided yet.
// Plain values; expressions are shared immutable trees.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "compiler/source/source.h"

namespace jrule::ast {

using source::Span;

struct Name {
  std::string text;
  Span span;
};

// ---- Dimensions, words, orbit types ----

/// A sum of integers and dimension parameters: `i`, `2`, `i-2`, `n+1`.
struct DimensionTerm {
  bool negative = false;
  std::variant<std::int64_t, std::string> value;  ///< a number or a parameter's name
  Span span;
};
struct Dimension {
  std::vector<DimensionTerm> terms;  ///< at least one
  Span span;
};

/// `2`, `~1`.
struct Letter {
  bool conjugate = false;
  Dimension dimension;
  Span span;
};
/// `[2,~1]`; no letters is ε.
struct Word {
  std::vector<Letter> letters;
  Span span;
};

/// One position of an orbit type or of a node's decoration.
struct Removed { };                             ///< `_`
struct Range { Dimension first, last; };        ///< `0..i-2`
struct OrbitElement {
  std::variant<Removed, Letter, Range, Word> value;
  Span span;
};
/// `<0,1>`, `<>`.
struct ElementList {
  std::vector<OrbitElement> elements;
  Span span;
};
/// `vertex`, `edge`, `face`, `volume`, `connected`, `cell(i)`.
struct CellName {
  enum class Kind { vertex, edge, face, volume, connected, cell } kind;
  std::optional<Dimension> dimension;  ///< of `cell(i)`
  Span span;
};
struct OrbitType {
  std::variant<ElementList, CellName> value;
  Span span;
};

// ---- Expressions ----

struct Expr;
using ExprPtr = std::shared_ptr<Expr const>;

struct BoolLiteral { bool value; };
struct IntLiteral { std::int64_t value; };
struct RealLiteral { double value; std::string text; };
struct StringLiteral { std::string value; };
/// A parameter, a `let`, a node or a function-less constant such as `pi`.
struct NameExpr { std::string name; };
enum class UnaryOp { negate, logical_not };
struct Unary { UnaryOp op; ExprPtr operand; };
enum class BinaryOp { add, subtract, multiply, divide, less, less_equal, greater, greater_equal, equal, not_equal, logical_and, logical_or };
struct Binary { BinaryOp op; Span op_span; ExprPtr left, right; };
struct Conditional { ExprPtr condition, then_value, else_value; };
/// `base.name`
struct Member { ExprPtr base; Name name; };
/// `base@0`, `base@[0,1]`
struct Walk { ExprPtr base; Word word; };
/// `base[d]` (results of rule calls, section 7)
struct Index { ExprPtr base, index; };
/// `<0,1>(a)`, `face(a) by <0>`
struct OrbitOf { OrbitType type; ExprPtr dart; std::optional<OrbitType> by; };
/// `f(x, name: y)`, `sew[2](a, b)`
struct Argument { std::optional<Name> name; ExprPtr value; };
struct Call { Name function; std::vector<Dimension> dimensions; std::vector<Argument> arguments; };
/// `mean(E for f in <1,2>(a) by <1>)`
struct Comprehension { Name aggregate; ExprPtr element; Name variable; ExprPtr orbit; };

struct Expr {
  std::variant<BoolLiteral, IntLiteral, RealLiteral, StringLiteral, NameExpr, Unary, Binary, Conditional, Member, Walk, Index,
               OrbitOf, Call, Comprehension>
      value;
  Span span;
};

// ---- Items ----

/// `Point3`, `Real`; `[Point3]` is a list.
struct TypeName {
  Name name;
  bool list = false;
};

struct Parameter {
  Name name;
  TypeName type;
  ExprPtr default_value;  ///< null if none
  std::string doc{};
};

struct Import {
  std::vector<Name> path;  ///< `std.surface` is two names
  Span span;
};

/// `exchange (i, j) where COND;` or `exchange (0,2), (1,3);`
struct ExchangeWhere { Name i, j; ExprPtr condition; };
struct ExchangePairs { std::vector<std::pair<Dimension, Dimension>> pairs; };
struct Exchange {
  std::variant<ExchangeWhere, ExchangePairs> value;
  Span span;
};
struct Model {
  std::string doc;
  Name name;
  std::optional<Name> parameter;            ///< the n of `model m(n)`
  std::vector<OrbitElement> dimensions;     ///< letters without `~`, and ranges
  std::vector<OrbitElement> oriented;
  std::vector<Exchange> exchanges;
  std::optional<Span> closed;
  Span span;
};

struct EmbeddingDecl {
  std::string doc;
  Name name;
  OrbitType orbit;
  TypeName type;
  ExprPtr default_value;            ///< null if none
  std::optional<Name> merge;
  Span span;
};
/// `gmap(2)`, `Surface`
struct ModelRef {
  Name name;
  std::optional<Dimension> dimension;
  Span span;
};
struct Modeler {
  std::string doc;
  Name name;
  ModelRef model;
  std::vector<EmbeddingDecl> embeddings;
  Span span;
};

/// `position = EXPR;` on a right-side node.
struct Clause { Name embedding; ExprPtr value; Span span; };
struct Node {
  std::string doc;
  bool hook = false;
  Name name;
  std::optional<ElementList> decoration;
  std::vector<Clause> clauses;
  Span span;
};
/// One step of a chain: `-d[w]-` or `-d[w]->`, or `<-d[w]-` (reversed).
struct ArcStep {
  enum class Direction { both, forward, backward } direction;
  Dimension dimension;
  std::optional<Word> word;
  Span span;
};
/// `a -0- b -1- c;`: nodes.size() == steps.size() + 1
struct ArcChain { std::vector<Name> nodes; std::vector<ArcStep> steps; Span span; };
struct Let { Name name; ExprPtr value; Span span; };
struct Require {
  ExprPtr condition;
  std::string text;  ///< the condition as written, a space for each gap between tokens
  Span span;
};
using SideItem = std::variant<Node, ArcChain, Let, Require>;
struct Side {
  std::vector<SideItem> items;
  Span span;  ///< with its braces
};
/// `expect V' = V + E + F;`
struct Expectation {
  Name count;  ///< without the prime
  ExprPtr value;
  Span span;
};
struct Rule {
  std::string doc;
  Name name;
  std::vector<Name> dimension_parameters;
  std::vector<Parameter> parameters;
  ModelRef on;
  Side left, right;
  std::vector<Expectation> expectations;
  Span span;
};

struct ExternType { std::string doc; Name name; std::string header, cpp_name; Span header_span, cpp_name_span, span; };
struct ExternFunction {
  std::string doc;
  Name name;
  std::vector<Parameter> parameters;
  TypeName result;
  std::string header, cpp_name;
  Span header_span, cpp_name_span, span;
};

// Operations (language reference, section 7).
struct Statement;
using Block = std::vector<Statement>;
struct ForOrbit { Name variable; ExprPtr orbit; std::shared_ptr<Block const> body; };
struct While { ExprPtr condition; std::shared_ptr<Block const> body; };
struct If { ExprPtr condition; std::shared_ptr<Block const> then_block, else_block; };  ///< else_block may be null
struct Try { std::shared_ptr<Block const> body, otherwise; };
struct Assign { ExprPtr target, value; };
struct Return { ExprPtr value; };  ///< may be null
struct Fail { std::string message; };
struct ApplyAll { Call call; ExprPtr orbit; };
struct ExprStatement { ExprPtr value; };
struct Statement {
  std::variant<Let, Assign, If, ForOrbit, While, Return, Fail, Try, ApplyAll, ExprStatement> value;
  Span span;
};
struct Operation {
  std::string doc;
  Name name;
  std::vector<Parameter> parameters;
  ModelRef on;
  std::optional<TypeName> result;
  Block body;
  Span span;
};

using Item = std::variant<Import, Model, Modeler, Rule, Operation, ExternType, ExternFunction>;

struct File {
  source::FileId file = source::no_file;
  std::vector<Item> items;
};

}  // namespace jrule::ast
