// Any bytes as rules and operations: each stage takes what the one before it accepts, and a printed program elaborates to the same.
#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "compiler/analysis/certify.h"
#include "compiler/analysis/counterexample/counterexample.h"
#include "compiler/backend/cpp/emit.h"
#include "compiler/backend/draw/draw.h"
#include "compiler/backend/text/print_jrule.h"
#include "tests/fuzz/claim.h"
#include "tests/fuzz/front_end.h"
#include "tests/text/again.h"

namespace jrule::fuzz {

namespace {

/// Maps tried for each refused rule: the search is tested for its length elsewhere.
constexpr std::size_t budget = 50;
/// Rules of more nodes are not drawn: the search for a layout would take most of the time.
constexpr std::size_t drawn_nodes = 4;

void show(ir::RuleScheme const& rule, analysis::Verdict const& verdict) {
  claim(!draw::rule_dot(rule).empty(), "a rule has a graph");
  if (rule.nodes.size() <= drawn_nodes) claim(draw::rule_svg(rule).ends_with("</svg>\n"), "a rule has a picture");
  if (verdict.accepted()) {
    (void)analysis::certify(rule);  // throws where it has no proof
  } else if (auto const example = analysis::find_counterexample(rule, budget)) {
    claim(!find_violation(example->before), "a counterexample begins with a map");
    claim(!draw::graph_svg(rule, *example).empty(), "a counterexample has a picture");
  }
}

void print_again(ir::Program const& program) {
  auto const text = text::print_jrule(program);
  if (!text) return;
  auto const again = tests::elaborate_again(*text, program.module);
  claim(again.errors.empty(), "a printed program elaborates:\n" + again.errors + *text);
  auto const second = text::print_jrule(again.program);
  claim(second.has_value(), "a printed program is printed again:\n" + *text);
  claim(*second == *text, "a printed program is printed alike:\n" + *text + *second);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
  Checked checked;
  check({reinterpret_cast<char const*>(data), size}, checked);
  ir::Program const& program = checked.program;
  std::vector<cpp::Rule> rules;
  for (std::size_t i = 0; i < program.rules.size(); ++i) {
    show(program.rules[i], checked.verdicts[i]);
    rules.push_back({&program.rules[i], &checked.verdicts[i].plan});
  }
  // What is refused means something too; but only whole programs, since what is left of others need not be one.
  bool const clean = !checked.diagnostics.has_errors();
  if (!clean) return 0;
  print_again(program);
  auto const files = cpp::emit(program, rules, checked.sources, {}, checked.diagnostics);
  claim(files.empty() == checked.diagnostics.has_errors(), "C++ is printed, or why it is not");
  return 0;
}

}  // namespace jrule::fuzz
