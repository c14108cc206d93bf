// The new values of all orbits of a pattern, on several threads: numbered as one thread numbers them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "jrule/orbit_walk.h"
#include "jrule/parallel.h"
#include "jrule/typed.h"

namespace jrule::rewrite {

/// Adds value(k) for each k in [0, n), whose handle is handles[k]. May throw what value() throws, std::bad_alloc and
/// std::length_error. value() reads the embedding as it is before; it is called by several threads.
template <class Index_ = std::size_t, class T, class ValueAt>
void add_value_of_each(NewValues<T>& values, Handle* handles, std::size_t n, Threads threads, ValueAt const& value) {
  Handle const base = values.extend(n, threads);
  parallel::for_each<Index_>(n, threads, [&](Index_ k) {
    handles[k] = base + static_cast<Handle>(k);
    values.set(handles[k], value(k));
  });
}

namespace detail {

/// On one thread: an orbit is met first at its smallest index.
template <class Index_, class T, class Orbits, class ValueAt>
void add_values_in_turn(NewValues<T>& values, Orbits const& orbits, Handle* handles, std::size_t n, ValueAt const& value) {
  std::fill(handles, handles + n, unset);
  for (std::size_t k = 0; k < n; ++k) {
    if (handles[k] == unset) orbits.fill(handles, static_cast<Index>(k), values.add(value(static_cast<Index_>(k))));
  }
}

/// The smallest indices of the orbits, by ranges of the pattern: those of one range are in `list` from where the range begins.
struct Firsts {
  std::size_t range;                ///< indices of each, but the last
  std::vector<std::size_t> before;  ///< by range: how many are in those before it; at the end, how many there are
  Index* list;
};

/// False if an orbit is too long to say: is_first(). Leaves the column of handles unset.
template <class Orbits>
bool find_firsts(Orbits const& orbits, Handle* handles, std::size_t n, Threads threads, Firsts& firsts) {
  std::size_t const ranges = (n + firsts.range - 1) / firsts.range;
  firsts.before.assign(ranges + 1, 0);
  bool const all_known = parallel::all_of(ranges, {threads.count, 1}, [&](std::size_t r) {
    std::size_t const begin = r * firsts.range, end = std::min(n, begin + firsts.range);
    std::fill(handles + begin, handles + end, unset);
    // Without branches, and then the few that are left.
    Index* const list = firsts.list + begin;
    std::size_t candidates = 0, count = 0;
    for (std::size_t k = begin; k < end; ++k) {
      list[candidates] = static_cast<Index>(k);
      candidates += orbits.may_be_first(static_cast<Index>(k)) ? 1 : 0;
    }
    for (std::size_t i = 0; i < candidates; ++i) {
      auto const is_first = orbits.is_first(list[i]);
      if (!is_first) return false;
      if (*is_first) list[count++] = list[i];
    }
    firsts.before[r + 1] = count;
    return true;
  });
  for (std::size_t r = 0; r < ranges; ++r) firsts.before[r + 1] += firsts.before[r];
  return all_known;
}

}  // namespace detail

/// Adds value(k) for the smallest index k of each orbit, in their order; handles[i] is that of i's orbit, for each i in [0, n). As
/// above, but what value() throws is the only thing that `handles` do not survive.
template <class Index_ = std::size_t, class T, class Orbits, class ValueAt>
void add_values(NewValues<T>& values, Orbits const& orbits, Handle* handles, std::size_t n, Threads threads, Workspace& workspace,
                ValueAt const& value) {
  if constexpr (requires { orbits.is_first(Index{}); }) {
    detail::Firsts firsts{std::max<std::size_t>(threads.grain, 1), {}, nullptr};
    if (threads.count > 1 && n >= 2 * firsts.range) {
      firsts.list = workspace.column(n);
      if (detail::find_firsts(orbits, handles, n, threads, firsts)) {
        Handle const base = values.extend(firsts.before.back(), threads);
        parallel::for_each(firsts.before.size() - 1, {threads.count, 1}, [&](std::size_t r) {
          Index const* const list = firsts.list + r * firsts.range;
          std::size_t const before = firsts.before[r];
          for (std::size_t i = 0; i < firsts.before[r + 1] - before; ++i) {
            Handle const handle = base + static_cast<Handle>(before + i);
            values.set(handle, value(static_cast<Index_>(list[i])));
            orbits.fill(handles, list[i], handle);
          }
        });
        return;
      }
    }
  }
  // Few darts, or orbits that only marks in their order find.
  detail::add_values_in_turn<Index_>(values, orbits, handles, n, value);
}

}  // namespace jrule::rewrite
