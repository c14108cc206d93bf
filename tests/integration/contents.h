// All of a map that can be told apart from outside: two maps of equal contents behave alike for ever.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "jrule/map.h"

namespace jrule::test {

struct Contents {
  Dart limit = 0;
  std::vector<std::vector<Dart>> targets, sources;  ///< by dimension and dart, erased ones too
  std::vector<Dart> next;                           ///< the darts that would be added next: all erased ones, then five more
  std::vector<std::vector<Handle>> handles;         ///< by embedding and dart
  /// By embedding and handle, also those that no dart has: the bits of their numbers, and what describes those of Type::Extern.
  std::vector<std::vector<std::array<std::uint64_t, 3>>> values;
  std::vector<std::vector<std::string>> extern_values;
  bool operator==(Contents const&) const = default;
};

/// A value of Type::Extern, which only a test knows, as text: equal for equal values only.
using Describe = std::string (*)(Embedding const& embedding, Handle value);

/// `describe` is needed for a map with embeddings of that type.
Contents contents(Map map, Describe describe = nullptr);

/// Are they equal, but for values that no dart has, and the numbers of those that some have?
bool equal_but_for_handles(Contents const& a, Contents const& b);

}  // namespace jrule::test
