// The constraints of a model (paper, Def. 7 to 9) and of embeddings: a quick test whether all hold, and if not, one pass over the
// darts for each, to say which does not.
#include <fmt/format.h>

#include <algorithm>

#include "jrule/map.h"

namespace jrule {

namespace {

using Found = std::optional<Violation>;

// ---- Do all hold? ----

bool is_live(std::span<Dart const> targets, Dart d) noexcept { return d < targets.size() && targets[d] != no_dart; }

/// Dimensions whose arcs are each other's inverse: then each dart has one outgoing and one incoming arc, too.
bool arcs_hold(Map const& map, int i) noexcept {
  std::span<Dart const> const to = map.targets(i), from = map.sources(i), any = map.targets(map.model().dimensions.front());
  for (Dart d = 0; d < to.size(); ++d) {
    if (any[d] == no_dart) continue;
    if (!is_live(any, to[d]) || !is_live(any, from[d]) || from[to[d]] != d || to[from[d]] != d) return false;
  }
  return true;
}

bool exchange_holds(Map const& map, int i, int j) noexcept {
  std::span<Dart const> const a = map.targets(i), b = map.targets(j);
  for (Dart d = 0; d < a.size(); ++d) {
    if (a[d] != no_dart && b[a[b[a[d]]]] != d) return false;
  }
  return true;
}

bool is_closed(Map const& map, int i) noexcept {
  std::span<Dart const> const to = map.targets(i);
  for (Dart d = 0; d < to.size(); ++d) {
    if (to[d] == d) return false;
  }
  return true;
}

/// What is equal at both ends of each step of an orbit is equal all over it.
bool values_hold(Map const& map, Embedding const& embedding) {
  std::span<Dart const> const live = map.targets(map.model().dimensions.front());
  std::span<Handle const> const handles = embedding.handles();
  std::size_t const count = embedding.value_count();
  for (Dart d = 0; d < live.size(); ++d) {
    if (live[d] != no_dart && handles[d] >= count) return false;
  }
  bool const compares = embedding.spec().type != Type::Extern;
  for (Word const& word : embedding.spec().orbit.words) {
    auto const differ = [&](Dart d, Dart to) {
      return handles[d] != handles[to] && !(compares && embedding.value(handles[d]) == embedding.value(handles[to]));
    };
    std::span<Dart const> const step = map.targets(word.front().dimension);
    bool const is_letter = word.size() == 1;  // forwards or backwards: the same pairs
    for (Dart d = 0; d < live.size(); ++d) {
      if (live[d] != no_dart && differ(d, is_letter ? step[d] : map.walk(d, word))) return false;
    }
  }
  return true;
}

/// Each test may walk arcs because those before it found them whole.
bool all_hold(Map const& map) {
  Model const& model = map.model();
  auto const& dimensions = model.dimensions;
  for (int const i : dimensions) {
    if (!arcs_hold(map, i)) return false;
  }
  for (auto const& [i, j] : model.exchange) {
    if (!exchange_holds(map, i, j)) return false;
  }
  if (model.closed && !std::all_of(dimensions.begin(), dimensions.end(), [&](int i) { return is_closed(map, i); })) return false;
  for (std::size_t e = 0; e < map.embedding_count(); ++e) {
    if (!values_hold(map, map.embedding(e))) return false;
  }
  return true;
}

// ---- Which does not, and where? ----

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
  if (all_hold(map)) return std::nullopt;
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
