#include "tests/reference/values.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <stdexcept>

#include "tests/reference/expressions.h"

namespace jrule::reference {

namespace {

using Values = std::vector<Value>;

void add_once(Values& values, Value const& value) {
  if (std::find(values.begin(), values.end(), value) == values.end()) values.push_back(value);
}

/// What the policy makes of the values of several orbits, which come in no order.
Values merged(MergePolicy policy, Values const& old) {
  auto const number = [](Value const& v) { return component(v, 0); };
  auto const by_number = [&](Value const& a, Value const& b) { return number(a) < number(b); };
  switch (policy) {
    case MergePolicy::none: return {};
    case MergePolicy::first: return old;
    case MergePolicy::min: return {*std::min_element(old.begin(), old.end(), by_number)};
    case MergePolicy::max: return {*std::max_element(old.begin(), old.end(), by_number)};
    case MergePolicy::mean: {
      double sum = 0;
      for (Value const& v : old) sum += std::get<double>(v);
      return {sum / static_cast<double>(old.size())};
    }
    case MergePolicy::function: break;
  }
  throw std::invalid_argument("a merge function");
}

struct Judge {
  ir::RuleScheme const& rule;
  PlainMap const& before;
  PlainValues const& values;
  Derivation const& derivation;
  std::map<Dart, Copy> copy_at{};  // of the darts of ι(R, P)
  std::map<std::size_t, std::map<Dart, Value>> given{};  // by clause and the dart of its node's copy: E(u)

  void evaluate_clauses() {
    Ground const ground{before, values, derivation.match};
    for (auto const& [copy, dart] : derivation.copies) {
      copy_at[dart] = copy;
      for (std::size_t c = 0; c < rule.clauses.size(); ++c) {
        if (rule.clauses[c].node == copy.second) given[c][dart] = value_at(*rule.clauses[c].value, ground, copy.first);
      }
    }
  }

  /// A step along an arc of ι(R, P).
  std::optional<Dart> step_inside(Dart d, Letter letter) const {
    ir::NodeId const node = copy_at.at(d).second;
    bool const inside = std::any_of(rule.right.arcs.begin(), rule.right.arcs.end(), [&](ir::Arc const& arc) {
      return arc.dimension == letter.dimension && (letter.conjugate ? arc.target : arc.source) == node;
    });
    if (!inside) return {};
    return walk(derivation.result, d, {letter});
  }
  std::optional<Dart> walk_inside(Dart d, Word const& word) const {
    std::optional<Dart> at = d;
    for (Letter const letter : word) {
      at = step_inside(*at, letter);
      if (!at) break;
    }
    return at;
  }

  /// The darts of ι(R, P) in parts that its arcs alone hold together.
  std::map<Dart, std::size_t> parts(OrbitType const& type) const {
    std::map<Dart, std::set<Dart>> beside;
    for (auto const& [dart, copy] : copy_at) {
      for (Word const& word : type.words) {
        auto const to = walk_inside(dart, word);
        if (!to) continue;
        beside[dart].insert(*to);
        beside[*to].insert(dart);
      }
    }
    std::map<Dart, std::size_t> part;
    std::size_t count = 0;
    for (auto const& [start, copy] : copy_at) {
      if (part.contains(start)) continue;
      std::vector<Dart> open{start};
      part[start] = count;
      while (!open.empty()) {
        Dart const d = open.back();
        open.pop_back();
        for (Dart const to : beside[d]) {
          if (part.emplace(to, count).second) open.push_back(to);
        }
      }
      ++count;
    }
    return part;
  }

  void judge(std::size_t e, std::vector<OrbitValues>& all) const {
    EmbeddingSpec const& spec = rule.modeler->embeddings[e];
    std::map<Dart, std::size_t> const part = parts(spec.orbit);
    std::vector<std::vector<Dart>> const old_orbits = orbits(before, spec.orbit);
    std::map<Dart, std::size_t> old_orbit;
    for (std::size_t o = 0; o < old_orbits.size(); ++o) {
      for (Dart const d : old_orbits[o]) old_orbit[d] = o;
    }
    for (auto& darts : orbits(derivation.result, spec.orbit)) {
      OrbitValues orbit;
      orbit.embedding = e;
      std::map<std::pair<std::size_t, std::size_t>, Values> of_parts;  // by clause and part
      std::map<std::size_t, Value> old;                                // by orbit of the map before
      for (Dart const d : darts) {
        for (auto const& [clause, at] : given) {
          if (rule.clauses[clause].embedding == e && at.contains(d)) of_parts[{clause, part.at(d)}].push_back(at.at(d));
        }
        if (before.targets.contains(d)) old.emplace(old_orbit.at(d), values[e].at(d));
      }
      for (auto& [key, list] : of_parts) {
        for (Value const& value : list) add_once(orbit.allowed, value);
        orbit.parts.push_back({key.first, std::move(list)});
      }
      Values brought;
      for (auto const& [number, value] : old) brought.push_back(value);
      if (!orbit.parts.empty()) {
        orbit.source = OrbitValues::Source::clause;
      } else if (brought.size() > 1) {
        orbit.source = OrbitValues::Source::merged;
        orbit.allowed = merged(spec.merge, brought);
      } else if (brought.size() == 1) {
        orbit.source = OrbitValues::Source::kept;
        orbit.allowed = brought;
      } else if (spec.default_value) {
        orbit.allowed = {*spec.default_value};
      }
      orbit.darts = std::move(darts);
      all.push_back(std::move(orbit));
    }
  }
};

}  // namespace

std::vector<OrbitValues> orbit_values(ir::RuleScheme const& rule, PlainMap const& before, PlainValues const& values,
                                      Derivation const& derivation) {
  Judge judge{rule, before, values, derivation};
  judge.evaluate_clauses();
  std::vector<OrbitValues> all;
  for (std::size_t e = 0; e < values.size(); ++e) judge.judge(e, all);
  return all;
}

}  // namespace jrule::reference
