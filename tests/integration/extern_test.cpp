// Generated code with C++ from outside: its values, and that a map is what it was when a function throws.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "terrain.h"
#include "tests/integration/contents.h"
#include "tests/integration/soils.h"

namespace {

using jrule::Dart;
using jrule::Map;
using jrule::test::Contents;
using terrain::Paths;
using terrain::Terrain;

std::string const data = JRULE_SOURCE_DIR "/tests/data/";

Contents contents(Map const& map) { return jrule::test::contents(map, jrule::test::describe_soil); }

void expect_valid(Map const& map) {
  auto const violation = find_violation(map);
  EXPECT_FALSE(violation) << violation->text;
}

class Extern : public testing::Test {
 protected:
  Extern() {
    geo::mixes_left = -1;
    geo::total_fails = false;
    geo::grass_made = 0;
  }

  // Two fields of different ground, of which the first has a border with the second.
  void make_neighbours() {
    auto const first = field(map_, 0, geo::Soil("clay"));
    auto const second = field(map_, 1, geo::Soil("marl", 0.5));
    ASSERT_TRUE(first && second);
    ASSERT_TRUE(sew(map_, first->c, second->h));  // c -0- d and h -0- g: x = 1, upwards
    border_ = first->c;
    far_ = second->d;
  }

  Terrain map_;
  Dart border_ = jrule::no_dart, far_ = jrule::no_dart;
};

// ---- Values ----

TEST_F(Extern, DefaultsAreComputedWhereTheyAreNeeded) {
  auto const made = pasture(map_);
  ASSERT_TRUE(made);
  EXPECT_EQ(geo::grass_made, 1);
  EXPECT_EQ(map_.soil(made->f).name, "wet grass");
  EXPECT_EQ(map_.soil(made->f).sand, 0.125);
  EXPECT_EQ(map_.owner(made->a).name, "sand");
  EXPECT_EQ(map_.label(made->a), 7);
  EXPECT_EQ(map_.height(made->a), 0.5);
  ASSERT_TRUE(pasture(map_));
  EXPECT_EQ(geo::grass_made, 2);
  expect_valid(map_.map());
}

TEST_F(Extern, ParametersHaveComputedDefaults) {
  auto const plain = field(map_, 0);
  auto const given = field(map_, 2, geo::sand(0.75));
  ASSERT_TRUE(plain && given);
  EXPECT_EQ(map_.soil(plain->a).name, "grass");
  EXPECT_EQ(map_.soil(given->e).name, "sand");
  EXPECT_EQ(map_.soil(given->e).sand, 0.75);
  EXPECT_EQ(geo::grass_made, 1);
}

TEST_F(Extern, AValueOfTheMapMayBeAnArgument) {
  auto const one = field(map_, 0, geo::Soil("clay"));
  ASSERT_TRUE(one);
  for (int i = 0; i < 20; ++i) ASSERT_TRUE(field(map_, i, map_.soil(one->a)));
  for (Dart const d : map_.cells(2)) EXPECT_EQ(map_.soil(d).name, "clay");
}

TEST_F(Extern, FunctionsStandInLetsRequirementsAndClauses) {
  auto const made = field(map_, 0, geo::Soil("clay", 0.25));
  ASSERT_TRUE(made);
  ASSERT_TRUE(plough(map_, made->a));
  EXPECT_EQ(map_.soil(made->e).name, "turned clay");
  EXPECT_EQ(map_.label(made->a), 8);
  ASSERT_TRUE(plough(map_, made->a, 0.125));
  EXPECT_EQ(map_.soil(made->e).name, "wet turned turned clay");
  EXPECT_EQ(map_.soil(made->e).sand, 0.125);
  // hardest(…) < 0.9 fails for ground without sand.
  map_.set_soil(made->c, geo::Soil("stone", 0));
  auto const refused = plough(map_, made->a);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().kind, jrule::Error::Kind::not_applicable);
  EXPECT_EQ(refused.error().message,
            "`plough` is not applicable: `hardest(<0,1>(a).soil) < 0.9 and count(<0,1>(a).soil) == 1` does not hold where the hook "
            "`a` is dart " + std::to_string(made->a));
  EXPECT_EQ(map_.soil(made->a).name, "stone");
}

TEST_F(Extern, OperationsHoldValuesFromOutside) {
  auto const made = field(map_, 0, geo::Soil("clay", 0.25));
  ASSERT_TRUE(made);
  auto const result = water(map_, made->a, 0);
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_EQ(result->name, "wet turned clay");
  EXPECT_EQ(map_.soil(made->a).name, "turned clay");
  EXPECT_EQ(map_.map().dart_count(), 16U);
  // The second block runs, with a default of its own.
  map_.set_soil(made->a, geo::Soil("stone", 0));
  auto const other = water(map_, made->a, 0);
  ASSERT_FALSE(other);
  EXPECT_EQ(other.error().message.substr(0, 25), "`plough` is not applicabl");
  EXPECT_EQ(map_.map().dart_count(), 16U);
  map_.set_soil(made->a, geo::Soil("clay", 0.25));
  // What a function throws is passed on, and nothing has changed.
  EXPECT_THROW((void)water(map_, made->a, -1), std::domain_error);
  EXPECT_EQ(map_.map().dart_count(), 16U);
  EXPECT_EQ(map_.soil(made->a).name, "clay");
  map_.set_soil(made->a, geo::Soil("sand", 0.75));
  auto const soft = water(map_, made->a, 0);
  ASSERT_FALSE(soft);
  EXPECT_EQ(soft.error().message, "`water` failed: too soft");
  EXPECT_EQ(map_.map().dart_count(), 16U);
  expect_valid(map_.map());
}

TEST_F(Extern, FunctionsAggregateComprehensions) {
  make_neighbours();
  map_.set_soil(far_, geo::Soil("stone", 0.25));
  ASSERT_TRUE(harden(map_, border_, 0.125));
  EXPECT_EQ(map_.soil(border_).name, "sand");
  EXPECT_EQ(map_.soil(border_).sand, -0.125);  // clay, without sand and wet, is the hardest
  ASSERT_TRUE(harden(map_, far_, 0));
  EXPECT_EQ(map_.soil(far_).sand, -0.125);
  EXPECT_THROW((void)harden(map_, far_, -1), std::domain_error);
}

TEST_F(Extern, PartsOfASplitOrbitKeepItsValue) {
  auto const made = field(map_, 0, geo::Soil("clay"));
  ASSERT_TRUE(made);
  auto const split = divide(map_, made->a, made->d);
  ASSERT_TRUE(split) << split.error().message;
  ASSERT_EQ(map_.cells(2).size(), 2U);
  for (Dart const d : map_.cells(2)) EXPECT_EQ(map_.soil(d).name, "clay");
  // A value of one part is not the other's any more.
  map_.set_soil(map_.cells(2)[0], geo::Soil("marl"));
  EXPECT_EQ(map_.soil(map_.cells(2)[1]).name, "clay");
  expect_valid(map_.map());
}

TEST_F(Extern, FunctionsMergeValues) {
  auto const first = field(map_, 0, geo::Soil("clay"));
  auto const second = field(map_, 1, geo::Soil("marl", 0.5));
  ASSERT_TRUE(first && second);
  map_.set_label(first->c, 30);
  map_.set_label(second->h, 12);
  map_.set_height(first->c, 2);
  map_.set_height(second->h, -1);
  map_.set_owner(first->c, geo::Soil("me"));
  ASSERT_TRUE(sew(map_, first->c, second->h));
  EXPECT_EQ(map_.label(second->a), 42);  // h -1- a: the same corner
  EXPECT_EQ(map_.label(second->g), 14);  // 7 + 7 at the other end
  EXPECT_EQ(map_.height(first->b), -1);
  ASSERT_TRUE(unite(map_, first->c)) << unite(map_, first->c).error().message;
  EXPECT_EQ(map_.cells(2).size(), 1U);
  EXPECT_EQ(map_.soil(first->a).name, "clay+marl");
  EXPECT_EQ(map_.soil(second->e).sand, 0.25);
  EXPECT_EQ(map_.owner(second->e).name, "me");
  EXPECT_EQ(map_.map().dart_count(), 12U);
  expect_valid(map_.map());
}

TEST_F(Extern, MergingOneValueCallsNoFunction) {
  auto const made = field(map_, 0, geo::Soil("clay"));
  ASSERT_TRUE(made);
  ASSERT_TRUE(divide(map_, made->a, made->d));
  geo::mixes_left = 0;
  // The border that divide made is the only one with a neighbour on both sides.
  Dart inner = jrule::no_dart;
  for (Dart const d : map_.map().darts()) {
    if (map_.map().target(d, 2) != d) inner = d;
  }
  auto const united = unite(map_, inner);
  ASSERT_TRUE(united) << united.error().message;
  EXPECT_EQ(map_.soil(made->a).name, "clay");
}

// A clause and a merge of one embedding, also where they meet in a corner: the clause says it.
TEST_F(Extern, ClausesComeBeforeMerges) {
  auto const first = field(map_, 0), second = field(map_, 1), third = field(map_, 2);
  ASSERT_TRUE(first && second && third);
  map_.set_label(first->c, 100);
  map_.set_label(first->d, 200);
  Contents const before = contents(map_.map());
  geo::total_fails = true;
  EXPECT_THROW((void)sew_twice(map_, first->c, second->h, second->a, third->f), geo::Rock);
  EXPECT_TRUE(contents(map_.map()) == before);
  geo::total_fails = false;
  auto const sewn = sew_twice(map_, first->c, second->h, second->a, third->f);
  ASSERT_TRUE(sewn) << sewn.error().message;
  EXPECT_EQ(map_.label(first->d), 201);
  EXPECT_EQ(map_.label(second->g), 201);
  EXPECT_EQ(map_.label(first->c), 101);
  EXPECT_EQ(map_.label(third->g), 101);
  EXPECT_EQ(map_.label(second->c), 14);
  EXPECT_EQ(map_.label(third->d), 14);
  expect_valid(map_.map());
}

TEST_F(Extern, CopiesOfAMapHaveTheirOwnValues) {
  make_neighbours();
  Terrain copy = map_;
  copy.set_soil(far_, geo::Soil("sea"));
  ASSERT_TRUE(unite(copy, border_));
  EXPECT_EQ(copy.soil(far_).name, "clay+sea");
  EXPECT_EQ(map_.soil(far_).name, "marl");
  auto const same = Terrain::from_map(map_.map());
  ASSERT_TRUE(same);
  EXPECT_EQ(same->soil(far_).name, "marl");
  EXPECT_FALSE(Paths::from_map(map_.map()));
}

TEST_F(Extern, ValuesThatNoDartHasAreDropped) {
  make_neighbours();
  ASSERT_TRUE(unite(map_, border_));
  EXPECT_EQ(map_.map().embedding(1).value_count(), 1U) << "clay and marl were the others";
  EXPECT_EQ(map_.soil(far_).name, "clay+marl");
}

TEST_F(Extern, ALongSeriesKeepsThePoolsSmall) {
  make_neighbours();
  std::size_t const darts = map_.map().dart_count();
  std::size_t most = 0;
  for (int i = 0; i < 100; ++i) {
    ASSERT_TRUE(plough(map_, far_));
    map_.set_owner(far_, geo::Soil("owner " + std::to_string(i)));
    EXPECT_EQ(map_.owner(far_).name, "owner " + std::to_string(i));
    for (std::size_t e = 0; e < map_.map().embedding_count(); ++e) most = std::max(most, map_.map().embedding(e).value_count());
  }
  EXPECT_LE(most, darts) << "of 400 that were made";
  EXPECT_EQ(map_.soil(far_).name.size(), 100 * std::string("turned ").size() + std::string("marl").size());
  EXPECT_EQ(map_.soil(border_).name, "clay");
  expect_valid(map_.map());
  // Where it fails, nothing is dropped either.
  for (int i = 0; i < 20; ++i) {
    Contents const before = contents(map_.map());
    EXPECT_THROW((void)plough(map_, far_, -1), std::domain_error);
    ASSERT_TRUE(contents(map_.map()) == before);
  }
}

// ---- Files ----

TEST_F(Extern, AMeshIsReadWithDefaults) {
  auto const cube = Terrain::read(data + "cube.obj");
  ASSERT_TRUE(cube) << to_string(cube.error());
  EXPECT_EQ(geo::grass_made, 1);
  EXPECT_EQ(cube->soil(17).name, "wet grass");
  EXPECT_EQ(cube->height(17), 0.5);
  expect_valid(cube->map());
}

TEST_F(Extern, JmapCannotHoldTheValues) {
  make_neighbours();
  std::string const path = testing::TempDir() + "extern.jmap";
  auto const written = map_.write(path);
  ASSERT_FALSE(written);
  EXPECT_EQ(to_string(written.error()),
            path + ": the embedding 'soil' has the C++ type geo::Soil, which .jmap cannot hold");
  EXPECT_THROW(print_jmap(map_.map()), std::invalid_argument);
  EXPECT_TRUE(map_.write(testing::TempDir() + "extern.off"));

  // Without the column the default is taken; a column of that name has another type.
  std::string const text = "jmap 1\nmodel gmap 2\ndarts 1\n0 0 0\nembedding position Point3 1 <1,2>\n0 0 0\n0\n";
  ASSERT_TRUE(jrule::write_whole_file(path, text));
  auto const read = Terrain::read(path);
  ASSERT_TRUE(read) << to_string(read.error());
  EXPECT_EQ(read->soil(0).name, "wet grass");
  ASSERT_TRUE(jrule::write_whole_file(path, text + "embedding soil Real 1 <0,1>\n0.5\n0\n"));
  auto const refused = Terrain::read(path);
  ASSERT_FALSE(refused);
  EXPECT_EQ(to_string(refused.error()),
            path + ":8: the embedding 'soil' has the C++ type geo::Soil, which .jmap cannot hold");
}

// ---- Functions that throw ----

TEST_F(Extern, AClauseThatThrowsLeavesTheMap) {
  make_neighbours();
  Contents const before = contents(map_.map());
  map_.set_soil(border_, geo::Soil("clay", 0.5));
  Contents const changed = contents(map_.map());
  EXPECT_FALSE(before == changed);
  EXPECT_THROW((void)plough(map_, border_, -1), std::domain_error);
  EXPECT_TRUE(contents(map_.map()) == changed);
  EXPECT_EQ(map_.soil(border_).name, "clay");
  ASSERT_TRUE(plough(map_, border_, 0));
}

TEST_F(Extern, AMergeThatThrowsLeavesTheMap) {
  make_neighbours();
  Contents const before = contents(map_.map());
  geo::mixes_left = 0;
  try {
    (void)unite(map_, border_);
    ADD_FAILURE() << "nothing is thrown";
  } catch (geo::Rock const& rock) {
    EXPECT_EQ(rock.where, "clay on marl");
  }
  EXPECT_TRUE(contents(map_.map()) == before);
  expect_valid(map_.map());
  geo::mixes_left = -1;
  ASSERT_TRUE(unite(map_, border_));
  EXPECT_EQ(map_.soil(far_).name, "clay+marl");
}

TEST_F(Extern, AMergeThatThrowsTakesAddedDartsBack) {
  auto const first = field(map_, 0, geo::Soil("clay", 0.5));
  auto const second = field(map_, 1, geo::Soil("marl"));
  ASSERT_TRUE(first && second);
  // Erased darts whose indices come first, then new ones: the strip takes four.
  auto const lost = pasture(map_);
  ASSERT_TRUE(lost);
  for (Dart const d : {lost->a, lost->b}) {
    for (int const i : {0, 1, 2}) map_.map().link(map_.map().target(d, i), i, map_.map().target(d, i));
  }
  map_.map().erase(lost->a);
  map_.map().erase(lost->b);
  Contents const before = contents(map_.map());
  geo::total_fails = true;
  EXPECT_THROW((void)strip(map_, first->c, second->h), geo::Rock);
  EXPECT_TRUE(contents(map_.map()) == before);
  geo::total_fails = false;
  auto const made = strip(map_, first->c, second->h);
  ASSERT_TRUE(made) << made.error().message;
  EXPECT_EQ(map_.soil(made->c).name, "turned clay");
  EXPECT_EQ(map_.label(made->c), 14);
  EXPECT_EQ(map_.label(second->h), 14);
  EXPECT_EQ(made->c, lost->a);
}

TEST_F(Extern, AMergeThatThrowsRestoresOrientedArcs) {
  auto cube = Paths::read(data + "cube.obj");
  ASSERT_TRUE(cube) << to_string(cube.error());
  std::vector<Dart> const faces = cube->cells(2);
  for (Dart const d : faces) cube->set_soil(d, geo::Soil(std::to_string(d)));
  Contents const before = contents(cube->map());
  for (Dart const d : cube->map().darts()) {
    geo::mixes_left = 0;
    EXPECT_THROW((void)open_border(*cube, d), geo::Rock);
    EXPECT_TRUE(contents(cube->map()) == before) << d;
  }
  geo::mixes_left = 1;
  auto const opened = open_border(*cube, 0);
  ASSERT_TRUE(opened) << opened.error().message;
  EXPECT_EQ(cube->cells(2).size(), 5U);
  EXPECT_EQ(cube->map().dart_count(), 22U);
  EXPECT_EQ(cube->soil(opened->p).name.find("0+"), 0U);
  expect_valid(cube->map());
}

TEST_F(Extern, ADefaultThatThrowsWhileReadingIsPassedOn) {
  std::vector<jrule::EmbeddingSpec> specs = Terrain::embeddings();
  specs[1].extern_parts.add_default = [](jrule::Embedding&) -> jrule::Handle { throw geo::Rock{"default"}; };
  EXPECT_THROW((void)jrule::read_map(data + "cube.obj", Terrain::model(), specs), geo::Rock);
}

}  // namespace
