#include "compiler/ir/count.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

namespace jrule::ir {

bool Count::fits() const {
  return constant.fits() && darts.fits() && std::all_of(cells.begin(), cells.end(), [](Fraction f) { return f.fits(); });
}

bool Count::is_constant() const {
  return darts.is_zero() && std::all_of(cells.begin(), cells.end(), [](Fraction f) { return f.is_zero(); });
}

Count operator+(Count const& a, Count const& b) {
  Count sum{a.constant + b.constant, {}, a.darts + b.darts};
  for (std::size_t i = 0; i < Count::named_cells; ++i) sum.cells[i] = a.cells[i] + b.cells[i];
  return sum;
}

Count operator*(Fraction factor, Count const& count) {
  Count product{factor * count.constant, {}, factor * count.darts};
  for (std::size_t i = 0; i < Count::named_cells; ++i) product.cells[i] = factor * count.cells[i];
  return product;
}

char count_name(std::optional<int> cell) {
  constexpr std::array<char, Count::named_cells> names{'V', 'E', 'F', 'C'};
  return cell ? names.at(static_cast<std::size_t>(*cell)) : 'D';
}

std::string to_string(Count const& count) {
  std::string text;
  auto const add = [&](Fraction factor, std::string const& what) {
    if (factor.is_zero()) return;
    text += text.empty() ? (factor.over < 0 ? "-" : "") : (factor.over < 0 ? " - " : " + ");
    std::int64_t const over = std::abs(factor.over);
    if (what.empty()) {
      text += std::to_string(over);
    } else {
      text += over == 1 ? what : fmt::format("{} * {}", over, what);
    }
    if (factor.under != 1) text += fmt::format(" / {}", factor.under);
  };
  for (std::size_t i = 0; i < Count::named_cells; ++i) add(count.cells[i], {count_name(static_cast<int>(i))});
  add(count.darts, "D");
  add(count.constant, "");
  return text.empty() ? "0" : text;
}

}  // namespace jrule::ir
