#include "tests/property/clauses.h"

#include "compiler/algebra/group.h"
#include "compiler/analysis/analyze.h"

namespace jrule::property {

namespace {

ir::ExprType const integer{Type::Int, false, false}, integers{Type::Int, true, false};

template <class Node>
ir::ExprPtr expr(Node node, ir::ExprType type) {
  return std::make_shared<ir::Expr const>(ir::Expr{type, std::move(node), {}});
}

struct Writer {
  ir::RuleScheme const& rule;
  Random& random;
  algebra::Group group{rule.model()};

  std::size_t any_embedding() { return random.below(rule.modeler->embeddings.size()); }

  /// A walk of up to three steps.
  Word path() {
    Word word;
    for (std::size_t k = random.below(4); k > 0; --k) {
      int const d = random.pick(rule.model().dimensions);
      word.push_back({static_cast<std::uint8_t>(d), rule.model().is_oriented(d) && random.chance(50)});
    }
    return group.normal_form(word);
  }

  ir::ExprPtr walked(ir::ExprPtr const& from) {
    Word const word = path();
    return word.empty() ? from : expr(ir::Walk{from, word}, ir::dart_type);
  }
  ir::ExprPtr left_dart() {
    std::vector<ir::NodeId> left;
    for (ir::NodeId s = 0; s < rule.nodes.size(); ++s) {
      if (!rule.nodes[s].added()) left.push_back(s);
    }
    return walked(expr(ir::NodeDart{random.pick(left)}, ir::dart_type));
  }
  ir::ExprPtr value_at(ir::ExprPtr const& dart) { return expr(ir::ValueAt{any_embedding(), dart}, integer); }

  /// Each dart of some orbit.
  ir::Darts darts() {
    std::vector<int> dimensions;
    for (int const d : rule.model().dimensions) {
      if (random.chance(50)) dimensions.push_back(d);
    }
    return {left_dart(), orbit_of_dimensions(dimensions), {}};
  }

  ir::ExprPtr number() {
    switch (rule.hooks.empty() ? 0 : random.below(5)) {
      case 0: return expr(ir::Constant{Value(static_cast<std::int64_t>(random.below(1000)))}, integer);
      case 1:
        return expr(ir::Apply{ir::Builtin::sum, {expr(ir::Collect{any_embedding(), darts()}, integers)}}, integer);
      case 2: {
        ir::Bound const dart{0, "d"};
        ir::ExprPtr const element = value_at(walked(expr(dart, ir::dart_type)));
        return expr(ir::Apply{ir::Builtin::sum, {expr(ir::ForEach{dart, darts(), element}, integers)}}, integer);
      }
      default: return value_at(left_dart());
    }
  }

  ir::ExprPtr value() {
    ir::ExprPtr sum = number();
    for (std::size_t k = random.below(3); k > 0; --k) sum = expr(ir::Apply{ir::Builtin::add, {sum, number()}}, integer);
    return sum;
  }
};

}  // namespace

ir::RuleScheme with_clauses(ir::RuleScheme rule, Random& random) {
  std::vector<ir::NodeId> right, added;
  for (ir::NodeId s = 0; s < rule.nodes.size(); ++s) {
    if (!rule.nodes[s].deleted()) right.push_back(s);
    if (rule.nodes[s].added()) added.push_back(s);
  }
  for (std::size_t k = right.empty() ? 0 : random.between(2, 8); k > 0; --k) {
    Writer writer{rule, random};
    // New orbits are what clauses are mostly for.
    ir::NodeId const node = random.pick(!added.empty() && random.chance(70) ? added : right);
    rule.clauses.push_back({node, writer.any_embedding(), writer.value(), {}});
    // An orbit that gets two values is no longer accepted.
    if (!analysis::analyze(rule).accepted()) rule.clauses.pop_back();
  }
  return rule;
}

}  // namespace jrule::property
