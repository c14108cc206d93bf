#include "tests/property/models.h"

#include <cstdint>

namespace jrule::property {

namespace {

Model custom(std::string name, std::vector<int> dimensions, std::uint16_t oriented,
             std::vector<std::pair<int, int>> exchange, bool closed = false) {
  Model model;
  model.name = std::move(name);
  model.dimension = dimensions.back();
  model.dimensions = std::move(dimensions);
  model.oriented = oriented;
  model.exchange = std::move(exchange);
  model.closed = closed;
  return model;
}

constexpr std::uint16_t bits(int a, int b) { return static_cast<std::uint16_t>((1U << a) | (1U << b)); }

}  // namespace

std::vector<Model> const& models() {
  static std::vector<Model> const all{
      gmap(2), gmap(3), omap(2), omap(3), closed_gmap(2), dual_omap(3), gmap(1), omap(4), closed_gmap(3), gmap(4),
      dual_omap(2), closed_gmap(1), omap(1), gmap(0),
      // Every pair of three involutions commutes.
      custom("cube", {0, 1, 2}, 0, {{0, 1}, {0, 2}, {1, 2}}),
      // The exchangeable pairs of theory.md, section 1.
      custom("path", {0, 1, 2}, 0, {{0, 1}, {1, 2}}),
      // Two oriented dimensions, each exchangeable with a non-oriented one.
      custom("two_oriented", {1, 2, 3, 5}, bits(1, 5), {{1, 3}, {2, 5}, {3, 5}}),
      // Two oriented dimensions that are exchangeable (paper, Fig. 28), one of them with a third.
      custom("oriented_exchange", {0, 1, 2}, bits(0, 1), {{0, 1}, {1, 2}}),
      // Oriented and closed, with a gap between its dimensions.
      custom("closed_oriented", {1, 4, 7}, static_cast<std::uint16_t>(1U << 4), {{1, 7}, {4, 7}}, true)};
  return all;
}

std::shared_ptr<ir::Modeler const> bare(Model const& model) {
  auto modeler = std::make_shared<ir::Modeler>();
  modeler->name = model.name;
  modeler->model = model;
  return modeler;
}

namespace {

/// How a modeler declares its k-th embedding, apart from the name and the orbit.
using Declare = EmbeddingSpec (*)(std::size_t k);

std::shared_ptr<ir::Modeler const> with_embeddings(Model const& model, Declare declare) {
  auto modeler = std::make_shared<ir::Modeler>(*bare(model));
  auto const add = [&](std::string name, OrbitType orbit) {
    EmbeddingSpec spec = declare(modeler->embeddings.size());
    spec.name = std::move(name);
    spec.orbit = std::move(orbit);
    modeler->embeddings.push_back(std::move(spec));
    modeler->embedding_docs.emplace_back();
    modeler->embedding_spans.emplace_back();
  };
  for (int i = 0; i <= model.dimension; ++i) {
    if (auto const orbit = cell_orbit(model, i)) add("cell" + std::to_string(i), *orbit);
  }
  add("dart", orbit_of_dimensions({}));
  for (int const i : model.dimensions) add("arc" + std::to_string(i), orbit_of_dimensions({i}));
  add("component", component_orbit(model));
  if (model.dimensions.size() > 1) {
    auto const first = static_cast<std::uint8_t>(model.dimensions[0]),
               last = static_cast<std::uint8_t>(model.dimensions.back());
    add("there_and_on", OrbitType{{{{first, false}, {last, false}}}});
  }
  return modeler;
}

EmbeddingSpec integer(MergePolicy merge) { return {"", {}, Type::Int, Value(std::int64_t{-1}), merge}; }

}  // namespace

std::shared_ptr<ir::Modeler const> embedded(Model const& model) {
  return with_embeddings(model, [](std::size_t) { return integer(MergePolicy::first); });
}

std::shared_ptr<ir::Modeler const> merging(Model const& model) {
  return with_embeddings(model, [](std::size_t k) {
    switch (k % 5) {
      case 0: return EmbeddingSpec{"", {}, Type::Real, Value(-1.0), MergePolicy::mean};
      case 1: return integer(MergePolicy::min);
      case 2: return integer(MergePolicy::max);
      case 3: return integer(MergePolicy::first);
      default: return integer(MergePolicy::none);
    }
  });
}

}  // namespace jrule::property
