// Rules from text, for tests of the stages behind sema.
#pragma once

#include <stdexcept>
#include <string>

#include "compiler/analysis/analyze.h"
#include "compiler/sema/elaborate.h"
#include "compiler/syntax/parse.h"

namespace jrule::tests {

/// The rules of a source text; throws with the messages if there are errors before the analysis.
inline ir::Program program_of(std::string const& text) {
  source::Sources sources;
  source::Diagnostics diagnostics;
  sema::Modules modules;
  modules.all.push_back({"test", syntax::parse(sources, sources.add("test.jrule", text), diagnostics)});
  ir::Program program = sema::elaborate(modules, diagnostics);
  std::string messages;
  for (source::Diagnostic const& d : diagnostics.sorted()) messages += source::render_human(sources, d);
  if (diagnostics.has_errors()) throw std::runtime_error(messages);
  return program;
}

/// The code numbers of a verdict's refusals, in order: "J0302 J0321".
inline std::string codes(analysis::Verdict const& verdict) {
  std::string text;
  for (analysis::Refusal const& refusal : verdict.refusals) {
    text += (text.empty() ? "" : " ") + std::string(source::info(refusal.diagnostic.code).number);
  }
  return text;
}

}  // namespace jrule::tests
