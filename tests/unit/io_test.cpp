// Surface files: what map they become, what they are refused for, and that they come back as they were written.
#include "jrule/io.h"

#include <unistd.h>

#include <bit>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>

#include <gtest/gtest.h>

#include "../../runtime/src/io/formats.h"

namespace jrule {
namespace {

namespace fs = std::filesystem;

std::string data(std::string const& name) { return std::string(JRULE_SOURCE_DIR) + "/tests/data/" + name; }

std::string slurp(std::string const& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  EXPECT_TRUE(in) << path;
  return text.str();
}

void spill(std::string const& path, std::string const& bytes) { std::ofstream(path, std::ios::binary) << bytes; }

std::vector<EmbeddingSpec> positions(Model const& model) {
  return {{"position", *cell_orbit(model, 0), Type::Point3, std::nullopt, MergePolicy::none}};
}

std::vector<std::size_t> cells(Map const& map) {
  std::vector<std::size_t> counts;
  for (int i = 0; i <= map.model().dimension; ++i) {
    counts.push_back(number_orbits(map, *cell_orbit(map.model(), i)).first.size());
  }
  return counts;
}

Point3 position(Map const& map, Dart d) { return map.embedding(0).values<Point3>()[map.embedding(0).handle(d)]; }

class Io : public testing::Test {
 protected:
  Io() : folder_(fs::temp_directory_path() / ("jrule_io_" + std::to_string(getpid()))) {
    fs::create_directory(folder_);
  }
  ~Io() override { fs::remove_all(folder_); }

  std::string path(std::string const& name) const { return (folder_ / name).string(); }
  std::size_t files() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }
  Result<Map> parse(std::string const& name, std::string const& bytes, Model const& model) const {
    spill(path(name), bytes);
    return read_map(path(name), model, positions(model));
  }
  /// The message of the error, with the file's name alone.
  std::string error(std::string const& name, std::string const& bytes, Model const& model = gmap(2)) const {
    auto const map = parse(name, bytes, model);
    if (map) return "no error";
    EXPECT_EQ(map.error().file, path(name));
    return to_string(map.error()).substr(folder_.string().size() + 1);
  }

 private:
  fs::path folder_;
};

Map read_valid(std::string const& path, Model const& model) {
  auto map = read_map(path, model, positions(model));
  if (!map) throw std::runtime_error(to_string(map.error()));
  auto const violation = find_violation(*map);
  EXPECT_FALSE(violation) << path << " " << model.name << ": " << violation->text;
  return *std::move(map);
}

using Counts = std::vector<std::size_t>;

TEST_F(Io, CellsOfGmaps) {
  EXPECT_EQ(cells(read_valid(data("cube.obj"), gmap(2))), (Counts{8, 12, 6}));
  EXPECT_EQ(cells(read_valid(data("cube.obj"), closed_gmap(2))), (Counts{8, 12, 6}));
  EXPECT_EQ(cells(read_valid(data("tetrahedron.off"), gmap(2))), (Counts{4, 6, 4}));
  EXPECT_EQ(cells(read_valid(data("tetrahedron.stl"), gmap(2))), (Counts{4, 6, 4}));
  EXPECT_EQ(cells(read_valid(data("grid.ply"), gmap(2))), (Counts{9, 12, 4}));
  EXPECT_EQ(cells(read_valid(data("moebius.obj"), gmap(2))), (Counts{5, 10, 5}));
  EXPECT_EQ(cells(read_valid(data("cube.obj"), gmap(3))), (Counts{8, 12, 6, 1}));
}

TEST_F(Io, CellsOfOmaps) {
  for (Model const& model : {omap(2), dual_omap(2)}) {
    EXPECT_EQ(cells(read_valid(data("cube.obj"), model)), (Counts{8, 12, 6})) << model.name;
    EXPECT_EQ(cells(read_valid(data("tetrahedron.off"), model)), (Counts{4, 6, 4})) << model.name;
    EXPECT_EQ(cells(read_valid(data("tetrahedron.stl"), model)), (Counts{4, 6, 4})) << model.name;
    // Four squares and the outer face.
    EXPECT_EQ(cells(read_valid(data("grid.ply"), model)), (Counts{9, 12, 5})) << model.name;
  }
}

TEST_F(Io, DartsOfGmap) {
  Map const map = read_valid(data("grid.ply"), gmap(2));
  ASSERT_EQ(map.dart_count(), 32U);
  // Face 1 has the corners 1 2 5 4 and the darts 8..15.
  EXPECT_EQ(position(map, 8), (Point3{1, 0, 0}));
  EXPECT_EQ(position(map, 9), (Point3{2, 0, 0}));
  EXPECT_EQ(position(map, 14), (Point3{1, 1, 0}));
  EXPECT_EQ(position(map, 15), (Point3{1, 0, 0}));
  EXPECT_EQ(map.target(8, 0), 9U);
  EXPECT_EQ(map.target(9, 1), 10U);
  EXPECT_EQ(map.target(15, 1), 8U);
  EXPECT_EQ(map.target(8, 2), 8U);
  // Its edge 4-1 is the edge 1-4 of face 0, the darts 2 and 3 there.
  EXPECT_EQ(map.target(14, 2), 3U);
  EXPECT_EQ(map.target(15, 2), 2U);
}

TEST_F(Io, DartsOfOmap) {
  Map const map = read_valid(data("grid.ply"), omap(2));
  ASSERT_EQ(map.dart_count(), 24U);  // 16 of the file, 8 of the outer face
  EXPECT_EQ(position(map, 4), (Point3{1, 0, 0}));
  EXPECT_EQ(position(map, 5), (Point3{2, 0, 0}));
  EXPECT_EQ(map.target(4, 1), 5U);
  EXPECT_EQ(map.target(7, 1), 4U);
  EXPECT_EQ(map.target(7, 2), 1U);
  EXPECT_EQ(map.target(0, 2), 16U);
  EXPECT_EQ(orbit(map, *cell_orbit(map.model(), 2), 16).size(), 8U);
  for (Dart d = 16; d < 24; ++d) {
    EXPECT_EQ(map.target(d, 1), d == 23 ? 16 : d + 1);
    EXPECT_EQ(position(map, d), position(map, map.target(map.target(d, 2), 1)));
  }
}

TEST_F(Io, PolygonsInMemoryAreReadAsThoseOfAFile) {
  std::vector<Point3> const points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 0}};
  std::string const off = "OFF\n5 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n2 0 0\n4 0 1 2 3\n3 4 2 1\n";
  for (Model const& model : {gmap(2), omap(2), dual_omap(2)}) {
    auto const built = map_of_polygons(points, {{0, 1, 2, 3}, {4, 2, 1}}, model, positions(model));
    auto const from_file = parse("two.off", off, model);
    ASSERT_TRUE(built && from_file);
    EXPECT_EQ(print_jmap(*built), print_jmap(*from_file)) << model.name;
  }
  auto const error = [&](std::vector<std::vector<std::uint32_t>> const& faces) {
    auto const map = map_of_polygons(points, faces, gmap(2), positions(gmap(2)));
    return map ? "" : to_string(map.error());
  };
  EXPECT_EQ(error({{0, 1, 2}, {0, 1}}).substr(0, 11), "polygons:2:");
  EXPECT_EQ(error({{0, 1, 9}}).substr(0, 11), "polygons:1:");
  EXPECT_EQ(error({}), "polygons:1: the file has no faces");
}

TEST_F(Io, DualOmapHasTheFacesOfTheFile) {
  Map const map = read_valid(data("cube.obj"), dual_omap(2));
  OrbitNumbers const faces = number_orbits(map, *cell_orbit(map.model(), 2));
  for (Dart d = 0; d < 24; ++d) {
    EXPECT_EQ(faces.number[d], d / 4);
    EXPECT_EQ(map.walk(d, {{1, false}, {2, false}}), d % 4 == 3 ? d - 3 : d + 1);
  }
}

TEST_F(Io, FacesAreTurnedAlikeForOmaps) {
  std::string const text = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 4 3\n";
  auto const map = parse("turned.obj", text, omap(2));
  ASSERT_TRUE(map) << to_string(map.error());
  EXPECT_FALSE(find_violation(*map));
  EXPECT_EQ(cells(*map), (Counts{4, 5, 3}));
  // The second face runs 1 3 4. Its dart k is still its k-th edge in the file.
  EXPECT_EQ(map->target(2, 2), 5U);
  EXPECT_EQ(position(*map, 5), (Point3{0, 0, 0}));
  EXPECT_EQ(position(*map, 4), (Point3{1, 1, 0}));
  EXPECT_EQ(map->target(5, 1), 4U);
  EXPECT_EQ(map->target(4, 1), 3U);
  EXPECT_EQ(map->target(3, 1), 5U);
}

TEST_F(Io, OneCubeFaceTurnedChangesNoCount) {
  std::string text = slurp(data("cube.obj"));
  text.replace(text.find("f 2 3 7 6"), 9, "f 6 7 3 2");
  auto const map = parse("cube.obj", text, omap(2));
  ASSERT_TRUE(map) << to_string(map.error());
  EXPECT_FALSE(find_violation(*map));
  EXPECT_EQ(cells(*map), (Counts{8, 12, 6}));
}

// Two triangles that share a vertex only: one vertex of the file, two of the map.
TEST_F(Io, FansAtOneVertexAreVerticesOfTheirOwn) {
  std::string const text = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv -1 0 0\nv -1 -1 0\nf 1 2 3\nf 1 4 5\n";
  for (Model const& model : {gmap(2), omap(2), dual_omap(2)}) {
    auto const map = parse("bow.obj", text, model);
    ASSERT_TRUE(map) << to_string(map.error());
    EXPECT_FALSE(find_violation(*map)) << model.name;
    EXPECT_EQ(cells(*map)[0], 6U) << model.name;
  }
}

TEST_F(Io, RoundTripIsTheSameMap) {
  for (Model const& model : {gmap(2), omap(2), dual_omap(2), gmap(3)}) {
    for (char const* name : {"cube.obj", "tetrahedron.off", "grid.ply", "tetrahedron.stl"}) {
      Map const map = read_valid(data(name), model);
      for (std::string const suffix : {".obj", ".off", ".ply", ".stl", ".jmap", ".OBJ"}) {
        auto const written = write_map(map, path("out" + suffix));
        ASSERT_TRUE(written) << to_string(written.error());
        if (suffix == ".stl" && std::string(name).front() != 't') continue;  // its faces are cut
        EXPECT_EQ(print_jmap(read_valid(path("out" + suffix), model)), print_jmap(map))
            << name << " " << suffix << " " << model.name;
      }
    }
  }
}

TEST_F(Io, StlCutsFacesIntoTriangles) {
  ASSERT_TRUE(write_map(read_valid(data("cube.obj"), gmap(2)), path("cube.stl")));
  EXPECT_EQ(fs::file_size(path("cube.stl")), 84U + 12U * 50U);
  EXPECT_EQ(cells(read_valid(path("cube.stl"), gmap(2))), (Counts{8, 18, 12}));
}

TEST_F(Io, NumbersReadBackExactly) {
  std::string const text = "v 0.1 1e-310 -0\nv 12345678901234567 0.30000000000000004 1e22\nv +5 1. .5\nf 1 2 3\n";
  auto const map = parse("numbers.obj", text, gmap(2));
  ASSERT_TRUE(map) << to_string(map.error());
  EXPECT_EQ(position(*map, 0), (Point3{0.1, 1e-310, 0}));
  EXPECT_TRUE(std::signbit(position(*map, 0).z));
  EXPECT_EQ(position(*map, 1), (Point3{12345678901234567.0, 0.30000000000000004, 1e22}));
  EXPECT_EQ(position(*map, 3), (Point3{5, 1, 0.5}));
  for (std::string const suffix : {".obj", ".off", ".ply", ".jmap"}) {
    ASSERT_TRUE(write_map(*map, path("out" + suffix)));
    EXPECT_EQ(print_jmap(read_valid(path("out" + suffix), gmap(2))), print_jmap(*map)) << suffix;
  }
}

TEST_F(Io, WrittenTextIsExactlyThis) {
  auto const map = parse("t.obj", "v 9 9 9\nv 0 0 0.5\nv 1 0 0\nv 0 1 0\nf 3 4 2\n", gmap(2));
  ASSERT_TRUE(map);
  ASSERT_TRUE(write_map(*map, path("out.obj")));
  EXPECT_EQ(slurp(path("out.obj")), "v 1 0 0\nv 0 1 0\nv 0 0 0.5\nf 1 2 3\n");
  ASSERT_TRUE(write_map(*map, path("out.off")));
  EXPECT_EQ(slurp(path("out.off")), "OFF\n3 1 0\n1 0 0\n0 1 0\n0 0 0.5\n3 0 1 2\n");
  ASSERT_TRUE(write_map(*map, path("out.ply")));
  EXPECT_EQ(slurp(path("out.ply")),
            "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\nproperty double z\n"
            "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
            "1 0 0\n0 1 0\n0 0 0.5\n3 0 1 2\n");
}

TEST_F(Io, ObjVariants) {
  std::string const text =
      "mtllib a.mtl\r\n# comment \\\r\no x\nv 0 0 0 1\nv 1 0 0 0.5 0.5 0.5 # colour\nvt 0 0\nvn 0 0 1\nv 1 \\\r\n  1 "
      "0\nv 0 1 0\n"
      "g a b\nusemtl m\ns off\nl 1 2\np 1\nwhatever 1 2\nf 1/1 2/1/1 -2//1\nf -4 3 \\\n  4/\n";
  auto const map = parse("variants.obj", text, gmap(2));
  ASSERT_TRUE(map) << to_string(map.error());
  EXPECT_EQ(cells(*map), (Counts{4, 5, 2}));
  EXPECT_EQ(position(*map, 4), (Point3{1, 1, 0}));
}

TEST_F(Io, OffVariants) {
  std::string const text =
      "# before\r\nOFF 4 2 # counts\r\n\r\n0 0 0\n1 0 0\n1 1 0\n0 1 0 # last\n3 0 1 2 255 0 0\n3 0 2 3 0.5 0.5 0.5 "
      "1\n\n";
  auto const map = parse("variants.off", text, gmap(2));
  ASSERT_TRUE(map) << to_string(map.error());
  EXPECT_EQ(cells(*map), (Counts{4, 5, 2}));
}

template <class T>
void put(std::string& bytes, T value, bool big) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  bool const reverse = big == (std::endian::native == std::endian::little);
  for (std::size_t i = 0; i < sizeof(T); ++i) bytes += raw[reverse ? sizeof(T) - 1 - i : i];
}

/// The grid of grid.ply, with properties and an element more.
std::string binary_grid(bool big) {
  std::string bytes = std::string("ply\nformat binary_") + (big ? "big" : "little") +
                      "_endian 1.0\ncomment two times two\nelement vertex 9\nproperty double x\nproperty uchar red\n"
                      "property float y\nproperty int16 z\nelement edge 2\nproperty list ushort double weights\n"
                      "element nothing 1000000000000\nelement face 4\nproperty list uchar uint vertex_index\n"
                      "property float area\nend_header\n";
  for (int i = 0; i < 9; ++i) {
    put(bytes, static_cast<double>(i % 3), big);
    put(bytes, static_cast<std::uint8_t>(200), big);
    put(bytes, static_cast<float>(i / 3), big);
    put(bytes, static_cast<std::int16_t>(0), big);
  }
  put(bytes, std::uint16_t{2}, big);
  put(bytes, 0.5, big);
  put(bytes, 1.5, big);
  put(bytes, std::uint16_t{0}, big);
  for (std::uint32_t first : {0U, 1U, 3U, 4U}) {
    put(bytes, std::uint8_t{4}, big);
    for (std::uint32_t corner : {first, first + 1, first + 4, first + 3}) put(bytes, corner, big);
    put(bytes, 1.0F, big);
  }
  return bytes;
}

TEST_F(Io, BinaryPly) {
  std::string const expected = print_jmap(read_valid(data("grid.ply"), gmap(2)));
  for (bool big : {false, true}) {
    auto const map = parse("grid.ply", binary_grid(big), gmap(2));
    ASSERT_TRUE(map) << to_string(map.error());
    EXPECT_EQ(print_jmap(*map), expected);
  }
  std::string const bytes = binary_grid(false);
  ASSERT_EQ(bytes.size(), 550U);
  EXPECT_EQ(error("a.ply", bytes.substr(0, 549)), "a.ply: the file ends inside an element (at byte 546)");
  EXPECT_EQ(error("a.ply", bytes + "x"), "a.ply: more data than the header promises (at byte 550)");
  std::string wrong = bytes;
  wrong[542] = 9;  // the last corner of the last face
  EXPECT_EQ(error("a.ply", wrong), "a.ply: there is no vertex 9: the file has 9 (face at byte 529)");
}

TEST_F(Io, BinaryStl) {
  Map const map = read_valid(data("tetrahedron.stl"), gmap(2));
  ASSERT_TRUE(write_map(map, path("t.stl")));
  std::string bytes = slurp(path("t.stl"));
  bytes.replace(0, 5, "solid");  // as some programs begin binary files
  auto const again = parse("t.stl", bytes, gmap(2));
  ASSERT_TRUE(again) << to_string(again.error());
  EXPECT_EQ(print_jmap(*again), print_jmap(map));

  EXPECT_EQ(error("t.stl", bytes.substr(0, 200)),
            "t.stl: a binary STL file of 4 triangles has 284 bytes, this one ends at byte 200");
  EXPECT_EQ(error("t.stl", std::string(70, '\0')),
            "t.stl: a binary STL file has 84 bytes or more, this one ends at byte 70");
  EXPECT_EQ(error("t.stl", std::string(84, '\0')), "t.stl: the file has no faces");
  std::string nan = bytes;
  for (std::size_t i = 0; i < 4; ++i) nan[84 + 12 + i] = '\xff';
  EXPECT_EQ(error("t.stl", nan), "t.stl: a coordinate is not a finite number (at byte 96)");
  std::string flat = bytes;
  flat.replace(84 + 24, 12, flat.substr(84 + 12, 12));
  EXPECT_EQ(error("t.stl", flat), "t.stl: the face has vertex (0, 0, 0) twice (face at byte 84)");
}

TEST_F(Io, StlZerosAreOnePoint) {
  std::string text = slurp(data("tetrahedron.stl"));
  text.replace(text.find("0 0 0"), 5, "-0 0 0");
  auto const map = parse("t.stl", text, gmap(2));
  ASSERT_TRUE(map) << to_string(map.error());
  EXPECT_EQ(cells(*map), (Counts{4, 6, 4}));
}

std::string const square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST_F(Io, SurfaceErrors) {
  EXPECT_EQ(error("a.obj", square), "a.obj:4: the file has no faces");
  EXPECT_EQ(error("a.obj", ""), "a.obj:1: the file has no faces");
  EXPECT_EQ(error("a.obj", square + "f 1 2 3\nf 1 2\n"), "a.obj:6: a face needs 3 corners or more, found 2");
  EXPECT_EQ(error("a.obj", square + "f\n"), "a.obj:5: a face needs 3 corners or more, found 0");
  EXPECT_EQ(error("a.obj", square + "f 1 2 3 2\n"), "a.obj:5: the face has vertex 2 twice");
  EXPECT_EQ(error("a.obj", square + "f 1 2 5\n"), "a.obj:5: there is no vertex 5: the file has 4");
  EXPECT_EQ(error("a.obj", square + "\nf 1 2 3\nf 1 4 3\n\nf 3 1 2\n"),
            "a.obj:9: the edge between vertices 3 and 1 belongs to more than two faces");
  EXPECT_EQ(
      error("a.obj", square + "f 1 2 3\nf 1 2 4\nf 2 3 4\n", closed_gmap(2)),
      "a.obj:5: the edge between vertices 3 and 1 belongs to one face only, but closed_gmap(2) allows no boundary");
  EXPECT_EQ(error("a.obj", slurp(data("moebius.obj")), omap(2)),
            "a.obj:10: the surface is not orientable, as omap(2) demands: the faces at the edge between vertices 4 and "
            "5 cannot "
            "be turned alike");
  EXPECT_EQ(error("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n"),
            "a.off:6: there is no vertex 3: the file has 3");
  EXPECT_EQ(error("a.off", "OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n"), "a.off:5: the file has no faces");
}

TEST_F(Io, ModelErrors) {
  std::string const text = square + "f 1 2 3 4\n";
  EXPECT_EQ(error("a.obj", text, omap(3)),
            "a.obj: a surface cannot be read as omap(3): its arcs above 2 cannot be loops");
  EXPECT_EQ(error("a.obj", text, closed_gmap(3)),
            "a.obj: a surface cannot be read as closed_gmap(3): its arcs above 2 cannot be loops");
  EXPECT_EQ(
      error("a.obj", text, gmap(1)),
      "a.obj: a surface cannot be read as gmap(1): only G-maps and O-maps of dimension 2 or more, and their closed and "
      "dual kinds");
  spill(path("a.obj"), text);
  EmbeddingSpec const area{"area", orbit_of_dimensions({0, 1}), Type::Real, std::nullopt, MergePolicy::none};
  auto const map = read_map(path("a.obj"), gmap(2), {area});
  ASSERT_FALSE(map);
  EXPECT_EQ(map.error().message, "the file has no values of embedding 'area', which has no default");
}

TEST_F(Io, OtherEmbeddingsTakeTheirDefaults) {
  EmbeddingSpec const area{"area", orbit_of_dimensions({0, 1}), Type::Real, Value(2.5), MergePolicy::none};
  EmbeddingSpec const second{"second", orbit_of_dimensions({2, 1}), Type::Point3, Value(Point3{1, 2, 3}),
                             MergePolicy::none};
  EmbeddingSpec const position_spec{"position", orbit_of_dimensions({2, 1}), Type::Point3, std::nullopt,
                                    MergePolicy::none};
  auto const map = read_map(data("cube.obj"), gmap(2), {area, position_spec, second});
  ASSERT_TRUE(map) << to_string(map.error());
  EXPECT_FALSE(find_violation(*map));
  EXPECT_EQ(map->embedding(0).value(map->embedding(0).handle(7)), Value(2.5));
  EXPECT_EQ(map->embedding(1).value(map->embedding(1).handle(47)), Value(Point3{0, 1, 0}));
  EXPECT_EQ(map->embedding(2).value(map->embedding(2).handle(47)), Value(Point3{1, 2, 3}));
}

TEST_F(Io, ObjErrors) {
  EXPECT_EQ(error("a.obj", "v 0 0\n"), "a.obj:1: a vertex needs 3 numbers, found 2");
  EXPECT_EQ(error("a.obj", "\nv 0 x 0\n"), "a.obj:2: 'x' is not a finite number");
  EXPECT_EQ(error("a.obj", "v 0 nan 0\n"), "a.obj:1: 'nan' is not a finite number");
  EXPECT_EQ(error("a.obj", "v 0 0 -inf\n"), "a.obj:1: '-inf' is not a finite number");
  EXPECT_EQ(error("a.obj", "v 0 0 1e999\n"), "a.obj:1: '1e999' is not a finite number");
  EXPECT_EQ(error("a.obj", "v 0 0 1,5\n"), "a.obj:1: '1,5' is not a finite number");
  EXPECT_EQ(error("a.obj", square + "f 0 1 2\n"), "a.obj:5: there is no vertex 0");
  EXPECT_EQ(error("a.obj", square + "f -5 1 2\n"), "a.obj:5: there is no vertex -5");
  EXPECT_EQ(error("a.obj", square + "f 99999999999 1 2\n"), "a.obj:5: there is no vertex 99999999999");
  EXPECT_EQ(error("a.obj", square + "f -9223372036854775808 1 2\n"),
            "a.obj:5: there is no vertex -9223372036854775808");
  EXPECT_EQ(error("a.obj", square + "f 1 2 3.5\n"), "a.obj:5: '3.5' is not a corner of a face");
  EXPECT_EQ(error("a.obj", square + "f 1/x 2 3\n"), "a.obj:5: '1/x' is not a corner of a face");
  EXPECT_EQ(error("a.obj", square + "f 1/1/1/1 2 3\n"), "a.obj:5: '1/1/1/1' is not a corner of a face");
  EXPECT_EQ(error("a.obj", square + "f 1 \\\n 2 \\\n z\n"), "a.obj:5: 'z' is not a corner of a face");
}

TEST_F(Io, OffErrors) {
  EXPECT_EQ(error("a.off", ""), "a.off:1: the file is empty");
  EXPECT_EQ(error("a.off", "COFF\n"), "a.off:1: expected 'OFF', found 'COFF'; only plain OFF is read");
  EXPECT_EQ(error("a.off", "OFF BINARY\n"), "a.off:1: expected the numbers of vertices, faces and edges");
  EXPECT_EQ(error("a.off", "OFF\n# end\n"), "a.off:2: the file ends before the numbers of vertices and faces");
  EXPECT_EQ(error("a.off", "OFF\n3 -1 0\n"), "a.off:2: '-1' is not a count");
  EXPECT_EQ(error("a.off", "OFF\n1000000000000 1 0\n0 0 0\n"),
            "a.off:3: the file ends after 1 of 1000000000000 vertices");
  EXPECT_EQ(error("a.off", "OFF\n1 1000000000000 0\n0 0 0\n"), "a.off:3: the file ends after 0 of 1000000000000 faces");
  EXPECT_EQ(error("a.off", "OFF\n3 1 0\n0 0 0 0\n"), "a.off:3: a vertex needs 3 numbers, found 4");
  EXPECT_EQ(error("a.off", "OFF\n3 1 0\n0 0 o\n"), "a.off:3: 'o' is not a finite number");
  std::string const start = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n";
  EXPECT_EQ(error("a.off", start + "3 0 1\n"), "a.off:6: a face of 3 corners has 2 on its line");
  EXPECT_EQ(error("a.off", start + "-3 0 1 2\n"), "a.off:6: '-3' is not a number of corners");
  EXPECT_EQ(error("a.off", start + "3 0 1 -1\n"), "a.off:6: there is no vertex -1");
  EXPECT_EQ(error("a.off", start + "3 0 1 b\n"), "a.off:6: 'b' is not an integer");
  EXPECT_EQ(error("a.off", start + "3 0 1 2\n3 0 1 2\n"), "a.off:7: more lines than the counts at the top promise");
}

TEST_F(Io, PlyErrors) {
  std::string const start = "ply\nformat ascii 1.0\n";
  std::string const vertex = "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
  std::string const face = "element face 1\nproperty list uchar int vertex_indices\n";
  std::string const header = start + vertex + face + "end_header\n";
  EXPECT_EQ(error("a.ply", ""), "a.ply:1: expected 'ply', found ''");
  EXPECT_EQ(error("a.ply", "plx\n"), "a.ply:1: expected 'ply', found 'plx'");
  EXPECT_EQ(error("a.ply", "ply\nformat ascii 2.0\n"), "a.ply:2: expected a format and its version 1.0");
  EXPECT_EQ(error("a.ply", "ply\nformat text 1.0\n"), "a.ply:2: unknown format 'text'");
  EXPECT_EQ(error("a.ply", "ply\nend_header\n"), "a.ply:2: the header has no format");
  EXPECT_EQ(error("a.ply", start + start.substr(4)), "a.ply:3: a second format");
  EXPECT_EQ(error("a.ply", start), "a.ply:2: the file ends inside the header");
  EXPECT_EQ(error("a.ply", start + "elephant\n"), "a.ply:3: unknown keyword 'elephant'");
  EXPECT_EQ(error("a.ply", start + "element vertex\n"), "a.ply:3: expected 'element', a name and a count");
  EXPECT_EQ(error("a.ply", start + "element vertex -1\n"), "a.ply:3: '-1' is not a count");
  EXPECT_EQ(error("a.ply", start + vertex + vertex), "a.ply:7: a second element 'vertex'");
  EXPECT_EQ(error("a.ply", start + vertex + "property float x\n"), "a.ply:7: a second property 'x'");
  EXPECT_EQ(error("a.ply", start + "property float x\n"), "a.ply:3: a property before the first element");
  EXPECT_EQ(error("a.ply", start + vertex + "property x\n"), "a.ply:7: expected 'property', a type and a name");
  EXPECT_EQ(error("a.ply", start + vertex + "property half x\n"), "a.ply:7: unknown type 'half'");
  EXPECT_EQ(error("a.ply", start + "element face 1\nproperty list float int vertex_indices\n"),
            "a.ply:4: the length of a list must be an integer");
  EXPECT_EQ(error("a.ply", start + "element face 1\nproperty list uchar float vertex_indices\n"),
            "a.ply:4: property 'vertex_indices' of element 'face' has the wrong type");
  EXPECT_EQ(error("a.ply", start + "element vertex 3\nproperty float x\n" + face + "end_header\n"),
            "a.ply:7: no element 'vertex' with properties x, y and z");
  EXPECT_EQ(error("a.ply", start + vertex + "end_header\n"), "a.ply:7: no element 'face' with a list vertex_indices");
  EXPECT_EQ(error("a.ply", header + "0 0 0\n"), "a.ply:10: the file ends after 1 of 3 items of element 'vertex'");
  EXPECT_EQ(error("a.ply", header + "0 0\n"), "a.ply:10: a number is missing on this line");
  EXPECT_EQ(error("a.ply", header + "0 0 0 0\n"), "a.ply:10: more numbers than element 'vertex' has");
  EXPECT_EQ(error("a.ply", header + "0 0 inf\n"), "a.ply:10: 'inf' is not a finite number");
  std::string const points = header + "0 0 0\n1 0 0\n0 1 0\n";
  EXPECT_EQ(error("a.ply", points + "3 0 1 x\n"), "a.ply:13: 'x' is not an integer");
  EXPECT_EQ(error("a.ply", points + "3 0 1 -1\n"), "a.ply:13: there is no vertex -1");
  EXPECT_EQ(error("a.ply", points + "-3 0 1 2\n"), "a.ply:13: a list has the length -3");
  EXPECT_EQ(error("a.ply", points + "3 0 1 1\n"), "a.ply:13: the face has vertex 1 twice");
  EXPECT_EQ(error("a.ply", points + "3 0 1 2\n7\n"), "a.ply:14: more data than the header promises");
  std::string huge = header;
  huge.replace(huge.find("vertex 3"), 8, "vertex 1000000000000");
  EXPECT_EQ(error("a.ply", huge), "a.ply:9: the file ends after 0 of 1000000000000 items of element 'vertex'");
  huge.replace(huge.find("ascii"), 5, "binary_big_endian");
  EXPECT_EQ(error("a.ply", huge), "a.ply: the file ends after 0 of 1000000000000 items of element 'vertex' (at byte " +
                                      std::to_string(huge.size()) + ")");
}

TEST_F(Io, StlErrors) {
  std::string const start = "solid\nfacet normal 0 0 nan\nouter loop\nvertex 0 0 0\n";
  EXPECT_EQ(error("a.stl", ""), "a.stl:1: the file has no faces");
  EXPECT_EQ(error("a.stl", "hello\n"), "a.stl:1: expected 'solid', found 'hello'");
  EXPECT_EQ(error("a.stl", "solid a\nfacet\n"), "a.stl:2: expected 'outer', found the end of the file");
  EXPECT_EQ(error("a.stl", "solid a\nfacte\n"), "a.stl:2: expected 'facet', found 'facte'");
  EXPECT_EQ(error("a.stl", start + "vertex 0 0 nan\n"), "a.stl:5: 'nan' is not a finite number");
  EXPECT_EQ(error("a.stl", start + "vertex 0 1 0\nendloop\n"), "a.stl:6: expected 'vertex', found 'endloop'");
  EXPECT_EQ(error("a.stl", start + "vertex 1 0 0\nvertex 0 0 0\nendloop\nendfacet\nendsolid\n"),
            "a.stl:2: the face has vertex (0, 0, 0) twice");
}

TEST_F(Io, FilesThatCannotBeRead) {
  auto const missing = read_map(path("none.obj"), gmap(2), {});
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().kind, Error::Kind::io);
  EXPECT_EQ(missing.error().message, "cannot read the file: No such file or directory");
  fs::create_directory(path("folder.obj"));
  auto const folder = read_map(path("folder.obj"), gmap(2), {});
  ASSERT_FALSE(folder);
  EXPECT_EQ(folder.error().message, "cannot read the file: Is a directory");
  auto const unknown = read_map("cube.xyz", gmap(2), {});
  ASSERT_FALSE(unknown);
  EXPECT_EQ(to_string(unknown.error()),
            "cube.xyz: no format has the suffix '.xyz'; the formats are .obj .off .ply .stl .jmap");
  EXPECT_EQ(write_map(Map(gmap(2)), "cube").error().message,
            "a file without a suffix has no format; the formats are .obj .off .ply .stl .jmap");
}

TEST_F(Io, AFileAppearsWholeOrNotAtAll) {
  Map const map = read_valid(data("cube.obj"), gmap(2));
  spill(path("cube.obj"), "old");
  spill(path("cube.obj.part0"), "of someone else");
  ASSERT_TRUE(write_map(map, path("cube.obj")));
  EXPECT_EQ(cells(read_valid(path("cube.obj"), gmap(2))), (Counts{8, 12, 6}));
  EXPECT_EQ(slurp(path("cube.obj.part0")), "of someone else");
  EXPECT_EQ(files(), 2U);

  fs::create_directories(path("folder.obj/inside"));
  auto const onto_folder = write_map(map, path("folder.obj"));
  ASSERT_FALSE(onto_folder);
  EXPECT_EQ(onto_folder.error().kind, Error::Kind::io);
  EXPECT_EQ(onto_folder.error().message, "cannot write the file: Is a directory");
  EXPECT_EQ(files(), 3U);

  auto const nowhere = write_map(map, path("none/cube.obj"));
  ASSERT_FALSE(nowhere);
  EXPECT_EQ(nowhere.error().message, "cannot write the file: No such file or directory");
}

TEST_F(Io, OfSeveralFilesAllAppearOrNone) {
  fs::create_directories(path("folder"));
  spill(path("first"), "old");
  for (std::string const& refused : {path("folder"), path("none/second")}) {
    FileText const files_to_write[] = {{path("first"), "new"}, {path("second"), "new"}, {refused, "new"}};
    auto const written = write_whole_files(files_to_write);
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().file, refused);
    EXPECT_EQ(slurp(path("first")), "old");
    EXPECT_EQ(files(), 2U);
  }
  FileText const files_to_write[] = {{path("first"), "new"}, {path("second"), ""}};
  ASSERT_TRUE(write_whole_files(files_to_write));
  EXPECT_EQ(slurp(path("first")), "new");
  EXPECT_EQ(slurp(path("second")), "");
  EXPECT_EQ(files(), 3U);
}

std::string const not_in_a_surface = "; a surface file cannot hold that, write a .jmap";

TEST_F(Io, MapsThatNoSurfaceFileHolds) {
  auto const refused = [&](Map const& map) {
    auto const result = write_map(map, path("out.obj"));
    EXPECT_FALSE(fs::exists(path("out.obj")));
    return result ? std::string("written") : result.error().message;
  };
  Model const g = gmap(2);
  Map map(g, positions(g));
  EXPECT_EQ(refused(map), "the map has no faces" + not_in_a_surface);
  EXPECT_EQ(refused(Map(g)), "the map has no embedding of type Point3 on vertices" + not_in_a_surface);
  EXPECT_EQ(refused(Map(gmap(1))), "a map of gmap(1) has no faces known here" + not_in_a_surface);

  // A path of two edges: its ends are free in dimension 1.
  map.add_darts(4);
  map.link(0, 0, 1);
  map.link(1, 1, 2);
  map.link(2, 0, 3);
  EXPECT_EQ(refused(map), "dart 0 has no value of 'position'" + not_in_a_surface);
  for (Dart d = 0; d < 4; ++d) map.embedding(0).set_handle(d, map.embedding(0).add(Point3{double((d + 1) / 2), 0, 0}));
  EXPECT_EQ(refused(map), "the face of dart 0 is open: the 1-arc of dart 3 is a loop" + not_in_a_surface);
  // Closed, it is a face of two corners.
  map.link(3, 1, 0);
  map.embedding(0).set_handle(3, map.embedding(0).handle(0));
  EXPECT_EQ(refused(map), "the face of dart 0 has only 2 corners" + not_in_a_surface);
  // Without its 0-arcs it is no face either.
  for (Dart d = 0; d < 4; ++d) map.link(d, 0, d);
  EXPECT_EQ(refused(map), "the face of dart 0 is open: the 0-arc of dart 0 is a loop" + not_in_a_surface);

  Map point = read_valid(data("cube.obj"), g);
  point.embedding(0).values<Point3>()[0].x = std::nan("");
  EXPECT_EQ(refused(point), "dart 0 has a 'position' that is not finite" + not_in_a_surface);
  EXPECT_EQ(write_map(point, path("out.jmap")).error().message, "dart 0 has a 'position' that is not finite");

  // One edge with both its sides in one face of an O-map.
  Model const o = omap(2);
  Map wire(o, positions(o));
  wire.add_darts(4);
  for (auto [from, to] : {std::pair{0U, 1U}, {1U, 2U}, {2U, 3U}, {3U, 0U}}) wire.set_target(from, 1, to);
  wire.link(0, 2, 3);
  wire.link(1, 2, 2);
  for (Dart d = 0; d < 4; ++d) {
    wire.embedding(0).set_handle(d, wire.embedding(0).add(Point3{double(d % 2), double(d / 3), 0}));
  }
  wire.embedding(0).set_handle(3, wire.embedding(0).handle(1));
  ASSERT_FALSE(find_violation(wire)) << find_violation(wire)->text;
  EXPECT_EQ(refused(wire), "the face of dart 0 meets the vertex of dart 3 twice" + not_in_a_surface);
}

TEST_F(Io, StlRefusesWhatAFloatCannotHold) {
  auto const far = parse("a.obj", "v 1e300 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", gmap(2));
  EXPECT_EQ(write_map(*far, path("a.stl")).error().message, "vertex 0 is beyond the range of STL's numbers");
  auto const thin = parse("a.obj", "v 1 0 0\nv 1.000000000001 0 0\nv 0 1 0\nf 1 2 3\n", gmap(2));
  EXPECT_EQ(write_map(*thin, path("a.stl")).error().message,
            "vertices 0, 1 and 2 are not three points in STL's precision");
}

// Whatever the bytes are: an error that says something, or a map that is one.
TEST_F(Io, BrokenFilesGiveErrorsOrValidMaps) {
  std::vector<std::pair<std::string, std::string>> files = {
      {"a.obj", slurp(data("cube.obj"))}, {"a.off", slurp(data("tetrahedron.off"))},
      {"a.ply", slurp(data("grid.ply"))}, {"a.ply", binary_grid(false)},
      {"a.ply", binary_grid(true)},       {"a.stl", slurp(data("tetrahedron.stl"))}};
  ASSERT_TRUE(write_map(read_valid(data("tetrahedron.stl"), gmap(2)), path("b.stl")));
  files.emplace_back("a.stl", slurp(path("b.stl")));
  std::size_t maps = 0;
  std::size_t errors = 0;
  auto const check = [&](std::string const& name, std::string const& bytes, Model const& model) {
    auto const surface = io::find_format(io::suffix_of(name))->parse(bytes, name);  // without a file: they are many
    auto const map = surface ? io::to_map(*surface, model, positions(model), name) : tl::unexpected(surface.error());
    ++(map ? maps : errors);
    if (!map) {
      ASSERT_FALSE(map.error().message.empty());
      ASSERT_EQ(map.error().kind, Error::Kind::bad_input);
    } else if (auto const violation = find_violation(*map)) {
      FAIL() << name << ": " << violation->text << "\n" << bytes;
    }
  };
  std::mt19937 random(20260117);
  for (auto const& [name, bytes] : files) {
    for (std::size_t size = 0; size < bytes.size(); ++size) check(name, bytes.substr(0, size), gmap(2));
    for (int i = 0; i < 2000; ++i) {
      std::string mutated = bytes;
      mutated[random() % mutated.size()] =
          i % 2 == 0 ? static_cast<char>(random() % 256) : "0123456789 -.\n"[random() % 14];
      check(name, mutated, i % 4 < 2 ? gmap(2) : omap(2));
    }
  }
  EXPECT_GT(maps, 1000U);
  EXPECT_GT(errors, 1000U);
}

}  // namespace
}  // namespace jrule
