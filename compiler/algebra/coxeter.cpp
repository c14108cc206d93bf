#include "compiler/algebra/coxeter.h"

#include <algorithm>
#include <cassert>

namespace jrule::algebra {

using Generator = RightAngledCoxeterGroup::Generator;

void RightAngledCoxeterGroup::commute(Generator a, Generator b) {
  assert(a < max_generators && b < max_generators && a != b);
  commuting_[a] = static_cast<GeneratorSet>(commuting_[a] | singleton(b));
  commuting_[b] = static_cast<GeneratorSet>(commuting_[b] | singleton(a));
}

// A reduced word is in normal form iff it has no factor t·u·s where s < t and s commutes with all of t·u.
//
// Let the tail be the longest suffix of g whose letters all commute with s. If an s stands right before the tail, it
// meets the new one and both vanish; otherwise g·s is longer. If they vanish, the result is in normal form: a forbidden
// factor of it would stay forbidden when the s is put back, for all of the tail commutes with s. If s stays, it goes
// before the first greater letter of the tail, and no factor becomes forbidden: one that ends in this s would begin in
// the tail with a letter greater than s, but there is none before it; one that begins with this s would end in some
// r < s, and be forbidden in g already from the next letter, which is greater than s; one with this s inside would be
// forbidden in g without it.
void RightAngledCoxeterGroup::multiply(Element& g, Generator s) const {
  auto tail = g.end();
  while (tail != g.begin() && commutes(*(tail - 1), s)) --tail;
  if (tail != g.begin() && *(tail - 1) == s) {
    g.erase(tail - 1);
    return;
  }
  g.insert(std::find_if(tail, g.end(), [s](Generator t) { return t > s; }), s);
}

// A reduced word is shortened by conjugation with s iff it is equal to s·v·s, that is iff it has two letters s, one of
// which can move to the front and the other to the back. If no s shortens it, it has least length among its conjugates.
std::vector<Generator> RightAngledCoxeterGroup::cyclically_reduced(Element g) const {
  auto const shorten = [&] {
    for (std::size_t first = 0; first < g.size(); ++first) {
      Generator const s = g[first];
      auto const passes = [&](Generator t) { return commutes(t, s); };
      auto const front = g.begin() + static_cast<std::ptrdiff_t>(first);
      auto const back = std::find(g.rbegin(), g.rend(), s).base() - 1;
      if (front != back && std::all_of(g.begin(), front, passes) && std::all_of(back + 1, g.end(), passes)) {
        g.erase(back);
        g.erase(front);
        return true;
      }
    }
    return false;
  };
  while (shorten()) {
  }
  return g;
}

RightAngledCoxeterGroup::GeneratorSet RightAngledCoxeterGroup::support(Element const& g) {
  GeneratorSet set = 0;
  for (Generator const s : g) set = static_cast<GeneratorSet>(set | singleton(s));
  return set;
}

}  // namespace jrule::algebra
