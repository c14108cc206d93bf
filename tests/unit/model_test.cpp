#include <gtest/gtest.h>

#include "jrule/model.h"
#include "jrule/result.h"
#include "jrule/word.h"

namespace jrule {
namespace {

std::string cell(Model const& model, int i) {
  auto const type = cell_orbit(model, i);
  return type ? to_string(*type) : "none";
}

TEST(Model, GmapHasAllDimensionsAndExchangesDistantOnes) {
  Model const m = gmap(3);
  EXPECT_EQ(m.name, "gmap");
  EXPECT_EQ(m.dimension, 3);
  EXPECT_EQ(m.dimensions, (std::vector<int>{0, 1, 2, 3}));
  EXPECT_EQ(m.oriented, 0);
  EXPECT_EQ(m.exchange, (std::vector<std::pair<int, int>>{{0, 2}, {0, 3}, {1, 3}}));
  EXPECT_FALSE(m.closed);
  EXPECT_TRUE(m.has(0));
  EXPECT_FALSE(m.has(4));
  EXPECT_FALSE(m.has(-1));
  EXPECT_TRUE(m.exchanges(2, 0)) << "a pair has no order";
  EXPECT_FALSE(m.exchanges(0, 1));
  EXPECT_FALSE(m.exchanges(1, 1));
}

TEST(Model, OmapsAreOrientedAtOneEnd) {
  Model const primal = omap(3);
  EXPECT_EQ(primal.dimensions, (std::vector<int>{1, 2, 3}));
  EXPECT_EQ(primal.exchange, (std::vector<std::pair<int, int>>{{1, 3}}));
  EXPECT_TRUE(primal.is_oriented(1));
  EXPECT_FALSE(primal.is_oriented(2));
  EXPECT_FALSE(primal.is_oriented(-1));
  EXPECT_EQ(primal.column(1), 0);
  EXPECT_EQ(primal.column(3), 2);
  EXPECT_EQ(primal.column(0), -1);

  Model const dual = dual_omap(3);
  EXPECT_EQ(dual.dimensions, primal.dimensions);
  EXPECT_TRUE(dual.is_oriented(3));
  EXPECT_FALSE(dual.is_oriented(1));
}

TEST(Model, BuiltinsAreFoundByName) {
  EXPECT_EQ(builtin_model("gmap", 0), gmap(0));
  EXPECT_EQ(builtin_model("gmap", 9), gmap(9));
  EXPECT_EQ(builtin_model("omap", 2), omap(2));
  EXPECT_EQ(builtin_model("dual_omap", 2), dual_omap(2));
  EXPECT_EQ(builtin_model("closed_gmap", 2), closed_gmap(2));
  EXPECT_TRUE(builtin_model("closed_gmap", 2)->closed);
  EXPECT_NE(builtin_model("gmap", 2), closed_gmap(2));
  EXPECT_FALSE(builtin_model("gmap", 10));
  EXPECT_FALSE(builtin_model("gmap", -1));
  EXPECT_FALSE(builtin_model("omap", 0)) << "it would have no dimension";
  EXPECT_FALSE(builtin_model("hypermap", 2));
}

TEST(Cells, OfGmapsLeaveOneDimensionOut) {
  EXPECT_EQ(cell(gmap(2), 0), "<1,2>");
  EXPECT_EQ(cell(gmap(2), 1), "<0,2>");
  EXPECT_EQ(cell(gmap(2), 2), "<0,1>");
  EXPECT_EQ(cell(gmap(2), 3), "none");
  EXPECT_EQ(cell(gmap(2), -1), "none");
  EXPECT_EQ(cell(gmap(0), 0), "<>");
  EXPECT_EQ(cell(closed_gmap(3), 2), "<0,1,3>");
}

TEST(Cells, OfOmapsTurnAboutTheVertex) {
  EXPECT_EQ(cell(omap(2), 0), "<[2,1]>");
  EXPECT_EQ(cell(omap(2), 1), "<2>");
  EXPECT_EQ(cell(omap(2), 2), "<1>");
  EXPECT_EQ(cell(omap(3), 0), "<[2,1],[3,1],[3,2]>");
  EXPECT_EQ(cell(omap(3), 3), "<1,2>");
  EXPECT_EQ(cell(omap(1), 0), "<>") << "each dart is a vertex";
  EXPECT_EQ(cell(omap(1), 1), "<>");
  EXPECT_EQ(cell(omap(2), 3), "none");
  EXPECT_EQ(cell(omap(2), -1), "none");
}

TEST(Cells, OfDualOmapsTurnAboutTheTopCell) {
  EXPECT_EQ(cell(dual_omap(2), 0), "<2>");
  EXPECT_EQ(cell(dual_omap(2), 1), "<1>");
  EXPECT_EQ(cell(dual_omap(2), 2), "<[1,2]>");
  EXPECT_EQ(cell(dual_omap(3), 0), "<2,3>");
  EXPECT_EQ(cell(dual_omap(3), 3), "<[1,2],[1,3],[2,3]>");
  EXPECT_EQ(cell(dual_omap(3), 4), "none");
}

TEST(Cells, OfOtherModelsLeaveOneOfTheirDimensionsOut) {
  Model m;
  m.name = "mixed";
  m.dimension = 4;
  m.dimensions = {1, 2, 4};
  m.oriented = 1U << 2;
  EXPECT_EQ(cell(m, 2), "<1,4>");
  EXPECT_EQ(cell(m, 0), "none");
  EXPECT_EQ(cell(m, 3), "none");
  EXPECT_EQ(to_string(component_orbit(m)), "<1,2,4>");
}

TEST(Word, IsSpelledAsInTheLanguage) {
  EXPECT_EQ(to_string(Word{}), "ε");
  EXPECT_EQ(to_string(Word{{2, false}}), "2");
  EXPECT_EQ(to_string(Word{{1, true}}), "~1");
  EXPECT_EQ(to_string(Word{{2, false}, {1, true}, {0, false}}), "[2,~1,0]");
  EXPECT_EQ(to_string(OrbitType{}), "<>");
  EXPECT_EQ(to_string(OrbitType{{{{0, false}}, {{2, false}, {1, false}}}}), "<0,[2,1]>");
  EXPECT_EQ(orbit_of_dimensions({0, 2}), (OrbitType{{{{0, false}}, {{2, false}}}}));
}

TEST(Error, NamesFileAndLineWhereKnown) {
  EXPECT_EQ(to_string(Error{Error::Kind::io, "cannot read it", "a.obj", 7}), "a.obj:7: cannot read it");
  EXPECT_EQ(to_string(Error{Error::Kind::io, "cannot read it", "a.obj", 0}), "a.obj: cannot read it");
  EXPECT_EQ(to_string(Error{Error::Kind::not_applicable, "no face there", "", 0}), "no face there");
  auto const f = []() -> Result<int> { return fail(Error::Kind::bad_input, "bad", "b.off", 2); };
  Result<int> const r = f();
  ASSERT_FALSE(r);
  EXPECT_EQ(r.error().kind, Error::Kind::bad_input);
  EXPECT_EQ(to_string(r.error()), "b.off:2: bad");
}

}  // namespace
}  // namespace jrule
