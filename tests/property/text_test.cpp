// parse(print(rule)) = rule, on random rules with random expressions.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <variant>

#include "compiler/backend/text/print_jrule.h"
#include "tests/property/cases.h"
#include "tests/property/expressions.h"
#include "tests/property/models.h"
#include "tests/text/again.h"
#include "tests/text/difference.h"

namespace jrule::property {

namespace {

/// A modeler without embeddings, named as in a text.
std::shared_ptr<ir::Modeler const> model_alone(Model const& model) {
  auto modeler = std::make_shared<ir::Modeler>(*bare(model));
  if (builtin_model(model.name, model.dimension)) modeler->name += "(" + std::to_string(model.dimension) + ")";
  return modeler;
}

/// A few random rules have a first hook without its loops, which sema never makes.
bool first_hook_is_full(ir::RuleScheme const& rule) {
  return rule.hooks.empty() || std::all_of(rule.hook_type.begin(), rule.hook_type.end(), [&](Letter const op) {
    return ir::find_same(rule.left, {rule.hooks[0], op.dimension, {op}, rule.hooks[0], {}}) != nullptr;
  });
}

/// How many expressions there are of each kind, in the order of ir::Expr; rules have none of the last two, which are those of
/// operations.
using Kinds = std::array<std::size_t, std::variant_size_v<decltype(ir::Expr::value)> - 2>;

struct Tally {
  int printed = 0, unspellable = 0;
  std::size_t clauses = 0, values = 0;
  Kinds kinds{};
  std::size_t inner_variables = 0;  // of comprehensions within comprehensions
  std::size_t dart_comparisons = 0;

  void add(ir::Expr const& expr) {
    ++kinds.at(expr.value.index());
    if (auto const* bound = std::get_if<ir::Bound>(&expr.value)) inner_variables += bound->level > 0;
    auto const parts = ir::parts(expr);
    dart_comparisons += std::holds_alternative<ir::Apply>(expr.value) && parts.size() == 2 && parts[0]->type == ir::dart_type;
    for (ir::ExprPtr const& part : parts) add(*part);
  }
};

void check_printed(std::string const& property, Tally& tally, ir::RuleScheme (*rule_of)(Case const&)) {
  EXPECT_TRUE(rc::check(property, [&] {
    ir::RuleScheme const rule = rule_of(*cases());
    auto const text = text::print_jrule(ir::Program{"test", {}, {rule}});
    if (!text) {
      if (first_hook_is_full(rule)) RC_FAIL(text.error().reason + "\n" + ir::print(rule));
      ++tally.unspellable;
      return;
    }
    auto const again = tests::elaborate_again(*text, "test");
    if (!again.errors.empty()) RC_FAIL(again.errors + *text + ir::print(rule));
    RC_ASSERT(again.program.rules.size() == 1U);
    ir::RuleScheme const& after = again.program.rules[0];
    RC_ASSERT(after.name == rule.name);
    RC_ASSERT(after.modeler->module == rule.modeler->module);
    if (auto const found = tests::difference(rule, after, tests::Order::free)) {
      RC_FAIL(*found + " differ\n" + *text + ir::print(rule) + ir::print(after));
    }
    ++tally.printed;
    tally.clauses += rule.clauses.size();
    tally.values += rule.lets.size() + rule.requirements.size() + rule.parameters.size();
    for (ir::Let const& let : rule.lets) tally.add(*let.value);
    for (ir::Requirement const& requirement : rule.requirements) tally.add(*requirement.condition);
    for (ir::Clause const& clause : rule.clauses) tally.add(*clause.value);
  }));
  testing::Test::RecordProperty("printed", tally.printed);
  testing::Test::RecordProperty("unspellable", tally.unspellable);
  EXPECT_GE(tally.printed, case_count() * 9 / 10);
}

}  // namespace

TEST(PrintedRule, ElaboratesToTheSameRule) {
  Tally tally;
  check_printed("a printed rule elaborates to the same rule", tally, [](Case const& c) { return make_rule(c, model_alone); });
}

TEST(PrintedRule, ElaboratesToTheSameExpressions) {
  Tally tally;
  check_printed("a printed rule with expressions elaborates to the same rule", tally, [](Case const& c) {
    Random random(c.maps);
    return with_expressions(make_rule(c, of_all_types), random);
  });
  EXPECT_GE(tally.clauses, static_cast<std::size_t>(case_count()));
  EXPECT_GE(tally.values, static_cast<std::size_t>(case_count()));
  testing::Test::RecordProperty("inner variables", std::to_string(tally.inner_variables));
  testing::Test::RecordProperty("dart comparisons", std::to_string(tally.dart_comparisons));
  EXPECT_GE(tally.inner_variables, static_cast<std::size_t>(case_count()) / 20);
  EXPECT_GE(tally.dart_comparisons, static_cast<std::size_t>(case_count()) / 20);
  for (std::size_t kind = 0; kind < tally.kinds.size(); ++kind) {
    testing::Test::RecordProperty("expressions of kind " + std::to_string(kind), std::to_string(tally.kinds[kind]));
    EXPECT_GE(tally.kinds[kind], static_cast<std::size_t>(case_count()) / 10) << "of alternative " << kind << " of ir::Expr";
  }
}

}  // namespace jrule::property
