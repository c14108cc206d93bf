// What is reported about wrong expressions: code, place, wording, labels, notes.
#include "expressions_fixture.h"

namespace jrule::sema {
namespace {

// ---- Operators ----

TEST_F(Expressions, PointsHaveNoSum) {
  EXPECT_EQ(errors("p3 + a.position"),
            "J0241 `+`: `+` is not defined for `Point3` and `Point3`\n"
            "| `p3`: this is a `Point3`\n"
            "| `a.position`: this is a `Point3`\n"
            "= `midpoint(a, b)`, `mean(…)` and `lerp(a, b, t)` mix points\n");
  EXPECT_EQ(errors("p2 + p2").substr(0, 59), "J0241 `+`: `+` is not defined for `Point2` and `Point2`\n| `");
}

TEST_F(Expressions, PointsHaveNoMultiples) {
  std::string const note =
      "= a point is a place and has no multiples; a vector has: `a + t * (b - a)`, which is `lerp(a, b, t)`\n";
  EXPECT_EQ(
      errors("2 * p3"),
      "J0241 `*`: `*` is not defined for `Int` and `Point3`\n| `2`: this is an `Int`\n| `p3`: this is a `Point3`\n" +
          note);
  EXPECT_EQ(
      errors("p2 / h"),
      "J0241 `/`: `/` is not defined for `Point2` and `Real`\n| `p2`: this is a `Point2`\n| `h`: this is a `Real`\n" +
          note);
  EXPECT_EQ(errors("1 + -p3"), "J0241 `-`: `-` is not defined for `Point3`\n| `p3`: this is a `Point3`\n" + note);
}

TEST_F(Expressions, OperatorsOnOtherTypes) {
  EXPECT_EQ(
      errors("u3 + u2"),
      "J0241 `+`: `+` is not defined for `Vec3` and `Vec2`\n| `u3`: this is a `Vec3`\n| `u2`: this is a `Vec2`\n");
  EXPECT_EQ(
      errors("(u3 * u3) + h"),
      "J0241 `*`: `*` is not defined for `Vec3` and `Vec3`\n| `u3`: this is a `Vec3`\n| `u3`: this is a `Vec3`\n"
      "= two vectors have the products `dot(v, w)` and, in space, `cross(v, w)`\n");
  std::string const condition = "= it takes a `Bool`, such as a comparison: `n > 0`\n";
  EXPECT_EQ(
      errors("h and flag"),
      "J0241 `and`: `and` is not defined for `Real` and `Bool`\n| `h`: this is a `Real`\n| `flag`: this is a `Bool`\n" +
          condition);
  EXPECT_EQ(errors("not n"), "J0241 `not`: `not` is not defined for `Int`\n| `n`: this is an `Int`\n" + condition);
  for (char const* text : {"u2 - p2",   "u3 - p3",  "p3 + u2",   "p3 - p2",     "p3 - h",    "h / u3",      "h + u3",
                           "red * red", "-red",     "-flag",     "flag + flag", "flag * 2",  "flag < flag", "u3 < u3",
                           "p3 >= p3",  "u3 == p3", "n == flag", "flag != h",   "red == u3", "n or flag"}) {
    EXPECT_EQ(errors(text).substr(0, 5), "J0241") << text;
    ASSERT_EQ(diagnostics_.all().size(), 1U) << text;
    EXPECT_EQ(diagnostics_.all()[0].labels.size(), text[0] == '-' ? 1U : 2U) << text;
  }
}

TEST_F(Expressions, EachWrongOperandIsReportedOnce) {
  EXPECT_EQ(errors("(p3 + p3) * (h + nowhere) + flag").substr(0, 5), "J0241");
  ASSERT_EQ(diagnostics_.all().size(), 2U);
  EXPECT_EQ(info(diagnostics_.all()[1].code).number, "J0206");
}

TEST_F(Expressions, ConditionsAreBool) {
  EXPECT_EQ(errors("if n then 1 else 2"), "J0240 `n`: expected a `Bool`, this is an `Int`\n");
  EXPECT_EQ(errors("if flag then p3 else u3"),
            "J0240 `u3`: the branches have different types: a `Point3` and a `Vec3`\n"
            "| `p3`: this is a `Point3`\n| `u3`: this is a `Vec3`\n");
  EXPECT_EQ(errors("if flag then h else flag").substr(0, 72),
            "J0240 `flag`: the branches have different types: a `Real` and a `Bool`\n|");
  EXPECT_EQ(errors("if flag then h else <0,1>(a).weight"),
            "J0240 `<0,1>(a).weight`: the branches have different types: a `Real` and a list `[Real]`\n"
            "| `h`: this is a `Real`\n| `<0,1>(a).weight`: this is a list `[Real]`\n");
}

TEST_F(Expressions, TheExpectedType) {
  EXPECT_EQ(errors("p3 - p3", one(Type::Point3)), "J0240 `p3 - p3`: expected a `Point3`, this is a `Vec3`\n");
  EXPECT_EQ(errors("h", one(Type::Int)), "J0240 `h`: expected an `Int`, this is a `Real`\n");
  EXPECT_EQ(errors("1", one(Type::Bool)), "J0240 `1`: expected a `Bool`, this is an `Int`\n");
  EXPECT_EQ(errors("<0,1>(a).position", one(Type::Point3)),
            "J0240 `<0,1>(a).position`: expected a `Point3`, this is a list `[Point3]`\n= aggregate it: `mean(…)`, "
            "`first(…)`\n");
  EXPECT_EQ(errors("h", list_of(Type::Real)), "J0240 `h`: expected a list `[Real]`, this is a `Real`\n");
  EXPECT_EQ(errors("<0,1>(a).level", list_of(Type::Real)),
            "J0240 `<0,1>(a).level`: expected a list `[Real]`, this is a list `[Int]`\n");
}

// ---- Functions ----

TEST_F(Expressions, FunctionsOnOtherTypes) {
  EXPECT_EQ(errors("1 + dot(p3, u3)"),
            "J0241 `dot`: `dot` is not defined for `Point3` and `Vec3`\n"
            "| `p3`: this is a `Point3`\n| `u3`: this is a `Vec3`\n"
            "= it is defined as `dot(Vec2, Vec2)`, `dot(Vec3, Vec3)`\n");
  EXPECT_EQ(errors("Vec3(1, flag, u3)"),
            "J0241 `Vec3`: `Vec3` is not defined for `Int`, `Bool` and `Vec3`\n"
            "| `1`: this is an `Int`\n| `flag`: this is a `Bool`\n| `u3`: this is a `Vec3`\n"
            "= it is defined as `Vec3(Real, Real, Real)`\n");
  EXPECT_EQ(errors("sum(<0,1>(a).position)"),
            "J0241 `sum`: `sum` is not defined for `[Point3]`\n"
            "| `<0,1>(a).position`: this is a list `[Point3]`\n"
            "= it is defined as `sum([Int])`, `sum([Real])`, `sum([Vec2])`, `sum([Vec3])`, `sum([Color])`\n");
  for (char const* text : {"cross(u2, u2)",
                           "norm(p3)",
                           "norm(h)",
                           "normalize(h)",
                           "midpoint(p3, p2)",
                           "midpoint(flag, flag)",
                           "lerp(p3, p3, u3)",
                           "distance(u3, u3)",
                           "distance(p3, p2)",
                           "sqrt(u3)",
                           "abs(u3)",
                           "floor(flag)",
                           "pow(h, flag)",
                           "min(u3, u3)",
                           "max(flag, n)",
                           "mean(<0,1>(a).mark)",
                           "sum(<0,1>(a).uv)",
                           "min(<0,1>(a).position)",
                           "all(<0,1>(a).level)",
                           "any(<0,1>(a).weight)",
                           "area_vector(<0,1>(a).uv)"}) {
    EXPECT_EQ(errors(text).substr(0, 5), "J0241") << text;
  }
}

TEST_F(Expressions, AggregatesNeedLists) {
  EXPECT_EQ(
      errors("mean(p3)"),
      "J0240 `p3`: `mean` needs a list, this is a `Point3`\n= a list is what an orbit gives: `<0,1>(a).position`\n");
  for (char const* text :
       {"sum(h)", "min(n)", "max(h)", "count(h)", "first(p3)", "all(flag)", "any(flag)", "area_vector(p3)"}) {
    EXPECT_EQ(errors(text).substr(0, 5), "J0240") << text;
    EXPECT_NE(show_all().find("needs a list, this is a"), std::string::npos) << text;
  }
}

TEST_F(Expressions, AListIsNotOneValue) {
  std::string const note = "= aggregate it: `mean(…)`, `first(…)`\n", conditions = "= aggregate it: `all(…)`, `any(…)`\n";
  EXPECT_EQ(errors("<0,1>(a).position - b.position"),
            "J0240 `<0,1>(a).position`: `-` needs one value, this is a list `[Point3]`\n" + note);
  EXPECT_EQ(errors("norm(<0,1>(a).normal)"),
            "J0240 `<0,1>(a).normal`: `norm` needs one value, this is a list `[Vec3]`\n" + note);
  EXPECT_EQ(errors("max(h, <0,1>(a).weight)"),
            "J0240 `<0,1>(a).weight`: `max` needs one value, this is a list `[Real]`\n" + note);
  EXPECT_EQ(errors("<0,1>(a).position.x"),
            "J0240 `<0,1>(a).position`: `.x` needs one value, this is a list `[Point3]`\n" + note);
  EXPECT_EQ(errors("<0>(a).mark == <0>(b).mark"),
            "J0240 `<0>(a).mark`: `==` needs one value, this is a list `[Bool]`\n" + conditions +
                "J0240 `<0>(b).mark`: `==` needs one value, this is a list `[Bool]`\n" + conditions);
}

TEST_F(Expressions, TheNumberOfArguments) {
  EXPECT_EQ(errors("1 + lerp(p3, p3)"),
            "J0242 `lerp`: `lerp` takes 3 arguments, not 2\n"
            "= it is defined as `lerp(Real, Real, Real)`, `lerp(Vec2, Vec2, Real)`, `lerp(Vec3, Vec3, Real)`, "
            "`lerp(Point2, Point2, Real)`, `lerp(Point3, Point3, Real)`, `lerp(Color, Color, Real)`\n");
  EXPECT_EQ(errors("sqrt()"), "J0242 `sqrt`: `sqrt` takes 1 argument, not 0\n= it is defined as `sqrt(Real)`\n");
  EXPECT_EQ(errors("min(1, 2, 3)"),
            "J0242 `min`: `min` takes 1 or 2 arguments, not 3\n"
            "= it is defined as `min([Int])`, `min([Real])`, `min(Int, Int)`, `min(Real, Real)`\n");
}

TEST_F(Expressions, CallsOfOtherThings) {
  EXPECT_EQ(errors("nrom(u3)"), "J0207 `nrom`: unknown function `nrom`\n+ `nrom` -> `norm`\n");
  EXPECT_EQ(errors("laplacian(a)"), "J0207 `laplacian`: unknown function `laplacian`\n");
  for (char const* name : {"x", "to_real", "h", "pi"})
    EXPECT_EQ(errors(std::string(name) + "(h)").substr(0, 5), "J0207") << name;
  EXPECT_EQ(errors("sew[2](a)"),
            "J0207 `sew`: `sew[…]` is not a function\n= rules are applied by operations, not by expressions\n");
  EXPECT_EQ(errors("norm(v: u3)"),
            "J0240 `v`: the arguments of `norm` have no names\n= they are told apart by their order\n");
  EXPECT_EQ(
      errors("a[0]"),
      "J0240 `a[0]`: an expression has nothing to index\n= `[…]` selects from the result of a rule, in an operation\n");
  EXPECT_EQ(errors("norm(\"u3\")"),
            "J0240 `\"u3\"`: a string is not a value of an expression\n"
            "= values are of type Bool, Int, Real, Vec2, Vec3, Point2, Point3 or Color\n");
}

TEST_F(Expressions, Components) {
  EXPECT_EQ(
      errors("u3.w"),
      "J0241 `w`: `.w` is not defined for `Vec3`\n| `u3`: this is a `Vec3`\n= its components are `.x`, `.y`, `.z`\n");
  EXPECT_EQ(
      errors("p2.z"),
      "J0241 `z`: `.z` is not defined for `Point2`\n| `p2`: this is a `Point2`\n= its components are `.x`, `.y`\n");
  EXPECT_EQ(errors("red.x"),
            "J0241 `x`: `.x` is not defined for `Color`\n| `red`: this is a `Color`\n= its components are `.r`, `.g`, "
            "`.b`\n");
  EXPECT_EQ(errors("u3.xy").substr(0, 10), "J0241 `xy`");
  EXPECT_EQ(errors("n.position"),
            "J0241 `position`: `.position` is not defined for `Int`\n| `n`: this is an `Int`\n= an `Int` has no "
            "components\n");
}

// ---- Names and the map ----

TEST_F(Expressions, UnknownNames) {
  EXPECT_EQ(errors("hh + 1"), "J0206 `hh`: unknown value `hh`\n+ `hh` -> `h`\n");
  EXPECT_EQ(errors("nowhere"),
            "J0206 `nowhere`: unknown value `nowhere`\n"
            "= known here: `flag`, `n`, `h`, `u2`, `u3`, `p2`, `p3`, `red`, `a`, `b`, `pi`\n");
  EXPECT_EQ(errors("somewhere.position").substr(0, 17), "J0206 `somewhere`");
  EXPECT_EQ(errors("somewhere@0.position").substr(0, 17), "J0206 `somewhere`");
  EXPECT_EQ(errors("<0,1>(somewhere).position").substr(0, 17), "J0206 `somewhere`");
  EXPECT_EQ(errors("mean"),
            "J0206 `mean`: `mean` is a function, not a value\n= it is called with its arguments: `mean(…)`\n");
}

TEST_F(Expressions, AnAddedNodeHasNoValuesBefore) {
  std::string const report =
      "J0206 `c`: `c` is a node of the right side only\n| (c): `c` is added here\n"
      "= an expression sees the map before the rule is applied\n";
  for (char const* text :
       {"c.position", "c@0.position", "<0,1>(c).position", "mean(<0,1>(c@2).position)", "c", "c.nothing"}) {
    EXPECT_EQ(errors(text), report) << text;
  }
}

TEST_F(Expressions, UnknownEmbeddings) {
  EXPECT_EQ(errors("a.positon"), "J0205 `positon`: unknown embedding `positon`\n+ `positon` -> `position`\n");
  EXPECT_EQ(errors("<0,1>(a@0).temperature"),
            "J0205 `temperature`: unknown embedding `temperature`\n"
            "= known here: `position`, `uv`, `color`, `mark`, `level`, `weight`, `normal`, `tangent`, `twisted`\n");
}

TEST_F(Expressions, ADartIsNotAValue) {
  std::string const note = "= a value at a dart is read with a dot: `a.position`\n";
  EXPECT_EQ(errors("a", one(Type::Point3)), "J0240 `a`: expected a `Point3`, this is a `Dart`\n" + note);
  EXPECT_EQ(errors("norm(a - b)"),
            "J0241 `-`: `-` is not defined for `Dart` and `Dart`\n| `a`: this is a `Dart`\n| `b`: this is a `Dart`\n" +
                note);
  EXPECT_EQ(errors("1 + a@0"),
            "J0241 `+`: `+` is not defined for `Int` and `Dart`\n| `1`: this is an `Int`\n| `a@0`: this is a `Dart`\n" +
                note);
  EXPECT_EQ(errors("mean(a)"),
            "J0240 `a`: `mean` needs a list, this is a `Dart`\n"
            "= a list is what an orbit gives: `<0,1>(a).position`\n");
  EXPECT_EQ(errors("if a then 1 else 2"), "J0240 `a`: expected a `Bool`, this is a `Dart`\n" + note);
  EXPECT_EQ(errors("a == 1").substr(0, 51), "J0241 `==`: `==` is not defined for `Dart` and `Int");
  EXPECT_EQ(errors("a < b").substr(0, 51), "J0241 `<`: `<` is not defined for `Dart` and `Dart`");
}

TEST_F(Expressions, AnOrbitIsNotAValue) {
  std::string const report =
      "J0240 `<0,1>(a)`: an orbit is not a value\n"
      "= a dot and an embedding's name make it a list of values: `<0,1>(a).position`\n";
  for (char const* text : {"mean(<0,1>(a))", "<0,1>(a)", "1 + <0,1>(a)", "if flag then <0,1>(a) else 1", "first(<0,1>(a))"}) {
    EXPECT_EQ(errors(text), report) << text;
  }
}

TEST_F(Expressions, PathsAndOrbitsStartAtDarts) {
  std::string const note = "= a dart is a node of the left side, or where a path from one leads: `a`, `a@0`\n";
  EXPECT_EQ(errors("h@0.position"), "J0243 `h`: `@` starts at a dart, this is a `Real`\n" + note);
  EXPECT_EQ(errors("a.position@0.position"), "J0243 `a.position`: `@` starts at a dart, this is a `Point3`\n" + note);
  EXPECT_EQ(errors("<0,1>(p3).position"), "J0243 `p3`: an orbit starts at a dart, this is a `Point3`\n" + note);
  EXPECT_EQ(errors("<0,1>(<0>(a).level).position"),
            "J0243 `<0>(a).level`: an orbit starts at a dart, this is a list `[Int]`\n" + note);
  EXPECT_EQ(errors("<0,1>(a)@0.position"), "J0243 `<0,1>(a)`: `@` starts at a dart, this is an orbit\n");
  EXPECT_EQ(errors("<0,1>(<0>(a)).position"), "J0243 `<0>(a)`: an orbit starts at a dart, this is an orbit\n");
  EXPECT_EQ(errors("pi@0"), "J0243 `pi`: `@` starts at a dart, this is a `Real`\n" + note);
}

TEST_F(Expressions, PathsAndOrbitsAreOfTheModel) {
  EXPECT_EQ(errors("a@4.position"), "J0217 `4`: a 3-G-map has no dimension 4\n= its dimensions are 0, 1, 2, 3\n");
  EXPECT_EQ(errors("<0,7>(a).position"), "J0217 `7`: a 3-G-map has no dimension 7\n= its dimensions are 0, 1, 2, 3\n");
  EXPECT_EQ(errors("a@j.position").substr(0, 9), "J0221 `j`");
  EXPECT_EQ(errors("<0,_>(a).position").substr(0, 9), "J0227 `_`");
}

// ---- Comprehensions ----

TEST_F(Expressions, ByIsInsideTheOrbit) {
  EXPECT_EQ(errors("count(<0,1>(a) by <0,2>)"),
            "J0245 `<0,2>`: the orbits <0,2> do not lie inside <0,1>\n| `<0,1>`: this is the orbit that is walked\n"
            "= `by` takes one dart for each of the smaller orbits; those of <0,2> inside are <0>\n");
  EXPECT_EQ(errors("mean(f.position for f in vertex(a) by face)").substr(0, 12), "J0245 `face`");
  EXPECT_EQ(errors("(<>(a) by <0>).position").substr(0, 11), "J0245 `<0>`");
  EXPECT_EQ(errors("<0,1>(a) by <5>").substr(0, 9), "J0217 `5`");
  EXPECT_EQ(errors("count(<0,1>(h) by <0>)").substr(0, 9), "J0243 `h`");
}

TEST_F(Expressions, AVariableHasANameOfItsOwn) {
  std::string const note = "= a comprehension's variable has a name of its own\n";
  EXPECT_EQ(errors("sum(1 for h in <0>(a))"), "J0208 `h`: `h` is a parameter already\n" + note);
  EXPECT_EQ(errors("mean(a.weight for a in <0>(b))").substr(0, 33), "J0208 `a`: `a` is a node already\n");
  EXPECT_EQ(errors("mean(c.weight for c in <0>(b))"),
            "J0208 `c`: `c` is a node already\n| (c): first declared here\n" + note);
  EXPECT_EQ(errors("sum(sum(f.weight for f in <0>(f)) for f in <1>(a))"),
            "J0208 `f`: `f` is the variable of a comprehension already\n| `f`: first declared here\n" + note);
  rule_.lets.push_back({"m", check("h + 1")});
  EXPECT_EQ(errors("sum(h for m in <0>(a))"), "J0208 `m`: `m` is a `let` already\n" + note);
}

TEST_F(Expressions, AVariableIsKnownInItsComprehensionOnly) {
  EXPECT_EQ(errors("mean(f.weight for f in <0>(a)) + f.weight").substr(0, 31), "J0206 `f`: unknown value `f`\n= ");
  EXPECT_EQ(errors("mean(f.weight for f in <0>(f))").substr(0, 9), "J0206 `f`");
  EXPECT_EQ(errors("mean(g.weight for f in <0>(a))").substr(0, 9), "J0206 `g`");
  EXPECT_NE(show_all().find("known here: `f`, `flag`"), std::string::npos) << show_all();
}

TEST_F(Expressions, TheElementOfAComprehensionIsOneValue) {
  std::string const text = "the element of a comprehension is one value, this is ";
  EXPECT_EQ(errors("count(f for f in <0>(a))"),
            "J0240 `f`: " + text + "a `Dart`\n= a value at it is read with a dot: `f.…`\n");
  EXPECT_EQ(errors("mean(<0>(f).weight for f in <1>(a))"),
            "J0240 `<0>(f).weight`: " + text + "a list `[Real]`\n= aggregate it: `mean(…)`, `first(…)`\n");
  EXPECT_EQ(errors("mean(<0>(f) for f in <1>(a))").substr(0, 39), "J0240 `<0>(f)`: an orbit is not a value");
}

TEST_F(Expressions, AComprehensionIsAggregated) {
  EXPECT_EQ(errors("norm(f.normal for f in <0>(a))"),
            "J0241 `norm`: `norm` does not aggregate a list\n= a comprehension is aggregated by `area_vector`, `mean`, "
            "`sum`, `min`, `max`, `count`, `first`, `all`, `any`\n");
  EXPECT_EQ(errors("avg(f.normal for f in <0>(a))").substr(0, 33), "J0207 `avg`: unknown aggregate `a");
  EXPECT_EQ(errors("mean(f.mark for f in <0>(a))").substr(0, 50), "J0241 `mean`: `mean` is not defined for `[Bool]`\n|");
  EXPECT_EQ(errors("all(f.level for f in <0>(a))").substr(0, 47), "J0241 `all`: `all` is not defined for `[Int]`\n|");
}

TEST_F(Expressions, AComprehensionRangesOverAnOrbit) {
  std::string const note = "= an orbit is written with its type and a dart: `<1,2>(a)`, `<1,2>(a) by <1>`\n";
  EXPECT_EQ(errors("mean(f.weight for f in a)"),
            "J0240 `a`: a comprehension ranges over an orbit, this is a `Dart`\n" + note);
  EXPECT_EQ(errors("mean(f.weight for f in <0>(a).weight)"),
            "J0240 `<0>(a).weight`: a comprehension ranges over an orbit, this is a list `[Real]`\n" + note);
}

TEST_F(Expressions, DivisionByTheConstantZero) {
  ASSERT_TRUE(check("h / (2 - 2)"));
  EXPECT_EQ(show_all(),
            "J0244 `/`: division by the constant zero\n| `2 - 2`: this is zero\n"
            "= the quotient is infinite, or no number at all\n");
  for (char const* text : {"1 / 0", "u3 / -0.0", "0 / 0", "red / 0", "h / (if true then 0 else 1)"}) {
    ASSERT_TRUE(check(text)) << text;
    ASSERT_EQ(diagnostics_.all().size(), 1U) << text;
    EXPECT_EQ(info(diagnostics_.all()[0].code).severity, source::Severity::warning);
  }
  for (char const* text : {"h / n", "h / (n - n)", "0 / h", "h / 1e-300"}) {
    ASSERT_TRUE(check(text)) << text;
    EXPECT_TRUE(diagnostics_.all().empty()) << text;
  }
}

// ---- Constants ----

TEST_F(Expressions, ADefaultIsAConstant) {
  EXPECT_EQ(constant_errors("h", Type::Real), "J0206 `h`: a default is a constant: it cannot read `h`\n");
  EXPECT_EQ(constant_errors("1 + a.weight", Type::Real), "J0206 `a`: a default is a constant: it cannot read `a`\n");
  EXPECT_EQ(constant_errors("a@0.weight", Type::Real),
            "J0206 `a@0`: a default is a constant: it cannot read the map\n");
  EXPECT_EQ(constant_errors("a@0", Type::Real), "J0206 `a@0`: a default is a constant: it cannot read the map\n");
  EXPECT_EQ(constant_errors("<0>(a)", Type::Real), "J0206 `<0>(a)`: a default is a constant: it cannot read the map\n");
  EXPECT_EQ(constant_errors("mean(<0>(a).weight)", Type::Real),
            "J0206 `<0>(a)`: a default is a constant: it cannot read the map\n");
  EXPECT_EQ(constant_errors("mean(f.weight for f in <0>(a))", Type::Real),
            "J0206 `<0>(a)`: a default is a constant: it cannot read the map\n");
  EXPECT_EQ(constant_errors("count(<0>(a) by <>)", Type::Int).substr(0, 5), "J0206");
  EXPECT_EQ(constant_errors("0.5", Type::Color), "J0240 `0.5`: expected a `Color`, this is a `Real`\n");
  EXPECT_EQ(constant_errors("0.5", Type::Int), "J0240 `0.5`: expected an `Int`, this is a `Real`\n");
  EXPECT_EQ(constant_errors("Point3(0,0,0) + Point3(0,0,0)", Type::Point3).substr(0, 9), "J0241 `+`");
}

// ---- Types and merge policies ----

TEST_F(Expressions, TypeNames) {
  auto const resolve = [&](std::string const& name, bool list = false) {
    diagnostics_ = {};
    auto const file = sources_.add("type.jrule", name);
    return resolve_stored_type({{name, {file, 0, static_cast<std::uint32_t>(name.size())}}, list}, {}, diagnostics_);
  };
  for (Type type :
       {Type::Bool, Type::Int, Type::Real, Type::Vec2, Type::Vec3, Type::Point2, Type::Point3, Type::Color}) {
    EXPECT_EQ(resolve(to_string(type)), one(type));
    EXPECT_TRUE(diagnostics_.all().empty());
  }
  EXPECT_FALSE(resolve("point3"));
  EXPECT_EQ(show_all(), "J0204 `point3`: unknown type `point3`\n+ `point3` -> `Point3`\n");
  EXPECT_FALSE(resolve("Quaternion"));
  EXPECT_EQ(show_all(),
            "J0204 `Quaternion`: unknown type `Quaternion`\n"
            "= known here: `Bool`, `Int`, `Real`, `Vec2`, `Vec3`, `Point2`, `Point3`, `Color`\n");
  EXPECT_FALSE(resolve("Dart"));
  EXPECT_EQ(show_all(),
            "J0204 `Dart`: a `Dart` cannot be stored\n"
            "= a rule gets darts at its hooks, an expression by the nodes of the left side\n");
  EXPECT_FALSE(resolve("Point3", true));
  EXPECT_EQ(show_all(), "J0491 `Point3`: values of the list type `[Point3]` are not yet implemented\n");
}

TEST_F(Expressions, MergePolicies) {
  auto const resolve = [&](std::string const& name, Type type) {
    diagnostics_ = {};
    auto const file = sources_.add("merge.jrule", name);
    auto const merge = resolve_merge({name, {file, 0, static_cast<std::uint32_t>(name.size())}}, one(type), {}, diagnostics_);
    return merge ? std::optional(merge->policy) : std::nullopt;
  };
  for (Type type :
       {Type::Bool, Type::Int, Type::Real, Type::Vec2, Type::Vec3, Type::Point2, Type::Point3, Type::Color}) {
    bool const number = type == Type::Int || type == Type::Real;
    bool const mixed = type != Type::Bool && type != Type::Int;
    EXPECT_EQ(resolve("first", type), MergePolicy::first);
    EXPECT_EQ(resolve("mean", type), mixed ? std::optional(MergePolicy::mean) : std::nullopt);
    EXPECT_EQ(resolve("min", type), number ? std::optional(MergePolicy::min) : std::nullopt);
    EXPECT_EQ(resolve("max", type), number ? std::optional(MergePolicy::max) : std::nullopt);
  }
  EXPECT_FALSE(resolve("mean", Type::Bool));
  EXPECT_EQ(show_all(),
            "J0405 `mean`: values of type `Bool` have no `mean`\n"
            "= `mean` merges values of type Real, Vec2, Vec3, Point2, Point3, Color\n");
  EXPECT_FALSE(resolve("min", Type::Point3));
  EXPECT_EQ(show_all(),
            "J0405 `min`: values of type `Point3` have no `min`\n= `min` merges values of type Int, Real\n");
  EXPECT_FALSE(resolve("average", Type::Real));
  EXPECT_EQ(show_all(),
            "J0405 `average`: unknown merge policy `average`\n= known here: `mean`, `min`, `max`, `first`\n");
}

}  // namespace
}  // namespace jrule::sema
