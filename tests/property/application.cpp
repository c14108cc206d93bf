#include "tests/property/application.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <set>

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

/// Bit for bit: the same darts, arcs and handles.
bool unchanged(Map const& before, Map const& after) {
  if (before.dart_limit() != after.dart_limit() || before.darts() != after.darts()) return false;
  for (Dart const d : before.darts()) {
    for (int const i : before.model().dimensions) {
      if (before.target(d, i) != after.target(d, i) || before.source(d, i) != after.source(d, i)) return false;
    }
    for (std::size_t e = 0; e < before.embedding_count(); ++e) {
      Handle const handle = before.embedding(e).handle(d);
      if (handle != after.embedding(e).handle(d)) return false;
      if (before.embedding(e).value(handle) != after.embedding(e).value(handle)) return false;
    }
  }
  return true;
}

/// Of an application that failed: only that it is not applicable there may be why, and then nothing has changed.
std::optional<std::string> refused_cleanly(Error const& error, Map const& before, Map const& after) {
  if (error.kind != Error::Kind::not_applicable) return "another error: " + to_string(error);
  if (!unchanged(before, after)) return "it does not apply, but the map is changed";
  return {};
}

}  // namespace

Application interpreted(ir::RuleScheme const& rule, analysis::Plan const& plan) {
  return [&rule, &plan](Map& map, std::vector<Dart> const& hooks) {
    rewrite::Workspace workspace;
    return interpreter::apply(rule, plan, map, hooks, {}, workspace);
  };
}

Examined examine(ir::RuleScheme const& rule, Site const& site, Application const& apply) {
  auto const expected = reference::derive(rule, reference::plain(site.map), site.hooks);
  Map after = site.map;
  auto const applied = apply(after, site.hooks);
  if (!applied) {
    if (expected) return {false, "it should apply, but: " + to_string(applied.error())};
    return {false, refused_cleanly(applied.error(), site.map, after)};
  }
  if (!expected) return {true, "it should not apply: " + expected.error()};
  if (auto const violation = find_violation(after)) return {true, "the result is no map: " + violation->text};
  if (auto const violation = reference::violation(reference::plain(after), rule.model()))
    return {true, "the result is no map: " + *violation};
  return {true, same_result(rule, site.map, *expected, after, *applied)};
}

Map with_values(ir::Modeler const& modeler, Map const& bare) {
  Map map(modeler.model, modeler.embeddings);
  map.add_darts(bare.dart_limit());
  for (Dart d = 0; d < bare.dart_limit(); ++d) {
    for (int const i : modeler.model.dimensions) map.set_target(d, i, bare.target(d, i));
  }
  for (std::size_t e = 0; e < map.embedding_count(); ++e) {
    Embedding& embedding = map.embedding(e);
    std::map<std::uint32_t, Handle> handles;
    auto const orbits = number_orbits(map, embedding.spec().orbit);
    for (Dart d = 0; d < map.dart_limit(); ++d) {
      auto const number = orbits.number[d];
      auto const [known, is_new] = handles.emplace(number, no_handle);
      double const components[] = {static_cast<double>(number)};
      if (is_new) known->second = embedding.add(from_components(embedding.spec().type, components));
      embedding.set_handle(d, known->second);
    }
  }
  return map;
}

Examined examine_values(ir::RuleScheme const& rule, Site const& site, Application const& apply) {
  Map const before = with_values(*rule.modeler, site.map);
  if (auto const violation = find_violation(before)) return {false, "the map before is no map: " + violation->text};
  Map after = before;
  auto const applied = apply(after, site.hooks);
  if (!applied) return {false, refused_cleanly(applied.error(), before, after)};
  if (auto const violation = find_violation(after)) return {true, "the result is no map: " + violation->text};
  std::set<Dart> added;
  for (ir::NodeId s = 0; s < rule.nodes.size(); ++s) {
    if (rule.nodes[s].added()) added.insert(applied->copies[s].begin(), applied->copies[s].end());
  }
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

std::optional<std::string> difference(Map const& start, std::vector<Dart> const& hooks, Application const& a,
                                      Application const& b) {
  Map map_a = start, map_b = start;
  auto const applied_a = a(map_a, hooks), applied_b = b(map_b, hooks);
  auto const error = [](auto const& applied) { return applied ? std::string("none") : to_string(applied.error()); };
  if (error(applied_a) != error(applied_b)) return "the errors differ: " + error(applied_a) + "; " + error(applied_b);
  if (applied_a && applied_a->copies != applied_b->copies) return "the copies of the nodes differ";
  if (map_a.darts() != map_b.darts() || print_jmap(map_a) != print_jmap(map_b))
    return "the maps differ:\n" + print_jmap(map_a) + print_jmap(map_b);
  return {};
}

}  // namespace jrule::property
