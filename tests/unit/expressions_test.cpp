// The types of expressions and their trees. Wrong ones: expression_errors_test.cpp; values: evaluate_test.cpp.
#include "expressions_fixture.h"

namespace jrule::sema {
namespace {

// ---- Operators ----

TEST_F(Expressions, LiteralsAndNamesHaveTheirTypes) {
  for (char const* text : {"true", "false", "flag"}) expect_type(text, one(Type::Bool));
  for (char const* text : {"1", "n", "a.level"}) expect_type(text, one(Type::Int));
  for (char const* text : {"1.5", "pi", "h"}) expect_type(text, one(Type::Real));
  expect_type("u2", one(Type::Vec2));
  expect_type("u3", one(Type::Vec3));
  expect_type("p2", one(Type::Point2));
  expect_type("p3", one(Type::Point3));
  expect_type("red", one(Type::Color));
}

TEST_F(Expressions, ArithmeticOfNumbers) {
  for (char const* op : {" + ", " - ", " * "}) {
    expect_type(std::string("n") + op + "n", one(Type::Int));
    expect_type(std::string("n") + op + "h", one(Type::Real));
    expect_type(std::string("h") + op + "n", one(Type::Real));
    expect_type(std::string("h") + op + "h", one(Type::Real));
  }
  for (char const* text : {"n / n", "n / h", "h / n", "h / h", "-h"}) expect_type(text, one(Type::Real));
  expect_type("-n", one(Type::Int));
}

TEST_F(Expressions, ArithmeticOfVectors) {
  for (auto const& [v, type] : {std::pair{std::string("u2"), Type::Vec2}, {std::string("u3"), Type::Vec3}}) {
    for (auto const& text : {v + " + " + v, v + " - " + v, "h * " + v, v + " * h", "n * " + v, v + " * n", v + " / h",
                             v + " / n", "-" + v}) {
      expect_type(text, one(type));
    }
  }
}

TEST_F(Expressions, ArithmeticOfPoints) {
  expect_type("p2 - p2", one(Type::Vec2));
  expect_type("p3 - p3", one(Type::Vec3));
  for (char const* text : {"p2 + u2", "u2 + p2", "p2 - u2"}) expect_type(text, one(Type::Point2));
  for (char const* text : {"p3 + u3", "u3 + p3", "p3 - u3", "p3 + h * (p3 - p3)"}) expect_type(text, one(Type::Point3));
}

TEST_F(Expressions, ArithmeticOfColours) {
  for (char const* text :
       {"red + red", "red - red", "h * red", "red * h", "2 * red", "red * 2", "red / h", "red / 2"}) {
    expect_type(text, one(Type::Color));
  }
}

TEST_F(Expressions, ComparisonsAndLogic) {
  for (char const* op : {"<", "<=", ">", ">=", "==", "!="}) {
    for (char const* left : {"n", "h"}) {
      for (char const* right : {"n", "h"}) expect_type(std::string(left) + " " + op + " " + right, one(Type::Bool));
    }
  }
  for (char const* name : {"flag", "u2", "u3", "p2", "p3", "red"}) {
    expect_type(std::string(name) + " == " + name, one(Type::Bool));
    expect_type(std::string(name) + " != " + name, one(Type::Bool));
  }
  for (char const* text : {"flag and flag", "flag or flag", "not flag"}) expect_type(text, one(Type::Bool));
}

TEST_F(Expressions, AnIntBecomesARealWhereOneIsNeededAndNowhereElse) {
  EXPECT_EQ(print("n + n"), "(+ n n)");
  EXPECT_EQ(print("n + h"), "(+ (to_real n) h)");
  EXPECT_EQ(print("h * n"), "(* h (to_real n))");
  EXPECT_EQ(print("n / n"), "(/ (to_real n) (to_real n))");
  EXPECT_EQ(print("n < n"), "(< n n)");
  EXPECT_EQ(print("n == h"), "(== (to_real n) h)");
  EXPECT_EQ(print("n * u3"), "(* (to_real n) u3)");
  EXPECT_EQ(print("sqrt(n)"), "(sqrt (to_real n))");
  EXPECT_EQ(print("abs(n)"), "(abs n)");
  EXPECT_EQ(print("min(n, n)"), "(min n n)");
  EXPECT_EQ(print("max(n, h)"), "(max (to_real n) h)");
  EXPECT_EQ(print("lerp(u3, u3, n)"), "(lerp u3 u3 (to_real n))");
  EXPECT_EQ(print("if flag then n else h"), "(if flag (to_real n) h)");
  EXPECT_EQ(print("if flag then h else n"), "(if flag h (to_real n))");
  EXPECT_EQ(ir::print(*check("n", one(Type::Real)), rule_), "(to_real n)");
  EXPECT_EQ(ir::print(*check("n", one(Type::Int)), rule_), "n");
  EXPECT_EQ(ir::print(*check("n + n * n", one(Type::Real)), rule_), "(to_real (+ n (* n n)))");
}

TEST_F(Expressions, Conditionals) {
  expect_type("if flag then p3 else a.position", one(Type::Point3));
  expect_type("if flag then n else n", one(Type::Int));
  expect_type("if flag then n else h", one(Type::Real));
  expect_type("if flag then <0>(a).weight else <1>(a).weight", list_of(Type::Real));
}

// ---- Functions ----

TEST_F(Expressions, ConstructorsAndComponents) {
  expect_type("Vec2(1, 2.5)", one(Type::Vec2));
  expect_type("Vec3(1, h, n)", one(Type::Vec3));
  expect_type("Point2(0, 0)", one(Type::Point2));
  expect_type("Point3(0, 0, 0)", one(Type::Point3));
  expect_type("Color(1, 0.5, 0)", one(Type::Color));
  for (char const* text :
       {"u2.x", "u2.y", "u3.x", "u3.y", "u3.z", "p2.x", "p2.y", "p3.x", "p3.y", "p3.z", "red.r", "red.g", "red.b"}) {
    expect_type(text, one(Type::Real));
  }
  EXPECT_EQ(print("a.position.z"), "(z a.position)");
  EXPECT_EQ(print("red.g"), "(y red)");
}

TEST_F(Expressions, Geometry) {
  for (char const* text :
       {"dot(u2, u2)", "dot(u3, u3)", "norm(u2)", "norm(u3)", "distance(p2, p2)", "distance(p3, p3)"}) {
    expect_type(text, one(Type::Real));
  }
  expect_type("cross(u3, u3)", one(Type::Vec3));
  expect_type("normalize(u2)", one(Type::Vec2));
  expect_type("normalize(u3)", one(Type::Vec3));
  expect_type("area_vector(<0,1>(a).position)", one(Type::Vec3));
  for (auto const& [v, type] : {std::pair{std::string("h"), Type::Real},
                                {std::string("n"), Type::Real},
                                {std::string("u2"), Type::Vec2},
                                {std::string("u3"), Type::Vec3},
                                {std::string("p2"), Type::Point2},
                                {std::string("p3"), Type::Point3},
                                {std::string("red"), Type::Color}}) {
    expect_type("midpoint(" + v + ", " + v + ")", one(type));
    expect_type("lerp(" + v + ", " + v + ", 0.5)", one(type));
  }
}

TEST_F(Expressions, Mathematics) {
  for (char const* f : {"sqrt", "abs", "floor", "ceil", "sin", "cos", "tan", "exp", "log"}) {
    expect_type(std::string(f) + "(h)", one(Type::Real));
    expect_type(std::string(f) + "(n)", one(std::string(f) == "abs" ? Type::Int : Type::Real));
  }
  for (char const* f : {"atan2", "pow", "min", "max"}) expect_type(std::string(f) + "(h, n)", one(Type::Real));
  expect_type("min(n, n)", one(Type::Int));
  expect_type("max(n, n)", one(Type::Int));
  expect_type("atan2(n, n)", one(Type::Real));
}

TEST_F(Expressions, Aggregates) {
  for (auto const& [name, type] : {std::pair{std::string("weight"), Type::Real},
                                   {std::string("tangent"), Type::Vec2},
                                   {std::string("normal"), Type::Vec3},
                                   {std::string("uv"), Type::Point2},
                                   {std::string("position"), Type::Point3},
                                   {std::string("color"), Type::Color}}) {
    expect_type("mean(<0,1>(a)." + name + ")", one(type));
  }
  for (auto const& [name, type] : {std::pair{std::string("weight"), Type::Real},
                                   {std::string("level"), Type::Int},
                                   {std::string("tangent"), Type::Vec2},
                                   {std::string("normal"), Type::Vec3},
                                   {std::string("color"), Type::Color}}) {
    expect_type("sum(<0,1>(a)." + name + ")", one(type));
  }
  expect_type("mean(<0,1>(a).level)", one(Type::Real));
  for (char const* f : {"min", "max"}) {
    expect_type(std::string(f) + "(<0,1>(a).weight)", one(Type::Real));
    expect_type(std::string(f) + "(<0,1>(a).level)", one(Type::Int));
  }
  for (auto const& e : rule_.modeler->embeddings) {
    expect_type("count(<0,1>(a)." + e.name + ")", one(Type::Int));
    expect_type("first(<0,1>(a)." + e.name + ")", one(e.type));
  }
  expect_type("all(<0,1>(a).mark)", one(Type::Bool));
  expect_type("any(<0,1>(a).mark)", one(Type::Bool));
}

// ---- Names and the map ----

TEST_F(Expressions, AParameterHidesALetAndALetHidesANode) {
  rule_.lets.push_back({"m", check("mean(<0,1>(a).position)")});
  EXPECT_EQ(print("m + u3"), "(+ m u3)");
  expect_type("m", one(Type::Point3));
  rule_.lets.push_back({"h", check("flag")});
  expect_type("h", one(Type::Real));
  rule_.lets.push_back({"b", check("u3")});
  expect_type("b", one(Type::Vec3));
  expect_type("b.x", one(Type::Real));
  rule_.lets.push_back({"pi", check("3")});
  expect_type("pi", one(Type::Int));
}

TEST_F(Expressions, PathsAreInNormalForm) {
  EXPECT_EQ(print("a.position"), "a.position");
  EXPECT_EQ(print("a@0.position"), "a@0.position");
  EXPECT_EQ(print("a@[0,1].position"), "a@[0,1].position");
  EXPECT_EQ(print("a@[1,0].position"), "a@[1,0].position");
  EXPECT_EQ(print("a@[2,0].position"), "a@[0,2].position");
  EXPECT_EQ(print("a@0@1@1.position"), "a@0.position");
  EXPECT_EQ(print("a@[0,1]@[1,0].position"), "a.position");
  EXPECT_EQ(print("a@[].position"), "a.position");
  EXPECT_EQ(print("a@i.position"), "a@2.position");
  EXPECT_EQ(print("a@[i-2,i+1].position"), "a@[0,3].position");
  EXPECT_EQ(print("(a@~0).position"), "a@0.position");
  EXPECT_EQ(std::get<ir::NodeDart>(std::get<ir::ValueAt>(check("b.weight")->value).at->value).node, 1U);
  EXPECT_EQ(std::get<ir::ValueAt>(check("b.weight")->value).embedding, 5U);
}

TEST_F(Expressions, PathsOfOrientedMapsGoBackwards) {
  auto modeler = std::make_shared<ir::Modeler>(*rule_.modeler);
  modeler->model = omap(2);
  rule_.modeler = modeler;
  group_ = algebra::Group(omap(2));
  EXPECT_EQ(print("a@~1.weight"), "a@~1.weight");
  EXPECT_EQ(print("a@~1@1.weight"), "a.weight");
  EXPECT_EQ(print("a@1@1.weight"), "a@[1,1].weight");
}

TEST_F(Expressions, AListHasAValueForEachOrbitOfTheIntersection) {
  EXPECT_EQ(print("<0,1>(a).position"), "<0,1>(a by <1>).position");  // a face: its vertices, by <1>
  EXPECT_EQ(print("<0,1>(a@2).color"), "<0,1>(a@2 by <0>).color");    // its edges
  EXPECT_EQ(print("<0,1>(a).normal"), "<0,1>(a by <>).normal");       // its darts
  EXPECT_EQ(print("<>(a).position"), "<>(a by <>).position");
  EXPECT_EQ(print("<1,2>(a).position"), "<1,2>(a by <1,2>).position");  // one value
  EXPECT_EQ(print("<3,2,1,0>(a).position"), "<3,2,1,0>(a by <3,2,1>).position");
  EXPECT_EQ(print("<1,1,0>(a).position"), "<1,1,0>(a by <1>).position");
  EXPECT_EQ(print("face(a).position"), "<0,1,3>(a by <1,3>).position");
  EXPECT_EQ(print("cell(i)(a).position"), "<0,1,3>(a by <1,3>).position");
  EXPECT_EQ(print("<0..i>(a).position"), "<0,1,2>(a by <1,2>).position");
  expect_type("<0,1>(a).position", list_of(Type::Point3));
}

TEST_F(Expressions, AListOverOrbitsOfWords) {
  EXPECT_EQ(print("<[2,0]>(a).twisted"), "<[2,0]>(a by <[0,2]>).twisted");  // the same element in both
  EXPECT_EQ(print("<0,2>(a).twisted"), "<0,2>(a by <[0,2]>).twisted");      // a generator of the embedding's orbit only
  EXPECT_EQ(print("<[1,2]>(a).position"), "<[1,2]>(a by <[1,2]>).position");  // a generator of the list's orbit only
  EXPECT_EQ(print("<[1,2],[2,1]>(a).position"), "<[1,2],[2,1]>(a by <[1,2]>).position");  // inverse of each other
  EXPECT_EQ(print("<[0,1]>(a).position"), "<[0,1]>(a by <>).position");
  EXPECT_EQ(print("<[1,1],0>(a).position"), "<[1,1],0>(a by <>).position");
}

// ---- Darts and comprehensions ----

TEST_F(Expressions, DartsAreComparedAndReadWhereverTheyComeFrom) {
  for (char const* text : {"a == b", "a@2 == a", "a@0 != b@[0,1]"}) expect_type(text, one(Type::Bool));
  expect_type("a@0", ir::dart_type);
  EXPECT_EQ(print("a@0@0 == a"), "(== a a)");
  rule_.lets.push_back({"m", check("a@[0,1]")});
  EXPECT_EQ(print("m@0.position"), "m@0.position");
  EXPECT_EQ(print("<0,1>(m@2@2).position"), "<0,1>(m by <1>).position");
  EXPECT_EQ(print("(if flag then a@0 else m).position"), "(if flag a@0 m).position");
  EXPECT_EQ(print("(if flag then a else m)@0@1.weight"), "(if flag a m)@[0,1].weight");
}

TEST_F(Expressions, OrbitsAreCounted) {
  expect_type("count(<0,1>(a) by <0>)", one(Type::Int));
  EXPECT_EQ(print("count(<0,1>(a) by <0>)"), "(count <0,1>(a by <0>))");
  EXPECT_EQ(print("count(<0,1>(a))"), "(count <0,1>(a by <>))");
  EXPECT_EQ(print("count(connected(a@2) by vertex)"), "(count <0,1,2,3>(a@2 by <1,2,3>))");
  EXPECT_EQ(print("count(<0,1>(a) by <[0,1]>)"), "(count <0,1>(a by <[0,1]>))");
}

TEST_F(Expressions, ByChoosesWhichValuesAreCollected) {
  EXPECT_EQ(print("mean((<0,1>(a) by <0>).position)"), "(mean <0,1>(a by <0>).position)");
  EXPECT_EQ(print("mean(<0,1>(a) by <0>.position)"), "(mean <0,1>(a by <0>).position)");
  EXPECT_EQ(print("mean((<0,1>(a) by <>).position)"), "(mean <0,1>(a by <>).position)");
}

TEST_F(Expressions, Comprehensions) {
  EXPECT_EQ(print("mean(f.position for f in <1,2>(a) by <1>)"), "(mean (f.position for f in <1,2>(a by <1>)))");
  EXPECT_EQ(print("sum(f@0.weight * h for f in <1,2>(a))"), "(sum ((* f@0.weight h) for f in <1,2>(a by <>)))");
  EXPECT_EQ(print("mean(mean(<0,1>(f).position) for f in <1,2>(a) by <1>)"),
            "(mean ((mean <0,1>(f by <1>).position) for f in <1,2>(a by <1>)))");
  EXPECT_EQ(print("sum(sum(norm(f.normal + g@1.normal + a.normal) for g in <0>(f@2)) for f in <1,2>(a) by <1>)"),
            "(sum ((sum ((norm (+ (+ f.normal g@1.normal) a.normal)) for g in <0>(f@2 by <>))) for f in <1,2>(a by <1>)))");
  expect_type("any(f@2 == f for f in <1,2>(a) by <2>)", one(Type::Bool));
  expect_type("all(f.mark for f in <1,2>(a))", one(Type::Bool));
  expect_type("mean(count(<0,1>(f) by <0>) for f in <1,2>(a) by <1>)", one(Type::Real));
  expect_type("max(count(<0,1>(f) by <0>) for f in <1,2>(a) by <1>)", one(Type::Int));
  expect_type("count(1 for f in <1,2>(a))", one(Type::Int));
  expect_type("first(f.color for f in <1,2>(a))", one(Type::Color));
  expect_type("area_vector(f.position for f in <0,1>(a) by <1>)", one(Type::Vec3));
  // Variables of comprehensions side by side may share a name.
  expect_type("min(f.weight for f in <0>(a)) + max(f.weight for f in <1>(a))", one(Type::Real));
}

// ---- Constants ----

TEST_F(Expressions, ConstantsAreComputedAtOnce) {
  EXPECT_EQ(print("h + (1 + 2 * 3)"), "(+ h 7)");
  EXPECT_EQ(print("u3 * (1 / 4)"), "(* u3 0.25)");
  EXPECT_EQ(print("h * 2"), "(* h 2)");
  EXPECT_EQ(print("p3 + Vec3(0, 1, 2)"), "(+ p3 Vec3(0, 1, 2))");
  EXPECT_EQ(print("norm(Vec2(3, 4)) - h"), "(- 5 h)");
  EXPECT_EQ(print("flag and 1 < 2"), "flag");
  EXPECT_EQ(print("flag and 2 < 1"), "false");
  EXPECT_EQ(print("true or flag"), "true");
  EXPECT_EQ(print("false or flag"), "flag");
  EXPECT_EQ(print("not not true == flag"), "(not (not (== true flag)))");
  EXPECT_EQ(print("if 1 < 2 then h else a.weight"), "h");
  EXPECT_EQ(print("if 1 > 2 then h else a.weight"), "a.weight");
  EXPECT_EQ(print("if flag then 1 + 1 else 2 + 2"), "(if flag 2 4)");
  EXPECT_EQ(print("Vec3(1, 2, 3).y + h"), "(+ 2 h)");
  EXPECT_EQ(ir::print(*check("n + 3", one(Type::Real)), rule_), "(to_real (+ n 3))");
  EXPECT_EQ(ir::print(*check("3", one(Type::Real)), rule_), "3");
  EXPECT_EQ(check("3", one(Type::Real))->type, one(Type::Real));
  rule_.lets.push_back({"m", check("2 * 3")});
  EXPECT_EQ(print("m + 1"), "7");
  expect_type("if 1 < 2 then h else 0.5", one(Type::Real));  // the place is still that of the whole
}

}  // namespace
}  // namespace jrule::sema
