#include "compiler/analysis/analyze.h"

#include <algorithm>
#include <set>

#include "compiler/analysis/closedness.h"
#include "compiler/analysis/cycles.h"
#include "compiler/analysis/dead_left.h"
#include "compiler/analysis/embeddings.h"
#include "compiler/analysis/expectations.h"
#include "compiler/analysis/incident_arcs.h"
#include "compiler/analysis/non_orientation.h"
#include "compiler/analysis/pattern.h"

namespace jrule::analysis {

namespace {
void append(Refusals& all, Refusals more) {
  for (Refusal& refusal : more) all.push_back(std::move(refusal));
}

// Refusals of dimensions in which nothing was refused before: one slip is said once.
void append_new_dimensions(Refusals& all, Refusals more) {
  std::set<int> known;
  for (Refusal const& refusal : all) known.insert(refusal.i);
  for (Refusal& refusal : more) {
    if (!known.contains(refusal.i)) all.push_back(std::move(refusal));
  }
}
}  // namespace

Verdict analyze(ir::RuleScheme const& rule) {
  Verdict verdict;
  Pattern const pattern(rule);
  PatternWords const& words = pattern.words;
  append(verdict.refusals, check_incident_arcs(rule));
  append_new_dimensions(verdict.refusals, check_non_orientation(rule, pattern.group, words));
  // What two arcs of one dimension imply is not worth saying.
  if (!gives_two_arcs(rule.left)) {
    append(verdict.refusals, pattern.completed.dead);
    if (pattern.completed.dead.empty()) append(verdict.refusals, check_dead_left(rule, pattern.group, pattern.placement, words));
  }
  if (!verdict.accepted()) return verdict;
  append(verdict.refusals, check_closedness(rule, words));
  append(verdict.refusals, check_cycles(pattern.completed.rule, pattern.group, words));
  if (!verdict.accepted()) return verdict;
  EmbeddingAnalysis embeddings = analyze_embeddings(pattern.completed.rule, words);
  append(verdict.refusals, std::move(embeddings.refusals));
  verdict.warnings = std::move(embeddings.warnings);
  // Completed arcs are preserved and hold wherever the rest matches: the application needs only the rule as written.
  verdict.plan = plan_application(rule);
  verdict.plan.orbits = std::move(embeddings.orbits);
  std::stable_sort(verdict.plan.orbits.begin(), verdict.plan.orbits.end(), [](OrbitComponent const& a, OrbitComponent const& b) {
    return std::pair(a.embedding, a.kind) < std::pair(b.embedding, b.kind);
  });
  append(verdict.refusals, check_expectations(rule, verdict.plan));
  return verdict;
}

}  // namespace jrule::analysis
