#include "tests/fuzz/front_end.h"

#include "compiler/analysis/operations.h"
#include "compiler/sema/elaborate.h"
#include "compiler/syntax/parse.h"
#include "tests/fuzz/claim.h"

namespace jrule::fuzz {

void claim_rendered(source::Sources const& sources, source::Diagnostics const& diagnostics) {
  for (source::Diagnostic const& d : diagnostics.sorted()) {
    claim(!source::render_human(sources, d).empty(), "a diagnostic has words");
    claim(source::render_json(sources, d).ends_with("}\n"), "a diagnostic is a json object");
  }
}

void check(std::string_view text, Checked& checked) {
  source::FileId const file = checked.sources.add("fuzz.jrule", std::string(text));
  checked.modules.all.push_back({"fuzz", syntax::parse(checked.sources, file, checked.diagnostics)});
  checked.program = sema::elaborate(checked.modules, checked.diagnostics);
  for (ir::RuleScheme const& rule : checked.program.rules) {
    if (auto const fault = ir::verify(rule)) claim(false, "rule " + rule.name + ": " + *fault);
    checked.verdicts.push_back(analysis::analyze(rule));
    for (analysis::Refusal const& refusal : checked.verdicts.back().refusals) checked.diagnostics.add(refusal.diagnostic);
    for (source::Diagnostic const& warning : checked.verdicts.back().warnings) checked.diagnostics.add(warning);
  }
  for (ir::Operation const& operation : checked.program.operations) {
    if (auto const fault = ir::verify(operation, checked.program)) claim(false, "operation " + operation.name + ": " + *fault);
    for (source::Diagnostic const& found : analysis::check_calls(operation, checked.program, checked.verdicts)) checked.diagnostics.add(found);
  }
  claim_rendered(checked.sources, checked.diagnostics);
}

}  // namespace jrule::fuzz
