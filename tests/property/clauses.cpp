#include "tests/property/clauses.h"

#include "compiler/algebra/group.h"
#include "compiler/analysis/analyze.h"

namespace jrule::property {

namespace {

ir::ExprType const truth{Type::Bool, false, false};

ir::ExprType of_type(Type type) { return {type, false, false}; }

struct Writer {
  ir::RuleScheme const& rule;
  Random& random;
  source::Span span;
  algebra::Group group{rule.model()};

  template <class Node>
  ir::ExprPtr expr(Node node, ir::ExprType type) {
    return std::make_shared<ir::Expr const>(ir::Expr{type, std::move(node), span});
  }
  ir::ExprPtr apply(ir::Builtin function, std::vector<ir::ExprPtr> arguments, ir::ExprType type) {
    return expr(ir::Apply{function, std::move(arguments)}, type);
  }

  std::vector<std::size_t> embeddings_of(Type type) {
    std::vector<std::size_t> found;
    for (std::size_t e = 0; e < rule.modeler->embeddings.size(); ++e) {
      if (rule.modeler->embeddings[e].type == type) found.push_back(e);
    }
    return found;
  }
  std::size_t any_embedding(Type type) { return random.pick(embeddings_of(type)); }

  /// A walk of up to so many steps.
  Word path(std::size_t limit) {
    Word word;
    for (std::size_t k = random.below(limit + 1); k > 0; --k) {
      int const d = random.pick(rule.model().dimensions);
      word.push_back({static_cast<std::uint8_t>(d), rule.model().is_oriented(d) && random.chance(50)});
    }
    return group.normal_form(word);
  }

  ir::ExprPtr walked(ir::ExprPtr const& from, Word const& word) {
    return word.empty() ? from : expr(ir::Walk{from, word}, ir::dart_type);
  }
  ir::ExprPtr left_node() {
    std::vector<ir::NodeId> left;
    for (ir::NodeId s = 0; s < rule.nodes.size(); ++s) {
      if (!rule.nodes[s].added()) left.push_back(s);
    }
    return expr(ir::NodeDart{random.pick(left)}, ir::dart_type);
  }
  ir::ExprPtr left_dart() { return walked(left_node(), path(random.chance(50) ? 0 : 3)); }
  ir::ExprPtr value_at(std::size_t embedding, ir::ExprPtr const& dart) {
    return expr(ir::ValueAt{embedding, dart}, of_type(rule.modeler->embeddings[embedding].type));
  }

  std::vector<int> some(std::vector<int> const& dimensions, std::size_t percent) {
    std::vector<int> chosen;
    for (int const d : dimensions) {
      if (random.chance(percent)) chosen.push_back(d);
    }
    return chosen;
  }
  /// Each dart of some orbit, or one for each smaller orbit in it.
  ir::Darts darts() {
    std::vector<int> const dimensions = some(rule.model().dimensions, 50);
    return {left_dart(), orbit_of_dimensions(dimensions),
            orbit_of_dimensions(some(dimensions, random.chance(50) ? 0 : 50))};
  }
  /// Values over an orbit.
  ir::ExprPtr list(Type type) {
    ir::ExprType const values{type, true, false};
    std::size_t const embedding = any_embedding(type);
    if (random.chance(50)) return expr(ir::Collect{embedding, darts()}, values);
    ir::Bound const dart{0, "d"};
    ir::ExprPtr const element = value_at(embedding, walked(expr(dart, ir::dart_type), path(3)));
    return expr(ir::ForEach{dart, darts(), element}, values);
  }
  /// A value at two darts, in an operation that does not mind their order.
  ir::ExprPtr pair(Type type) {
    ir::ExprPtr const node = left_node();
    Word const first = path(1);
    std::size_t const embedding = any_embedding(type);
    return apply(random.pick(std::vector{ir::Builtin::add, ir::Builtin::min, ir::Builtin::max}),
                 {value_at(embedding, walked(node, first)),
                  value_at(embedding, walked(node, group.product(path(1), first)))},
                 of_type(type));
  }
  /// Do two paths from a dart lead to the same dart?
  ir::ExprPtr choice(Type type) {
    ir::ExprPtr const node = left_node();
    ir::ExprPtr const same =
        apply(ir::Builtin::equal, {walked(node, path(2)), walked(node, path(2))}, truth);
    return expr(ir::Conditional{same, simple(type), simple(type)}, of_type(type));
  }
  ir::ExprPtr simple(Type type) { return value_at(any_embedding(type), left_dart()); }

  ir::ExprPtr number() {
    ir::ExprType const integer = of_type(Type::Int);
    switch (rule.hooks.empty() ? 0 : random.below(10)) {
      case 0: return expr(ir::Constant{Value(static_cast<std::int64_t>(random.below(1000)))}, integer);
      case 1: return apply(ir::Builtin::count, {expr(darts(), ir::darts_type)}, integer);
      case 2:
        return apply(random.pick(std::vector{ir::Builtin::min, ir::Builtin::max, ir::Builtin::first}),
                     {list(Type::Int)}, integer);
      case 3: case 4: case 5: return apply(ir::Builtin::sum, {list(Type::Int)}, integer);
      case 6: return pair(Type::Int);
      case 7: return choice(Type::Int);
      default: return simple(Type::Int);
    }
  }
  ir::ExprPtr real() {
    ir::ExprType const type = of_type(Type::Real);
    switch (rule.hooks.empty() || embeddings_of(Type::Real).empty() ? 0 : random.below(6)) {
      case 0: return apply(ir::Builtin::to_real, {number()}, type);
      case 1: return apply(ir::Builtin::mean, {list(Type::Int)}, type);
      case 2: case 3:
        return apply(random.chance(75) ? ir::Builtin::mean : ir::Builtin::sum, {list(Type::Real)}, type);
      case 4: return pair(Type::Real);
      default: return simple(Type::Real);
    }
  }

  /// Of Int or Real.
  ir::ExprPtr value(Type type) {
    auto const part = [&] { return type == Type::Int ? number() : real(); };
    ir::ExprPtr result = part();
    for (std::size_t k = random.below(3); k > 0; --k) {
      auto const function = random.chance(80) ? ir::Builtin::add : type == Type::Int ? ir::Builtin::multiply : ir::Builtin::midpoint;
      result = apply(function, {result, part()}, of_type(type));
    }
    return result;
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
    auto const number = static_cast<std::uint32_t>(rule.clauses.size());
    Writer writer{rule, random, {source::no_file, number, number + 1}};
    // New orbits are what clauses are mostly for.
    ir::NodeId const node = random.pick(!added.empty() && random.chance(70) ? added : right);
    std::size_t const embedding = random.below(rule.modeler->embeddings.size());
    rule.clauses.push_back({node, embedding, writer.value(rule.modeler->embeddings[embedding].type), writer.span});
    // An orbit that gets two values is no longer accepted.
    if (!analysis::analyze(rule).accepted()) rule.clauses.pop_back();
  }
  return rule;
}

}  // namespace jrule::property
