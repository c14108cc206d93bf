#include "compiler/driver/selection.h"

#include <fmt/format.h>

#include <charconv>

namespace jrule::driver {

namespace {

Result<Dart> select_one(Selectable const& map, std::string_view part) {
  std::size_t const colon = part.find(':');
  std::string_view const what = part.substr(0, colon);
  std::string_view const number = colon == std::string_view::npos ? std::string_view{} : part.substr(colon + 1);
  std::uint32_t n = 0;
  auto const [end, error] = std::from_chars(number.data(), number.data() + number.size(), n);
  bool const is_number = error == std::errc{} && end == number.data() + number.size() && !number.empty();
  static constexpr std::string_view cells[] = {"vertex", "edge", "face", "volume"};
  std::optional<int> dimension;
  for (int i = 0; i < 4; ++i) {
    if (cells[i] == what) dimension = i;
  }
  if (!is_number || (what != "dart" && !dimension)) {
    return fail(Error::Kind::bad_input,
                fmt::format("`{}` selects nothing: write `all`, `dart:N`, `vertex:N`, `edge:N`, `face:N` or `volume:N`", part));
  }
  if (!dimension) {
    if (!map.contains(n)) return fail(Error::Kind::bad_input, fmt::format("there is no dart {}: the map has {} darts", n, map.dart_count));
    return n;
  }
  auto const first = map.cells(*dimension);
  if (!first) return fail(Error::Kind::bad_input, fmt::format("a map of dimension {} has no {}-cells", map.dimension, *dimension));
  if (n >= first->size()) {
    return fail(Error::Kind::bad_input, fmt::format("there is no {} {}: the map has {} of them, numbered from 0", what, n, first->size()));
  }
  return (*first)[n];
}

}  // namespace

Result<std::vector<Dart>> select(Selectable const& map, std::string const& selection) {
  std::vector<Dart> darts;
  std::string_view rest = selection;
  while (true) {
    std::size_t const comma = rest.find(',');
    auto const dart = select_one(map, rest.substr(0, comma));
    if (!dart) return tl::unexpected(dart.error());
    darts.push_back(*dart);
    if (comma == std::string_view::npos) return darts;
    rest.remove_prefix(comma + 1);
  }
}

Result<std::vector<Dart>> select(Map const& map, std::string const& selection) {
  auto const contains = [&](Dart d) { return map.contains(d); };
  auto const numbered = [&](int dimension) -> std::optional<std::vector<Dart>> {
    if (!cell_orbit(map.model(), dimension)) return {};
    return cells(map, dimension);
  };
  return select(Selectable{map.model().dimension, map.dart_count(), contains, numbered}, selection);
}

}  // namespace jrule::driver
