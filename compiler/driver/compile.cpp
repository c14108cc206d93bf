#include "compiler/driver/compile.h"

#include <cstdlib>
#include <stdexcept>

#include "compiler/sema/imports.h"

namespace jrule::driver {

sema::SearchPath search_path(Common const& common) {
  char const* const chosen = std::getenv("JRULE_STDLIB");
  return {chosen ? chosen : JRULE_STDLIB, common.import_dirs};
}

analysis::Verdict judge(ir::RuleScheme const& rule, source::Diagnostics& diagnostics, CounterexampleFiles* files) {
  if (auto const fault = ir::verify(rule)) throw std::logic_error("rule " + rule.name + ": " + *fault);
  analysis::Verdict verdict = analysis::analyze(rule);
  refute(rule, verdict, files);
  auto const tell = [&](source::Diagnostic const& found) {
    diagnostics.add(rule.import ? sema::told_at_import(found, *rule.import, rule.name, rule.module, rule.modeler->name) : found);
  };
  for (analysis::Refusal const& refusal : verdict.refusals) tell(refusal.diagnostic);
  for (source::Diagnostic const& warning : verdict.warnings) tell(warning);
  return verdict;
}

std::unique_ptr<Compilation> compile(std::string const& path, Common const& common, CounterexampleFiles* files) {
  auto compilation = std::make_unique<Compilation>();
  compilation->modules = sema::load(path, search_path(common), compilation->sources, compilation->diagnostics);
  compilation->program = sema::elaborate(compilation->modules, compilation->diagnostics);
  for (ir::RuleScheme const& rule : compilation->program.rules) {
    compilation->verdicts.push_back(judge(rule, compilation->diagnostics, files));
  }
  if (common.warnings_are_errors) compilation->diagnostics.make_errors_of_warnings();
  return compilation;
}

}  // namespace jrule::driver
