// The large rules of data/stars.jrule, as they are and each with a mistake: for the benchmark, and for the test that
// they are what it takes them for.
#pragma once

#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

namespace jrule::bench {

inline std::string stars() {
  std::ifstream in(JRULE_SOURCE_DIR "/tests/bench/data/stars.jrule");
  if (!in) throw std::runtime_error("cannot read tests/bench/data/stars.jrule");
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

/// Both rules with one arc wrong: of a node of the first, the letters of two loops are exchanged; an arc of the second
/// lacks its word.
inline std::string wrong_stars() {
  std::string text = stars();
  for (auto const& [right, wrong] : {std::pair{"c2 <_,3,4,_,_>", "c2 <_,4,3,_,_>"}, {"c2 -3[1]- d2", "c2 -3- d2"}}) {
    std::string const sought = right;
    std::size_t const at = text.find(sought);
    if (at == std::string::npos) throw std::runtime_error("stars.jrule has no " + sought);
    text.replace(at, sought.size(), wrong);
  }
  return text;
}

}  // namespace jrule::bench
