#include "compiler/backend/interpreter/evaluate.h"

#include <stdexcept>

namespace jrule::interpreter {

namespace {

// What an expression reads: parameters, lets, and values of the map.
struct Leaf {
  Scene const& scene;
  rewrite::Index k;

  Dart dart(ir::NodeId node, Word const& path) const { return scene.map.walk(scene.match[node][k], path); }

  ir::Evaluated operator()(ir::ParameterRef const& p) const { return scene.arguments[p.index]; }
  ir::Evaluated operator()(ir::LetRef const& l) const { return scene.lets[l.index]; }
  ir::Evaluated operator()(ir::ValueAt const& v) const {
    Embedding const& e = scene.map.embedding(v.embedding);
    return e.value(e.handle(dart(v.node, v.path)));
  }
  ir::Evaluated operator()(ir::Collect const& c) const {
    Embedding const& e = scene.map.embedding(c.embedding);
    std::vector<Value> values;
    for (Dart const d : rewrite::representatives(scene.map, c.orbit, c.by, dart(c.node, c.path))) values.push_back(e.value(e.handle(d)));
    return values;
  }
  template <class Other>
  ir::Evaluated operator()(Other const&) const {
    throw std::logic_error("an expression that is no leaf");
  }
};

}  // namespace

ir::Evaluated evaluate(ir::Expr const& expr, Scene const& scene, rewrite::Index k) {
  return ir::evaluate(expr, [&](ir::Expr const& leaf) { return std::visit(Leaf{scene, k}, leaf.value); });
}

Value evaluate_value(ir::Expr const& expr, Scene const& scene, rewrite::Index k) { return std::get<Value>(evaluate(expr, scene, k)); }

}  // namespace jrule::interpreter
