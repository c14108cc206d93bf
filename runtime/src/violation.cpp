// The constraints of a model (paper, Def. 7 to 9) and of embeddings, one pass over the darts for each.
#include <fmt/format.h>

#include "jrule/map.h"

namespace jrule {

namespace {

using Found = std::optional<Violation>;

/// One outgoing and one incoming i-arc at each dart: every target is a live dart, no two darts share one, and the
/// stored sources are the inverse.
Found incident_arcs(Map const& map, int i) {
  auto const found = [&](Dart d, std::string text) {
    return Violation{Violation::Kind::incident_arcs, d, i, -1, std::move(text)};
  };
  std::vector<Dart> incoming(map.dart_limit(), no_dart);
  for (Dart d = 0; d < map.dart_limit(); ++d) {
    if (!map.contains(d)) continue;
    Dart const to = map.target(d, i);
    if (!map.contains(to)) {
      if (to == no_dart) return found(d, fmt::format("dart {}: it has no {}-arc", d, i));
      return found(d, fmt::format("dart {}: its {}-arc leads to dart {}, which is not in the map", d, i, to));
    }
    if (incoming[to] != no_dart) {
      return found(d, fmt::format("dart {}: its {}-arc leads to dart {}, and so does the {}-arc of dart {}", d, i, to,
                                  i, incoming[to]));
    }
    incoming[to] = d;
  }
  if (!map.model().is_oriented(i)) return std::nullopt;
  for (Dart d = 0; d < map.dart_limit(); ++d) {
    if (!map.contains(d) || map.source(d, i) == incoming[d]) continue;
    return found(d, fmt::format("dart {}: the {}-arc of dart {} leads to it, but dart {} is recorded as the source", d,
                                i, incoming[d], map.source(d, i)));
  }
  return std::nullopt;
}

Found non_orientation(Map const& map, int i) {
  for (Dart d = 0; d < map.dart_limit(); ++d) {
    if (!map.contains(d)) continue;
    Dart const to = map.target(d, i);
    Dart const back = map.target(to, i);
    if (back == d) continue;
    return Violation{Violation::Kind::non_orientation, d, i, -1,
                     fmt::format("dart {}: its {}-arc leads to dart {}, whose {}-arc leads to dart {}", d, i, to, i,
                                 back)};
  }
  return std::nullopt;
}

Found cycle(Map const& map, int i, int j) {
  for (Dart d = 0; d < map.dart_limit(); ++d) {
    if (!map.contains(d)) continue;
    Dart const end = map.target(map.target(map.target(map.target(d, i), j), i), j);
    if (end == d) continue;
    return Violation{Violation::Kind::cycle, d, i, j,
                     fmt::format("dart {}: the path {}{}{}{} does not return (it ends at dart {})", d, i, j, i, j,
                                 end)};
  }
  return std::nullopt;
}

Found closedness(Map const& map, int i) {
  for (Dart d = 0; d < map.dart_limit(); ++d) {
    if (!map.contains(d) || map.target(d, i) != d) continue;
    return Violation{Violation::Kind::closed, d, i, -1,
                     fmt::format("dart {}: its {}-arc is a loop, but the model {} is closed", d, i, map.model().name)};
  }
  return std::nullopt;
}

/// A value at every dart, and the same one all over an orbit. Handles may differ where the values are equal.
Found values(Map const& map, Embedding const& embedding) {
  auto const found = [](Dart d, std::string text) {
    return Violation{Violation::Kind::embedding, d, -1, -1, std::move(text)};
  };
  auto const& spec = embedding.spec();
  std::size_t const count = embedding.value_count();
  for (Dart d = 0; d < map.dart_limit(); ++d) {
    if (!map.contains(d)) continue;
    Handle const h = embedding.handle(d);
    if (h == no_handle) return found(d, fmt::format("dart {}: it has no value of `{}`", d, spec.name));
    if (h >= count) {
      return found(d, fmt::format("dart {}: its handle of `{}` is {}, but the number of values is {}", d, spec.name, h,
                                  count));
    }
  }
  OrbitNumbers const orbits = number_orbits(map, spec.orbit);
  for (Dart d = 0; d < map.dart_limit(); ++d) {
    if (!map.contains(d)) continue;
    Dart const first = orbits.first[orbits.number[d]];
    Handle const a = embedding.handle(first);
    Handle const b = embedding.handle(d);
    // Values of a C++ type from outside are not compared: two are two.
    if (a == b || (spec.type != Type::Extern && embedding.value(a) == embedding.value(b))) continue;
    return found(first, fmt::format("darts {} and {} are of one {}-orbit but their values of `{}` differ", first, d,
                                    to_string(spec.orbit), spec.name));
  }
  return std::nullopt;
}

}  // namespace

std::optional<Violation> find_violation(Map const& map) {
  Model const& model = map.model();
  // Each pass may walk arcs because the passes before it found them whole.
  for (int i : model.dimensions) {
    if (Found v = incident_arcs(map, i)) return v;
  }
  for (int i : model.dimensions) {
    if (model.is_oriented(i)) continue;
    if (Found v = non_orientation(map, i)) return v;
  }
  for (auto [i, j] : model.exchange) {
    if (Found v = cycle(map, i, j)) return v;
  }
  if (model.closed) {
    for (int i : model.dimensions) {
      if (Found v = closedness(map, i)) return v;
    }
  }
  for (std::size_t k = 0; k < map.embedding_count(); ++k) {
    if (Found v = values(map, map.embedding(k))) return v;
  }
  return std::nullopt;
}

}  // namespace jrule
