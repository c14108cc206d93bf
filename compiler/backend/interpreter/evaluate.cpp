#include "compiler/backend/interpreter/evaluate.h"

namespace jrule::interpreter {

namespace {

ir::Evaluated evaluate_apply(ir::Apply const& outermost, Scene const& scene, rewrite::Index k) {
  // Sums of many terms nest to the left: descend there in a loop, not by recursion.
  std::vector<ir::Apply const*> spine{&outermost};
  while (auto const* inner = std::get_if<ir::Apply>(&spine.back()->arguments.front()->value)) spine.push_back(inner);
  ir::Evaluated value = evaluate(*spine.back()->arguments.front(), scene, k);
  while (!spine.empty()) {
    ir::Apply const& apply = *spine.back();
    spine.pop_back();
    std::vector<ir::Evaluated> arguments{std::move(value)};
    for (std::size_t i = 1; i < apply.arguments.size(); ++i) arguments.push_back(evaluate(*apply.arguments[i], scene, k));
    value = ir::apply(apply.function, arguments);
  }
  return value;
}

}  // namespace

ir::Evaluated evaluate(ir::Expr const& expr, Scene const& scene, rewrite::Index k) {
  struct Visitor {
    Scene const& scene;
    rewrite::Index k;
    Embedding const& embedding(std::size_t i) const { return scene.map.embedding(i); }
    Dart dart(ir::NodeId node, Word const& path) const { return scene.map.walk(scene.match[node][k], path); }

    ir::Evaluated operator()(ir::Constant const& c) const { return c.value; }
    ir::Evaluated operator()(ir::ParameterRef const& p) const { return scene.arguments[p.index]; }
    ir::Evaluated operator()(ir::LetRef const& l) const { return scene.lets[l.index]; }
    ir::Evaluated operator()(ir::ValueAt const& v) const {
      Embedding const& e = embedding(v.embedding);
      return e.value(e.handle(dart(v.node, v.path)));
    }
    ir::Evaluated operator()(ir::Collect const& c) const {
      Embedding const& e = embedding(c.embedding);
      std::vector<Value> values;
      for (Dart const d : rewrite::representatives(scene.map, c.orbit, c.by, dart(c.node, c.path))) values.push_back(e.value(e.handle(d)));
      return values;
    }
    ir::Evaluated operator()(ir::Apply const& a) const { return evaluate_apply(a, scene, k); }
    ir::Evaluated operator()(ir::Conditional const& c) const {
      return evaluate(std::get<bool>(evaluate_value(*c.condition, scene, k)) ? *c.then_value : *c.else_value, scene, k);
    }
  };
  return std::visit(Visitor{scene, k}, expr.value);
}

Value evaluate_value(ir::Expr const& expr, Scene const& scene, rewrite::Index k) { return std::get<Value>(evaluate(expr, scene, k)); }

}  // namespace jrule::interpreter
