// Are two maps the same to the last bit: darts, arcs, handles, and the values in the order in which they lie?
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <optional>
#include <string>

#include "jrule/map.h"

namespace jrule::tests {

inline bool same_bits(Value const& a, Value const& b) {
  if (a.index() != b.index()) return false;
  if (auto const* const integer = std::get_if<std::int64_t>(&a)) return *integer == std::get<std::int64_t>(b);
  for (int c = 0; c < component_count(type_of(a)); ++c) {
    if (std::bit_cast<std::uint64_t>(component(a, c)) != std::bit_cast<std::uint64_t>(component(b, c))) return false;
  }
  return true;
}

/// Where they differ; none if nowhere. Values of types from outside are not compared.
inline std::optional<std::string> difference_in_bits(Map const& a, Map const& b) {
  if (a.dart_limit() != b.dart_limit()) return "the numbers of darts";
  if (a.darts() != b.darts()) return "the erased darts";
  for (int const d : a.model().dimensions) {
    if (!std::ranges::equal(a.targets(d), b.targets(d))) return "the " + std::to_string(d) + "-arcs";
    if (!std::ranges::equal(a.sources(d), b.sources(d))) return "the sources of the " + std::to_string(d) + "-arcs";
  }
  for (std::size_t e = 0; e < a.embedding_count(); ++e) {
    Embedding const &one = a.embedding(e), &other = b.embedding(e);
    if (!std::ranges::equal(one.handles(), other.handles())) return "the handles of " + one.spec().name;
    if (one.value_count() != other.value_count()) return "how many values " + one.spec().name + " has";
    if (one.spec().type == Type::Extern) continue;
    for (Handle h = 0; h < one.value_count(); ++h) {
      if (!same_bits(one.value(h), other.value(h))) return "the values of " + one.spec().name;
    }
  }
  return {};
}

/// What is compared with one thread: several, and ranges so short that there are some of each small map.
inline constexpr Threads several[] = {{2, 5}, {3, 2}, {8, 1}};

}  // namespace jrule::tests
