// Counterexamples as SVG: the map before and the graph after, dart by dart.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "compiler/backend/draw/draw.h"
#include "compiler/backend/draw/graph_layout.h"
#include "compiler/backend/draw/style.h"

namespace jrule::draw {

namespace {

using analysis::Counterexample;
using analysis::Graph;

constexpr double dart_radius = 11, scale = 78, margin = 56;
constexpr char const* broken_color = "#ffb300";

/// Arcs as they are drawn: an arc and its reverse are one line without an arrow.
struct Line {
  Dart from, to;
  std::size_t column;
  bool both_ways;
  bool broken;
};

struct Panel {
  Graph const& graph;
  Model const& model;
  std::vector<Position> const& at;  // in pixels
  std::set<Dart> hooks, added, deleted;
  std::set<std::tuple<Dart, std::size_t, Dart>> broken_arcs;
  std::set<Dart> broken_darts;
  std::string svg{};

  bool drawn(Dart d) const {
    if (graph.contains(d)) return true;
    // An erased dart is drawn where an arc dangles.
    for (auto const& from : graph.targets) {
      for (auto const& to : from) {
        if (std::find(to.begin(), to.end(), d) != to.end()) return true;
      }
    }
    return d < graph.targets.size() &&
           std::any_of(graph.targets[d].begin(), graph.targets[d].end(), [](auto const& to) { return !to.empty(); });
  }

  std::vector<Line> lines() const {
    std::map<std::tuple<Dart, std::size_t, Dart>, std::size_t> arcs;  // with how often each is there
    for (Dart d = 0; d < graph.targets.size(); ++d) {
      for (std::size_t c = 0; c < graph.targets[d].size(); ++c) {
        for (Dart const to : graph.targets[d][c]) ++arcs[{d, c, to}];
      }
    }
    std::vector<Line> result;
    for (auto& [arc, count] : arcs) {
      auto const& [from, c, to] = arc;
      bool const non_oriented = !model.is_oriented(model.dimensions[c]);
      auto const reverse = std::tuple(to, c, from);
      for (; count > 0; --count) {
        Line line{from, to, c, non_oriented && from == to, broken_arcs.contains(arc)};
        auto const found = arcs.find(reverse);
        if (non_oriented && from != to && found != arcs.end() && found->second > 0) {
          --found->second;
          line.both_ways = true;
          line.broken = line.broken || broken_arcs.contains(reverse);
        }
        result.push_back(line);
      }
    }
    return result;
  }

  void path(std::string const& d, Line const& line) {
    int const dimension = model.dimensions[line.column];
    if (line.broken)
      svg += fmt::format(
          "<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"8\" stroke-linecap=\"round\" opacity=\"0.75\"/>\n",
          d, broken_color);
    svg += fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.8\"/>\n", d, color_of(dimension));
  }

  void label(Position p, Line const& line) {
    int const dimension = model.dimensions[line.column];
    svg += fmt::format("<text class=\"d\" x=\"{:.1f}\" y=\"{:.1f}\" fill=\"{}\">{}</text>\n", p.x, p.y + 3.5,
                       color_of(dimension), dimension);
  }

  /// The tip at the rim of the dart `end`, coming from `from`.
  void arrow(Position from, Position end, Line const& line) {
    double const length = std::max(std::hypot(end.x - from.x, end.y - from.y), 1e-6);
    double const x = (end.x - from.x) / length, y = (end.y - from.y) / length;
    Position const tip{end.x - x * dart_radius, end.y - y * dart_radius}, back{tip.x - 8 * x, tip.y - 8 * y};
    svg += fmt::format("<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}L{:.1f} {:.1f}Z\" fill=\"{}\"/>\n", tip.x, tip.y,
                       back.x - 3.5 * y, back.y + 3.5 * x, back.x + 3.5 * y, back.y - 3.5 * x,
                       color_of(model.dimensions[line.column]));
  }

  /// The k-th of several lines between two darts, bent apart from the others.
  void draw_link(Line const& line, double bend) {
    Position const a = at[line.from], b = at[line.to];
    double const length = std::max(std::hypot(b.x - a.x, b.y - a.y), 1e-6);
    // The same side for both directions.
    double const sign = line.from < line.to ? 1 : -1;
    Position const control{(a.x + b.x) / 2 - sign * bend * (b.y - a.y) / length,
                           (a.y + b.y) / 2 + sign * bend * (b.x - a.x) / length};
    path(fmt::format("M{:.1f} {:.1f}Q{:.1f} {:.1f} {:.1f} {:.1f}", a.x, a.y, control.x, control.y, b.x, b.y), line);
    if (!line.both_ways) arrow(control, b, line);
    label({(a.x + b.x) / 4 + control.x / 2, (a.y + b.y) / 4 + control.y / 2}, line);
  }

  void draw_loop(Line const& line, double angle) {
    Position const a = at[line.from];
    auto const point = [&](double turn, double radius) {
      return Position{a.x + radius * std::cos(angle + turn), a.y + radius * std::sin(angle + turn)};
    };
    Position const p = point(-0.42, 46), q = point(0.42, 46);
    path(
        fmt::format("M{:.1f} {:.1f}C{:.1f} {:.1f} {:.1f} {:.1f} {:.1f} {:.1f}", a.x, a.y, p.x, p.y, q.x, q.y, a.x, a.y),
        line);
    if (!line.both_ways) arrow(q, a, line);
    label(point(0, 35), line);
  }

  /// Loops stand where no neighbour is: around the direction away from the others.
  double free_direction(Dart d, std::vector<Line> const& all) const {
    double x = 0, y = 0;
    for (Line const& line : all) {
      if ((line.from != d && line.to != d) || line.from == line.to) continue;
      Position const other = at[line.from == d ? line.to : line.from];
      double const length = std::max(std::hypot(other.x - at[d].x, other.y - at[d].y), 1e-6);
      x -= (other.x - at[d].x) / length;
      y -= (other.y - at[d].y) / length;
    }
    return std::hypot(x, y) < 0.05 ? -1.57 : std::atan2(y, x);
  }

  void draw_dart(Dart d) {
    Position const p = at[d];
    bool const live = graph.contains(d), broken = broken_darts.contains(d);
    char const* const fill = broken                ? broken_color
                             : added.contains(d)   ? added_color
                             : deleted.contains(d) ? deleted_color
                                                   : "#ffffff";
    if (hooks.contains(d))
      svg += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\" fill=\"none\" stroke=\"#212121\"/>\n", p.x, p.y,
                         dart_radius + 4);
    svg += fmt::format(
        "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\" fill=\"{}\" stroke=\"#212121\"{}/>\n<text class=\"n\" "
        "x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n",
        p.x, p.y, dart_radius, fill, live ? "" : " stroke-dasharray=\"3 2\"", p.x, p.y + 4, d);
  }

  std::string draw() {
    std::vector<Line> const all = lines();
    std::map<std::pair<Dart, Dart>, std::vector<Line>> groups;
    for (Line const& line : all) groups[std::minmax(line.from, line.to)].push_back(line);
    for (auto const& [ends, group] : groups) {
      double const middle = (static_cast<double>(group.size()) - 1) / 2;
      double const free = ends.first == ends.second ? free_direction(ends.first, all) : 0;
      for (std::size_t k = 0; k < group.size(); ++k) {
        double const offset = static_cast<double>(k) - middle;
        ends.first == ends.second ? draw_loop(group[k], free + 0.95 * offset) : draw_link(group[k], 34 * offset);
      }
    }
    for (Dart d = 0; d < graph.targets.size(); ++d) {
      if (drawn(d)) draw_dart(d);
    }
    return svg;
  }
};

/// The arcs that show the violation.
void mark_violation(Panel& panel, Violation const& violation) {
  Graph const& graph = panel.graph;
  panel.broken_darts.insert(violation.dart);
  auto const mark = [&](Dart from, int i) {
    Dart to = no_dart;
    if (from >= graph.targets.size()) return to;
    auto const c = static_cast<std::size_t>(panel.model.column(i));
    for (Dart const t : graph.targets[from][c]) panel.broken_arcs.insert({from, c, to = t});
    return to;
  };
  Dart d = mark(violation.dart, violation.i);
  if (violation.kind == Violation::Kind::non_orientation) mark(d, violation.i);
  if (violation.kind == Violation::Kind::cycle) mark(mark(mark(d, violation.j), violation.i), violation.j);
  if (violation.kind != Violation::Kind::incident_arcs) return;
  auto const c = static_cast<std::size_t>(panel.model.column(violation.i));
  for (Dart from = 0; from < graph.targets.size(); ++from) {
    for (Dart const to : graph.targets[from][c]) {
      if (to == violation.dart) panel.broken_arcs.insert({from, c, to});
    }
  }
}

std::string legend(Model const& model, double y) {
  std::string text;
  double x = 20;
  for (int const d : model.dimensions) {
    text += fmt::format(
        "<path d=\"M{:.1f} {:.1f}h24\" stroke=\"{}\" stroke-width=\"1.8\"/><text x=\"{:.1f}\" "
        "y=\"{:.1f}\">{}-arc</text>\n",
        x, y, color_of(d), x + 29, y + 4, d);
    x += 76;
  }
  x = 28;
  y += 26;
  auto const add = [&](char const* fill, std::string const& what) {
    text += fmt::format(
        "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"7\" fill=\"{}\" stroke=\"#212121\"/><text x=\"{:.1f}\" "
        "y=\"{:.1f}\">{}</text>\n",
        x, y, fill, x + 14, y + 4, what);
    x += 34 + 7 * static_cast<double>(what.size());
  };
  text += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"10\" fill=\"none\" stroke=\"#212121\"/>\n", x, y);
  add("#ffffff", "hook");
  add(deleted_color, "deleted");
  add(added_color, "added");
  add(broken_color, "breaks the model");
  return text;
}

}  // namespace

std::string graph_svg(ir::RuleScheme const& rule, Counterexample const& example) {
  Model const& model = rule.model();
  Graph const before = analysis::graph_of(example.before);
  std::set<std::pair<Dart, Dart>> links;
  for (Graph const* graph : {&before, &example.after}) {
    for (Dart d = 0; d < graph->targets.size(); ++d) {
      for (auto const& column : graph->targets[d]) {
        for (Dart const to : column) {
          if (d != to) links.insert({std::min(d, to), std::max(d, to)});
        }
      }
    }
  }
  std::vector<Position> at = spring_layout(example.after.targets.size(), {links.begin(), links.end()});
  Position low, high;
  for (Position const& p : at) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  double const top = 64;
  for (Position& p : at) p = {(p.x - low.x) * scale + margin, (p.y - low.y) * scale + margin + top};
  double const panel_width = std::max((high.x - low.x) * scale + 2 * margin, 240.0),
               panel_height = (high.y - low.y) * scale + 2 * margin;
  std::string const story = "after: " + example.violation.text;
  double const width = std::max({2 * panel_width, 7.2 * static_cast<double>(story.size()) + 40,
                                 76.0 * static_cast<double>(model.dimensions.size()) + 40, 460.0});
  double const height = top + panel_height + 68;

  Panel left{before, model, at, {example.hooks.begin(), example.hooks.end()}, {}, {}, {}, {}};
  Panel right{example.after, model, at, {}, {}, {}, {}, {}};
  for (ir::NodeId id = 0; id < rule.nodes.size(); ++id) {
    if (rule.nodes[id].deleted()) left.deleted.insert(example.copies[id].begin(), example.copies[id].end());
    if (rule.nodes[id].added()) right.added.insert(example.copies[id].begin(), example.copies[id].end());
  }
  right.deleted = left.deleted;
  for (Dart const hook : example.hooks) {
    if (!right.deleted.contains(hook)) right.hooks.insert(hook);
  }
  mark_violation(right, example.violation);

  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" viewBox=\"0 0 {0:.0f} "
      "{1:.0f}\">\n",
      width, height);
  svg +=
      "<style>text{font:13px "
      "Helvetica,Arial,sans-serif}.n{text-anchor:middle;font-size:11px}.d{text-anchor:middle;font-size:11px;paint-"
      "order:stroke;"
      "stroke:#ffffff;stroke-width:3px}</style>\n<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n";
  svg +=
      fmt::format("<text x=\"20\" y=\"26\" style=\"font-weight:bold\">{}</text>\n<text x=\"20\" y=\"46\">{}</text>\n",
                  escape(fmt::format("{} on {}: before, and after", rule.name, rule.modeler->name)), escape(story));
  if (before.darts.empty())
    svg += fmt::format("<text x=\"20\" y=\"{:.1f}\">(the empty map)</text>\n", top + panel_height / 2);
  svg += "<g>\n" + left.draw() + "</g>\n";
  svg += fmt::format("<path d=\"M{0:.1f} {1:.1f}V{2:.1f}\" stroke=\"#bdbdbd\"/>\n", width / 2, top, top + panel_height);
  svg += fmt::format("<g transform=\"translate({:.1f} 0)\">\n", width / 2) + right.draw() + "</g>\n";
  return svg + legend(model, top + panel_height + 14) + "</svg>\n";
}

}  // namespace jrule::draw
