#include "tests/integration/contents.h"

#include <bit>
#include <tuple>

namespace jrule::test {

namespace {

// -0 is not 0, and a NaN equals itself.
std::array<std::uint64_t, 3> bits(Value const& value) {
  if (auto const* const number = std::get_if<std::int64_t>(&value)) return {std::bit_cast<std::uint64_t>(*number)};
  std::array<std::uint64_t, 3> all{};
  for (int c = 0; c < component_count(type_of(value)); ++c) {
    all[static_cast<std::size_t>(c)] = std::bit_cast<std::uint64_t>(component(value, c));
  }
  return all;
}

}  // namespace

Contents contents(Map map, Describe describe) {
  Contents all;
  all.limit = map.dart_limit();
  for (int const i : map.model().dimensions) {
    auto const targets = map.targets(i), sources = map.sources(i);
    all.targets.emplace_back(targets.begin(), targets.end());
    all.sources.emplace_back(sources.begin(), sources.end());
  }
  for (std::size_t e = 0; e < map.embedding_count(); ++e) {
    Embedding const& embedding = map.embedding(e);
    all.handles.emplace_back(embedding.handles().begin(), embedding.handles().end());
    auto& values = all.values.emplace_back();
    auto& extern_values = all.extern_values.emplace_back();
    for (Handle h = 0; h < embedding.value_count(); ++h) {
      if (embedding.spec().type == Type::Extern) {
        extern_values.push_back(describe(embedding, h));
      } else {
        values.push_back(bits(embedding.value(h)));
      }
    }
  }
  all.next = map.add_darts(map.dart_limit() - map.dart_count() + 5);
  return all;
}

bool equal_but_for_handles(Contents const& a, Contents const& b) {
  auto const darts = [](Contents const& c) { return std::tie(c.limit, c.targets, c.sources, c.next); };
  if (darts(a) != darts(b) || a.handles.size() != b.handles.size()) return false;
  for (std::size_t e = 0; e < a.handles.size(); ++e) {
    for (Dart d = 0; d < a.limit; ++d) {
      Handle const h = a.handles[e][d], g = b.handles[e][d];
      if ((h == no_handle) != (g == no_handle)) return false;
      if (h == no_handle) continue;
      bool const equal = a.values[e].empty() ? a.extern_values[e][h] == b.extern_values[e][g] : a.values[e][h] == b.values[e][g];
      if (!equal) return false;
    }
  }
  return true;
}

}  // namespace jrule::test
