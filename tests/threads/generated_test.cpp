// Generated code gives the same bits on any number of threads.
#include <gtest/gtest.h>

#include <string>

#include "patchwork.h"
#include "subdivision.h"
#include "surface.h"
#include "tests/threads/bits.h"

namespace jrule {

namespace {

template <class Modeler>
Modeler read(std::string const& file) {
  auto modeler = Modeler::read(JRULE_SOURCE_DIR "/tests/data/" + file);
  if (!modeler) throw std::runtime_error(modeler.error().message);
  return std::move(*modeler);
}

/// The rule on one thread; and that several give the same.
template <class Modeler, class Rule>
void apply(Modeler& mesh, char const* name, Rule everywhere) {
  SCOPED_TRACE(name);
  Modeler const start = mesh;
  std::size_t const darts = mesh.map().dart_count();
  auto const applied = everywhere(mesh, Threads{});
  ASSERT_TRUE(applied) << applied.error().message;
  ASSERT_FALSE(find_violation(mesh.map()));
  for (Threads const threads : tests::several) {
    Modeler other = start;
    ASSERT_TRUE(everywhere(other, threads));
    auto const difference = tests::difference_in_bits(mesh.map(), other.map());
    EXPECT_FALSE(difference) << *difference << " differ on " << threads.count << " threads, from " << darts << " darts";
  }
}
#define APPLY(MESH, RULE) apply(MESH, #RULE, [](auto& given, Threads threads) { return RULE##_everywhere(given, threads); })

TEST(SeveralThreads, GiveTheSameGMaps) {
  auto mesh = read<mesh::Mesh>("cube.obj");
  APPLY(mesh, subdivision::catmull_clark);
  APPLY(mesh, surface::quad);
  APPLY(mesh, surface::triangulate);
  APPLY(mesh, surface::edge_vertices);
  APPLY(mesh, surface::dual);
  APPLY(mesh, subdivision::catmull_clark);
}

TEST(SeveralThreads, GiveTheSameGMapsWithABorder) {
  auto mesh = read<mesh::Mesh>("patch.obj");
  APPLY(mesh, subdivision::catmull_clark);
  APPLY(mesh, surface::quad);
  APPLY(mesh, subdivision::catmull_clark);
}

TEST(SeveralThreads, GiveTheSameOMaps) {
  auto mesh = read<mesh::HalfedgeMesh>("cube.obj");
  APPLY(mesh, subdivision::catmull_clark_halfedges);
  APPLY(mesh, surface::quad_halfedges);
  APPLY(mesh, surface::triangulate_halfedges);
  APPLY(mesh, surface::edge_vertices_halfedges);
  APPLY(mesh, surface::dual_halfedges);
}

TEST(SeveralThreads, GiveTheSameValuesOfEveryOrigin) {
  auto patchwork = read<patchwork::Patchwork>("cube.obj");
  APPLY(patchwork, patchwork::quad);
  APPLY(patchwork, patchwork::relax);
  APPLY(patchwork, patchwork::quad);
  APPLY(patchwork, patchwork::insert_vertices);
  APPLY(patchwork, patchwork::explode);
  // Faces go, and their darts leave holes.
  for (int faces = 0; faces < 5; ++faces) {
    Dart const middle = patchwork.map().darts()[patchwork.map().dart_count() / 2];
    ASSERT_TRUE(patchwork::remove(patchwork, middle));
  }
  ASSERT_TRUE(patchwork.map().has_erased_darts());
  APPLY(patchwork, patchwork::quad);
  APPLY(patchwork, patchwork::relax);
  APPLY(patchwork, patchwork::remove);
}

TEST(SeveralThreads, GiveTheSameWhereAMapIsReadAndWritten) {
  auto halfedges = read<patchwork::Halfedges>("cube.obj");
  APPLY(halfedges, patchwork::reverse);
}

}  // namespace

}  // namespace jrule
