#include "compiler/backend/cpp/dart_tests.h"

#include <algorithm>

#include "compiler/ir/extern_use.h"

namespace jrule::cpp {

namespace {

using ir::Builtin;

// ⟨a⟩ and ⟨b⟩ by the words that are written; the same group may be written otherwise, and then the answer is no.
bool contains(OrbitType const& a, OrbitType const& b) {
  return std::all_of(b.words.begin(), b.words.end(), [&](Word const& word) {
    return std::find(a.words.begin(), a.words.end(), word) != a.words.end();
  });
}

// Does the expression mention no dart but the bound one, and has it, if `by` is not empty, the same value all over a ⟨by⟩-orbit:
// is it then only the size of larger orbits that it asks for?
bool depends_only_on(ir::Bound const& dart, OrbitType const& by, ir::Expr const& expr) {
  if (std::holds_alternative<ir::NodeDart>(expr.value) || std::holds_alternative<ir::LetRef>(expr.value)) return false;
  if (auto const* bound = std::get_if<ir::Bound>(&expr.value)) return bound->level != dart.level || by.words.empty();
  if (auto const* apply = std::get_if<ir::Apply>(&expr.value); apply && apply->function == Builtin::count) {
    auto const* darts = std::get_if<ir::Darts>(&apply->arguments[0]->value);
    auto const* at = darts ? std::get_if<ir::Bound>(&darts->at->value) : nullptr;
    if (at && at->level == dart.level && contains(darts->orbit, by)) return true;
  }
  auto const parts = ir::parts(expr);
  return std::all_of(parts.begin(), parts.end(), [&](ir::ExprPtr const& part) { return depends_only_on(dart, by, *part); });
}

// all(… for d in ⟨hook type⟩(hook)) or any(…).
std::optional<DartTest> test_of(ir::RuleScheme const& rule, ir::Expr const& aggregate, bool negated) {
  auto const* apply = std::get_if<ir::Apply>(&aggregate.value);
  if (!apply || apply->function != (negated ? Builtin::any : Builtin::all)) return {};
  auto const* each = std::get_if<ir::ForEach>(&apply->arguments[0]->value);
  if (!each) return {};
  auto const* from = std::get_if<ir::NodeDart>(&each->over.at->value);
  OrbitType const type = rule.hook_orbit();
  OrbitType const& orbit = each->over.orbit;
  if (!from || from->node != rule.hooks.front() || !contains(orbit, type) || !contains(type, orbit)) return {};
  if (ir::find_call(*each->element) || !depends_only_on(each->variable, each->over.by, *each->element)) return {};
  return DartTest{each->variable, each->element, !negated};
}

bool add_tests(ir::RuleScheme const& rule, ir::Expr const& condition, std::vector<DartTest>& tests) {
  auto const* apply = std::get_if<ir::Apply>(&condition.value);
  if (apply && apply->function == Builtin::logical_and) {
    return add_tests(rule, *apply->arguments[0], tests) && add_tests(rule, *apply->arguments[1], tests);
  }
  bool const negated = apply && apply->function == Builtin::logical_not;
  auto test = test_of(rule, negated ? *apply->arguments[0] : condition, negated);
  if (test) tests.push_back(std::move(*test));
  return test.has_value();
}

}  // namespace

std::optional<std::vector<DartTest>> dart_tests(ir::RuleScheme const& rule, ir::Requirement const& requirement) {
  std::vector<DartTest> tests;
  if (!add_tests(rule, *requirement.condition, tests)) return {};
  return tests;
}

}  // namespace jrule::cpp
