// OpenMesh's PolyMesh_ArrayKernelT, a halfedge data structure in arrays.
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Dualizer/meshDualT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/CatmullClarkT.hh>
#include <OpenMesh/Tools/Utils/MeshCheckerT.hh>
#include <sstream>

#include "tests/bench/peers/own.h"

namespace jrule::bench {

namespace {

struct Doubles : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};
using Mesh = OpenMesh::PolyMesh_ArrayKernelT<Doubles>;

char const* const name = "OpenMesh";

Mesh make(Surface const& s) {
  Mesh mesh;
  for (Point3 const& p : s.points) mesh.add_vertex({p.x, p.y, p.z});
  std::vector<Mesh::VertexHandle> corners;
  for (std::size_t f = 0; f < s.face_count(); ++f) {
    corners.clear();
    for (std::uint32_t c = s.first[f]; c < s.first[f + 1]; ++c) corners.emplace_back(static_cast<int>(s.vertex[c]));
    if (!mesh.add_face(corners).is_valid()) throw std::runtime_error("OpenMesh refuses a face");
  }
  return mesh;
}

Counts count(Mesh const& mesh, Row const&) {
  return {mesh.n_halfedges(), std::array<std::size_t, 4>{mesh.n_vertices(), mesh.n_edges(), mesh.n_faces(), 0}};
}

Mesh::Point const origin(0, 0, 0);

void split_edges(Mesh& mesh, bool with_points) {
  int const count = static_cast<int>(mesh.n_edges());
  for (int e = 0; e < count; ++e) {
    Mesh::EdgeHandle const edge(e);
    mesh.split_edge(edge, mesh.add_vertex(with_points ? mesh.calc_edge_midpoint(edge) : origin));
  }
}

void subdivide(Mesh& mesh, bool with_points) {
  int const faces = static_cast<int>(mesh.n_faces()), corners = static_cast<int>(mesh.n_vertices());
  std::vector<Mesh::Point> centres;
  for (int f = 0; with_points && f < faces; ++f) centres.push_back(mesh.calc_face_centroid(Mesh::FaceHandle(f)));
  split_edges(mesh, with_points);
  std::vector<Mesh::HalfedgeHandle> middles;  // that lead to the middle of a side
  for (int f = 0; f < faces; ++f) {
    middles.clear();
    Mesh::HalfedgeHandle const start = mesh.halfedge_handle(Mesh::FaceHandle(f));
    Mesh::HalfedgeHandle h = start;
    do {
      if (mesh.to_vertex_handle(h).idx() >= corners) middles.push_back(h);
      h = mesh.next_halfedge_handle(h);
    } while (h != start);
    // An edge from the second middle to the first, its middle becomes the centre; from each further middle one to
    // there.
    Mesh::HalfedgeHandle const cut = mesh.insert_edge(middles[1], mesh.next_halfedge_handle(middles[0]));
    mesh.split_edge(mesh.edge_handle(cut),
                    mesh.add_vertex(with_points ? centres[static_cast<std::size_t>(f)] : origin));
    Mesh::HalfedgeHandle const to_centre = mesh.next_halfedge_handle(middles[0]);
    for (std::size_t k = 2; k < middles.size(); ++k) mesh.insert_edge(middles[k], mesh.next_halfedge_handle(to_centre));
  }
}

void triangulate(Mesh& mesh, Mesh::FaceHandle f) { mesh.split(f, mesh.calc_face_centroid(f)); }

struct Sampled {
  Mesh mesh;
  std::vector<Mesh::FaceHandle> faces;
};

}  // namespace

void enter_openmesh(Contest& contest) {
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
    OpenMesh::Subdivider::Uniform::CatmullClarkT<Mesh, double> subdivider;
    subdivider.attach(mesh);
    bool const done = subdivider(1);
    subdivider.detach();
    if (!done) throw std::runtime_error("OpenMesh does not subdivide");
  });
  enter(Work::triangulate, [](Mesh& mesh) {
    int const faces = static_cast<int>(mesh.n_faces());
    for (int f = 0; f < faces; ++f) triangulate(mesh, Mesh::FaceHandle(f));
  });
  enter(Work::edge_vertices, [](Mesh& mesh) { split_edges(mesh, true); });
  enter(Work::check, [](Mesh& mesh) {
    std::ostringstream faults;
    if (!OpenMesh::Utils::MeshCheckerT<Mesh>(mesh).check(OpenMesh::Utils::MeshCheckerT<Mesh>::CHECK_ALL, faults)) {
      throw std::runtime_error(faults.str());
    }
  });
  contest.enter(
      name, 2, Work::dual, prepare, [](Mesh& mesh) { return std::unique_ptr<Mesh>(OpenMesh::Util::MeshDual(mesh)); },
      [](std::unique_ptr<Mesh> const& mesh, Row const& row) { return count(*mesh, row); });
  contest.enter(
      name, 2, Work::single_faces,
      [prepare](Row const& row) {
        Sampled sampled{prepare(row), {}};
        for (std::uint32_t const f : sample_faces(*row.surface, single_face_count + 1)) {
          sampled.faces.emplace_back(static_cast<int>(f));
        }
        triangulate(sampled.mesh, sampled.faces.back());
        sampled.faces.pop_back();
        return sampled;
      },
      [](Sampled& sampled) -> Sampled& {
        for (auto const f : sampled.faces) triangulate(sampled.mesh, f);
        return sampled;
      },
      [](Sampled const& sampled, Row const& row) { return count(sampled.mesh, row); });
}

}  // namespace jrule::bench
