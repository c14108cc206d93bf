// The numbers of cells that the comments of the library's rules state, read from them.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "jrule/map.h"

namespace jrule::test {

/// By its letter, how often a number is in a sum: `1` is the constant.
using Sum = std::map<char, long long>;

/// "V + n", "F + n - 1", "C stays": how many more there are afterwards; "V' = v + 2e": how many there are.
struct Stated {
  int cell;  ///< its dimension
  bool total;
  Sum sum;
};
std::vector<Stated> stated_counts(std::string const& comment);

/// What the letters mean where a rule is applied to whole components: the numbers v, e and f of cells there were.
Sum letters_of(Map const& map);
/// What they mean for any other rule: of the cell at its hook, the numbers v, e, f and c of the cells that it meets; n
/// is that of edges.
Sum letters_of(Map const& map, OrbitType const& hook_orbit, Dart hook);

long long value(Sum const& sum, Sum const& letters);

}  // namespace jrule::test
