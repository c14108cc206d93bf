#include "jrule/trial.h"

#include <cassert>

namespace jrule::rewrite {

Trial::Trial(Map& map, Workspace& workspace, std::size_t arcs)
    : map_(map), workspace_(workspace), limit_(map.dart_limit()) {
  arcs_.reserve(arcs);
  value_counts_.reserve(map.embedding_count());
  for (std::size_t e = 0; e < map.embedding_count(); ++e) value_counts_.push_back(map.embedding(e).value_count());
}

Trial::~Trial() {
  if (kept_) return;
  for (auto arc = arcs_.rbegin(); arc != arcs_.rend(); ++arc) {
    map_.undo_target(arc->from, arc->dimension, arc->to, arc->old_target, arc->old_source);
  }
  if (!added_.empty()) map_.undo_add(added_, limit_);
  for (std::size_t e = 0; e < value_counts_.size(); ++e) map_.embedding(e).truncate_values(value_counts_[e]);
}

std::span<Dart const> Trial::add_darts(std::size_t count) {
  assert(added_.empty());
  added_ = map_.add_darts(count);
  return added_;
}

void Trial::set_target(Dart from, int dimension, Dart to) noexcept {
  assert(arcs_.size() < arcs_.capacity());
  arcs_.push_back({from, dimension, to, map_.target(from, dimension), map_.source(to, dimension)});
  map_.set_target(from, dimension, to);
}

void Trial::begin_merges(std::size_t embedding) noexcept {
  embedding_ = embedding;
  workspace_.clear_marks();
}

void Trial::exclude(Dart d) noexcept {
  (void)collect_orbit(map_, map_.embedding(embedding_).spec().orbit, d, workspace_);
}

void Trial::merge(Dart d) {
  Embedding& e = map_.embedding(embedding_);
  std::span<Dart const> const members = collect_orbit(map_, e.spec().orbit, d, workspace_);
  if (members.empty()) return;
  std::vector<Handle>& parts = workspace_.handles();
  if (collect_values(e, members, parts)) return;
  Handle const value = parts.size() == 1 ? parts.front() : e.spec().extern_parts.add_merged(e, parts);
  merged_.push_back({embedding_, d, value});
}

void Trial::commit_merges(std::size_t embedding) noexcept {
  workspace_.clear_marks();
  for (Merged const& m : merged_) {
    if (m.embedding == embedding) assign_orbit(map_, embedding, m.dart, m.value, workspace_);
  }
}

}  // namespace jrule::rewrite
