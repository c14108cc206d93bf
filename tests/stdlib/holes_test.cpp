// std.holes: a surface that lost a face gets it back.
#include <gtest/gtest.h>

#include <algorithm>

#include "compiler/backend/interpreter/operation.h"
#include "compiler/sema/elaborate.h"
#include "tests/integration/contents.h"
#include "tests/reference/plain_map.h"
#include "tests/stdlib/measure.h"
#include "tests/stdlib/shapes.h"

namespace jrule::test {
namespace {

class Holes : public testing::Test {
 protected:
  Holes() {
    source::Sources sources;
    source::Diagnostics diagnostics;
    program_ = sema::elaborate(sema::load(JRULE_SOURCE_DIR "/stdlib/std/holes.jrule", {JRULE_SOURCE_DIR "/stdlib", {}}, sources, diagnostics), diagnostics);
    for (source::Diagnostic const& d : diagnostics.all()) ADD_FAILURE() << source::render_human(sources, d);
    for (ir::RuleScheme const& rule : program_.rules) verdicts_.push_back(analysis::analyze(rule));
  }

  ir::Modeler const& mesh() const { return *program_.operations.at(0).modeler; }
  Result<void> fill(Map& map, Dart border) {
    auto const filled = interpreter::run({program_, verdicts_}, 0, map, {border}, workspace_);
    if (!filled) return tl::unexpected(filled.error());
    EXPECT_TRUE(map.contains(std::get<Dart>(filled->value())));
    EXPECT_FALSE(find_violation(map));
    return {};
  }

 private:
  ir::Program program_;
  std::vector<analysis::Verdict> verdicts_;
  rewrite::Workspace workspace_;
};

std::vector<Dart> border(Map const& map) {
  std::vector<Dart> result;
  for (Dart const d : map.darts()) {
    if (map.target(d, 2) == d) result.push_back(d);
  }
  return result;
}

bool same(Map const& a, Map const& b) { return reference::isomorphic(reference::plain(a), reference::plain(b), {}, {}, {}); }

TEST_F(Holes, AreFilledByTheFaceThatWasThere) {
  for (Shape const& shape : closed_surfaces()) {
    SCOPED_TRACE(shape.name);
    Map const whole = build(mesh(), shape.polygons);
    Polygons polygons = shape.polygons;
    polygons.faces.erase(polygons.faces.begin() + static_cast<std::ptrdiff_t>(polygons.faces.size() / 2));
    Map const holed = build(mesh(), polygons);
    ASSERT_FALSE(border(holed).empty());
    for (Dart const d : border(holed)) {
      Map map = holed;
      auto const filled = fill(map, d);
      ASSERT_TRUE(filled) << filled.error().message;
      EXPECT_TRUE(border(map).empty());
      EXPECT_EQ(summarize(map).cells, summarize(whole).cells);
      EXPECT_TRUE(whole.dart_count() > 1000 || same(map, whole));
    }
  }
}

// The faces at the first vertex go; one face fills what they leave, and the vertex is gone.
TEST_F(Holes, OfSeveralFacesBecomeOne) {
  for (Shape const& shape : closed_surfaces()) {
    SCOPED_TRACE(shape.name);
    Polygons polygons = shape.polygons;
    auto const at_first = [&](auto const& face) { return std::find(face.begin(), face.end(), shape.polygons.faces[0][0]) != face.end(); };
    auto const gone = static_cast<std::size_t>(std::erase_if(polygons.faces, at_first));
    Map map = build(mesh(), polygons);
    auto const whole = summarize(build(mesh(), shape.polygons)).cells;
    auto const filled = fill(map, border(map).front());
    ASSERT_TRUE(filled) << filled.error().message;
    EXPECT_TRUE(border(map).empty());
    EXPECT_EQ(summarize(map).cells, (std::vector<std::size_t>{whole[0] - 1, whole[1] - gone, whole[2] - gone + 1}));
  }
}

// Two opposite quads of the four around a vertex of a torus: without them the other two have a vertex each, and the border runs
// along both holes.
TEST_F(Holes, TwoAtOneVertexAreOne) {
  Shape const& torus = *std::find_if(closed_surfaces().begin(), closed_surfaces().end(), [](Shape const& s) { return s.name == "torus"; });
  Polygons polygons = torus.polygons;
  auto const first = polygons.faces[0];
  auto const opposite = std::find_if(polygons.faces.begin(), polygons.faces.end(), [&](auto const& face) {
    std::size_t shared = 0;
    for (auto const v : face) shared += static_cast<std::size_t>(std::count(first.begin(), first.end(), v));
    return shared == 1;
  });
  ASSERT_NE(opposite, polygons.faces.end());
  polygons.faces.erase(opposite);
  polygons.faces.erase(polygons.faces.begin());
  Map map = build(mesh(), polygons);
  ASSERT_EQ(border(map).size(), 16U);
  ASSERT_TRUE(fill(map, border(map).front()));
  EXPECT_TRUE(border(map).empty());
  auto const whole = summarize(build(mesh(), torus.polygons)).cells;
  EXPECT_EQ(summarize(map).cells, (std::vector<std::size_t>{whole[0] + 1, whole[1], whole[2] - 1}));
}

TEST_F(Holes, WhereThereIsNone) {
  Map const cube = build(mesh(), platonic_solids()[1].polygons);
  Map map = cube;
  auto const closed = fill(map, 0);
  ASSERT_FALSE(closed);
  EXPECT_NE(closed.error().message.find("there is no hole at this edge"), std::string::npos) << closed.error().message;
  EXPECT_EQ(contents(map), contents(cube));

  // An edge alone: its border ends at its two vertices.
  Map const edge = [&] {
    Map m(mesh().model, mesh().embeddings);
    m.add_darts(2);
    m.link(0, 0, 1);
    for (Dart const d : {Dart{0}, Dart{1}}) m.embedding(0).set_handle(d, m.embedding(0).add(Point3{double(d), 0, 0}));
    return m;
  }();
  map = edge;
  auto const open = fill(map, 0);
  ASSERT_FALSE(open);
  EXPECT_NE(open.error().message.find("the border of the hole is not closed"), std::string::npos) << open.error().message;
  EXPECT_EQ(contents(map), contents(edge));
}

}  // namespace
}  // namespace jrule::test
