// Rules as SVG, in the manner of the papers' figures: two graphs side by side, nodes with what becomes of the pattern's arcs, hooks
// with a double ring, arcs in the style of their dimension.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "compiler/backend/draw/draw.h"
#include "compiler/backend/draw/grid_layout.h"
#include "compiler/backend/draw/rule_lines.h"
#include "compiler/backend/draw/style.h"

namespace jrule::draw {

namespace {

constexpr double name_letter = 7.8, small_letter = 6.6;  // widths, of 13 and 11 pixels high
constexpr double ring_gap = 3.5, loop_length = 30, bend_step = 30, panel_margin = 14, arrow_width = 56;
constexpr char const *ink = "#212121", *font = "ui-monospace,Menlo,Consolas,'DejaVu Sans Mono',monospace";

struct Point {
  double x = 0, y = 0;
};
Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y}; }
Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
Point operator*(double s, Point a) { return {s * a.x, s * a.y}; }
Point unit(Point a) { return (1 / std::max(std::hypot(a.x, a.y), 1e-6)) * a; }

/// A place that is taken: its middle and half its size.
struct Area {
  Point middle;
  double width = 0, height = 0;
  bool meets(Area const& other) const {
    return std::abs(middle.x - other.middle.x) < width + other.width && std::abs(middle.y - other.middle.y) < height + other.height;
  }
  bool contains(Point p) const { return meets({p, 0, 0}); }
};

std::string shown(std::string const& name) { return name.size() <= 24 ? name : name.substr(0, 23) + "…"; }
double width_of(std::size_t letters, double letter) { return letter * static_cast<double>(std::min<std::size_t>(letters, 24)); }

/// A box with round ends that holds the node's name and decoration.
struct NodeBox {
  Point middle;
  double half_width = 0, half_height = 0;
  bool hook = false;

  /// Where its rim is left in that direction.
  Point exit(Point toward) const {
    double const gap = hook ? ring_gap : 0, radius = half_height + gap, flat = half_width - half_height;
    Point const d = unit(toward - middle);
    double const up = radius / std::max(std::abs(d.y), 1e-6);
    if (std::abs(up * d.x) <= flat) return middle + up * d;
    double const along = std::abs(d.x) * flat;
    return middle + (along + std::sqrt(std::max(along * along - flat * flat + radius * radius, 0.0))) * d;
  }
  Area area() const { return {middle, half_width + ring_gap, half_height + ring_gap}; }
};

/// A line as it is drawn: a quadratic curve, straight if its control point is its middle.
struct Curve {
  RuleLine line;
  Point from, control, to;
  Point at(double t) const { return (1 - t) * (1 - t) * from + 2 * t * (1 - t) * control + t * t * to; }
};

struct Panel {
  ir::RuleScheme const& rule;
  std::vector<NodeBox> boxes;  // by node
  std::vector<ir::NodeId> nodes;
  DecoratedSide side;

  std::string links{}, rings{}, labels{};
  std::vector<Area> taken{};
  std::vector<Curve> curves{};
  Point low{std::numeric_limits<double>::max(), std::numeric_limits<double>::max()};
  Point high{std::numeric_limits<double>::lowest(), std::numeric_limits<double>::lowest()};

  void cover(Area const& area) {
    low = {std::min(low.x, area.middle.x - area.width), std::min(low.y, area.middle.y - area.height)};
    high = {std::max(high.x, area.middle.x + area.width), std::max(high.y, area.middle.y + area.height)};
  }

  void stroke(std::string const& path, int dimension) {
    auto const draw = [&](char const* color, double width, std::string const& more) {
      links += fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\"{}/>\n", path, color, width, more);
    };
    switch (dimension) {
      case 0: return draw(color_of(0), 1.8, "");
      case 1: return draw(color_of(1), 1.8, " stroke-dasharray=\"7 3\"");
      case 2: draw(color_of(2), 5, ""); return draw("#ffffff", 2, "");
      case 3: return draw(color_of(3), 2.4, " stroke-dasharray=\"0.1 4.4\" stroke-linecap=\"round\"");
      default: return draw(color_of(dimension), 1.8, " stroke-dasharray=\"9 3 2 3\"");
    }
  }

  void tip(Point from, Point end, int dimension) {
    Point const d = unit(end - from), back = end - 10 * d, aside{-4.5 * d.y, 4.5 * d.x};
    rings += fmt::format("<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}L{:.1f} {:.1f}Z\" fill=\"{}\"/>\n", end.x, end.y, back.x + aside.x, back.y + aside.y,
                         back.x - aside.x, back.y - aside.y, color_of(dimension));
  }

  void label(Area const& area, ir::Arc const& arc) {
    taken.push_back(area);
    cover(area);
    labels += fmt::format(
        "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" rx=\"3\" fill=\"#ffffff\" fill-opacity=\"0.9\"/>"
        "<text x=\"{:.1f}\" y=\"{:.1f}\" fill=\"{}\">{}</text>\n",
        area.middle.x - area.width, area.middle.y - area.height, 2 * area.width, 2 * area.height, area.middle.x, area.middle.y + 4,
        color_of(arc.dimension), escape(arc_label(arc)));
  }
  static Area label_area(Point middle, ir::Arc const& arc) {
    return {middle, small_letter * static_cast<double>(arc_label(arc).size()) / 2 + 2.5, 7.5};
  }

  // ---- Links of two nodes ----

  /// Several between the same nodes are bent apart.
  void add_curves() {
    std::map<std::pair<ir::NodeId, ir::NodeId>, std::vector<RuleLine>> groups;
    for (RuleLine const& line : side.lines) {
      if (line.arc->source != line.arc->target) groups[std::minmax(line.arc->source, line.arc->target)].push_back(line);
    }
    for (auto const& [ends, group] : groups) {
      for (std::size_t k = 0; k < group.size(); ++k) {
        NodeBox const &a = boxes[group[k].arc->source], &b = boxes[group[k].arc->target];
        double const sign = group[k].arc->source == ends.first ? 1 : -1;
        double const bend = sign * 2 * bend_step * (static_cast<double>(k) - (static_cast<double>(group.size()) - 1) / 2);
        Point const along = unit(b.middle - a.middle), halfway = 0.5 * (a.middle + b.middle);
        Point const control = halfway + Point{-bend * along.y, bend * along.x};
        Point const from = a.exit(control), to = b.exit(control);
        curves.push_back({group[k], from, bend == 0 ? 0.5 * (from + to) : control, to});
      }
    }
  }

  void draw_curves() {
    for (Curve const& c : curves) {
      ir::Arc const& arc = *c.line.arc;
      stroke(fmt::format("M{:.1f} {:.1f}Q{:.1f} {:.1f} {:.1f} {:.1f}", c.from.x, c.from.y, c.control.x, c.control.y, c.to.x, c.to.y), arc.dimension);
      if (!c.line.both_ways) tip(c.control, c.to, arc.dimension);
      // The end from which the word is read.
      if (c.line.both_ways && !c.line.palindrome) {
        rings += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3.5\" fill=\"#ffffff\" stroke=\"{}\" stroke-width=\"1.5\"/>\n", c.from.x, c.from.y,
                             color_of(arc.dimension));
      }
      for (double const t : {0.0, 0.25, 0.5, 0.75, 1.0}) cover({c.at(t), 2, 2});
    }
  }

  /// Each label on its line, as near to the middle as it covers nothing else.
  void label_curves() {
    for (std::size_t i = 0; i < curves.size(); ++i) {
      double least = std::numeric_limits<double>::max();
      Area best;
      for (int const step : {0, 1, -1, 2, -2, 3, -3, 4, -4}) {
        double const t = 0.5 + 0.07 * step;
        Area const area = label_area(curves[i].at(t), *curves[i].line.arc);
        double cost = std::abs(step);
        for (Area const& other : taken) cost += other.meets(area) ? 100 : 0;
        for (std::size_t j = 0; j < curves.size(); ++j) {
          for (int k = 0; k <= 24 && j != i; ++k) cost += area.contains(curves[j].at(k / 24.0)) ? 20 : 0;
        }
        if (cost >= least) continue;
        least = cost;
        best = area;
      }
      label(best, *curves[i].line.arc);
    }
  }

  // ---- Loops that no decoration says ----

  /// Where the loops of the node go: directions as far as can be from its links and from each other.
  void draw_loops(ir::NodeId id) {
    NodeBox const& box = boxes[id];
    std::vector<Point> away;
    for (Curve const& c : curves) {
      if (c.line.arc->source == id) away.push_back(unit(c.control - box.middle));
      if (c.line.arc->target == id) away.push_back(unit(c.control - box.middle));
    }
    for (RuleLine const& line : side.lines) {
      if (line.arc->source != id || line.arc->target != id) continue;
      static constexpr Point directions[] = {{0, -1}, {0, 1}, {1, 0}, {-1, 0}, {0.8, -0.6}, {-0.8, -0.6}, {0.8, 0.6}, {-0.8, 0.6}};
      Point best = directions[0];
      double least = std::numeric_limits<double>::max();
      for (Point const d : directions) {
        double cost = -1;
        for (Point const other : away) cost = std::max(cost, d.x * other.x + d.y * other.y);
        if (occupied(id, d)) cost += 0.5;
        if (cost > least - 1e-9) continue;
        least = cost;
        best = d;
      }
      away.push_back(best);
      draw_loop(box, best, line);
    }
  }
  bool occupied(ir::NodeId id, Point direction) const {
    double const reach = loop_length / 2 + 8;
    Area const loop{boxes[id].exit(boxes[id].middle + direction) + reach * direction, 10 + reach * std::abs(direction.x), 10 + reach * std::abs(direction.y)};
    return std::any_of(nodes.begin(), nodes.end(), [&](ir::NodeId other) { return other != id && boxes[other].area().meets(loop); });
  }

  void draw_loop(NodeBox const& box, Point direction, RuleLine const& line) {
    Point const aside{-direction.y, direction.x}, root = box.exit(box.middle + direction);
    // Both ends on the rim beside the root, a little inside of it: the box is drawn over them.
    Point const from = root - 8 * aside - 2 * direction, to = root + 8 * aside - 2 * direction;
    Point const out = 1.3 * loop_length * direction;
    Point const first = from + out - 10 * aside, last = to + out + 10 * aside;
    stroke(fmt::format("M{:.1f} {:.1f}C{:.1f} {:.1f} {:.1f} {:.1f} {:.1f} {:.1f}", from.x, from.y, first.x, first.y, last.x, last.y, to.x, to.y),
           line.arc->dimension);
    if (!line.both_ways) tip(last, to + 2 * direction, line.arc->dimension);
    Point const apex = root + 0.95 * loop_length * direction;
    cover({apex, 14, 6});
    Area area = label_area(apex, *line.arc);
    area.middle = area.middle + Point{direction.x * (area.width - 4), direction.y * 6};
    label(area, *line.arc);
  }

  // ---- Nodes ----

  std::string node(ir::NodeId id) const {
    ir::Node const& n = rule.nodes[id];
    NodeBox const& box = boxes[id];
    char const* const fill = n.added() ? added_color : n.deleted() ? deleted_color : "#ffffff";
    auto const outline = [&](double gap, char const* inside) {
      return fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" rx=\"{:.1f}\" fill=\"{}\" stroke=\"{}\" stroke-width=\"1.3\"/>\n",
                         box.middle.x - box.half_width - gap, box.middle.y - box.half_height - gap, 2 * (box.half_width + gap),
                         2 * (box.half_height + gap), box.half_height + gap, inside, ink);
    };
    std::string text = n.hook ? outline(ring_gap, "#ffffff") + outline(0, fill) : outline(0, fill);
    std::string const& decoration = side.decorations[id];
    text += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"13\" font-weight=\"bold\" fill=\"{}\">{}</text>\n", box.middle.x,
                        box.middle.y + (decoration.empty() ? 4.5 : -2), ink, escape(shown(n.name)));
    if (decoration.empty()) return text;
    return text + fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" fill=\"{}\">{}</text>\n", box.middle.x, box.middle.y + 12, ink, escape(decoration));
  }

  /// The graph, its middle at the origin.
  std::string draw() {
    for (ir::NodeId const id : nodes) {
      taken.push_back(boxes[id].area());
      cover(boxes[id].area());
    }
    add_curves();
    draw_curves();
    for (ir::NodeId const id : nodes) draw_loops(id);
    label_curves();
    std::string text = links;
    for (ir::NodeId const id : nodes) text += node(id);
    if (nodes.empty()) {
      cover({{0, 0}, 16, 16});
      text += fmt::format("<text x=\"0\" y=\"8\" font-size=\"24\" fill=\"{}\">∅</text>\n", ink);
    }
    return text + rings + labels;
  }
};

/// The nodes' boxes, each at one place for both sides.
std::vector<NodeBox> place(ir::RuleScheme const& rule, DecoratedSide const& left, DecoratedSide const& right) {
  std::vector<GridNode> nodes;
  for (ir::Node const& node : rule.nodes) nodes.push_back({(node.added() ? 0 : left_side) | (node.deleted() ? 0 : right_side), 0});
  std::map<std::pair<std::size_t, std::size_t>, Sides> pairs;
  std::vector<GridLink> links;
  std::size_t longest = 0;
  for (Sides const side : {left_side, right_side}) {
    for (RuleLine const& line : (side == left_side ? left : right).lines) {
      ir::Arc const& arc = *line.arc;
      longest = std::max(longest, arc_label(arc).size());
      if (arc.source == arc.target) {
        nodes[arc.source].loops |= side;
        continue;
      }
      auto const same = std::find_if(links.begin(), links.end(), [&](GridLink const& link) {
        return std::minmax<std::size_t>(link.from, link.to) == std::minmax<std::size_t>(arc.source, arc.target);
      });
      if (same != links.end()) {
        same->sides |= side;
      } else {
        links.push_back({arc.source, arc.target, side});
      }
    }
  }
  std::vector<Cell> const cells = grid_layout(nodes, links);
  std::vector<NodeBox> boxes;
  double widest = 0;
  bool const decorated = !rule.hook_type.empty();
  for (ir::NodeId id = 0; id < rule.nodes.size(); ++id) {
    double const name = width_of(shown(rule.nodes[id].name).size(), name_letter);
    double const text = small_letter * static_cast<double>(std::max(left.decorations[id].size(), right.decorations[id].size()));
    double const half_height = decorated ? 19 : 14;
    boxes.push_back({{}, std::max({half_height, name / 2 + 10, text / 2 + 10}), half_height, rule.nodes[id].hook.has_value()});
    widest = std::max(widest, boxes.back().half_width);
  }
  double const across = 2 * widest + std::max(46.0, small_letter * static_cast<double>(std::min<std::size_t>(longest, 12)) + 42);
  double const down = decorated ? 92 : 82;
  for (ir::NodeId id = 0; id < boxes.size(); ++id) boxes[id].middle = {across * cells[id].column, down * cells[id].row};
  return boxes;
}

}  // namespace

std::string rule_svg(ir::RuleScheme const& rule) {
  algebra::Group const group(rule.model());
  DecoratedSide left = decorated_side(rule, group, true), right = decorated_side(rule, group, false);
  std::vector<NodeBox> const boxes = place(rule, left, right);
  std::vector<ir::NodeId> left_nodes, right_nodes;
  for (ir::NodeId id = 0; id < rule.nodes.size(); ++id) {
    if (!rule.nodes[id].added()) left_nodes.push_back(id);
    if (!rule.nodes[id].deleted()) right_nodes.push_back(id);
  }
  Panel panels[] = {{rule, boxes, left_nodes, std::move(left)}, {rule, boxes, right_nodes, std::move(right)}};
  std::string graphs[2];
  double height = 0;
  for (std::size_t i = 0; i < 2; ++i) {
    graphs[i] = panels[i].draw();
    height = std::max(height, panels[i].high.y - panels[i].low.y);
  }
  height = std::ceil(height + 2 * panel_margin);
  double x = 1;
  std::string body;
  for (std::size_t i = 0; i < 2; ++i) {
    Panel const& panel = panels[i];
    double const width = std::ceil(panel.high.x - panel.low.x + 2 * panel_margin);
    body += fmt::format("<rect x=\"{:.1f}\" y=\"1\" width=\"{:.1f}\" height=\"{:.1f}\" rx=\"8\" fill=\"#ffffff\" stroke=\"#bdbdbd\"/>\n", x, width, height);
    body += fmt::format("<g transform=\"translate({:.1f} {:.1f})\">\n{}</g>\n", x + panel_margin - panel.low.x,
                        1 + height / 2 - (panel.low.y + panel.high.y) / 2, graphs[i]);
    x += width;
    if (i == 1) break;
    body += fmt::format("<path d=\"M{:.1f} {:.1f}h{:.1f}m-8 -6l8 6l-8 6\" fill=\"none\" stroke=\"{}\" stroke-width=\"2\"/>\n", x + 12, 1 + height / 2,
                        arrow_width - 24, ink);
    x += arrow_width;
  }
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" viewBox=\"0 0 {0:.0f} {1:.0f}\" font-family=\"{2}\" "
      "font-size=\"11\" text-anchor=\"middle\">\n<title>{3} on {4}: its left and its right side</title>\n{5}</svg>\n",
      x + 1, height + 2, font, escape(rule.name), escape(rule.modeler->name), body);
}

}  // namespace jrule::draw
