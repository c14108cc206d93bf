// OpenSubdiv's Far::TopologyRefiner, with all of the topology of the refined level, and PrimvarRefiner for its points.
// Bilinear subdivision is the one into quads by the middles of edges and the centres of faces.
#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/far/topologyDescriptor.h>
#include <opensubdiv/far/topologyRefinerFactory.h>

#include "tests/bench/peers/own.h"
#include "tests/smoothing/mixed.h"

namespace jrule::bench {

namespace {

namespace far = OpenSubdiv::Far;
namespace sdc = OpenSubdiv::Sdc;
using test::Mixed;

struct Refined {
  std::unique_ptr<far::TopologyRefiner> refiner;
  std::vector<Mixed> points{};
};

Refined make(Surface const& s, sdc::SchemeType scheme) {
  std::vector<int> degrees, corners(s.vertex.begin(), s.vertex.end());
  for (std::size_t f = 0; f < s.face_count(); ++f) degrees.push_back(static_cast<int>(s.first[f + 1] - s.first[f]));
  far::TopologyDescriptor descriptor;
  descriptor.numVertices = static_cast<int>(s.points.size());
  descriptor.numFaces = static_cast<int>(s.face_count());
  descriptor.numVertsPerFace = degrees.data();
  descriptor.vertIndicesPerFace = corners.data();
  using Factory = far::TopologyRefinerFactory<far::TopologyDescriptor>;
  Refined made{std::unique_ptr<far::TopologyRefiner>(Factory::Create(descriptor, Factory::Options(scheme)))};
  if (!made.refiner) throw std::runtime_error("OpenSubdiv refuses the mesh");
  for (Point3 const& p : s.points) made.points.push_back({p});
  return made;
}

void refine(Refined& mesh, bool with_points) {
  far::TopologyRefiner::UniformOptions uniform(1);
  uniform.fullTopologyInLastLevel = true;
  mesh.refiner->RefineUniform(uniform);
  if (!with_points) return;
  std::vector<Mixed> refined(static_cast<std::size_t>(mesh.refiner->GetLevel(1).GetNumVertices()));
  far::PrimvarRefinerReal<double>(*mesh.refiner).Interpolate(1, mesh.points, refined);
  mesh.points = std::move(refined);
}

Counts count(Refined const& mesh, Row const&) {
  far::TopologyLevel const& level = mesh.refiner->GetLevel(1);
  auto const size = [](int n) { return static_cast<std::size_t>(n); };
  return {2 * size(level.GetNumEdges()),
          std::array<std::size_t, 4>{size(level.GetNumVertices()), size(level.GetNumEdges()), size(level.GetNumFaces()),
                                     0}};
}

}  // namespace

void enter_opensubdiv(Contest& contest) {
  auto const enter = [&](Work work, sdc::SchemeType scheme, bool with_points) {
    contest.enter(
        "OpenSubdiv", 2, work, [scheme](Row const& row) { return make(*row.surface, scheme); },
        [with_points](Refined& mesh) -> Refined& { return refine(mesh, with_points), mesh; }, count);
  };
  enter(Work::quad, sdc::SCHEME_BILINEAR, false);
  enter(Work::quad_positions, sdc::SCHEME_BILINEAR, true);
  enter(Work::catmull_clark, sdc::SCHEME_CATMARK, true);
}

}  // namespace jrule::bench
