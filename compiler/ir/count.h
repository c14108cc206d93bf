// Numbers of cells, as sums over the numbers of cells and darts there were before: what `expect` clauses say.
#pragma once

#include <array>
#include <cstdint>
#include <numeric>
#include <optional>
#include <string>

#include "compiler/source/source.h"
#include "jrule/model.h"

namespace jrule::ir {

/// In lowest terms, `under` > 0. Numerators and denominators are small, at most `limit`: sums and products of two do not overflow.
struct Fraction {
  static constexpr std::int64_t limit = 1'000'000'000;

  std::int64_t over = 0;
  std::int64_t under = 1;

  static constexpr Fraction of(std::int64_t over, std::int64_t under) {
    std::int64_t const divisor = std::gcd(over, under) * (under < 0 ? -1 : 1);
    return {over / divisor, under / divisor};
  }
  bool fits() const { return -limit <= over && over <= limit && under <= limit; }
  bool is_zero() const { return over == 0; }
  bool operator==(Fraction const&) const = default;
  friend Fraction operator+(Fraction a, Fraction b) { return of(a.over * b.under + b.over * a.under, a.under * b.under); }
  friend Fraction operator*(Fraction a, Fraction b) { return of(a.over * b.over, a.under * b.under); }
};

/// constant + cells[0] V + cells[1] E + cells[2] F + cells[3] C + darts D.
struct Count {
  static constexpr std::size_t named_cells = 4;

  Fraction constant{};
  std::array<Fraction, named_cells> cells{};
  Fraction darts{};

  bool fits() const;
  bool is_constant() const;
  bool operator==(Count const&) const = default;
  friend Count operator+(Count const& a, Count const& b);
  friend Count operator*(Fraction factor, Count const& count);
};

/// What a count is called: 'V', 'E', 'F', 'C' are cells of dimension 0 to 3, 'D', of no dimension, are darts. Others have no name: throws
/// std::out_of_range.
char count_name(std::optional<int> cell);
/// "V + 2 * E + D / 2", "0": the language's spelling.
std::string to_string(Count const& count);

/// `expect V' = V + E + F;`
struct Expectation {
  std::optional<int> cell;  ///< the dimension of the cells; none: darts
  Count count;
  source::Span span;
};

}  // namespace jrule::ir
