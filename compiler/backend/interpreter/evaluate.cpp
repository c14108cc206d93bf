#include "compiler/backend/interpreter/evaluate.h"

#include <stdexcept>

#include "jrule/operation.h"

namespace jrule::interpreter {

namespace {

// What an expression reads: parameters, lets, darts and values of the map.
struct Reader {
  Scene const& scene;
  rewrite::Index k;
  std::vector<Dart> bound{};  // by the comprehensions around, the outermost first

  ir::Evaluated evaluate(ir::Expr const& expr) {
    return ir::evaluate(expr, [this](ir::Expr const& leaf) { return std::visit(*this, leaf.value); });
  }
  // Where the map is read.
  Dart dart(ir::ExprPtr const& expr) {
    Dart const d = std::get<Dart>(evaluate(*expr));
    return scene.locals ? operation::alive(scene.map, d, scene.locals->operation) : d;
  }
  std::vector<Dart> darts(ir::Darts const& d) { return rewrite::representatives(scene.map, d.orbit, d.by, dart(d.at)); }

  ir::Evaluated operator()(ir::ParameterRef const& p) { return scene.arguments[p.index]; }
  ir::Evaluated operator()(ir::LetRef const& l) { return scene.lets[l.index]; }
  ir::Evaluated operator()(ir::NodeDart const& n) { return scene.match[n.node][k]; }
  ir::Evaluated operator()(ir::Bound const& b) { return bound[b.level]; }
  ir::Evaluated operator()(ir::Walk const& w) { return scene.map.walk(dart(w.from), w.path); }
  ir::Evaluated operator()(ir::Darts const& d) { return darts(d); }
  ir::Evaluated operator()(ir::ValueAt const& v) {
    Embedding const& e = scene.map.embedding(v.embedding);
    return e.value(e.handle(dart(v.at)));
  }
  ir::Evaluated operator()(ir::Collect const& c) {
    Embedding const& e = scene.map.embedding(c.embedding);
    std::vector<Value> values;
    for (Dart const d : darts(c.over)) values.push_back(e.value(e.handle(d)));
    return values;
  }
  ir::Evaluated operator()(ir::ForEach const& f) {
    std::vector<Value> values;
    for (Dart const d : darts(f.over)) {
      bound.push_back(d);
      values.push_back(std::get<Value>(evaluate(*f.element)));
      bound.pop_back();
    }
    return values;
  }
  ir::Evaluated operator()(ir::VariableRef const& v) { return std::get<ir::Evaluated>(scene.locals->variables[v.index]); }
  ir::Evaluated operator()(ir::CopyOf const& c) {
    auto const& result = std::get<CallResult>(scene.locals->variables[c.result.index]);
    std::vector<Dart> const& copies = result.copies[c.node];
    if (!c.at) return copies.front();  // of the hook's dart
    Dart const at = std::get<Dart>(evaluate(*c.at));
    return operation::Copies(result.copies[result.hook.value()], copies).at(at, scene.locals->operation, c.result.name + "." + c.node_name);
  }
  template <class Other>
  ir::Evaluated operator()(Other const&) {
    throw std::logic_error("an expression that is no leaf");
  }
};

}  // namespace

ir::Evaluated evaluate(ir::Expr const& expr, Scene const& scene, rewrite::Index k) {
  return Reader{scene, k}.evaluate(expr);
}

Value evaluate_value(ir::Expr const& expr, Scene const& scene, rewrite::Index k) { return std::get<Value>(evaluate(expr, scene, k)); }

}  // namespace jrule::interpreter
