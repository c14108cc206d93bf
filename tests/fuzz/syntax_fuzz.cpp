// Any bytes as a .jrule file: what parses has one layout, which means the same.
#include <cstddef>
#include <cstdint>

#include "compiler/syntax/format.h"
#include "compiler/syntax/parse.h"
#include "tests/fuzz/claim.h"
#include "tests/fuzz/front_end.h"

namespace jrule::fuzz {

namespace {

ast::File parse(std::string const& text, source::Sources& sources, source::Diagnostics& diagnostics) {
  return syntax::parse(sources, sources.add("fuzz.jrule", text), diagnostics);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
  std::string const text(reinterpret_cast<char const*>(data), size);
  source::Sources sources;
  source::Diagnostics diagnostics;
  ast::File const file = parse(text, sources, diagnostics);
  claim_rendered(sources, diagnostics);
  std::string const tree = syntax::dump(file);
  if (diagnostics.has_errors()) return 0;

  std::string const laid_out = syntax::format(text);
  ast::File const again = parse(laid_out, sources, diagnostics);
  claim(!diagnostics.has_errors(), "what is laid out parses:\n" + laid_out);
  claim(syntax::dump(again) == tree, "what is laid out means the same:\n" + laid_out);
  claim(syntax::format(laid_out) == laid_out, "what is laid out stays:\n" + laid_out);
  return 0;
}

}  // namespace jrule::fuzz
