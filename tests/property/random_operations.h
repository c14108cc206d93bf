// Random operations over a few rules for surfaces, as source text.
#pragma once

#include <cstddef>
#include <string>

#include "tests/property/random.h"

namespace jrule::property {

/// A file with the modeler `S` and `count` operations `f0`, `f1`, … (d: Dart, n: Int) on S -> Int. They end: loops have bounds,
/// and each calls only those before it. Many of them fail, at the beginning, in the middle, inside and outside of `try`s.
std::string random_operations(std::size_t count, Random& random);

}  // namespace jrule::property
