#include "compiler/analysis/alternating_paths.h"

#include <utility>

namespace jrule::analysis {

bool closes(AlternatingPath const& path) { return path.size() == 4 && path.back()->target == path.front()->source; }

AlternatingPath SideView::walk(ir::NodeId from, int i, int j) const {
  AlternatingPath path;
  for (int const d : {i, j, i, j}) {
    ir::Arc const* const arc = table.out(from, d);
    if (!arc) break;
    path.push_back(arc);
    from = arc->target;
  }
  return path;
}

std::vector<ir::Arc const*> SideView::arcs_of(AlternatingPath const& cycle, Model const& model) const {
  std::vector<ir::Arc const*> arcs = cycle;
  if (model.is_oriented(cycle[0]->dimension) || model.is_oriented(cycle[1]->dimension)) return arcs;
  for (ir::Arc const* arc : cycle) {
    ir::Arc const* const reverse = table.out(arc->target, arc->dimension);
    if (reverse && reverse->target == arc->source) arcs.push_back(reverse);
  }
  return arcs;
}

AlternatingPath SideView::maximal_from(ir::Arc const& first, int other_dimension) const {
  ir::Arc const* const before = table.in(first.source, other_dimension);
  if (before && changed(*before)) return {};
  AlternatingPath path;
  int d = other_dimension;
  int e = first.dimension;
  for (ir::Arc const* arc = &first; arc && changed(*arc); arc = table.out(arc->target, d), std::swap(d, e)) path.push_back(arc);
  return path;
}

namespace {

AlternatingPath partner_of(AlternatingPath const& path, SideView const& view, int second) {
  ir::Arc const* const first = view.table.out(path.front()->source, path.front()->dimension);
  if (!first || !view.changed(*first)) return {};
  AlternatingPath partner = view.maximal_from(*first, second);
  bool const coherent = partner.size() == path.size() && partner.back()->target == path.back()->target &&
                        !closes(view.walk(first->source, first->dimension, second));
  return coherent ? partner : AlternatingPath{};
}

void collect(SideView const& view, SideView const& other, bool added, Model const& model, int i, int j, std::vector<CycleObligation>& all) {
  for (ir::Arc const& arc : view.side.arcs) {
    if ((arc.dimension != i && arc.dimension != j) || !view.changed(arc)) continue;
    int const second = arc.dimension == i ? j : i;
    AlternatingPath walk = view.walk(arc.source, arc.dimension, second);
    if (walk.size() == 4) {
      all.push_back({added, std::move(walk), {}});
      continue;
    }
    AlternatingPath path = view.maximal_from(arc, second);
    if (path.empty()) continue;  // part of a longer one, which starts elsewhere
    bool const mirror = path.front()->source > path.back()->target && !model.is_oriented(i) && !model.is_oriented(j);
    if (mirror) continue;
    AlternatingPath partner = partner_of(path, other, second);
    all.push_back({added, std::move(path), std::move(partner)});
  }
}

}  // namespace

std::vector<CycleObligation> cycle_obligations(SideView const& left, SideView const& right, Model const& model, int i, int j) {
  std::vector<CycleObligation> all;
  collect(left, right, false, model, i, j, all);
  collect(right, left, true, model, i, j, all);
  return all;
}

}  // namespace jrule::analysis
