// Any bytes as a Jerboa modeler: what is imported is a file of the language, with one layout.
#include <cstddef>
#include <cstdint>

#include "compiler/jerboa/read.h"
#include "compiler/jerboa/write.h"
#include "compiler/syntax/format.h"
#include "compiler/syntax/parse.h"
#include "tests/fuzz/claim.h"
#include "tests/fuzz/front_end.h"

namespace jrule::fuzz {

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
  source::Sources sources;
  source::Diagnostics diagnostics;
  source::FileId const file = sources.add("fuzz.jme", {reinterpret_cast<char const*>(data), size});
  auto const modeler = jerboa::read(sources, file, diagnostics);
  claim(modeler.has_value() == !diagnostics.has_errors(), "a modeler is read, or why it is not");
  if (modeler) {
    std::string const written = jerboa::write(*modeler, "fuzz.jme", diagnostics);
    syntax::parse(sources, sources.add("fuzz.jrule", written), diagnostics);
    claim(!diagnostics.has_errors() || written.size() > 1U << 20U, "what is imported parses:\n" + written);
    std::string const laid_out = syntax::format(written);
    claim(syntax::format(laid_out) == laid_out, "what is imported has one layout:\n" + laid_out);
  }
  claim_rendered(sources, diagnostics);
  return 0;
}

}  // namespace jrule::fuzz
