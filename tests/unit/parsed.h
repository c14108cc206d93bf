// A text parsed on its own, with its diagnostics as lines of text.
#pragma once

#include <string>
#include <vector>

#include "compiler/syntax/parse.h"

namespace jrule::tests {

using Lines = std::vector<std::string>;

struct Parsed {
  source::Sources sources;
  source::Diagnostics diagnostics;
  ast::File file;
};

inline Parsed parse(std::string text) {
  Parsed result;
  auto const id = result.sources.add("test.jrule", std::move(text));
  result.file = syntax::parse(result.sources, id, result.diagnostics);
  return result;
}

/// "2:5 J0101 expected …", one for each diagnostic, in order of place.
inline Lines errors(Parsed const& parsed) {
  Lines lines;
  for (auto const& diagnostic : parsed.diagnostics.sorted()) {
    auto const at = parsed.sources.position(diagnostic.span.file, diagnostic.span.begin);
    lines.push_back(std::to_string(at.line) + ":" + std::to_string(at.column) + " " +
                    std::string(source::info(diagnostic.code).number) + " " + diagnostic.message);
  }
  return lines;
}

inline Lines errors_of(std::string text) { return errors(parse(std::move(text))); }

/// A small generator whose numbers are the same everywhere.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  std::size_t below(std::size_t bound) {
    state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
    return static_cast<std::size_t>(state_ >> 33U) % bound;
  }

 private:
  std::uint64_t state_;
};

}  // namespace jrule::tests
