// The subgroups of Γ that orbits of a rule's copies are described by: each is given by a few words that generate it.
#pragma once

#include <vector>

#include "compiler/algebra/group.h"

namespace jrule::analysis {

/// Words that generate the same subgroup, none longer than the given ones and none of them ε; of a word and its inverse, one. In order.
std::vector<Word> reduced(algebra::Group const& group, std::vector<Word> generators);

/// Is the word in the subgroup? Decided where the generators are letters or the words of a cell; else a search that takes off generators,
/// with a bound, so `false` may mean "not found". O(|generators|) products for each word that is looked at.
bool generates(algebra::Group const& group, std::vector<Word> const& generators, Word const& word);

}  // namespace jrule::analysis
