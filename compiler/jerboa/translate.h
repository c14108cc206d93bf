// Expressions of Jerboa's rules -> expressions of jrule.
#pragma once

#include <functional>
#include <map>
#include <string>

#include "compiler/jerboa/value.h"

namespace jrule::jerboa {

/// What code may name, by its names in the .jme file.
struct Scope {
  struct Known {
    std::string name;  ///< in jrule
    Type type = Type::real;
  };
  std::map<std::string, std::string, std::less<>> nodes;  ///< of the left side, to their names in jrule
  std::map<std::string, Known, std::less<>> embeddings;
  std::map<std::string, Known, std::less<>> parameters;
};

/// Where the translation of a code stopped, and why.
struct Untranslated {
  std::size_t begin = 0, end = 0;  ///< bytes of the text
  std::string reason;              ///< to follow "is not translated: "
};

/// The expression for a code that computes a value of that type: variables that are given values, then `return` with an
/// expression, in which there may be
/// - embeddings at nodes, `n0.pos`, `n0@0@1.pos`, `n0->ebd("pos")`, and their lists over orbits, `<0,1>_pos(n0)`;
/// - numbers, parameters, constants, arithmetic, comparison, `c ? a : b`;
/// - `new Vec3(…)`, `Color(…)`, and the functions of vectors and numbers that jrule::jerboa::call knows.
tl::expected<std::string, Untranslated> translate(std::string const& code, Scope const& scope, Type type);

}  // namespace jrule::jerboa
