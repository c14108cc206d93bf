// Any bytes as a documented module: its page is XML.
#include <cstddef>
#include <cstdint>
#include <pugixml.hpp>

#include "compiler/backend/docs/page.h"
#include "tests/fuzz/claim.h"
#include "tests/fuzz/front_end.h"

namespace jrule::fuzz {

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
  Checked checked;
  check({reinterpret_cast<char const*>(data), size}, checked);
  if (checked.diagnostics.has_errors()) return 0;
  docs::Module const module = docs::describe(checked.sources, checked.modules, checked.program, checked.verdicts);
  std::string const page = docs::page(module, checked.program, checked.verdicts, {{"fuzz.jrule", "fuzz.html"}});
  pugi::xml_document document;
  auto const parsed = document.load_string(page.c_str());
  claim(static_cast<bool>(parsed), std::string("a page is XML: ") + parsed.description() + "\n" + page);
  return 0;
}

}  // namespace jrule::fuzz
