#include "tests/smoothing/peers.h"

#ifdef JRULE_WITH_OPENMESH

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/LoopT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/Sqrt3T.hh>
#include <stdexcept>

namespace jrule::test {

namespace {

struct Doubles : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};
using Mesh = OpenMesh::TriMesh_ArrayKernelT<Doubles>;
namespace uniform = OpenMesh::Subdivider::Uniform;

std::size_t number(OpenMesh::BaseHandle handle) { return static_cast<std::size_t>(handle.idx()); }

Mesh mesh_of(Polygons const& polygons) {
  Mesh mesh;
  std::vector<Mesh::VertexHandle> handles;
  for (Point3 const& p : polygons.points) handles.push_back(mesh.add_vertex({p.x, p.y, p.z}));
  for (Vertices const& face : polygons.faces) {
    std::vector<Mesh::VertexHandle> corners;
    for (std::size_t const v : face) corners.push_back(handles[v]);
    if (corners.size() != 3 || !mesh.add_face(corners).is_valid())
      throw std::runtime_error("OpenMesh refuses the mesh");
  }
  return mesh;
}

Vertices corners(Mesh const& mesh, Mesh::FaceHandle face) {
  Vertices result;
  for (auto const v : mesh.fv_range(face)) result.push_back(number(v));
  return result;
}

// LoopT and Sqrt3T keep the numbers of the vertices, and then add one for each edge, or face, in the order of their
// numbers.
Refinement descent(Mesh const& mesh, Scheme scheme) {
  Refinement result;
  std::size_t const old = mesh.n_vertices();
  for (std::size_t v = 0; v < old; ++v) result.of_vertex.push_back(v);
  if (scheme == Scheme::loop) {
    for (auto const e : mesh.edges()) {
      auto const h = mesh.halfedge_handle(e, 0);
      result.of_edge[ascending({number(mesh.from_vertex_handle(h)), number(mesh.to_vertex_handle(h))})] =
          old + number(e);
    }
  } else {
    for (auto const f : mesh.faces()) result.of_face[ascending(corners(mesh, f))] = old + number(f);
  }
  return result;
}

template <class Subdivider>
void refine(Mesh& mesh) {
  Subdivider subdivider;
  subdivider.attach(mesh);
  bool const done = subdivider(1);
  subdivider.detach();
  if (!done) throw std::runtime_error("OpenMesh does not refine the mesh");
}

}  // namespace

std::optional<std::vector<Refinement>> refine_by_openmesh(Polygons const& polygons, Scheme scheme, int levels) {
  if (scheme == Scheme::catmull_clark) throw std::invalid_argument("OpenMesh is asked for loop and sqrt3 only");
  Mesh mesh = mesh_of(polygons);
  std::vector<Refinement> result;
  for (int l = 1; l <= levels; ++l) {
    Refinement& refinement = result.emplace_back(descent(mesh, scheme));
    if (scheme == Scheme::loop) {
      refine<uniform::LoopT<Mesh, double>>(mesh);
    } else {
      refine<uniform::Sqrt3T<Mesh, double>>(mesh);
    }
    for (auto const v : mesh.vertices()) {
      auto const& p = mesh.point(v);
      refinement.mesh.points.push_back({p[0], p[1], p[2]});
    }
    for (auto const f : mesh.faces()) refinement.mesh.faces.push_back(corners(mesh, f));
  }
  return result;
}

}  // namespace jrule::test

#else

namespace jrule::test {

std::optional<std::vector<Refinement>> refine_by_openmesh(Polygons const&, Scheme, int) { return {}; }

}  // namespace jrule::test

#endif
