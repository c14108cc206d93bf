// Rules of the library, applied by the interpreter.
#pragma once

#include <optional>

#include "tests/integration/both.h"

namespace jrule::test {

/// The value of each parameter if none is given.
std::vector<Value> defaults(ir::RuleScheme const& rule);

/// Applies the rule once, at these darts, and fails the test where it is not applicable. The map has to be valid
/// afterwards. Without arguments the parameters have their defaults.
std::vector<std::vector<Dart>> apply(Module::Rule const& rule, Map& map, std::vector<Dart> const& hooks,
                                     std::vector<Value> const& arguments = {});
/// Why it is not applicable there; empty if it is. The map has to stay as it was.
std::string refusal(Module::Rule const& rule, Map const& map, std::vector<Dart> const& hooks,
                    std::vector<Value> const& arguments = {});

/// The rules of std.basic stand for one in each dimension: that of these dimensions, on gmap(n). None if there is none, or if it
/// is refused.
std::optional<Module::Rule> find_instance(std::string const& family, std::vector<int> const& dimensions, int n);
/// The same, and fails the test if there is none.
Module::Rule instance(std::string const& family, std::vector<int> const& dimensions, int n);

}  // namespace jrule::test
