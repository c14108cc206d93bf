// Other programs that subdivide meshes. Each file of a peer is compiled with it only where it is installed.
#pragma once

#include <optional>
#include <vector>

#include "tests/smoothing/polygons.h"

namespace jrule::test {

enum class Scheme { catmull_clark, loop, sqrt3 };

/// What OpenSubdiv does on borders.
enum class Border { edges, edges_and_corners };

/// The mesh refined 1, …, `levels` times, each after the one before, in double precision. None if this was built
/// without the peer.
///
/// OpenSubdiv (Debian: libosd-dev): catmull_clark, and loop on triangles.
std::optional<std::vector<Refinement>> refine_by_opensubdiv(Polygons const& mesh, Scheme scheme, Border border,
                                                            int levels);
/// OpenMesh (Debian: libopenmesh-dev): loop and sqrt3, on triangles.
std::optional<std::vector<Refinement>> refine_by_openmesh(Polygons const& mesh, Scheme scheme, int levels);

}  // namespace jrule::test
