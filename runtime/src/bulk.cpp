#include "jrule/bulk.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace jrule::rewrite {

namespace {

/// Are indices in an ascending P the darts themselves?
bool is_identity(Map const& map, std::vector<Dart> const& pattern) { return pattern.size() == map.dart_limit(); }

std::span<Dart const> arcs(Map const& map, Letter letter) {
  return letter.conjugate ? map.sources(letter.dimension) : map.targets(letter.dimension);
}

}  // namespace

Applications all_applications(Map const& map, OrbitType const& type) {
  OrbitNumbers orbits = number_orbits(map, type);
  Applications all{map.darts(), std::move(orbits.number), std::move(orbits.first)};
  if (is_identity(map, all.pattern)) return all;
  // From darts to indices; both ascend, so nothing is overwritten before it is read.
  for (std::size_t k = 0; k < all.pattern.size(); ++k) {
    Dart const d = all.pattern[k];
    all.number[k] = all.number[d];
    Index& first = all.first[all.number[k]];
    if (first == d) first = static_cast<Index>(k);
  }
  all.number.resize(all.pattern.size());
  return all;
}

Applications applications_within(Map const& map, OrbitType const& type, OrbitType const& within, Dart d) {
  Applications found{orbit(map, within, d), {}, {}};
  std::sort(found.pattern.begin(), found.pattern.end());
  found.number.resize(found.pattern.size(), no_orbit);
  auto const index = [&](Dart at) { return std::lower_bound(found.pattern.begin(), found.pattern.end(), at) - found.pattern.begin(); };
  for (std::size_t k = 0; k < found.pattern.size(); ++k) {
    if (found.number[k] != no_orbit) continue;
    auto const number = static_cast<Index>(found.first.size());
    found.first.push_back(static_cast<Index>(k));
    for (Dart const at : orbit(map, type, found.pattern[k])) found.number[static_cast<std::size_t>(index(at))] = number;
  }
  return found;
}

Applications without(Applications const& all, std::vector<bool> const& refused) {
  Applications kept;
  std::vector<Index> number(all.count());  // the new one of each
  for (std::size_t a = 0; a < all.count(); ++a) {
    number[a] = static_cast<Index>(kept.first.size());
    if (!refused[a]) kept.first.push_back(all.first[a]);
  }
  for (std::size_t k = 0; k < all.pattern.size(); ++k) {
    Index const a = all.number[k];
    if (refused[a]) continue;
    if (all.first[a] == k) kept.first[number[a]] = static_cast<Index>(kept.pattern.size());
    kept.pattern.push_back(all.pattern[k]);
    kept.number.push_back(number[a]);
  }
  return kept;
}

std::vector<Dart> without(Applications const& all, std::vector<bool> const& refused, std::span<Dart const> match) {
  std::vector<Dart> kept;
  for (std::size_t k = 0; k < match.size(); ++k) {
    if (!refused[all.number[k]]) kept.push_back(match[k]);
  }
  return kept;
}

void mark_pattern(Map const& map, std::vector<Dart> const& pattern, Workspace& workspace, Threads threads) {
  workspace.reserve(map.dart_limit());
  if (is_identity(map, pattern)) return;
  workspace.clear_marks();
  parallel::for_each(pattern.size(), threads, [&](std::size_t k) { workspace.mark(pattern[k], static_cast<Index>(k)); });
}

Column bulk_column(Map const& map, std::vector<Dart> const& pattern, Word const& word, Workspace const& workspace, Threads threads) {
  if (!word.empty() && !is_identity(map, pattern)) return column(map, pattern, word, workspace, threads);
  Column result(pattern.size());
  parallel::for_ranges(result.size(), threads, [&](std::size_t begin, std::size_t end) {
    if (word.empty()) return std::iota(result.data() + begin, result.data() + end, static_cast<Index>(begin));
    std::span<Dart const> const first = arcs(map, word.front());
    std::copy(first.data() + begin, first.data() + end, result.data() + begin);
    for (std::size_t i = 1; i < word.size(); ++i) {
      std::span<Dart const> const next = arcs(map, word[i]);
      for (std::size_t k = begin; k < end; ++k) result[k] = next[result[k]];
    }
  });
  return result;
}

void refuse_matched_twice(Applications const& all, std::span<std::span<Dart const> const> matches, Workspace& workspace,
                          std::vector<bool>& refused) {
  // The indices of P, one application after the other: marks are of one application at a time.
  std::vector<Index> begin(all.count() + 1, 0), order(all.pattern.size());
  for (Index const a : all.number) ++begin[a + 1];
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<Index> next(begin.begin(), begin.end() - 1);
  for (std::size_t k = 0; k < all.pattern.size(); ++k) order[next[all.number[k]]++] = static_cast<Index>(k);
  for (std::size_t a = 0; a < all.count(); ++a) {
    if (refused[a]) continue;
    workspace.clear_marks();
    for (std::span<Dart const> const match : matches) {
      for (Index i = begin[a]; i < begin[a + 1]; ++i) {
        if (!workspace.mark(match[order[i]], 0)) refused[a] = true;
      }
    }
  }
}

}  // namespace jrule::rewrite
