#include "compiler/analysis/effects.h"

#include <fmt/format.h>

#include <algorithm>

#include "compiler/analysis/pattern.h"
#include "compiler/analysis/side_orbits.h"
#include "compiler/analysis/wording.h"

namespace jrule::analysis {

namespace {

struct Analysis : Pattern {
  Analysis(ir::RuleScheme const& its_rule, Plan const& its_plan) : Pattern(its_rule), plan(its_plan) {}

  Plan const& plan;
  OrbitCounter const counter{group};
  // With one hook, that is the only node of the left side: any other would match darts of the component again.
  bool const whole = rule.hooks.empty() || (rule.hooks.size() == 1 && fills_components());

  CellClass cell_class(SideOrbits const& side, SideOrbit const& orbit) const {
    CellClass found{orbit.nodes, {}, rule.hooks.empty(), orbit.reaches_out};
    std::sort(found.nodes.begin(), found.nodes.end());
    found.single = found.single || std::all_of(plan.generators.begin(), plan.generators.end(),
                                               [&](Word const& word) { return side.generated(word, orbit.generators); });
    found.per.words = counter.shortened(orbit.generators, [&](Word const& by) { return words.stays_in_pattern(by); });
    return found;
  }

  // Do all darts of the orbit that outlive the application lie in one orbit by the other side too?
  bool stays_together(SideOrbit const& orbit, SideOrbits const& other) const {
    SideOrbit::Survivor const& base = orbit.survivors.front();
    for (SideOrbit::Survivor const& survivor : orbit.survivors) {
      if (!other.joins(base, survivor)) return false;
    }
    return std::all_of(orbit.generators.begin(), orbit.generators.end(), [&](Word const& g) { return other.joins(base, moved(base, g)); });
  }

  // From the copy at u to that at u·g.
  SideOrbit::Survivor moved(SideOrbit::Survivor const& survivor, Word const& g) const {
    return {survivor.node, survivor.tail, group.product(g, survivor.path)};
  }

  // Are they of one cell in every map before, since a path within the cell leads from one to the other?
  bool joined_by_place(SideOrbit::Survivor const& s, SideOrbit::Survivor const& t, OrbitType const& cell) const {
    auto const element = [&](SideOrbit::Survivor const& survivor) -> std::optional<Word> {
      auto const translated = placement.translate(placement.hook(survivor.node), survivor.path);
      auto const& offset = placement.offset(survivor.node);
      if (!translated || !offset) return {};
      return group.product(group.product(*translated, *offset), survivor.tail);
    };
    if (placement.hook(s.node) != placement.hook(t.node)) return false;
    auto const of_s = element(s), of_t = element(t);
    return of_s && of_t && group.in_orbit(group.product(group.inverse(*of_s), *of_t), cell);
  }

  bool never_merges(SideOrbit const& orbit, SideOrbits const& left, OrbitType const& cell) const {
    SideOrbit::Survivor const& base = orbit.survivors.front();
    auto const together = [&](SideOrbit::Survivor const& other) { return left.joins(base, other) || joined_by_place(base, other, cell); };
    return std::all_of(orbit.survivors.begin(), orbit.survivors.end(), together) &&
           std::all_of(orbit.generators.begin(), orbit.generators.end(), [&](Word const& g) { return together(moved(base, g)); });
  }

  static bool share_survivor(SideOrbit const& a, SideOrbit const& b) {
    return std::any_of(a.survivors.begin(), a.survivors.end(), [&](SideOrbit::Survivor const& s) {
      return std::any_of(b.survivors.begin(), b.survivors.end(),
                         [&](SideOrbit::Survivor const& t) { return s.node == t.node && s.tail == t.tail; });
    });
  }
  static bool share_survivor(SideOrbit const& a, std::vector<SideOrbit const*> const& others) {
    return std::any_of(others.begin(), others.end(), [&](SideOrbit const* other) { return share_survivor(a, *other); });
  }

  CellEffects of_cells(int dimension, OrbitType const& cell) const {
    CellEffects found;
    found.dimension = dimension;
    found.orbit = cell;
    SideOrbits const left(completed.rule, true, cell, group, words), right(completed.rule, false, cell, group, words);
    std::vector<SideOrbit const*> merged, split;
    for (SideOrbit const& orbit : right.all()) {
      if (orbit.survivors.empty()) {
        found.created.push_back(cell_class(right, orbit));
      } else if (!never_merges(orbit, left, cell)) {
        found.merged.push_back(cell_class(right, orbit));
        merged.push_back(&orbit);
      }
    }
    std::vector<CellClass> gone = {}, come = found.created;
    for (SideOrbit const& orbit : left.all()) {
      if (orbit.survivors.empty()) {
        found.deleted.push_back(cell_class(left, orbit));
        gone.push_back(found.deleted.back());
      } else if (!stays_together(orbit, right)) {
        found.split.push_back(cell_class(left, orbit));
        split.push_back(&orbit);
        gone.push_back(found.split.back());
      } else if (share_survivor(orbit, merged)) {
        gone.push_back(cell_class(left, orbit));
      } else {
        found.kept.push_back(cell_class(left, orbit));
      }
    }
    for (SideOrbit const& orbit : right.all()) {
      bool const is_merged = std::find(merged.begin(), merged.end(), &orbit) != merged.end();
      if (is_merged || share_survivor(orbit, split)) come.push_back(cell_class(right, orbit));
    }
    found.count = whole ? count_all(right) : count_changes(dimension, gone, come);
    return found;
  }

  OrbitCount orbits_of(std::vector<Word> const& generators) const {
    return rule.hooks.empty() ? OrbitCount{.count = {.constant = {1, 1}}} : counter.count(generators);
  }

  OrbitCount finished(OrbitCount sum) const {
    if (sum.regular_only) sum.count = counter.readable(sum.count);
    return sum;
  }

  // Of a component all is matched, so the right side's orbits are all that there are.
  OrbitCount count_all(SideOrbits const& right) const {
    OrbitCount sum;
    for (SideOrbit const& orbit : right.all()) sum = counter.add(sum, orbits_of(orbit.generators));
    return finished(std::move(sum));
  }

  // Where all cells that do not stay as they are, and all that come of them, lie within the matched part, and each class is one
  // cell, these are all the changes: a cell that reaches out of it stays one, and meets no other.
  static std::optional<OrbitCount> count_changes(int dimension, std::vector<CellClass> const& gone, std::vector<CellClass> const& come) {
    auto const certain = [](std::vector<CellClass> const& classes) {
      return std::all_of(classes.begin(), classes.end(), [](CellClass const& c) { return c.single && !c.reaches_out; });
    };
    auto const i = static_cast<std::size_t>(dimension);
    if (!certain(gone) || !certain(come) || i >= ir::Count::named_cells) return {};
    OrbitCount sum;
    sum.count.cells[i] = {1, 1};
    sum.count.constant.over = static_cast<std::int64_t>(come.size()) - static_cast<std::int64_t>(gone.size());
    return sum;
  }

  std::optional<OrbitCount> count_darts() const {
    auto const nodes = [&](bool (ir::Node::*is)() const) {
      return std::count_if(rule.nodes.begin(), rule.nodes.end(), [&](ir::Node const& node) { return (node.*is)(); });
    };
    std::int64_t const more = nodes(&ir::Node::added) - nodes(&ir::Node::deleted);
    OrbitCount sum;
    if (rule.hooks.empty()) {
      sum.count.constant.over = more;
    } else if (whole) {
      sum.count.darts.over = 1 + more;
    } else if (more == 0 || std::all_of(plan.generators.begin(), plan.generators.end(), [&](Word const& w) { return words.trivial(w); })) {
      sum.count.darts.over = 1;
      sum.count.constant.over = more;
    } else {
      return {};
    }
    return sum;
  }
};

std::string nodes_text(ir::RuleScheme const& rule, CellClass const& cells) {
  std::string text;
  for (ir::NodeId const id : cells.nodes) text += (text.empty() ? "`" : ", `") + rule.nodes[id].name + "`";
  return text;
}

}  // namespace

Effects analyze_effects(ir::RuleScheme const& rule, Plan const& plan) {
  Analysis const analysis(rule, plan);
  Effects effects{{}, analysis.count_darts(), analysis.whole};
  for (int i = 0; i <= rule.model().dimension; ++i) {
    if (auto const cell = cell_orbit(rule.model(), i)) effects.cells.push_back(analysis.of_cells(i, *cell));
  }
  return effects;
}

std::string why_no_count(ir::RuleScheme const& rule, Effects const& effects, CellEffects const* cells) {
  std::string const place = rule.hooks.size() > 1 ? fmt::format("`{}` has {} hooks", rule.name, rule.hooks.size())
                                                  : fmt::format("the hook's type {} is not a whole component", to_string(rule.hook_orbit()));
  if (!cells) return place + ", and how many darts its pattern has is not known";
  std::string const what = orbit_names(rule.model(), cells->orbit);
  if (static_cast<std::size_t>(cells->dimension) >= ir::Count::named_cells) return fmt::format("there is no letter for {}", what);
  if (!effects.whole && !cells->split.empty()) {
    return fmt::format("{}, and {} of {} may be split: into how many depends on the map", place, what, nodes_text(rule, cells->split.front()));
  }
  if (!effects.whole && !cells->merged.empty()) {
    return fmt::format("{}, and {} may merge in those of {}: how many depends on the map", place, what, nodes_text(rule, cells->merged.front()));
  }
  for (bool const is_new : {true, false}) {
    for (CellClass const& c : is_new ? cells->created : cells->deleted) {
      if (c.single) continue;
      return fmt::format("{}, and of the {} {} of {} there is one for each {} of the pattern, which has a number of them that depends on the map", place,
                         is_new ? "new" : "deleted", what, nodes_text(rule, c),
                         c.per.words.empty() ? "dart" : orbit_name(rule.model(), c.per));
    }
  }
  return place;
}

}  // namespace jrule::analysis
