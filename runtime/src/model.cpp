#include "jrule/model.h"

#include <algorithm>
#include <cassert>

namespace jrule {

namespace {

/// The pairs that generalized and oriented maps exchange: i + 2 <= j.
std::vector<std::pair<int, int>> distant_pairs(std::vector<int> const& dimensions) {
  std::vector<std::pair<int, int>> pairs;
  for (int i : dimensions) {
    for (int j : dimensions) {
      if (i + 2 <= j) pairs.emplace_back(i, j);
    }
  }
  return pairs;
}

Model standard_model(std::string name, int first, int n) {
  assert(first <= n && n <= max_dimension);
  Model model;
  model.name = std::move(name);
  model.dimension = n;
  for (int d = first; d <= n; ++d) model.dimensions.push_back(d);
  model.exchange = distant_pairs(model.dimensions);
  return model;
}

std::uint16_t bit(int d) { return static_cast<std::uint16_t>(1U << d); }

/// D = 1..n with one oriented dimension: the shape of O-maps and of their duals.
bool is_oriented_by(Model const& model, int d) {
  auto const& dims = model.dimensions;
  return !dims.empty() && dims.front() == 1 && dims.back() == model.dimension &&
         static_cast<int>(dims.size()) == model.dimension && model.oriented == bit(d);
}

OrbitType all_but(Model const& model, int removed) {
  auto dims = model.dimensions;
  std::erase(dims, removed);
  return orbit_of_dimensions(dims);
}

Letter letter(int d) { return {static_cast<std::uint8_t>(d), false}; }

}  // namespace

bool Model::has(int d) const noexcept { return column(d) >= 0; }

bool Model::exchanges(int i, int j) const noexcept {
  std::pair<int, int> const pair = std::minmax(i, j);
  return std::find(exchange.begin(), exchange.end(), pair) != exchange.end();
}

int Model::column(int d) const noexcept {
  auto const found = std::find(dimensions.begin(), dimensions.end(), d);
  return found == dimensions.end() ? -1 : static_cast<int>(found - dimensions.begin());
}

Model gmap(int n) { return standard_model("gmap", 0, n); }

Model omap(int n) {
  Model model = standard_model("omap", 1, n);
  model.oriented = bit(1);
  return model;
}

Model dual_omap(int n) {
  Model model = standard_model("dual_omap", 1, n);
  model.oriented = bit(n);
  return model;
}

Model closed_gmap(int n) {
  Model model = standard_model("closed_gmap", 0, n);
  model.closed = true;
  return model;
}

std::optional<Model> builtin_model(std::string const& name, int n) {
  if (n < 0 || n > max_dimension) return std::nullopt;
  if (name == "gmap") return gmap(n);
  if (name == "closed_gmap") return closed_gmap(n);
  if (n == 0) return std::nullopt;  // D = 1..n would be empty
  if (name == "omap") return omap(n);
  if (name == "dual_omap") return dual_omap(n);
  return std::nullopt;
}

std::optional<OrbitType> cell_orbit(Model const& model, int i) {
  int const n = model.dimension;
  if (is_oriented_by(model, 1)) {
    if (i < 0 || i > n) return std::nullopt;
    if (i > 0) return all_but(model, i);
    // A dart of an O-map starts at its vertex: turning to the next dart there is a step j, then a step i < j. A 1-map
    // has no such words: each dart is its own vertex.
    OrbitType vertex;
    for (int a = 1; a <= n; ++a) {
      for (int b = a + 1; b <= n; ++b) vertex.words.push_back({letter(b), letter(a)});
    }
    return vertex;
  }
  if (is_oriented_by(model, n)) {
    // The dual of an O-map: its dimension d is n + 1 - d there, and its i-cells are the (n-i)-cells.
    if (i < 0 || i > n) return std::nullopt;
    if (i < n) return all_but(model, i + 1);
    OrbitType cell;
    for (int a = 1; a <= n; ++a) {
      for (int b = a + 1; b <= n; ++b) cell.words.push_back({letter(a), letter(b)});
    }
    return cell;
  }
  if (!model.has(i)) return std::nullopt;
  return all_but(model, i);
}

OrbitType component_orbit(Model const& model) { return orbit_of_dimensions(model.dimensions); }

}  // namespace jrule
