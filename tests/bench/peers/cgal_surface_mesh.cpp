// CGAL's Surface_mesh, a halfedge data structure in arrays.
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Dual.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/subdivision_method_3.h>

#include <utility>

#include "tests/bench/peers/own.h"

namespace jrule::bench {

namespace {

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
namespace euler = CGAL::Euler;

char const* const name = "Surface_mesh";

Mesh make(Surface const& s) {
  Mesh mesh;
  for (Point3 const& p : s.points) mesh.add_vertex(Point(p.x, p.y, p.z));
  std::vector<Mesh::Vertex_index> corners;
  for (std::size_t f = 0; f < s.face_count(); ++f) {
    corners.clear();
    for (std::uint32_t c = s.first[f]; c < s.first[f + 1]; ++c) corners.emplace_back(s.vertex[c]);
    if (mesh.add_face(corners) == Mesh::null_face()) throw std::runtime_error("Surface_mesh refuses a face");
  }
  return mesh;
}

Counts count(Mesh const& mesh, Row const&) {
  return {mesh.number_of_halfedges(),
          std::array<std::size_t, 4>{mesh.number_of_vertices(), mesh.number_of_edges(), mesh.number_of_faces(), 0}};
}

Point centre(Mesh const& mesh, Mesh::Face_index f) {
  double x = 0, y = 0, z = 0, n = 0;
  for (auto const v : mesh.vertices_around_face(mesh.halfedge(f))) {
    Point const& p = mesh.point(v);
    x += p.x(), y += p.y(), z += p.z(), ++n;
  }
  return {x / n, y / n, z / n};
}

void split_edges(Mesh& mesh, bool with_points) {
  auto const count = static_cast<std::uint32_t>(mesh.number_of_edges());
  for (std::uint32_t e = 0; e < count; ++e) {
    auto const h = mesh.halfedge(Mesh::Edge_index(e));
    Point const middle = with_points ? CGAL::midpoint(mesh.point(mesh.source(h)), mesh.point(mesh.target(h))) : Point();
    auto const made = euler::split_edge(h, mesh);
    if (with_points) mesh.point(mesh.target(made)) = middle;
  }
}

void subdivide(Mesh& mesh, bool with_points) {
  auto const faces = static_cast<std::uint32_t>(mesh.number_of_faces());
  std::size_t const corners = mesh.number_of_vertices();
  std::vector<Point> centres;
  for (std::uint32_t f = 0; with_points && f < faces; ++f) centres.push_back(centre(mesh, Mesh::Face_index(f)));
  split_edges(mesh, with_points);
  std::vector<Mesh::Halfedge_index> middles;  // that lead to the middle of a side
  for (std::uint32_t f = 0; f < faces; ++f) {
    middles.clear();
    for (auto const h : mesh.halfedges_around_face(mesh.halfedge(Mesh::Face_index(f)))) {
      if (mesh.target(h) >= Mesh::Vertex_index(static_cast<std::uint32_t>(corners))) middles.push_back(h);
    }
    // An edge from the first middle to the second, its middle becomes the centre; from there one to each further
    // middle.
    auto const to_centre = euler::split_edge(euler::split_face(middles[0], middles[1], mesh), mesh);
    for (std::size_t k = 2; k < middles.size(); ++k) euler::split_face(to_centre, middles[k], mesh);
    if (with_points) mesh.point(mesh.target(to_centre)) = centres[f];
  }
}

void triangulate(Mesh& mesh, Mesh::Face_index f) {
  Point const p = centre(mesh, f);
  mesh.point(mesh.target(euler::add_center_vertex(mesh.halfedge(f), mesh))) = p;
}

/// Of the dual graph's vertices, which are the faces of the mesh.
struct Centres {
  using key_type = Mesh::Face_index;
  using value_type = Point;
  using reference = Point;
  using category = boost::readable_property_map_tag;
  Mesh const* mesh;
  friend Point get(Centres const& centres, Mesh::Face_index f) { return centre(*centres.mesh, f); }
};

Mesh dual(Mesh& mesh) {
  Mesh result;
  CGAL::copy_face_graph(CGAL::Dual<Mesh>(mesh), result, CGAL::parameters::vertex_point_map(Centres{&mesh}));
  return result;
}

struct Sampled {
  Mesh mesh;
  std::vector<Mesh::Face_index> faces;
};

}  // namespace

void enter_cgal_surface_mesh(Contest& contest) {
  Originals<Mesh> const originals;
  auto const prepare = [originals](Row const& row) {
    return Mesh(originals(row.mesh, [&] { return make(*row.surface); }));
  };
  auto const enter = [&](Work work, auto run) {
    contest.enter(
        name, 2, work, prepare, [run](Mesh& mesh) -> Mesh& { return run(mesh), mesh; }, count);
  };
  enter(Work::quad, [](Mesh& mesh) { subdivide(mesh, false); });
  enter(Work::quad_positions, [](Mesh& mesh) { subdivide(mesh, true); });
  enter(Work::catmull_clark, [](Mesh& mesh) {
    CGAL::Subdivision_method_3::CatmullClark_subdivision(mesh, CGAL::parameters::number_of_iterations(1));
  });
  enter(Work::triangulate, [](Mesh& mesh) {
    auto const faces = static_cast<std::uint32_t>(mesh.number_of_faces());
    for (std::uint32_t f = 0; f < faces; ++f) triangulate(mesh, Mesh::Face_index(f));
  });
  enter(Work::edge_vertices, [](Mesh& mesh) { split_edges(mesh, true); });
  enter(Work::check, [](Mesh& mesh) {
    if (!mesh.is_valid(false)) throw std::runtime_error("Surface_mesh is not valid");
  });
  contest.enter(
      name, 2, Work::dual, prepare, [](Mesh& mesh) { return dual(mesh); }, count);
  contest.enter(
      name, 2, Work::single_faces,
      [prepare](Row const& row) {
        Sampled sampled{prepare(row), {}};
        for (std::uint32_t const f : sample_faces(*row.surface, single_face_count + 1)) sampled.faces.emplace_back(f);
        triangulate(sampled.mesh, sampled.faces.back());
        sampled.faces.pop_back();
        return sampled;
      },
      [](Sampled& sampled) -> Sampled& {
        for (auto const f : sampled.faces) triangulate(sampled.mesh, f);
        return sampled;
      },
      [](Sampled& sampled, Row const& row) { return count(sampled.mesh, row); });
}

}  // namespace jrule::bench
