// The .jmap format: what it reads, what it refuses and on which line, and that its text is canonical.
#include <cmath>
#include <fstream>
#include <limits>
#include <random>
#include <sstream>

#include <gtest/gtest.h>

#include "jrule/io.h"

namespace jrule {
namespace {

std::string const square_path = std::string(JRULE_SOURCE_DIR) + "/tests/data/square.jmap";

std::string square() {
  std::ifstream in(square_path);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

std::string error(std::string const& text) {
  auto const map = parse_jmap(text, "a.jmap");
  return map ? "no error" : to_string(map.error());
}

/// The text with one part replaced.
std::string with(std::string text, std::string const& part, std::string const& other) {
  std::size_t const at = text.find(part);
  EXPECT_NE(at, std::string::npos) << part;
  return text.replace(at, part.size(), other);
}

/// Two darts of a G-map of dimension 0, joined.
std::string const edge = "jmap 1\nmodel gmap 0\ndarts 2\n1\n0\n";

TEST(Jmap, ReadsAndPrintsTheSame) {
  auto const map = read_jmap(square_path);
  ASSERT_TRUE(map) << to_string(map.error());
  EXPECT_EQ(map->model(), gmap(2));
  EXPECT_EQ(map->dart_count(), 8U);
  ASSERT_EQ(map->embedding_count(), 2U);
  EXPECT_EQ(to_string(map->embedding(0).spec().orbit), "<1,2>");
  EXPECT_EQ(map->embedding(0).value(map->embedding(0).handle(2)), Value(Point3{1, 0, 0}));
  std::string const text = print_jmap(*map);
  EXPECT_EQ(text, square().substr(square().find('\n') + 1));  // all but the comment
  auto const again = parse_jmap(text, "again");
  ASSERT_TRUE(again) << to_string(again.error());
  EXPECT_EQ(print_jmap(*again), text);
}

TEST(Jmap, EmptyMap) {
  Map const map(gmap(2), {{"area", orbit_of_dimensions({0, 1}), Type::Real, std::nullopt, MergePolicy::none}});
  std::string const text = print_jmap(map);
  EXPECT_EQ(text, "jmap 1\nmodel gmap 2\ndarts 0\nembedding area Real 0 <0,1>\n");
  auto const again = parse_jmap(text, "a.jmap");
  ASSERT_TRUE(again) << to_string(again.error());
  EXPECT_EQ(print_jmap(*again), text);
}

TEST(Jmap, EveryTypeOfValue) {
  OrbitType const each{};  // every dart is an orbit
  std::vector<Value> const values = {true,
                                     std::numeric_limits<std::int64_t>::max(),
                                     0.1,
                                     Vec2{-0.0, 1e-310},
                                     Vec3{1, 2, 3},
                                     Point2{1e300, -5},
                                     Point3{0.30000000000000004, 1e22, 3},
                                     Color{1, 0.5, 0}};
  std::vector<EmbeddingSpec> specs;
  for (Value const& v : values) {
    specs.push_back({"e" + std::to_string(v.index()), each, type_of(v), std::nullopt, MergePolicy::none});
  }
  Map map(gmap(0), specs);
  map.add_darts(1);
  for (std::size_t i = 0; i < values.size(); ++i) map.embedding(i).set_handle(0, map.embedding(i).add(values[i]));
  std::string const text = print_jmap(map);
  EXPECT_NE(text.find("embedding e1 Int 1 <>\n9223372036854775807\n0\n"), std::string::npos) << text;
  EXPECT_NE(text.find("embedding e3 Vec2 1 <>\n-0 1e-310\n0\n"), std::string::npos) << text;
  auto const again = parse_jmap(text, "a.jmap");
  ASSERT_TRUE(again) << to_string(again.error());
  for (std::size_t i = 0; i < values.size(); ++i) {
    EXPECT_EQ(again->embedding(i).value(again->embedding(i).handle(0)), values[i]);
  }
  EXPECT_EQ(print_jmap(*again), text);
}

TEST(Jmap, CustomModels) {
  Model model;
  model.name = "knot";
  model.dimension = 3;
  model.dimensions = {0, 1, 3};
  model.oriented = 1U << 1U;
  model.exchange = {{0, 3}, {1, 3}};
  model.closed = true;
  Map map(
      model,
      {{"mark", {{{{1, false}, {0, false}}, {{1, true}, {3, false}}}}, Type::Int, std::nullopt, MergePolicy::none}});
  std::string const text = print_jmap(map);
  EXPECT_EQ(text,
            "jmap 1\nmodel knot 3 dimensions 0 1 3 oriented 1 exchange 0,3 1,3 closed\ndarts 0\n"
            "embedding mark Int 0 <[1,0],[~1,3]>\n");
  auto const again = parse_jmap(text, "a.jmap");
  ASSERT_TRUE(again) << to_string(again.error());
  EXPECT_EQ(again->model(), model);
  EXPECT_EQ(again->embedding(0).spec(), map.embedding(0).spec());

  // A model that only has the name of a built-in one is written out too.
  Model impostor = gmap(2);
  impostor.exchange.clear();
  EXPECT_EQ(print_jmap(Map(impostor)), "jmap 1\nmodel gmap 2 dimensions 0 1 2\ndarts 0\n");
}

TEST(Jmap, TextIsCanonical) {
  auto map = read_jmap(square_path);
  ASSERT_TRUE(map);
  std::string const text = print_jmap(*map);
  // A dart that came and went, and a value of its own for each dart, leave no trace.
  Dart const extra = map->add_darts(1)[0];
  map->erase(extra);
  Embedding& position = map->embedding(0);
  for (Dart d = 0; d < 8; ++d) position.set_handle(d, position.add(position.value(position.handle(d))));
  EXPECT_EQ(print_jmap(*map), text);

  // Live darts are renumbered.
  Map darts(gmap(0));
  darts.add_darts(4);
  darts.link(1, 0, 3);
  darts.erase(0);
  EXPECT_EQ(print_jmap(darts), "jmap 1\nmodel gmap 0\ndarts 3\n2\n1\n0\n");
}

TEST(Jmap, OrbitTypeMayBeLeftOutForPoints) {
  auto const map = parse_jmap(with(with(square(), " <1,2>", ""), "4\n0 0 0", "4 # of what?\n\n0 0 0"), "a.jmap");
  ASSERT_TRUE(map) << to_string(map.error());
  EXPECT_EQ(map->embedding(0).spec().orbit, *cell_orbit(gmap(2), 0));
  EXPECT_EQ(error(with(square(), " <0,1>", "")), "a.jmap:19: the orbit type of embedding 'area' is missing");
}

TEST(Jmap, ErrorsOfTheHead) {
  EXPECT_EQ(error(""), "a.jmap:1: expected 'jmap 1'");
  EXPECT_EQ(error("# jmap 1\n"), "a.jmap:1: expected 'jmap 1'");
  EXPECT_EQ(error("jmap 2\n"), "a.jmap:1: only version 1 of the format is known");
  EXPECT_EQ(error("jmap 1\n"), "a.jmap:1: expected 'model', a name and a dimension");
  EXPECT_EQ(error("jmap 1\n\nmodel gmap\n"), "a.jmap:3: expected 'model', a name and a dimension");
  EXPECT_EQ(error("jmap 1\nmodel gmap 10\n"), "a.jmap:2: a dimension is in 0..9, found '10'");
  EXPECT_EQ(error("jmap 1\nmodel foo 2\n"), "a.jmap:2: no built-in model 'foo' of dimension 2; give its dimensions");
  EXPECT_EQ(error("jmap 1\nmodel omap 0\n"), "a.jmap:2: no built-in model 'omap' of dimension 0; give its dimensions");
  EXPECT_EQ(error("jmap 1\nmodel foo 2 closed\n"), "a.jmap:2: the model has no dimensions");
  EXPECT_EQ(error("jmap 1\nmodel foo 2 dimensions 1 0\n"), "a.jmap:2: the dimensions must ascend");
  EXPECT_EQ(error("jmap 1\nmodel foo 2 dimensions 0 x\n"), "a.jmap:2: a dimension is in 0..9, found 'x'");
  EXPECT_EQ(error("jmap 1\nmodel foo 2 dimensions 0 1 oriented 2\n"),
            "a.jmap:2: 2 is oriented but no dimension of the model");
  EXPECT_EQ(error("jmap 1\nmodel foo 2 dimensions 0 1 2 exchange 2,0\n"),
            "a.jmap:2: '2,0' is not a pair i,j of the model's dimensions, i below j");
  EXPECT_EQ(error("jmap 1\nmodel foo 2 dimensions 0 1 2 exchange 0,2 0,2\n"),
            "a.jmap:2: the exchangeable pairs must ascend");
  EXPECT_EQ(error("jmap 1\nmodel foo 2 0 1\n"),
            "a.jmap:2: expected 'dimensions', 'oriented', 'exchange' or 'closed', found '0'");
  EXPECT_EQ(error("jmap 1\nmodel gmap 2\n"), "a.jmap:2: expected 'darts' and their number");
  EXPECT_EQ(error("jmap 1\nmodel gmap 2\ndarts -1\n"), "a.jmap:3: '-1' is not a number of darts");
  EXPECT_EQ(error("jmap 1\nmodel gmap 2\ndarts 1000000000000\n"), "a.jmap:3: '1000000000000' is not a number of darts");
}

TEST(Jmap, ErrorsOfDarts) {
  EXPECT_EQ(error("jmap 1\nmodel gmap 2\ndarts 4000000000\n0 0 0\n"),
            "a.jmap:4: the file ends after 1 of 4000000000 darts");
  EXPECT_EQ(error("jmap 1\nmodel gmap 2\ndarts 1\n0 0\n"), "a.jmap:4: dart 0 needs 3 targets, found 2");
  EXPECT_EQ(error("jmap 1\nmodel gmap 2\ndarts 1\n0 0 1\n"), "a.jmap:4: dart 0: '1' is not a dart in 0..0");
  EXPECT_EQ(error("jmap 1\nmodel gmap 2\ndarts 1\n0 0 x\n"), "a.jmap:4: dart 0: 'x' is not a dart in 0..0");
  EXPECT_EQ(error("jmap 1\nmodel gmap 0\ndarts 2\n1\n1\n"),
            "a.jmap:5: dart 1: its 0-arc leads to dart 1, and so does the 0-arc of dart 0");
  EXPECT_EQ(error("jmap 1\nmodel gmap 0\ndarts 3\n0\n# a turn of two\n2\n1\n0\n"),
            "a.jmap:8: expected 'embedding' or the end of the file, found '0'");
  EXPECT_EQ(error("jmap 1\nmodel gmap 0\ndarts 3\n1\n# a turn of three\n2\n0\n"),
            "a.jmap:4: dart 0: its 0-arc leads to dart 1, whose 0-arc leads to dart 2");
  EXPECT_EQ(error("jmap 1\nmodel closed_gmap 0\ndarts 3\n1\n0\n2\n"),
            "a.jmap:6: dart 2: its 0-arc is a loop, but the model closed_gmap is closed");
  EXPECT_EQ(error("jmap 1\nmodel gmap 2\ndarts 4\n1 0 0\n0 1 2\n2 2 1\n3 3 3\n"),
            "a.jmap:4: dart 0: the path 0202 does not return (it ends at dart 1)");
}

TEST(Jmap, ErrorsOfEmbeddings) {
  EXPECT_EQ(error(edge + "embedding a Real\n"),
            "a.jmap:6: expected 'embedding', a name, a type, the number of values and an orbit type");
  EXPECT_EQ(error(edge + "embedding a Complex 1 <0>\n"), "a.jmap:6: unknown type 'Complex'");
  EXPECT_EQ(error(edge + "embedding a Real x <0>\n"), "a.jmap:6: 'x' is not a number of values");
  for (std::string const orbit : {"<1>", "0", "<0", "<[0>", "<0>0", "<,0>", "<[]>"}) {
    EXPECT_EQ(error(edge + "embedding a Real 1 " + orbit + "\n"),
              "a.jmap:6: '" + orbit + "' is not an orbit type of the model");
  }
  EXPECT_EQ(error(edge + "embedding a Real 9000000000000 <0>\n1\n"),
            "a.jmap:7: the file ends after 1 of 9000000000000 values of 'a'");
  EXPECT_EQ(error(edge + "embedding a Vec2 1 <0>\n1\n"), "a.jmap:7: a Vec2 needs 2 numbers, found 1");
  EXPECT_EQ(error(edge + "embedding a Real 1 <0>\nnan\n"), "a.jmap:7: 'nan' is not a finite number");
  EXPECT_EQ(error(edge + "embedding a Int 1 <0>\n1.5\n"), "a.jmap:7: '1.5' is not an integer");
  EXPECT_EQ(error(edge + "embedding a Bool 1 <0>\n2\n"), "a.jmap:7: '2' is not a Bool, 0 or 1");
  EXPECT_EQ(error(edge + "embedding a Real 1 <0>\n1\n"), "a.jmap:7: the file ends before the value indices of 'a'");
  EXPECT_EQ(error(edge + "embedding a Real 1 <0>\n1\n0\n"),
            "a.jmap:8: expected the value index of each of 2 darts, found 1");
  EXPECT_EQ(error(edge + "embedding a Real 1 <0>\n1\n0 1\n"),
            "a.jmap:8: dart 1: '1' is not a value index; 'a' has 1 values");
  EXPECT_EQ(error(edge + "embedding a Real 1 <0>\n1\n0 -\n"),
            "a.jmap:8: dart 1: '-' is not a value index; 'a' has 1 values");
  EXPECT_EQ(error(edge + "embedding a Real 1 <0>\n1\n0 0\nembedding a Real 1 <0>\n"),
            "a.jmap:9: a second embedding 'a'");
  EXPECT_EQ(error(edge + "embedding a Real 1 <0>\n1\n0 0\nembedding b Real 2 <0>\n1\n2\n0 1\n"),
            "a.jmap:12: darts 0 and 1 are of one <0>-orbit but their values of `b` differ");
  EXPECT_EQ(error(edge + "embedding a Real 1 <0>\n1\n0 0\nmore\n"),
            "a.jmap:9: expected 'embedding' or the end of the file, found 'more'");
}

TEST(Jmap, ReadAsAGivenModel) {
  EmbeddingSpec const area{"area", orbit_of_dimensions({1, 0}), Type::Real, std::nullopt, MergePolicy::mean};
  EmbeddingSpec const mark{"mark", orbit_of_dimensions({0, 1, 2}), Type::Int, Value(std::int64_t{7}),
                           MergePolicy::none};
  auto const map = read_map(square_path, gmap(2), {mark, area});
  ASSERT_TRUE(map) << to_string(map.error());
  EXPECT_EQ(map->embedding_count(), 2U);
  EXPECT_EQ(map->embedding(1).spec(), area);
  EXPECT_EQ(map->embedding(0).value(map->embedding(0).handle(3)), Value(std::int64_t{7}));
  EXPECT_EQ(map->embedding(1).value(map->embedding(1).handle(3)), Value(1.0));

  auto const refused = [](Model const& model, EmbeddingSpec const& spec) {
    auto const result = read_map(square_path, model, {spec});
    return result ? "no error" : to_string(result.error()).substr(square_path.size());
  };
  EXPECT_EQ(refused(omap(2), mark), ":3: a map of gmap(2), expected one of omap(2)");
  Model other = gmap(2);
  other.closed = true;
  EXPECT_EQ(refused(other, mark), ":3: the file's model gmap(2) has other constraints than the one expected");
  EmbeddingSpec spec = area;
  spec.type = Type::Int;
  spec.merge = MergePolicy::none;
  EXPECT_EQ(refused(gmap(2), spec), ":19: embedding 'area' has type Real, expected Int");
  spec = area;
  spec.orbit = orbit_of_dimensions({0, 2});
  EXPECT_EQ(refused(gmap(2), spec), ":19: embedding 'area' is on <0,1>, expected <0,2>");
  spec = area;
  spec.name = "volume";
  EXPECT_EQ(refused(gmap(2), spec), ": the file has no values of embedding 'volume', which has no default");
}

TEST(Jmap, BrokenTextGivesErrorsOrValidMaps) {
  std::string const text = square();
  std::size_t maps = 0;
  std::size_t errors = 0;
  auto const check = [&](std::string const& broken) {
    auto const map = parse_jmap(broken, "a.jmap");
    ++(map ? maps : errors);
    if (!map) {
      ASSERT_FALSE(map.error().message.empty());
    } else {
      ASSERT_FALSE(find_violation(*map)) << broken;
      auto const again = parse_jmap(print_jmap(*map), "again");
      ASSERT_TRUE(again) << to_string(again.error()) << "\n" << broken;
      ASSERT_EQ(print_jmap(*again), print_jmap(*map));
    }
  };
  for (std::size_t size = 0; size < text.size(); ++size) check(text.substr(0, size));
  std::mt19937 random(20260117);
  for (int i = 0; i < 4000; ++i) {
    std::string mutated = text;
    mutated[random() % mutated.size()] =
        i % 2 == 0 ? static_cast<char>(random() % 256) : "0123456789 -.\n"[random() % 14];
    check(mutated);
  }
  EXPECT_GT(maps, 100U);
  EXPECT_GT(errors, 1000U);
}

}  // namespace
}  // namespace jrule
