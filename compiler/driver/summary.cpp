#include "compiler/driver/summary.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>

namespace jrule::driver {

namespace {

std::string grouped(std::size_t number) {
  std::string digits = std::to_string(number);
  for (std::size_t at = digits.size(); at > 3; at -= 3) digits.insert(at - 3, " ");
  return digits;
}

struct Noun { char const* one; char const* many; };
constexpr std::array<Noun, 4> cell_nouns{{{"vertex", "vertices"}, {"edge", "edges"}, {"face", "faces"}, {"volume", "volumes"}}};

}  // namespace

std::string summary_text(Summary const& s) {
  std::string text;
  for (std::size_t i = 0; i < s.cells.size(); ++i) {
    std::string const noun = i < cell_nouns.size() ? (s.cells[i] == 1 ? cell_nouns[i].one : cell_nouns[i].many)
                                                   : fmt::format("{}-cell{}", i, s.cells[i] == 1 ? "" : "s");
    text += fmt::format("{} {}, ", grouped(s.cells[i]), noun);
  }
  text += fmt::format("{} dart{}, {}\n", grouped(s.darts), s.darts == 1 ? "" : "s", s.valid ? "valid" : "not valid");
  text += fmt::format("{} of dimension {}, {} component{}, Euler characteristic {}, {}, ", s.model, s.dimension, grouped(s.components),
                      s.components == 1 ? "" : "s", s.euler, s.orientable ? "orientable" : "not orientable");
  text += s.boundary_darts == 0 ? "without boundary\n" : fmt::format("{} boundary darts\n", grouped(s.boundary_darts));
  return text;
}

std::string summary_json(Summary const& s) {
  return fmt::format(
      R"({{"model":"{}","dimension":{},"darts":{},"cells":[{}],"components":{},"euler":{},"orientable":{},"boundary_darts":{},"valid":{}}})", s.model,
      s.dimension, s.darts, fmt::join(s.cells, ","), s.components, s.euler, s.orientable, s.boundary_darts, s.valid);
}

}  // namespace jrule::driver
