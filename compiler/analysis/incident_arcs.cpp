#include "compiler/analysis/incident_arcs.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "compiler/analysis/wording.h"

namespace jrule::analysis {

using source::Code;

namespace {

struct IncidentArcs {
  ir::RuleScheme const& rule;
  ir::Table left{rule.nodes.size(), rule.left};
  ir::Table right{rule.nodes.size(), rule.right};
  Refusals refusals{};

  void refuse(Code code, source::Span span, std::string message, std::vector<source::Label> labels, ir::NodeId id, int d, std::string help = {}) {
    source::Diagnostic diagnostic{.code = code, .span = span, .message = std::move(message), .labels = std::move(labels)};
    diagnostic.notes.push_back(incident_arcs_note(rule.model(), d));
    if (!help.empty()) diagnostic.notes.push_back(std::move(help));
    refusals.push_back({std::move(diagnostic), id, d, -1});
  }

  static std::string directed_name(int d, bool outgoing) { return fmt::format("{} {}-arc", outgoing ? "outgoing" : "incoming", d); }
  // "d-arc", or for an oriented dimension "outgoing d-arc" and "incoming d-arc".
  std::string arc_name(int d, bool outgoing) const { return rule.model().is_oriented(d) ? directed_name(d, outgoing) : fmt::format("{}-arc", d); }
  // Of a node with one direction of an arc only, the other one.
  std::string missing_name(int d, bool out, bool in) const { return !out && !in ? fmt::format("{}-arc", d) : directed_name(d, !out); }

  bool check_at_most_one(ir::NodeId id, int d) {
    for (bool const on_left : {true, false}) {
      ir::Table const& table = on_left ? left : right;
      for (bool const outgoing : {true, false}) {
        auto const& arcs = outgoing ? table.all_out(id, d) : table.all_in(id, d);
        if (arcs.size() < 2) continue;
        refuse(Code::two_arcs, arcs[1]->span,
               fmt::format("the {} side gives `{}` {} {}s", on_left ? "left" : "right", rule.nodes[id].name,
                           arcs.size() == 2 ? "two" : fmt::format("{}", arcs.size()), arc_name(d, outgoing)),
               {{arcs[0]->span, describe(rule, *arcs[0])}}, id, d);
        return false;
      }
    }
    return true;
  }

  // An added node has an outgoing or an incoming d-arc, but not both.
  std::string missing_half_help(ir::NodeId id, int d, bool out) const {
    ir::Node const& node = rule.nodes[id];
    if (rule.model().is_oriented(d)) return out ? fmt::format("add an arc `… -{}-> {}`", d, node.name) : fmt::format("add an arc `{} -{}-> …`", node.name, d);
    return fmt::format("write {} for both directions", both_directions(rule, out ? *right.out(id, d) : *right.in(id, d)));
  }

  void check_added(ir::NodeId id, int d) {
    ir::Node const& node = rule.nodes[id];
    bool const out = right.out(id, d), in = right.in(id, d);
    if (out && in) return;
    bool const half = out || in;
    if (half && !rule.model().is_oriented(d)) return;  // see check_incident_arcs
    refuse(Code::missing_arc, *node.right_span, fmt::format("the right side creates `{}` without {} {}", node.name, half ? "an" : "a", missing_name(d, out, in)),
           {{*node.right_span, "this node is added here"}}, id, d,
           half ? missing_half_help(id, d, out) : fmt::format("give `{}` a {}-arc: in its decoration, or as `{} -{}- …`", node.name, d, node.name, d));
  }

  void check_deleted(ir::NodeId id, int d) {
    ir::Node const& node = rule.nodes[id];
    bool const out = left.out(id, d), in = left.in(id, d);
    if (out && in) return;
    if ((out || in) && !rule.model().is_oriented(d)) return;  // see check_incident_arcs
    refuse(Code::dangling_node, *node.left_span, fmt::format("the rule deletes `{}`, but the left side does not match its {}", node.name, missing_name(d, out, in)),
           {{*node.left_span, "this node is not on the right side"}}, id, d,
           fmt::format("an unmatched {}-arc of a deleted dart would be left dangling", d));
  }

  void check_preserved(ir::NodeId id, int d) {
    ir::Node const& node = rule.nodes[id];
    bool const none_before = !left.out(id, d) && !left.in(id, d), half_after = !right.out(id, d) != !right.in(id, d);
    if (none_before && half_after && !rule.model().is_oriented(d)) return;  // see check_incident_arcs
    bool const out_differs = !left.out(id, d) != !right.out(id, d), in_differs = !left.in(id, d) != !right.in(id, d);
    for (bool const outgoing : {true, false}) {
      if (!(outgoing ? out_differs : in_differs)) continue;
      ir::Arc const* const before = outgoing ? left.out(id, d) : left.in(id, d);
      ir::Arc const* const after = outgoing ? right.out(id, d) : right.in(id, d);
      std::string const arc = out_differs && in_differs ? arc_name(d, outgoing) : directed_name(d, outgoing);
      if (after) {
        refuse(Code::gained_arc, after->span, fmt::format("`{}` gains {}, but keeps the {} that it has", node.name, describe(rule, *after), arc),
               {{*node.left_span, fmt::format("its {} is not matched here", arc)}}, id, d,
               fmt::format("match the {}-arc of `{}` on the left side, so that the rule replaces it", d, node.name));
      } else {
        refuse(Code::lost_arc, *node.right_span, fmt::format("`{}` loses its {} and gets no other", node.name, arc),
               {{before->span, fmt::format("{} is matched here", describe(rule, *before))}}, id, d,
               fmt::format("an arc of the left side that the right side does not repeat is deleted; repeat it, or give `{}` another {}-arc", node.name, d));
      }
      return;
    }
  }
};

}  // namespace

// Where a node has one half of a non-oriented arc, an arc was written that lacks its reverse: the non-orientation condition
// refuses that arc, and says so at the arc (J0311, J0312).
Refusals check_incident_arcs(ir::RuleScheme const& rule) {
  IncidentArcs check{rule};
  for (ir::NodeId id = 0; id < rule.nodes.size(); ++id) {
    for (int const d : rule.model().dimensions) {
      if (!check.check_at_most_one(id, d)) continue;
      ir::Node const& node = rule.nodes[id];
      if (node.added()) {
        check.check_added(id, d);
      } else if (node.deleted()) {
        check.check_deleted(id, d);
      } else {
        check.check_preserved(id, d);
      }
    }
  }
  return std::move(check.refusals);
}

bool gives_two_arcs(ir::Side const& side) {
  std::set<std::pair<ir::NodeId, int>> leave, enter;
  return !std::all_of(side.arcs.begin(), side.arcs.end(), [&](ir::Arc const& arc) {
    return leave.emplace(arc.source, arc.dimension).second && enter.emplace(arc.target, arc.dimension).second;
  });
}

}  // namespace jrule::analysis
