// Rules and operations as source text: the inverse of parsing and elaborating.
#pragma once

#include <string>

#include <tl/expected.hpp>

#include "compiler/ir/program.h"

namespace jrule::text {

/// Why the language cannot say what is to be printed: one sentence, lower case, no full stop, naming the rule.
struct Unspellable {
  std::string reason;
};
template <class T>
using Spelled = tl::expected<T, Unspellable>;

/// A source file of the program's modelers, the models and the C++ that they need, its rules and operations, in canonical layout. Parsed and
/// elaborated under the name `program.module` it gives the same program again, but for:
/// - spans, of course, and the words of requirements, which become canonical: `pi / 2` is a number;
/// - modelers, extern types and extern functions that the program imports, which the file declares itself, so that it stands
///   alone;
/// - imported rules and operations, which the file declares itself too, `Terrain.quad` as `Terrain_quad`;
/// - a rule that is an instance of a family: `sew[2]` is called `sew_2`, or `sew_2_` where that name is taken;
/// - the order of arcs, where a hook's loops do not come first, and the numbers of nodes, where left nodes do not: text
///   has no other order. Programs that come from text keep both.
///
/// Rules and operations must satisfy ir::verify. Unspellable is what no text elaborates to, and sema never makes:
/// - names that are no names of the language, or that two things of one scope share;
/// - a first hook without the loops of its type, hooks that are not in the order of the nodes, an arc twice on a side;
/// - operations that constants decide, which sema computes; a `let` that is one of these, or before its declaration; paths that
///   are not in normal form; a list of darts, or of a comprehension, where nothing counts or aggregates it; a comprehension
///   whose variable has the name of something around it;
/// - documentation with white space at the end of a line, and whatever exceeds the parser's limits;
/// and, from text too:
/// - a program without modelers and rules, since a file has an item;
/// - different models of one name for which no one declaration is found: families are written as one model with the
///   dimension n if their dimensions are the same, or end with n, or are the same up to n;
/// - an imported modeler, model, extern type or function with the name of another item.
/// Cost: linear in the text, about that of parsing it.
Spelled<std::string> print_jrule(ir::Program const& program);

/// A file of that rule alone.
Spelled<std::string> print_jrule(ir::RuleScheme const& rule);

}  // namespace jrule::text
