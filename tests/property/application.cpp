#include "tests/property/application.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <set>

#include "compiler/backend/interpreter/interpreter.h"
#include "jrule/io.h"
#include "tests/reference/engine.h"

namespace jrule::property {

namespace {

std::optional<std::string> same_result(ir::RuleScheme const& rule, Map const& before,
                                       reference::Derivation const& expected, Map const& after,
                                       interpreter::Applied const& applied) {
  std::map<Dart, unsigned> expected_node, node;  // of the added darts: a renaming keeps whose copies they are
  std::map<ir::NodeId, std::set<Dart>> expected_copies;
  for (auto const& [copy, dart] : expected.copies) {
    expected_copies[copy.second].insert(dart);
    if (rule.nodes[copy.second].added()) expected_node[dart] = copy.second;
  }
  for (ir::NodeId s = 0; s < rule.nodes.size(); ++s) {
    std::set<Dart> const copies(applied.copies[s].begin(), applied.copies[s].end());
    if (rule.nodes[s].preserved() && copies != expected_copies[s])
      return "the copies of node " + rule.nodes[s].name + " lie elsewhere";
    if (!rule.nodes[s].added()) continue;
    for (Dart const d : copies) node[d] = s;
  }
  std::map<Dart, Dart> kept;
  for (Dart const d : before.darts()) {
    if (expected.result.targets.contains(d)) kept[d] = d;
  }
  if (!reference::isomorphic(expected.result, reference::plain(after), kept, expected_node, node))
    return "the results differ:\n" + print_jmap(after);
  return {};
}

}  // namespace

Examined examine(ir::RuleScheme const& rule, analysis::Plan const& plan, Site const& site) {
  auto const expected = reference::derive(rule, reference::plain(site.map), site.hooks);
  Map after = site.map;
  rewrite::Workspace workspace;
  auto const applied = interpreter::apply(rule, plan, after, site.hooks, {}, workspace);
  if (!applied) {
    if (expected) return {false, "it should apply, but: " + to_string(applied.error())};
    if (applied.error().kind != Error::Kind::not_applicable)
      return {false, "another error: " + to_string(applied.error())};
    if (print_jmap(after) != print_jmap(site.map)) return {false, "it does not apply, but the map is changed"};
    return {false, {}};
  }
  if (!expected) return {true, "it should not apply: " + expected.error()};
  if (auto const violation = find_violation(after)) return {true, "the result is no map: " + violation->text};
  if (auto const violation = reference::violation(reference::plain(after), rule.model()))
    return {true, "the result is no map: " + *violation};
  return {true, same_result(rule, site.map, *expected, after, *applied)};
}

Examined examine_values(ir::RuleScheme const& rule, analysis::Plan const& plan, Site const& site) {
  Map before(rule.model(), rule.modeler->embeddings);
  before.add_darts(site.map.dart_limit());
  for (Dart d = 0; d < site.map.dart_limit(); ++d) {
    for (int const i : rule.model().dimensions) before.set_target(d, i, site.map.target(d, i));
  }
  for (std::size_t e = 0; e < before.embedding_count(); ++e) {
    Embedding& embedding = before.embedding(e);
    std::map<std::uint32_t, Handle> handles;
    auto const orbits = number_orbits(before, embedding.spec().orbit);
    for (Dart d = 0; d < before.dart_limit(); ++d) {
      auto const number = orbits.number[d];
      auto const [known, is_new] = handles.emplace(number, no_handle);
      if (is_new) known->second = embedding.add(Value(std::int64_t{number}));
      embedding.set_handle(d, known->second);
    }
  }
  if (auto const violation = find_violation(before)) return {false, "the map before is no map: " + violation->text};
  Map after = before;
  rewrite::Workspace workspace;
  auto const applied = interpreter::apply(rule, plan, after, site.hooks, {}, workspace);
  if (!applied) {
    if (print_jmap(after) != print_jmap(before)) return {false, "it does not apply, but the map is changed"};
    return {false, {}};
  }
  if (auto const violation = find_violation(after)) return {true, "the result is no map: " + violation->text};
  std::set<Dart> added;
  for (ir::NodeId const s : plan.added) added.insert(applied->copies[s].begin(), applied->copies[s].end());
  for (std::size_t e = 0; e < after.embedding_count(); ++e) {
    auto const orbits = number_orbits(after, after.embedding(e).spec().orbit);
    std::vector<std::set<std::int64_t>> brought(orbits.first.size());
    for (Dart const d : after.darts()) {
      if (!added.contains(d))
        brought[orbits.number[d]].insert(
            std::get<std::int64_t>(before.embedding(e).value(before.embedding(e).handle(d))));
    }
    for (std::size_t o = 0; o < brought.size(); ++o) {
      auto const value = std::get<std::int64_t>(after.embedding(e).value(after.embedding(e).handle(orbits.first[o])));
      if (brought[o].empty() ? value != -1 : !brought[o].contains(value)) {
        return {true, "the " + after.embedding(e).spec().name + "-orbit of dart " + std::to_string(orbits.first[o]) +
                          " has the value " + std::to_string(value) + ", which none of its darts had\n" +
                          print_jmap(after)};
      }
    }
  }
  return {true, {}};
}

}  // namespace jrule::property
