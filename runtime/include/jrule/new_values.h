// The new values of all orbits of a pattern, on several threads: numbered as one thread numbers them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
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

/// Those indices in [begin, end) that are the smallest of their orbits, in their order; nothing if an orbit is too long to say. Leaves
/// that range of the column of handles unset. May throw std::bad_alloc.
template <class Orbits>
std::optional<ColumnOf<Index>> firsts_of_range(Orbits const& orbits, Handle* handles, std::size_t begin, std::size_t end) {
  std::fill(handles + begin, handles + end, unset);
  // Without branches, and then the few that are left.
  ColumnOf<Index> list(end - begin);
  std::size_t candidates = 0, count = 0;
  for (std::size_t k = begin; k < end; ++k) {
    list[candidates] = static_cast<Index>(k);
    candidates += orbits.may_be_first(static_cast<Index>(k)) ? 1 : 0;
  }
  for (std::size_t i = 0; i < candidates; ++i) {
    auto const is_first = orbits.is_first(list[i]);
    if (!is_first) return std::nullopt;
    if (*is_first) list[count++] = list[i];
  }
  // As short as it is: of all ranges together, few of the indices are first.
  return ColumnOf<Index>(list.begin(), list.begin() + count);
}

/// The smallest indices of all orbits, by ranges of the pattern.
struct Firsts {
  std::size_t range;                  ///< indices of each, but the last
  std::vector<ColumnOf<Index>> list;  ///< by range
  std::vector<std::size_t> before;    ///< by range: how many are in those before it; at the end, how many there are
};

/// False if an orbit is too long to say.
template <class Orbits>
bool find_firsts(Orbits const& orbits, Handle* handles, std::size_t n, Threads threads, Firsts& firsts) {
  firsts.list.resize((n + firsts.range - 1) / firsts.range);
  bool const all_known = parallel::all_of(firsts.list.size(), {threads.count, 1}, [&](std::size_t r) {
    std::size_t const begin = r * firsts.range;
    auto list = firsts_of_range(orbits, handles, begin, std::min(n, begin + firsts.range));
    if (list) firsts.list[r] = std::move(*list);
    return list.has_value();
  });
  firsts.before = {0};
  for (ColumnOf<Index> const& list : firsts.list) firsts.before.push_back(firsts.before.back() + list.size());
  return all_known;
}

}  // namespace detail

/// Adds value(k) for the smallest index k of each orbit, in their order; handles[i] is that of i's orbit, for each i in [0, n). As
/// above, but what value() throws is the only thing that `handles` do not survive.
template <class Index_ = std::size_t, class T, class Orbits, class ValueAt>
void add_values(NewValues<T>& values, Orbits const& orbits, Handle* handles, std::size_t n, Threads threads,
                ValueAt const& value) {
  if constexpr (requires { orbits.is_first(Index{}); }) {
    detail::Firsts firsts{std::max<std::size_t>(threads.grain, 1), {}, {}};
    if (threads.count > 1 && n >= 2 * firsts.range && detail::find_firsts(orbits, handles, n, threads, firsts)) {
      Handle const base = values.extend(firsts.before.back(), threads);
      parallel::for_each(firsts.list.size(), {threads.count, 1}, [&](std::size_t r) {
        Handle handle = base + static_cast<Handle>(firsts.before[r]);
        for (Index const first : firsts.list[r]) {
          values.set(handle, value(static_cast<Index_>(first)));
          orbits.fill(handles, first, handle++);
        }
      });
      return;
    }
  }
  // Few darts, or orbits that only marks in their order find.
  detail::add_values_in_turn<Index_>(values, orbits, handles, n, value);
}

}  // namespace jrule::rewrite
