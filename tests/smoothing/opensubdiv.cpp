#include "tests/smoothing/peers.h"

#ifdef JRULE_WITH_OPENSUBDIV

#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/far/topologyDescriptor.h>
#include <opensubdiv/far/topologyRefinerFactory.h>

#include <memory>
#include <stdexcept>

#include "tests/smoothing/mixed.h"

namespace jrule::test {

namespace {

namespace far = OpenSubdiv::Far;
namespace sdc = OpenSubdiv::Sdc;

std::unique_ptr<far::TopologyRefiner> refiner_of(Polygons const& mesh, Scheme scheme, Border border) {
  std::vector<int> degrees, corners;
  for (Vertices const& face : mesh.faces) {
    degrees.push_back(static_cast<int>(face.size()));
    for (std::size_t const v : face) corners.push_back(static_cast<int>(v));
  }
  far::TopologyDescriptor descriptor;
  descriptor.numVertices = static_cast<int>(mesh.points.size());
  descriptor.numFaces = static_cast<int>(mesh.faces.size());
  descriptor.numVertsPerFace = degrees.data();
  descriptor.vertIndicesPerFace = corners.data();
  sdc::Options options;
  options.SetVtxBoundaryInterpolation(border == Border::edges ? sdc::Options::VTX_BOUNDARY_EDGE_ONLY
                                                              : sdc::Options::VTX_BOUNDARY_EDGE_AND_CORNER);
  using Factory = far::TopologyRefinerFactory<far::TopologyDescriptor>;
  Factory::Options const how(scheme == Scheme::loop ? sdc::SCHEME_LOOP : sdc::SCHEME_CATMARK, options);
  std::unique_ptr<far::TopologyRefiner> refiner(Factory::Create(descriptor, how));
  if (!refiner) throw std::runtime_error("OpenSubdiv refuses the mesh");
  return refiner;
}

template <class Indices>
Vertices vertices(Indices const& indices) {
  Vertices result;
  for (int i = 0; i < indices.size(); ++i) result.push_back(static_cast<std::size_t>(indices[i]));
  return result;
}

// The children of a level, and the faces of the next one. With Loop's scheme no vertex comes from a face.
Refinement descent(far::TopologyLevel const& level, far::TopologyLevel const& next, Scheme scheme) {
  Refinement result;
  for (int v = 0; v < level.GetNumVertices(); ++v)
    result.of_vertex.push_back(static_cast<std::size_t>(level.GetVertexChildVertex(v)));
  for (int e = 0; e < level.GetNumEdges(); ++e) {
    result.of_edge[ascending(vertices(level.GetEdgeVertices(e)))] =
        static_cast<std::size_t>(level.GetEdgeChildVertex(e));
  }
  for (int f = 0; scheme == Scheme::catmull_clark && f < level.GetNumFaces(); ++f) {
    result.of_face[ascending(vertices(level.GetFaceVertices(f)))] =
        static_cast<std::size_t>(level.GetFaceChildVertex(f));
  }
  for (int f = 0; f < next.GetNumFaces(); ++f) result.mesh.faces.push_back(vertices(next.GetFaceVertices(f)));
  return result;
}

}  // namespace

std::optional<std::vector<Refinement>> refine_by_opensubdiv(Polygons const& mesh, Scheme scheme, Border border,
                                                            int levels) {
  if (scheme == Scheme::sqrt3) throw std::invalid_argument("OpenSubdiv has no √3 subdivision");
  auto const refiner = refiner_of(mesh, scheme, border);
  far::TopologyRefiner::UniformOptions uniform(levels);
  uniform.fullTopologyInLastLevel = true;
  refiner->RefineUniform(uniform);
  far::PrimvarRefinerReal<double> const interpolate(*refiner);
  std::vector<Mixed> points;
  for (Point3 const& p : mesh.points) points.push_back({p});
  std::vector<Refinement> result;
  for (int l = 1; l <= levels; ++l) {
    Refinement& refinement = result.emplace_back(descent(refiner->GetLevel(l - 1), refiner->GetLevel(l), scheme));
    std::vector<Mixed> refined(static_cast<std::size_t>(refiner->GetLevel(l).GetNumVertices()));
    interpolate.Interpolate(l, points, refined);
    for (Mixed const& m : refined) refinement.mesh.points.push_back(m.point);
    points = std::move(refined);
  }
  return result;
}

}  // namespace jrule::test

#else

namespace jrule::test {

std::optional<std::vector<Refinement>> refine_by_opensubdiv(Polygons const&, Scheme, Border, int) { return {}; }

}  // namespace jrule::test

#endif
