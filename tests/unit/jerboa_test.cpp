// Code of Jerboa's rules as expressions of jrule; names of Jerboa as names of jrule.
#include <gtest/gtest.h>

#include <string>

#include "compiler/jerboa/names.h"
#include "compiler/jerboa/translate.h"

namespace jrule::jerboa {
namespace {

Scope scope() {
  Scope result;
  result.nodes = {{"n0", "n0"}, {"n1", "n1"}, {"left", "left_"}};
  result.embeddings = {{"pos", {"pos", Type::point3}}, {"color", {"color", Type::color}}, {"normal", {"normal", Type::vec3}}, {"n", {"n", Type::integer}}};
  result.parameters = {{"weight", {"weight", Type::real}}, {"shift", {"shift", Type::vec3}}, {"count", {"count", Type::integer}}, {"flag", {"flag", Type::boolean}}};
  return result;
}

/// The expression, or `! reason`, with the code where the translation stopped in braces.
std::string translated(std::string const& code, Type type) {
  auto const result = translate(code, scope(), type);
  if (result) return *result;
  auto const& stop = result.error();
  return "! " + stop.reason + " {" + code.substr(stop.begin, stop.end - stop.begin) + "}";
}
std::string point(std::string const& code) { return translated(code, Type::point3); }
std::string real(std::string const& code) { return translated(code, Type::real); }
std::string color(std::string const& code) { return translated(code, Type::color); }
std::string condition(std::string const& code) { return translated(code, Type::boolean); }

TEST(Translate, Coordinates) {
  EXPECT_EQ(point("return new Vec3(0, 1.5, -2);"), "Point3(0, 1.5, -2)");
  EXPECT_EQ(point("return new fr.lias.Vec3();"), "Point3(0, 0, 0)");
  EXPECT_EQ(point("geo::Vec3(.5, 1.f, 2e3)"), "Point3(0.5, 1.0, 2000.0)");
  EXPECT_EQ(translated("new Vec3(0, 0, 1)", Type::vec3), "Vec3(0, 0, 1)");
  EXPECT_EQ(point("new Vec3(0, 1)"), "! `Vec3` has 3 components {new Vec3(0, 1)}");
}

TEST(Translate, ValuesAtNodes) {
  EXPECT_EQ(point("return n0.pos;"), "n0.pos");
  EXPECT_EQ(point("return n0@0.pos;"), "n0@0.pos");
  EXPECT_EQ(point("return left@0@1.pos;"), "left_@[0,1].pos");
  EXPECT_EQ(point("return n0@1.<Vec3>ebd(\"pos\");"), "n0@1.pos");
  EXPECT_EQ(point("return n0.alpha(0).alpha(2).<Vec3>ebd(\"pos\");"), "n0@[0,2].pos");
  EXPECT_EQ(point("return *(Vec3*)n0()->ebd(\"pos\");"), "n0.pos");
  EXPECT_EQ(point("return new Vec3(n1.pos);"), "n1.pos");
  EXPECT_EQ(point("return n2.pos;"), "! `n2.pos` is not known {n2.pos}");
  EXPECT_EQ(point("return n0.soil;"), "! there is no embedding `soil` here {n0.soil}");
  EXPECT_EQ(point("return n0;"), "! a dart is no Point3 {n0}");
}

TEST(Translate, MeansAndSegments) {
  EXPECT_EQ(point("return Vec3.mid(n0.pos, n1.pos);"), "midpoint(n0.pos, n1.pos)");
  EXPECT_EQ(point("return Point3.middle(n0.pos, new Point3(0, 0, 0));"), "midpoint(n0.pos, Point3(0, 0, 0))");
  EXPECT_EQ(point("return Vec3::middle(<0,1>_pos(n0@2));"), "mean(<0,1>(n0@2).pos)");
  EXPECT_EQ(point("Vec3 c = new Vec3(); c.barycenter(<0,1,3>_pos(n0)); return new Vec3(Vec3.segmentABByWeight(n0.pos, c, 0.4f));"),
            "lerp(n0.pos, mean(<0,1,3>(n0).pos), 0.4)");
  EXPECT_EQ(color("return Color.middle(<0,1>_color(n0));"), "mean(<0,1>(n0).color)");
  EXPECT_EQ(point("return Vec3.mid(n0.pos, n1.pos, n0.pos);"), "! `mid` is known of a list or of two values {Vec3.mid(n0.pos, n1.pos, n0.pos)}");
  EXPECT_EQ(point("return middle(<0,1>_soil(n0));"), "! there is no embedding `soil` here {<0,1>_soil}");
}

TEST(Translate, PlacesAndDisplacements) {
  EXPECT_EQ(point("return n0.pos.addn(0, 0, 1);"), "n0.pos + Vec3(0, 0, 1)");
  EXPECT_EQ(point("return n0.pos.addn(shift);"), "n0.pos + shift");
  EXPECT_EQ(point("return n0.pos - 2 * n0.normal;"), "n0.pos - 2 * n0.normal");
  EXPECT_EQ(point("return n0.pos + (n1.pos - n0.pos) * weight;"), "n0.pos + (n1.pos - n0.pos) * weight");
  EXPECT_EQ(translated("return n1.pos - n0.pos;", Type::vec3), "n1.pos - n0.pos");
  // Sums of places are those of the displacements from the origin.
  EXPECT_EQ(point("return (n0.pos + n1.pos) / 2;"), "Point3(0, 0, 0) + (n0.pos + (n1.pos - Point3(0, 0, 0)) - Point3(0, 0, 0)) / 2");
  EXPECT_EQ(point("return shift;"), "Point3(0, 0, 0) + shift");
  // Changed in place: what the map has would be another value afterwards.
  EXPECT_EQ(point("return n0.pos.add(shift);"), "! `add` has no counterpart {n0.pos.add(shift)}");
  EXPECT_EQ(point("Vec3 p = n0.pos; p.add(shift); p += new Vec3(1, 0, 0); return p;"), "n0.pos + shift + Vec3(1, 0, 0)");
}

TEST(Translate, Colors) {
  EXPECT_EQ(color("return new Color(0, 153, 255);"), "Color(0, 153 / 255, 1)");
  EXPECT_EQ(color("return new Color(0.5f, 1.0f, 0f);"), "Color(0.5, 1.0, 0.0)");
  EXPECT_EQ(color("Color col = new Color(20,20,25);\nreturn col;"), "Color(20 / 255, 20 / 255, 25 / 255)");
  EXPECT_EQ(color("return Color.red;"), "Color(1, 0, 0)");
  EXPECT_EQ(color("return new Color(1, 2, 3, 4);"), "! colors have three components, red, green and blue {new Color(1, 2, 3, 4)}");
}

TEST(Translate, Numbers) {
  EXPECT_EQ(real("return 2 * (weight + 1);"), "2 * (weight + 1)");
  EXPECT_EQ(real("return 1 - (2 - weight);"), "1 - (2 - weight)");
  EXPECT_EQ(real("return Math.sqrt(weight) / Math.PI;"), "sqrt(weight) / pi");
  EXPECT_EQ(real("return n0.pos.x + n0.pos.y();"), "n0.pos.x + n0.pos.y");
  EXPECT_EQ(real("return (double) count / 2;"), "count / 2");
  EXPECT_EQ(real("return flag ? 1 : weight;"), "if flag then 1 else weight");
  // Java divides Ints to an Int.
  EXPECT_EQ(real("return 7 / 2;"), "3");
  EXPECT_EQ(real("return count / 2;"), "! there is no division of Ints {count / 2}");
  EXPECT_EQ(real("return 010;"), "! `010` is no decimal number that fits {010}");
  EXPECT_EQ(real("return 1e999;"), "! the number is too large {1e999}");
}

TEST(Translate, Conditions) {
  EXPECT_EQ(condition("return n0@2 == n0 || !flag && count < 3;"), "n0@2 == n0 or not flag and count < 3");
  EXPECT_EQ(condition("return (flag || count > 1) && n0 != n1;"), "(flag or count > 1) and n0 != n1");
  EXPECT_EQ(condition("return n0.pos == n1.pos;"), "! a Point3 and a Point3 are not compared by `==` {n0.pos == n1.pos}");
}

TEST(Translate, GivesUpWhereItStands) {
  EXPECT_EQ(point(""), "! it ends where an expression goes on {}");
  EXPECT_EQ(point("return"), "! it ends where an expression goes on {}");
  EXPECT_EQ(point("return n0.pos; n1"), "! `n1` is not expected there {n1}");
  EXPECT_EQ(point("for (int i = 0; i < 3; i++) {}"), "! `int` is neither a node of the left side, nor a parameter, nor a variable {int}");
  EXPECT_EQ(point("@print(n0); return n0.pos;"), "! `@` is not expected there {@}");
  EXPECT_EQ(point("return unknown;"), "! `unknown` is neither a node of the left side, nor a parameter, nor a variable {unknown}");
  EXPECT_EQ(point("return new Soil(1);"), "! the type `Soil` is not known {new Soil(1)}");
  EXPECT_EQ(real("return " + std::string(200, '(') + "1" + std::string(200, ')') + ";"), "! it is nested too deeply {(}");
}

TEST(Translate, VariablesDoNotMakeItGrowWithoutEnd) {
  std::string code = "float a = weight;";
  for (int i = 0; i < 60; ++i) code += "a = a + a;";
  EXPECT_TRUE(real(code + "return a;").starts_with("! it is too long"));
}

// Whatever it is cut to, it is translated or given up.
TEST(Translate, AnyPieceOfCode) {
  std::string const code = "Vec3 c = new Vec3(); c.barycenter(<0,1,3>_pos(n0)); c += -n0.normal * 2f; return flag ? c.addn(1, .5, 1e3) : (Vec3) n0@0@1.<Vec3>ebd(\"pos\");";
  int given_up = 0;
  for (std::size_t begin = 0; begin < code.size(); ++begin) {
    for (std::size_t size = 0; size <= code.size() - begin; ++size) {
      auto const result = translate(code.substr(begin, size), scope(), Type::point3);
      if (result) continue;
      ++given_up;
      ASSERT_LE(result.error().begin, result.error().end);
      ASSERT_LE(result.error().end, size);
    }
  }
  EXPECT_GT(given_up, 1000);
  EXPECT_EQ(point(code), "if flag then mean(<0,1,3>(n0).pos) + -n0.normal * 2.0 + Vec3(1, 0.5, 1000.0) else n0@[0,1].pos");
}

TEST(TypeOf, ClassesByTheirName) {
  EXPECT_EQ(type_of("fr.ensma.lias.jerboa.embeddings.Vec3"), Type::vec3);
  EXPECT_EQ(type_of("geo::Point3 const&"), Type::point3);
  EXPECT_EQ(type_of("java.awt.Color"), Type::color);
  EXPECT_EQ(type_of("List<Vec3>"), std::nullopt);
  EXPECT_EQ(type_of(""), std::nullopt);
}

TEST(TypeOf, VectorsAtVerticesArePlaces) {
  auto const type = [](std::string const& name, Orbit orbit) {
    return type_of(Embedding{.name = {name, {}}, .type = {"Vec3", {}}, .orbit = std::move(orbit), .comment = {}, .default_code = {}}, 3);
  };
  EXPECT_EQ(type("pos", {3, 1, 2}), Type::point3);
  EXPECT_EQ(type("pos", {1, 2}), Type::vec3);
  EXPECT_EQ(type("pos", {0, 1, 2}), Type::vec3);
  EXPECT_EQ(type("normal", {1, 2, 3}), Type::vec3);
}

TEST(Names, AreNamesOfTheLanguageAndGivenOnce) {
  Names names;
  EXPECT_EQ(names.take("Face"), "Face");
  EXPECT_EQ(names.take("Face"), "Face_2");
  EXPECT_EQ(names.take("left"), "left_");
  EXPECT_EQ(names.take("2D"), "_2D");
  EXPECT_EQ(names.take("a-b c"), "a_b_c");
  EXPECT_EQ(names.take("été"), "_t_");
  EXPECT_EQ(names.take(""), "_1");
  EXPECT_EQ(names.take("_"), "_1_2");
}

}  // namespace
}  // namespace jrule::jerboa
