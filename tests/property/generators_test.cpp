// That the random cases are what they claim to be: maps of their models, rules that the front end could have made.
#include <gtest/gtest.h>

#include <set>

#include "compiler/analysis/analyze.h"
#include "tests/property/cases.h"
#include "tests/property/models.h"
#include "tests/property/mutation.h"
#include "tests/property/operations.h"

namespace jrule::property {

TEST(RandomMap, IsAMapOfItsModel) {
  for (Model const& model : models()) {
    Random random(7);
    std::set<std::size_t> sizes;
    for (Map const& map : random_maps(model, 60, random)) {
      auto const violation = find_violation(map);
      EXPECT_FALSE(violation) << model.name << ": " << violation->text;
      sizes.insert(map.dart_count());
    }
    EXPECT_GE(sizes.size(), 8U) << model.name;
  }
}

TEST(RandomOperation, IsAcceptedAndApplies) {
  // These are sound in some models only, or may ask for loops where there are none; all others have to be accepted wherever they
  // are offered.
  std::set<std::string> const nearly_sound{"edge_removal", "product", "unsew", "frame"};
  int refused = 0;
  Random random(8);
  std::set<std::string> accepted, applied;
  for (int k = 0; k < 4000; ++k) {
    ir::RuleScheme const rule = random_operation(bare(random.pick(models())), random);
    ASSERT_FALSE(ir::verify(rule)) << *ir::verify(rule) << '\n' << ir::print(rule);
    bool const is_accepted = analysis::analyze(rule).accepted();
    EXPECT_TRUE(is_accepted || nearly_sound.contains(rule.name)) << ir::print(rule);
    if (!is_accepted) {
      ++refused;
      continue;
    }
    accepted.insert(rule.name);
    if (grow_site(rule, random)) applied.insert(rule.name);
  }
  EXPECT_LE(refused, 200);
  EXPECT_GE(accepted.size(), 18U);
  EXPECT_EQ(applied, accepted);
}

TEST(Mutation, ChangesTheRuleAndKeepsItWellFormed) {
  Random random(9);
  int changed = 0;
  for (int k = 0; k < 1000; ++k) {
    ir::RuleScheme const rule = random_operation(bare(random.pick(models())), random);
    ir::RuleScheme const mutant = mutate(rule, random);
    ASSERT_FALSE(ir::verify(mutant)) << *ir::verify(mutant) << '\n' << ir::print(mutant);
    changed += ir::print(mutant) != ir::print(rule);
  }
  EXPECT_GE(changed, 700);
}

}  // namespace jrule::property
