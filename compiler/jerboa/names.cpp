#include "compiler/jerboa/names.h"

#include <fmt/format.h>

#include <cctype>

#include "compiler/syntax/parse.h"

namespace jrule::jerboa {

namespace {

// The parser knows the reserved words.
bool is_reserved(std::string const& name) {
  source::Sources sources;
  source::Diagnostics diagnostics;
  syntax::parse(sources, sources.add("", fmt::format("modeler {} on gmap(2);", name)), diagnostics);
  return diagnostics.has_errors();
}

std::string identifier(std::string_view wanted) {
  std::string name;
  for (char const c : wanted) {
    bool const allowed = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
    // One sign for each character, however many bytes it has.
    if ((static_cast<unsigned char>(c) & 0xC0U) != 0x80U) name += allowed ? c : '_';
  }
  if (name.empty() || (name[0] >= '0' && name[0] <= '9')) name = "_" + name;
  if (name.find_first_not_of('_') == std::string::npos) name += "1";
  return is_reserved(name) ? name + "_" : name;
}

}  // namespace

std::string Names::take(std::string_view wanted) {
  std::string const first = identifier(wanted);
  std::string name = first;
  for (int i = 2; !taken_.insert(name).second; ++i) name = fmt::format("{}_{}", first, i);
  return name;
}

}  // namespace jrule::jerboa
