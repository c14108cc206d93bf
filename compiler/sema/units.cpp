#include "compiler/sema/units.h"

#include <algorithm>

namespace jrule::sema {

Documented split_unit(std::string const& doc) {
  std::size_t const end = doc.find(']');
  if (!doc.starts_with('[') || end == std::string::npos || doc.substr(end + 1).starts_with('(')) return {"", doc};
  std::string unit = doc.substr(1, end - 1);
  // A backslash could join the lines of a generated comment.
  if (unit.empty() || unit.front() == ' ' || unit.back() == ' ' || unit.find_first_of(",\\\t\n") != std::string::npos) return {"", doc};
  return {std::move(unit), doc.substr(std::min(doc.find_first_not_of(" \t\n", end + 1), doc.size()))};
}

}  // namespace jrule::sema
