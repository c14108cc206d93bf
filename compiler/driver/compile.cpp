#include "compiler/driver/compile.h"

#include <cstdlib>
#include <filesystem>
#include <stdexcept>

#include "compiler/analysis/operations.h"
#include "compiler/sema/imports.h"

namespace jrule::driver {

namespace {

// Where an installed jrule has its library, wherever it was moved to since. Empty in a build tree, and where the system
// does not tell a program its own path.
std::string installed_stdlib() {
  namespace fs = std::filesystem;
  std::error_code error;
  fs::path const self = fs::read_symlink("/proc/self/exe", error);
  if (error) return {};
  fs::path const folder = (self.parent_path() / JRULE_STDLIB_FROM_EXECUTABLE).lexically_normal();
  return fs::is_directory(folder / "std", error) ? folder.string() : std::string();
}

std::string stdlib() {
  if (char const* const chosen = std::getenv("JRULE_STDLIB")) return chosen;
  std::string const installed = installed_stdlib();
  return installed.empty() ? JRULE_STDLIB : installed;
}

}  // namespace

sema::SearchPath search_path(Common const& common) { return {stdlib(), common.import_dirs}; }

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
  for (ir::Operation const& operation : compilation->program.operations) {
    if (auto const fault = ir::verify(operation, compilation->program)) throw std::logic_error("operation " + operation.name + ": " + *fault);
    for (source::Diagnostic const& found : analysis::check_calls(operation, compilation->program, compilation->verdicts)) {
      compilation->diagnostics.add(
          operation.import ? sema::told_at_import(found, *operation.import, operation.name, operation.module, operation.modeler->name) : found);
    }
  }
  if (common.warnings_are_errors) compilation->diagnostics.make_errors_of_warnings();
  return compilation;
}

bool keep_only(RuleReference const& reference, std::optional<int> n, Compilation& compilation) {
  ir::Program& program = compilation.program;
  std::vector<ir::RuleScheme> const rules = std::move(program.rules);
  std::vector<analysis::Verdict> const verdicts = std::move(compilation.verdicts);
  program.rules.clear();
  program.operations.clear();  // they call other rules
  compilation.verdicts.clear();
  for (std::size_t i = 0; i < rules.size() && reference.dimensions.empty(); ++i) {
    if (rules[i].name != reference.rule) continue;
    program.rules.push_back(rules[i]);
    compilation.verdicts.push_back(verdicts[i]);
  }
  if (program.rules.empty()) {
    auto rule = sema::instantiate(compilation.modules, reference.rule, reference.dimensions, n, compilation.diagnostics);
    if (!rule) return false;
    compilation.verdicts.push_back(judge(*rule, compilation.diagnostics));
    program.rules.push_back(std::move(*rule));
  }
  std::erase_if(program.modelers, [&](auto const& modeler) { return modeler->name != program.rules[0].modeler->name; });
  return true;
}

}  // namespace jrule::driver
