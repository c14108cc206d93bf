#include <gtest/gtest.h>

#include <array>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <functional>
#include <limits>
#include <locale>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "compiler/backend/draw/draw.h"
#include "jrule/io.h"

namespace jrule::draw {
namespace {

constexpr Letter letter(int d, bool conjugate = false) { return {static_cast<std::uint8_t>(d), conjugate}; }

EmbeddingSpec on_vertices(Model const& model, Type type) {
  return {"position", *cell_orbit(model, 0), type, std::nullopt, MergePolicy::none};
}

Map read_bunny(Model const& model) {
  auto map = read_map(JRULE_SOURCE_DIR "/examples/data/bunny.obj", model, {on_vertices(model, Type::Point3)});
  if (!map) throw std::runtime_error(to_string(map.error()));
  return std::move(*map);
}

/// G-map polygons, glued nowhere; each corner at the position that `place` gives it.
template <class P>
Map polygons(std::size_t faces, std::size_t corners, Type type, std::function<P(std::size_t, std::size_t)> const& place,
             std::vector<EmbeddingSpec> more = {}) {
  Model const model = gmap(2);
  more.insert(more.begin(), on_vertices(model, type));
  Map map(model, std::move(more));
  for (std::size_t f = 0; f < faces; ++f) {
    std::vector<Dart> const d = map.add_darts(2 * corners);
    for (std::size_t k = 0; k < corners; ++k) {
      Dart const begin = d[2 * k], before = d[(2 * k + 2 * corners - 1) % (2 * corners)];
      map.link(begin, 0, d[2 * k + 1]);
      map.link(begin, 1, before);
      Handle const handle = map.embedding(0).add(place(f, k));
      map.embedding(0).set_handle(begin, handle);
      map.embedding(0).set_handle(before, handle);
    }
  }
  return map;
}

Point3 corner_of_square(std::size_t face, std::size_t k) {
  return {k == 1 || k == 2 ? 1.0 : 0.0, k >= 2 ? 1.0 : 0.0, -static_cast<double>(face)};
}
Map squares(std::size_t faces) { return polygons<Point3>(faces, 4, Type::Point3, corner_of_square); }

/// A reader of just enough XML to tell whether a text is well-formed; the elements by name, with their attributes.
struct Element {
  std::string name;
  std::map<std::string, std::string> attributes;
};

std::vector<Element> parse_xml(std::string const& text) {
  std::vector<Element> elements;
  std::vector<std::string> open;
  std::size_t at = 0;
  auto const fault = [&](char const* what) { return std::runtime_error(what + (" at byte " + std::to_string(at))); };
  auto const name = [&] {
    std::size_t const begin = at;
    while (at < text.size() && (std::isalnum(static_cast<unsigned char>(text[at])) != 0 || text[at] == '-')) ++at;
    if (at == begin) throw fault("a name is missing");
    return text.substr(begin, at - begin);
  };
  auto const expect = [&](char c) {
    if (at >= text.size() || text[at] != c) throw fault("an unexpected character");
    ++at;
  };
  while (at < text.size()) {
    if (text[at] != '<') {
      bool const entity =
          text.compare(at, 4, "&lt;") == 0 || text.compare(at, 4, "&gt;") == 0 || text.compare(at, 5, "&amp;") == 0;
      if (text[at] == '>' || (text[at] == '&' && !entity)) throw fault("a bare character");
      if (open.empty() && text[at] != '\n') throw fault("text outside the root");
      ++at;
      continue;
    }
    ++at;
    if (text[at] == '/') {
      ++at;
      if (open.empty() || name() != open.back()) throw fault("an end tag without its start tag");
      expect('>');
      open.pop_back();
      continue;
    }
    if (open.empty() && !elements.empty()) throw fault("a second root");
    Element element{name(), {}};
    while (at < text.size() && text[at] == ' ') {
      ++at;
      std::string const key = name();
      expect('=');
      expect('"');
      std::size_t const begin = at;
      while (at < text.size() && text[at] != '"' && text[at] != '<' && text[at] != '&') ++at;
      if (!element.attributes.emplace(key, text.substr(begin, at - begin)).second) throw fault("an attribute twice");
      expect('"');
    }
    if (at < text.size() && text[at] == '/') ++at;
    else open.push_back(element.name);
    expect('>');
    elements.push_back(std::move(element));
  }
  if (!open.empty()) throw fault("an element is not closed");
  return elements;
}

std::vector<Element> polygons_of(Result<std::string> const& svg) {
  if (!svg) throw std::runtime_error(to_string(svg.error()));
  std::vector<Element> found;
  for (Element& element : parse_xml(*svg)) {
    if (element.name == "polygon") found.push_back(std::move(element));
  }
  return found;
}

std::string error_of(Result<std::string> const& svg) {
  if (svg) return "no error";
  EXPECT_EQ(svg.error().kind, Error::Kind::bad_input);
  return svg.error().message;
}

TEST(SurfaceSvg, OneSquare) {
  auto const svg = surface_svg(squares(1), 100);
  ASSERT_TRUE(svg) << to_string(svg.error());
  auto const elements = parse_xml(*svg);
  ASSERT_EQ(elements.size(), 5U);
  EXPECT_EQ(elements[0].name, "svg");
  EXPECT_EQ(elements[0].attributes.at("xmlns"), "http://www.w3.org/2000/svg");
  EXPECT_EQ(elements[1].name, "title");
  EXPECT_NE(svg->find("<title>gmap(2), 1 face</title>"), std::string::npos);
  EXPECT_EQ(elements[2].attributes.at("fill"), "#ffffff");
  EXPECT_EQ(elements[3].name, "g");
  // From the corner's right, above and before: the right side, x = 1, is nearer, thus lower than the left.
  double x[4], y[4];
  ASSERT_EQ(std::sscanf(elements[4].attributes.at("points").c_str(), "%lf,%lf %lf,%lf %lf,%lf %lf,%lf", x, y, x + 1,
                        y + 1, x + 2, y + 2, x + 3, y + 3),
            8);
  EXPECT_LT(x[0], x[1]);
  EXPECT_EQ(x[1], x[2]);
  EXPECT_EQ(x[0], x[3]);
  EXPECT_GT(y[1], y[2]);
  EXPECT_GT(y[1], y[0]);
  for (int k = 0; k < 4; ++k) {
    EXPECT_GE(x[k], 4);
    EXPECT_LE(x[k], 96);
    EXPECT_GE(y[k], 3.99);
    EXPECT_LE(y[k], 96.01);
  }
}

TEST(SurfaceSvg, TheSameSurfaceInEveryModel) {
  auto const svg = surface_svg(read_bunny(gmap(2)));
  auto const faces = polygons_of(svg);
  EXPECT_EQ(faces.size(), 3674U);
  EXPECT_EQ(*svg, *surface_svg(read_bunny(gmap(2))));
  std::string const body = svg->substr(svg->find("<rect"));
  for (Model const& model : {omap(2), dual_omap(2), gmap(3)}) {
    auto const other = surface_svg(read_bunny(model));
    ASSERT_TRUE(other) << model.name << ": " << to_string(other.error());
    EXPECT_TRUE(other->substr(other->find("<rect")) == body) << model.name << '(' << model.dimension << ')';
  }
}

TEST(SurfaceSvg, FitsItsWidth) {
  for (int width : {1, 20, 800, 5000}) {
    auto const svg = surface_svg(read_bunny(omap(2)), width);
    ASSERT_TRUE(svg);
    auto const root = parse_xml(*svg).front();
    int const w = std::stoi(root.attributes.at("width")), h = std::stoi(root.attributes.at("height"));
    EXPECT_EQ(std::max(w, h), width);
    EXPECT_EQ(root.attributes.at("viewBox"), "0 0 " + std::to_string(w) + " " + std::to_string(h));
    for (auto const& face : polygons_of(svg)) {
      double x[3], y[3];
      ASSERT_EQ(std::sscanf(face.attributes.at("points").c_str(), "%lf,%lf %lf,%lf %lf,%lf", x, y, x + 1, y + 1, x + 2,
                            y + 2),
                6);
      for (int k = 0; k < 3; ++k) {
        ASSERT_TRUE(x[k] >= 0 && x[k] <= w && y[k] >= 0 && y[k] <= h) << x[k] << ',' << y[k];
      }
    }
  }
}

TEST(SurfaceSvg, StaysSmall) {
  auto const svg = surface_svg(squares(11022));
  ASSERT_TRUE(svg);
  EXPECT_EQ(polygons_of(svg).size(), 11022U);
  EXPECT_LT(svg->size(), 2500000U);
}

TEST(SurfaceSvg, NearerFacesCoverFartherOnes) {
  // Parallel squares, the first the nearest; each has its own colour.
  Model const model = gmap(2);
  EmbeddingSpec const color{"color", *cell_orbit(model, 2), Type::Color, std::nullopt, MergePolicy::none};
  Map map = polygons<Point3>(3, 4, Type::Point3, corner_of_square, {color});
  std::array<Color, 3> const given{Color{1, 0, 0}, Color{0, 1, 0}, Color{0, 0, std::nan("")}};
  for (std::size_t f = 0; f < 3; ++f) {
    Handle const handle = map.embedding(1).add(given[f]);
    for (Dart d = 0; d < 8; ++d) map.embedding(1).set_handle(static_cast<Dart>(8 * f + d), handle);
  }
  auto const faces = polygons_of(surface_svg(map));
  ASSERT_EQ(faces.size(), 3U);
  EXPECT_EQ(faces[0].attributes.at("fill"), "#000000");  // not a number is no light
  std::string const green = faces[1].attributes.at("fill"), red = faces[2].attributes.at("fill");
  EXPECT_EQ(green.substr(0, 3) + green.substr(5), "#0000");
  EXPECT_NE(green, "#000000");
  EXPECT_EQ(red.substr(3), "0000");
  EXPECT_NE(red, "#000000");
}

TEST(SurfaceSvg, BothSidesAreLitAlike) {
  auto const reversed = [](std::size_t face, std::size_t k) { return corner_of_square(face, 3 - k); };
  auto const front = polygons_of(surface_svg(squares(1)));
  auto const back = polygons_of(surface_svg(polygons<Point3>(1, 4, Type::Point3, reversed)));
  EXPECT_EQ(front.at(0).attributes.at("fill"), back.at(0).attributes.at("fill"));
}

TEST(SurfaceSvg, ThinnerEdgesWhenThereAreManyFaces) {
  auto const stroke = [](Map const& map) {
    auto const svg = surface_svg(map);
    return std::stod(parse_xml(svg.value()).at(3).attributes.at("stroke-width"));
  };
  EXPECT_LT(stroke(squares(10000)), stroke(squares(100)));
  EXPECT_GT(stroke(squares(100000)), 0);
}

TEST(SurfaceSvg, APlaneMapIsSeenFromTheFront) {
  auto const place = [](std::size_t face, std::size_t k) {
    Point3 const p = corner_of_square(face, k);
    return Point2{p.x, p.y};
  };
  auto const faces = polygons_of(surface_svg(polygons<Point2>(1, 4, Type::Point2, place), 100));
  EXPECT_EQ(faces.at(0).attributes.at("points"), "4.00,96.00 96.00,96.00 96.00,4.00 4.00,4.00");
}

TEST(SurfaceSvg, OrbitTypesAreRecognizedInAnyOrder) {
  EmbeddingSpec const spec{"p", orbit_of_dimensions({2, 1}), Type::Point3, std::nullopt, MergePolicy::none};
  Map map(gmap(2), {spec});
  map.add_darts(1);
  EXPECT_EQ(error_of(surface_svg(map)), "the face of dart 0 is open: the 0-arc of dart 0 is a loop");
  map = Map(omap(2), {{"p", {{{letter(1, true), letter(2)}}}, Type::Point3, Point3{}, MergePolicy::none}});
  map.add_darts(1);
  map.embedding(0).set_handle(0, map.embedding(0).add(Point3{1, 2, 3}));
  EXPECT_EQ(polygons_of(surface_svg(map)).size(), 1U);
}

TEST(SurfaceSvg, PointsThatCoincideAndExtremeOnes) {
  double constexpr huge = std::numeric_limits<double>::max(), tiny = std::numeric_limits<double>::denorm_min();
  auto const draw = [](double scale, double offset) {
    return surface_svg(polygons<Point3>(2, 4, Type::Point3, [&](std::size_t face, std::size_t k) {
      Point3 const p = corner_of_square(face, k);
      return Point3{p.x * scale + offset, p.y * scale + offset, p.z * scale + offset};
    }));
  };
  auto const all_equal = draw(0, 7);
  EXPECT_EQ(polygons_of(all_equal).size(), 2U);
  EXPECT_EQ(all_equal->find("nan"), std::string::npos);
  EXPECT_EQ(all_equal->find("inf"), std::string::npos);
  std::string const usual = draw(1, 0).value();
  EXPECT_EQ(draw(0x1p1020, 0).value(), usual);
  EXPECT_EQ(draw(0x1p-1000, 0).value(), usual);
  EXPECT_EQ(draw(1, 1024).value(), usual);
  for (auto const& svg : {draw(huge, 0), draw(tiny, 0)}) {
    EXPECT_EQ(polygons_of(svg).size(), 2U);
    EXPECT_EQ(svg->find("nan"), std::string::npos);
    EXPECT_EQ(svg->find("inf"), std::string::npos);
  }
}

TEST(SurfaceSvg, WhatHasNoPicture) {
  Model const model = gmap(2);
  EXPECT_EQ(error_of(surface_svg(Map(model, {on_vertices(model, Type::Point3)}))), "an empty map has no picture");
  EXPECT_EQ(error_of(surface_svg(Map(gmap(1)))), "a map of gmap(1) has no polygons to draw");
  EXPECT_EQ(error_of(surface_svg(Map(omap(1)))), "a map of omap(1) has no polygons to draw");
  EXPECT_EQ(error_of(surface_svg(squares(1), 0)), "a picture is at least one pixel wide");

  Map bare(model);
  for (int i = 0; i < 4; ++i) bare.add_darts(1);
  for (Dart d : {0U, 2U}) {
    bare.link(d, 0, d + 1);
    bare.link(d + 1, 1, (d + 2) % 4);
  }
  EXPECT_EQ(error_of(surface_svg(bare)), "the map has no embedding of type Point3 or Point2 on vertices");
  bare.link(1, 1, 1);
  bare.link(2, 1, 2);
  EXPECT_EQ(error_of(surface_svg(bare)), "the face of dart 0 is open: the 1-arc of dart 1 is a loop");

  Map map = squares(2);
  map.embedding(0).set_handle(10, no_handle);
  EXPECT_EQ(error_of(surface_svg(map)), "dart 10 has no `position`");
  map = squares(2);
  map.embedding(0).values<Point3>()[map.embedding(0).handle(12)].y = std::numeric_limits<double>::infinity();
  EXPECT_EQ(error_of(surface_svg(map)), "the `position` of dart 12 is not finite");
}

TEST(SurfaceSvg, IsTheSameInEveryLocale) {
  struct Commas : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
  };
  auto const usual = surface_svg(squares(2000), 5000);
  std::locale const before = std::locale::global(std::locale(std::locale::classic(), new Commas));
  auto const other = surface_svg(squares(2000), 5000);
  std::locale::global(before);
  EXPECT_EQ(usual.value(), other.value());
}

TEST(SurfaceSvg, SeveralMapsAreDrawnInOneFrame) {
  Map const near = squares(1);
  Map const both = squares(2);
  auto const svgs = surface_svgs({&near, &both}, 300, false);
  ASSERT_TRUE(svgs);
  ASSERT_EQ(svgs->size(), 2U);
  auto const first = polygons_of((*svgs)[0]), second = polygons_of((*svgs)[1]);
  ASSERT_EQ(first.size(), 1U);
  ASSERT_EQ(second.size(), 2U);
  // What is at one place lies at one place: of the two, the nearer one is drawn last.
  EXPECT_EQ(first[0].attributes, second[1].attributes);
  EXPECT_EQ(surface_svgs({&both}, 300, false)->front(), *surface_svg(both, 300));
  std::string const dotted = surface_svgs({&near}, 300, true)->front();
  std::size_t dots = 0;
  for (std::size_t at = dotted.find("<circle"); at != std::string::npos; at = dotted.find("<circle", at + 1)) ++dots;
  EXPECT_EQ(dots, 4U);
  EXPECT_FALSE(surface_svgs({&near, nullptr}, 0, false));
  Map const empty(gmap(2), {on_vertices(gmap(2), Type::Point3)});
  EXPECT_FALSE(surface_svgs({&near, &empty}, 300, false));
  EXPECT_TRUE(surface_svgs({}, 300, false)->empty());
}

TEST(SurfaceSvg, TheNameOfAModelIsEscaped) {
  Model model = gmap(2);
  model.name = "a<b&c>";
  Map map(model, {on_vertices(model, Type::Point3)});
  map.add_darts(2);
  map.link(0, 0, 1);
  map.link(0, 1, 1);
  Handle const handle = map.embedding(0).add(Point3{});
  for (Dart d : {0U, 1U}) map.embedding(0).set_handle(d, handle);
  auto const svg = surface_svg(map);
  EXPECT_EQ(polygons_of(svg).size(), 1U);
  EXPECT_NE(svg->find("<title>a&lt;b&amp;c&gt;(2), 1 face</title>"), std::string::npos);
}

}  // namespace
}  // namespace jrule::draw
