#include "compiler/jerboa/modeler.h"

namespace jrule::jerboa {

Span Snippet::place(std::size_t begin, std::size_t end) const {
  if (offsets.empty()) return {};
  return {file, offsets[begin], offsets[end]};
}

Span Snippet::place() const {
  if (blank()) return place(0, text.size());
  return place(text.find_first_not_of(" \t\r\n\f\v"), text.find_last_not_of(" \t\r\n\f\v") + 1);
}

}  // namespace jrule::jerboa
