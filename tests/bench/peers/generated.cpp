// Generated C++ on G-maps and O-maps: each rule at all orbits of its hook at once.
#include "subdivision.h"
#include "surface.h"
#include "tests/bench/peers/own.h"
#include "topology.h"

namespace jrule::bench {

Counts count_cells(Map const& map, Row const& row) {
  Counts counts{map.dart_count()};
  if (!row.count_cells) return counts;
  counts.cells.emplace();
  for (int i = 0; i <= map.model().dimension; ++i) (*counts.cells)[static_cast<std::size_t>(i)] = cells(map, i).size();
  return counts;
}

namespace {

/// One column: a modeler, and how its rules are applied: on how many threads.
template <class Modeler>
class Column {
 public:
  Column(Contest& contest, std::string name, Threads threads)
      : contest_(contest), name_(std::move(name)), threads_(threads) {}

  template <class Rule>
  void enter(Work work, Rule rule) const {
    contest_.enter(
        name_, darts_per_edge, work, [originals = originals_](Row const& row) { return fresh(originals, row); },
        [rule, threads = threads_](Modeler& mesh) -> Modeler& {
          expect(rule(mesh, threads));
          return mesh;
        },
        [](Modeler const& mesh, Row const& row) { return count_cells(mesh.map(), row); });
  }

  void enter_check() const {
    contest_.enter(
        name_, darts_per_edge, Work::check, [originals = originals_](Row const& row) { return fresh(originals, row); },
        [](Modeler& mesh) -> Modeler& {
          if (auto const violation = find_violation(mesh.map())) throw std::runtime_error(violation->text);
          return mesh;
        },
        [](Modeler const& mesh, Row const& row) { return count_cells(mesh.map(), row); });
  }

  /// The rule at the faces of a sample in turn.
  template <class Rule>
  void enter_single_faces(Work work, Rule rule) const {
    struct Sampled {
      Modeler mesh;
      std::vector<Dart> at;
    };
    contest_.enter(
        name_, darts_per_edge, work,
        [originals = originals_, rule](Row const& row) {
          Sampled sampled{fresh(originals, row), {}};
          for (std::uint32_t const f : sample_faces(*row.surface, single_face_count + 1)) {
            sampled.at.push_back(row.surface->first[f] * static_cast<Dart>(darts_per_edge / 2));
          }
          expect(rule(sampled.mesh, sampled.at.back()));
          sampled.at.pop_back();
          return sampled;
        },
        [rule](Sampled& sampled) -> Sampled& {
          for (Dart const d : sampled.at) expect(rule(sampled.mesh, d));
          return sampled;
        },
        [](Sampled const& sampled, Row const& row) { return count_cells(sampled.mesh.map(), row); });
  }

 private:
  static constexpr bool is_gmap = std::is_same_v<Modeler, mesh::Mesh> || std::is_same_v<Modeler, topology::Surface>;
  static constexpr int darts_per_edge = is_gmap ? 4 : 2;

  static Modeler fresh(Originals<Map> const& originals, Row const& row) {
    auto const make = [&] { return map_of(*row.surface, Modeler::model(), Modeler::embeddings()); };
    auto mesh = Modeler::from_map(originals(row.mesh, make));
    expect(mesh);
    return std::move(*mesh);
  }

  Contest& contest_;
  std::string name_;
  Threads threads_;
  Originals<Map> originals_;
};

}  // namespace

// Functions as values that templates take: at all orbits, at one.
#define RULE(FUNCTION) [](auto& mesh, Threads given) { return FUNCTION##_everywhere(mesh, given); }
#define AT_ONE(FUNCTION) [](auto& mesh, Dart d) { return FUNCTION(mesh, d); }

namespace {

Column<mesh::Mesh> enter_gmap(Contest& contest, std::string const& name, Threads threads) {
  Column<topology::Surface>(contest, name, threads).enter(Work::quad, RULE(topology::quad));
  Column<mesh::Mesh> column(contest, name, threads);
  column.enter(Work::quad_positions, RULE(surface::quad));
  column.enter(Work::catmull_clark, RULE(subdivision::catmull_clark));
  column.enter(Work::triangulate, RULE(surface::triangulate));
  column.enter(Work::edge_vertices, RULE(surface::edge_vertices));
  column.enter(Work::dual, RULE(surface::dual));
  return column;
}

Column<mesh::HalfedgeMesh> enter_omap(Contest& contest, std::string const& name, Threads threads) {
  Column<topology::Halfedges>(contest, name, threads).enter(Work::quad, RULE(topology::quad_halfedges));
  Column<mesh::HalfedgeMesh> column(contest, name, threads);
  column.enter(Work::quad_positions, RULE(surface::quad_halfedges));
  column.enter(Work::catmull_clark, RULE(subdivision::catmull_clark_halfedges));
  column.enter(Work::triangulate, RULE(surface::triangulate_halfedges));
  column.enter(Work::edge_vertices, RULE(surface::edge_vertices_halfedges));
  column.enter(Work::dual, RULE(surface::dual_halfedges));
  return column;
}

}  // namespace

void enter_generated(Contest& contest) {
  Column<mesh::Mesh> const gmap = enter_gmap(contest, ours, {1});
  gmap.enter_check();
  gmap.enter_single_faces(Work::single_faces, AT_ONE(surface::triangulate_face));
  Column<topology::Surface>(contest, ours, {1}).enter_single_faces(Work::single_faces_topology, AT_ONE(topology::triangulate_face));
  enter_gmap(contest, "G, 2 threads", {2});

  Column<mesh::HalfedgeMesh> const omap = enter_omap(contest, "O-map", {1});
  omap.enter_check();
  omap.enter_single_faces(Work::single_faces, AT_ONE(surface::triangulate_face_halfedges));
  Column<topology::Halfedges>(contest, "O-map", {1})
      .enter_single_faces(Work::single_faces_topology, AT_ONE(topology::triangulate_face_halfedges));
  enter_omap(contest, "O, 2 threads", {2});
}

#undef RULE
#undef AT_ONE

}  // namespace jrule::bench
