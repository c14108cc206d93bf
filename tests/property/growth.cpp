#include "tests/property/growth.h"

namespace jrule::property {

Dart Growth::add_dart() {
  auto const d = static_cast<Dart>(size());
  for (auto* columns : {&out_, &in_}) {
    for (auto& c : *columns) c.push_back(no_dart);
  }
  return d;
}

// The square a -i-> b -j-> c -i-> e -j-> a through an i-arc: what its known arcs say of the others.
void Growth::follow_square(Arc const& arc, int j, std::vector<Arc>& open) const {
  int const i = arc.dimension;
  Dart const a = arc.from, b = arc.to;
  Dart const c = target(b, j), e = source(a, j);
  if (c != no_dart && e != no_dart) open.push_back({c, i, e});
  if (c != no_dart && target(c, i) != no_dart) open.push_back({target(c, i), j, a});
  if (e != no_dart && source(e, i) != no_dart) open.push_back({b, j, source(e, i)});
}

bool Growth::set(Dart from, int dimension, Dart to) {
  std::vector<Arc> open{{from, dimension, to}};
  while (!open.empty()) {
    Arc const arc = open.back();
    open.pop_back();
    int const i = arc.dimension;
    Dart& out = out_[column(i)][arc.from];
    Dart& in = in_[column(i)][arc.to];
    if (out == arc.to) continue;
    if (out != no_dart || in != no_dart || (model_->closed && arc.from == arc.to)) return false;
    out = arc.to;
    in = arc.from;
    if (!model_->is_oriented(i)) open.push_back({arc.to, i, arc.from});
    for (auto const& [p, q] : model_->exchange) {
      if (p == i) follow_square(arc, q, open);
      if (q == i) follow_square(arc, p, open);
    }
  }
  return true;
}

std::optional<Map> Growth::complete(Random& random, std::size_t limit) const {
  Growth growth = *this;
  std::vector<std::pair<Dart, int>> missing;
  bool const dimension_by_dimension = random.chance(50);
  std::size_t const loops = random.below(60), fresh = random.below(40);  // percent
  int budget = 400;
  for (;;) {
    missing.clear();
    for (int const i : model_->dimensions) {
      if (dimension_by_dimension && !missing.empty()) break;
      for (Dart d = 0; d < growth.size(); ++d) {
        if (growth.target(d, i) == no_dart) missing.emplace_back(d, i);
      }
    }
    if (missing.empty()) break;
    auto const [d, i] = random.pick(missing);
    std::vector<Dart> free;
    for (Dart t = 0; t < growth.size(); ++t) {
      if (growth.source(t, i) == no_dart) free.push_back(t);
    }
    bool done = false;
    for (int attempt = 0; attempt < 8 && !done; ++attempt) {
      if (--budget < 0) return {};
      Growth next = growth;
      Dart to;
      if (attempt == 7 || random.chance(fresh)) {
        if (growth.size() >= limit) continue;
        to = next.add_dart();
      } else if (random.chance(loops) && growth.source(d, i) == no_dart) {
        to = d;
      } else {
        to = random.pick(free);
      }
      done = next.set(d, i, to);
      if (done) growth = std::move(next);
    }
    if (!done) return {};
  }
  Map map(*model_);
  map.add_darts(growth.size());
  for (int const i : model_->dimensions) {
    for (Dart d = 0; d < growth.size(); ++d) map.set_target(d, i, growth.target(d, i));
  }
  return map;
}

}  // namespace jrule::property
