// A rule at many orbits of its hook at once: what the applications of an independent rule have in common, done in one pass.
//
// Notation of rewrite.h, for all applications together: P is the union of their patterns, the darts ascending, so that every
// column is one loop over P. Where no dart of the map is erased and all orbits take part, indices are the darts themselves, and the
// column of one letter is the map's own array.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "jrule/rewrite.h"

namespace jrule::rewrite {

struct Applications {
  std::vector<Dart> pattern;  ///< P, ascending
  Column number;              ///< by index in P: which application it is of; they are numbered by their smallest darts
  std::vector<Index> first;   ///< by application: the index of its smallest dart, the one that its hook is matched to

  std::size_t count() const noexcept { return first.size(); }
};

/// One application for each ⟨type⟩-orbit of the map, `type` being the hook's. O(darts · words).
Applications all_applications(Map const& map, OrbitType const& type);

/// The same for those inside ⟨within⟩(d), of which the hook's type must be a subgroup. O(orbit · (words + log orbit)).
Applications applications_within(Map const& map, OrbitType const& type, OrbitType const& within, Dart d);

/// Those that are not refused (one flag for each), in the same order. O(|P|).
Applications without(Applications const& all, std::vector<bool> const& refused);
/// The match column of what without() keeps, from that of all.
std::vector<Dart> without(Applications const& all, std::vector<bool> const& refused, std::span<Dart const> match);

/// Makes room to mark every dart, and marks those of P with their indices if column() needs it. Throws std::bad_alloc.
void mark_pattern(Map const& map, std::vector<Dart> const& pattern, Workspace& workspace, Threads threads = {});
/// The column of a word under which P is closed, for an ascending P; mark_pattern() must have been called for it, and no marks
/// changed since. O(|P| · |w|).
Column bulk_column(Map const& map, std::vector<Dart> const& pattern, Word const& word, Workspace const& workspace, Threads threads = {});

/// Refuses the applications whose match columns name a dart twice. Two applications may name one dart. Forgets P's marks; there
/// must be room for marks. O(|P| · columns).
void refuse_matched_twice(Applications const& all, std::span<std::span<Dart const> const> matches, Workspace& workspace,
                          std::vector<bool>& refused);

}  // namespace jrule::rewrite
