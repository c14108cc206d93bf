// What a fuzzer claims of every input.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <string>

namespace jrule::fuzz {

/// Ends the program with `what` if it does not hold: libFuzzer then keeps the input, and a replay fails.
inline void claim(bool holds, std::string const& what) {
  if (holds) return;
  std::fprintf(stderr, "does not hold: %s\n", what.c_str());
  std::abort();
}

}  // namespace jrule::fuzz
