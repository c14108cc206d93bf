#include "compiler/backend/draw/graph_layout.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace jrule::draw {

namespace {

/// Depth first, so that the darts of a cycle follow each other.
std::vector<Dart> reached_order(std::size_t count, std::vector<std::pair<Dart, Dart>> const& links) {
  std::vector<std::vector<Dart>> near(count);
  for (auto const& [a, b] : links) {
    near[a].push_back(b);
    near[b].push_back(a);
  }
  std::vector<bool> seen(count, false);
  std::vector<Dart> order;
  auto const visit = [&](auto const& self, Dart d) -> void {
    if (seen[d]) return;
    seen[d] = true;
    order.push_back(d);
    for (Dart const next : near[d]) self(self, next);
  };
  for (Dart d = 0; d < count; ++d) visit(visit, d);
  return order;
}

}  // namespace

std::vector<Position> spring_layout(std::size_t count, std::vector<std::pair<Dart, Dart>> const& links) {
  std::vector<Position> at(count);
  if (count < 2) return at;
  std::vector<Dart> const order = reached_order(count, links);
  auto const n = static_cast<double>(count);
  double const radius = n / (2 * std::numbers::pi) + 0.3;
  for (std::size_t k = 0; k < count; ++k) {
    double const angle = 2 * std::numbers::pi * static_cast<double>(k) / n - std::numbers::pi / 2;
    at[order[k]] = {radius * std::cos(angle), radius * std::sin(angle)};
  }
  std::size_t const steps = std::min<std::size_t>(300, 20'000'000 / (count * count) + 1);
  std::vector<Position> force(count);
  for (std::size_t step = 0; step < steps; ++step) {
    std::fill(force.begin(), force.end(), Position{});
    for (std::size_t a = 0; a < count; ++a) {
      for (std::size_t b = a + 1; b < count; ++b) {
        double const dx = at[a].x - at[b].x, dy = at[a].y - at[b].y;
        double const square = std::max(dx * dx + dy * dy, 1e-4);
        force[a].x += dx / square;
        force[a].y += dy / square;
        force[b].x -= dx / square;
        force[b].y -= dy / square;
      }
      // A pull to the middle keeps components together.
      force[a].x -= 0.5 * at[a].x;
      force[a].y -= 0.5 * at[a].y;
    }
    for (auto const& [a, b] : links) {
      double const dx = at[a].x - at[b].x, dy = at[a].y - at[b].y;
      double const length = std::hypot(dx, dy);
      force[a].x -= dx * length;
      force[a].y -= dy * length;
      force[b].x += dx * length;
      force[b].y += dy * length;
    }
    double const longest = 0.3 * (1 - static_cast<double>(step) / static_cast<double>(steps));
    for (std::size_t d = 0; d < count; ++d) {
      double const length = std::hypot(force[d].x, force[d].y);
      if (length < 1e-9) continue;
      double const move = std::min(length, longest) / length;
      at[d].x += force[d].x * move;
      at[d].y += force[d].y * move;
    }
  }
  return at;
}

}  // namespace jrule::draw
