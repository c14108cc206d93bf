// Any bytes as a .jmap: what is read is printed, and that reads as the same.
#include <cstddef>
#include <cstdint>

#include "jrule/io.h"
#include "tests/fuzz/claim.h"

namespace jrule::fuzz {

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
  std::string_view const text(reinterpret_cast<char const*>(data), size);
  auto const map = parse_jmap(text, "fuzz.jmap");
  if (!map) {
    claim(!map.error().message.empty(), "an error has words");
    return 0;
  }
  claim(!find_violation(*map), "what is read is a map");
  (void)summarize(*map);
  std::string const printed = print_jmap(*map);
  auto const again = parse_jmap(printed, "fuzz.jmap");
  claim(again.has_value(), "what is printed reads:\n" + printed);
  claim(print_jmap(*again) == printed, "what is printed stays:\n" + printed);
  return 0;
}

}  // namespace jrule::fuzz
