#include "compiler/driver/reference.h"

#include <charconv>

namespace jrule::driver {

std::optional<RuleReference> parse_reference(std::string const& text) {
  std::size_t const colon = text.rfind(':');
  if (colon == std::string::npos || colon == 0 || colon + 1 == text.size()) return {};
  RuleReference reference{text.substr(0, colon), text.substr(colon + 1), {}};
  std::size_t const bracket = reference.rule.find('[');
  if (bracket == std::string::npos) return reference;
  if (!reference.rule.ends_with(']')) return {};
  std::string_view rest = std::string_view(reference.rule).substr(bracket + 1);
  while (!rest.empty()) {
    int d = 0;
    auto const [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), d);
    if (error != std::errc{} || (*end != ',' && *end != ']')) return {};
    reference.dimensions.push_back(d);
    rest.remove_prefix(static_cast<std::size_t>(end - rest.data()) + 1);
  }
  reference.rule.resize(bracket);
  return reference;
}

}  // namespace jrule::driver
