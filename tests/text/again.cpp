#include "tests/text/again.h"

#include "compiler/sema/elaborate.h"
#include "compiler/syntax/parse.h"

namespace jrule::tests {

Again elaborate_again(std::string const& text, std::string const& module) {
  source::Sources sources;
  source::Diagnostics diagnostics;
  sema::Modules modules;
  modules.all.push_back({module, syntax::parse(sources, sources.add(module + ".jrule", text), diagnostics)});
  Again again{sema::elaborate(modules, diagnostics), {}};
  for (source::Diagnostic const& d : diagnostics.sorted()) {
    if (source::severity(d) == source::Severity::error) again.errors += source::render_human(sources, d);
  }
  return again;
}

}  // namespace jrule::tests
