#include "compiler/analysis/counterexample/partial_map.h"

namespace jrule::analysis {

PartialMap::PartialMap(Model model)
    : model_(std::move(model)),
      exchanged_(model_.dimensions.size()),
      out_(model_.dimensions.size()),
      in_(model_.dimensions.size()) {
  for (auto const& [i, j] : model_.exchange) {
    auto const a = static_cast<std::size_t>(model_.column(i)), b = static_cast<std::size_t>(model_.column(j));
    exchanged_[a].push_back(b);
    exchanged_[b].push_back(a);
  }
}

Dart PartialMap::walk(Dart d, Word const& word) const {
  for (Letter const l : word) {
    auto const c = static_cast<std::size_t>(model_.column(l.dimension));
    d = l.conjugate ? in_[c][d] : out_[c][d];
  }
  return d;
}

Dart PartialMap::walk_back(Dart d, Word const& word) const {
  for (auto l = word.rbegin(); l != word.rend(); ++l) {
    auto const c = static_cast<std::size_t>(model_.column(l->dimension));
    d = l->conjugate ? out_[c][d] : in_[c][d];
  }
  return d;
}

Dart PartialMap::add_dart() {
  for (auto* const side : {&out_, &in_}) {
    for (std::vector<Dart>& column : *side) column.push_back(no_dart);
  }
  return size_++;
}

// a -i-> b -j-> c -i-> e -j-> a: what an i-arc and those of the others that are known say of the rest.
void PartialMap::follow_square(Arc const& arc, std::size_t j) {
  std::size_t const i = arc.column;
  Dart const a = arc.from, b = arc.to;
  Dart const c = out_[j][b], e = in_[j][a];
  if (c != no_dart && e != no_dart) open_.push_back({c, i, e});
  if (c != no_dart && out_[i][c] != no_dart) open_.push_back({out_[i][c], j, a});
  if (e != no_dart && in_[i][e] != no_dart) open_.push_back({b, j, in_[i][e]});
}

bool PartialMap::set(Dart from, std::size_t column, Dart to) {
  open_.assign(1, {from, column, to});
  while (!open_.empty()) {
    Arc const arc = open_.back();
    open_.pop_back();
    Dart& out = out_[arc.column][arc.from];
    Dart& in = in_[arc.column][arc.to];
    if (out == arc.to) continue;
    if (out != no_dart || in != no_dart || (model_.closed && arc.from == arc.to)) return false;
    out = arc.to;
    in = arc.from;
    arcs_.push_back(arc);
    if (!model_.is_oriented(model_.dimensions[arc.column])) open_.push_back({arc.to, arc.column, arc.from});
    for (std::size_t const j : exchanged_[arc.column]) follow_square(arc, j);
  }
  return true;
}

void PartialMap::undo(Mark mark) {
  while (arcs_.size() > mark.arcs) {
    Arc const& arc = arcs_.back();
    out_[arc.column][arc.from] = no_dart;
    in_[arc.column][arc.to] = no_dart;
    arcs_.pop_back();
  }
  size_ = mark.size;
  for (auto* const side : {&out_, &in_}) {
    for (std::vector<Dart>& column : *side) column.resize(size_);
  }
}

Map PartialMap::to_map() const {
  Map map(model_);
  map.add_darts(size_);
  for (std::size_t c = 0; c < columns(); ++c) {
    for (Dart d = 0; d < size_; ++d) map.set_target(d, model_.dimensions[c], out_[c][d]);
  }
  return map;
}

PartialMap PartialMap::components_of(std::vector<Dart>& darts) const {
  std::vector<bool> kept(size_, false);
  std::vector<Dart> open = darts;
  while (!open.empty()) {
    Dart const d = open.back();
    open.pop_back();
    if (kept[d]) continue;
    kept[d] = true;
    for (auto const& column : out_) open.push_back(column[d]);  // a permutation: forwards is enough
  }
  PartialMap part(model_);
  std::vector<Dart> number(size_, no_dart);
  for (Dart d = 0; d < size_; ++d) {
    if (kept[d]) number[d] = part.add_dart();
  }
  for (Arc const& arc : arcs_) {
    if (kept[arc.from]) part.set(number[arc.from], arc.column, number[arc.to]);
  }
  for (Dart& d : darts) d = number[d];
  return part;
}

}  // namespace jrule::analysis
