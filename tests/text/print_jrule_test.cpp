#include "compiler/backend/text/print_jrule.h"

#include <gtest/gtest.h>

#include <fstream>
#include <limits>
#include <regex>

#include "tests/text/again.h"
#include "tests/text/difference.h"

namespace jrule::tests {

namespace {

ir::Program program_of(std::string const& text) {
  Again again = elaborate_again(text, "test");
  EXPECT_EQ(again.errors, "") << text;
  return std::move(again.program);
}
ir::RuleScheme rule_of(std::string const& text) { return program_of(text).rules.at(0); }

std::string printed(std::string const& text) {
  auto const result = text::print_jrule(program_of(text));
  return result ? *result : "unspellable: " + result.error().reason;
}
std::string reason(ir::Program const& program) {
  auto const result = text::print_jrule(program);
  return result ? "spelled: " + *result : result.error().reason;
}
std::string reason(ir::RuleScheme const& rule) { return reason(ir::Program{"test", {}, {rule}}); }

ir::ExprPtr expr(ir::ExprType type, decltype(ir::Expr::value) value) {
  return std::make_shared<ir::Expr const>(ir::Expr{type, std::move(value), {}});
}
ir::ExprPtr constant(Value const& value) { return expr({type_of(value)}, ir::Constant{value}); }

}  // namespace

// ---- Printed as they are written: these texts are what the printer gives for them ----

TEST(PrintJrule, KeepsArcsOfEveryKind) {
  std::string const text = R"(rule arcs on omap(3) {
  left  {
    hook a <1,2>;
    b <~1,_>;
    a -3-> b;
    b -3[1]- b;
    b -2[~1,2]-> a;
  }
  right {
    a <_,_>;
    b;
    c <1,1>;
    d;
    a -1-> c -1[2,~1]-> d -1[~1,~1]-> b;
    a -3-> b;
    c -2[1]- d;
    d -2- d;
    d -3[1]-> d;
  }
}
)";
  // `a -3-> b` is half an arc; `b -3[1]- b` are two, with the words 1 and ~1. On the right, `a` lacks the decoration of the left,
  // and `b` repeats it.
  EXPECT_EQ(printed(text), text);
}

TEST(PrintJrule, KeepsRulesVerbatim) {
  for (std::string const text : {
           R"(/// Creates a square.
rule create on gmap(2) {
  left  { }
  right {
    a;
    b;
    a -0- b -1- a;
    a -2- a;
    b -2- b;
  }
}
)",
           R"(rule several_hooks on dual_omap(2) {
  left  {
    hook a <2>;
    hook b <~2>;
    /// Between.
    c;
    hook d;
    a -1- c;
    b -1- b;
    d -1- d;
  }
  right {
    /// Is new.
    e;
    c;
    a;
    b;
    d;
    a -1- b;
  }
}
)",
           R"(rule one_dart on closed_gmap(2) {
  left  {
    hook a <>;
    b;
    a -2- b;
  }
  right {
    a;
    b;
    a -2- b;
  }
}
)"}) {
    EXPECT_EQ(printed(text), text);
  }
}

TEST(PrintJrule, WritesAsFewParenthesesAsCanBe) {
  std::string const text = R"(modeler M on gmap(2) {
  embedding at : <1,2> -> Point3;
  embedding n  : <0,1> -> Int;
  embedding ok : <> -> Bool;
}

rule expressions(x: Real, i: Int, p: Point3, on_: Bool) on M {
  left  {
    hook a <0,1,2>;
    let s = i - (2 - i) - 4;
    let t = x * (x + i) / (2.0 / x) * -x;
    let u = -(x + 1.0) * --x - (if on_ then i else x);
    let v = (if on_ then p else a@1.at).x + (p - a@[0,1].at).y + midpoint(p, p).z;
    let w = <0,1>(a@2).at;
    let l = if if on_ then a.ok else on_ then if on_ then 1 else 2 else if on_ then 3 else 4;
    require (x < 1.0) == (i < x);
    require not (a.ok and (on_ or i == 1)) or on_ and not not a@0.ok and (on_ and on_);
    require (not on_) == on_ and not on_ == on_;
    require count(w) > 2 and i < -1 and x == 3.141592653589793;
  }
  right {
    a {
      at = mean(<0,1>(a).at) + (x + i) * (p - mean(w));
      n = max(i, l) - min(<[0,1],[]>(a).n);
      ok = any(<>(a).ok);
    }
  }
}
)";
  EXPECT_EQ(printed(text), text);
}

TEST(PrintJrule, KeepsComprehensionsAndDartsVerbatim) {
  std::string const text = R"(modeler M on gmap(2) {
  embedding at : <1,2> -> Point3;
  embedding n  : <0,1> -> Int;
  embedding ok : <> -> Bool;
}

rule expressions(on_: Bool, i: Int) on M {
  left  {
    hook a <0,1,2>;
    let start = a@[0,1];
    let c = count(<0,1>(a) by <0>) + count(<>(start)) + count(<0,1>(start@2) by <[0,1],[]>);
    let d = if on_ then a else start;
    let l = (<0,1,2>(a) by <0>).at;
    require not any(e@2 == e for e in <1,2>(a) by <2>);
    require (if on_ then a else d@1)@0.ok and first(<0>(if on_ then a else d).n) == i;
  }
  right {
    a {
      at = mean(mean(mean(w@1.at for w in <0>(v)) for v in <1,2>(if u == d then a else u@2)) for u in <0,1>(d));
      n = max(i for x in <>(a)) + min((<0,1>(a) by <0>).n) + sum(count(<0,1>(x)) for x in <1>(a)) + i;
      ok = all(a != x or (x@0.ok == on_) == on_ for x in <0,1>(a)) or any(if on_ then true else e.ok for e in <1>(a));
    }
  }
}
)";
  EXPECT_EQ(printed(text), text);
}

TEST(PrintJrule, KeepsWhatIsFromOutsideVerbatim) {
  std::string const text = R"(/// What the ground is made of.
extern type Soil in "geo/soil.hpp" as "geo::Soil";

extern fn wet(soil: Soil, rain: Real) -> Soil in "geo/soil.hpp" as "geo::wet";

extern fn grass() -> Soil in "geo/soil.hpp" as "geo::grass";

extern fn blend(soils: [Soil]) -> Soil in "geo/soil.hpp" as "geo::blend";

extern fn lowest(a: Real, b: Real) -> Real in "low.hpp" as "lowest";

/// Says how hard it is.
extern fn hardness(soil: Soil) -> Real in "geo/soil.hpp" as "geo::hardness";

modeler Terrain on gmap(2) {
  embedding soil   : <0,1> -> Soil { default wet(grass(), 0.5); merge blend; }
  embedding owner  : <0,1> -> Soil { merge first; }
  embedding height : <1,2> -> Real { default 0.0; merge lowest; }
}

rule plough(
    /// how much it rains,
    /// in metres
    rain: Int = 1, other: Soil = grass()) on Terrain {
  left  {
    hook a <0,1>;
    let before = first(e.soil for e in <0,1>(a));
    require hardness(first(<0,1>(a).owner)) < rain and count(<0,1>(a).soil) == 1;
  }
  right {
    a {
      soil = if rain > 1 then wet(before, rain) else blend(if f == a then other else f.soil for f in <0,1,2>(a));
    }
  }
}
)";
  EXPECT_EQ(printed(text), text);
}

TEST(PrintJrule, RefusesWhatIsFromOutsideAndCannotBeWritten) {
  auto const changed = [](auto change) {
    ir::RuleScheme rule = rule_of(R"(extern type Soil in "soil.hpp" as "Soil";
modeler M on gmap(2) { embedding soil : <0,1> -> Soil; }
rule r on M { left { hook a <0,1>; } right { a; } })");
    ir::Modeler modeler = *rule.modeler;
    ir::ExternType type = *modeler.externs.at(0).type;
    change(type);
    modeler.externs[0].type = std::make_shared<ir::ExternType const>(std::move(type));
    rule.modeler = std::make_shared<ir::Modeler const>(std::move(modeler));
    return reason(rule);
  };
  EXPECT_EQ(changed([](ir::ExternType& type) { type.name = "Real"; }), "`Real` is a name of the language already");
  EXPECT_EQ(changed([](ir::ExternType& type) { type.name = "M"; }), "two items are called `M`");
  EXPECT_EQ(changed([](ir::ExternType& type) { type.name = "a b"; }), "`a b` is no name of the language");
  EXPECT_EQ(changed([](ir::ExternType& type) { type.header = "a\"b"; }), "`a\"b` is no name or header of C++");
}

TEST(PrintJrule, KeepsUnitsOfParameters) {
  ir::RuleScheme const rule = rule_of(R"(rule r(
    /// [m] how far up
    a: Real,
    /// [°]
    b: Real,
    /// [kg m/s]
    /// of each
    c: Real,
    /// [m] (high)
    d: Real,
    /// [0, 1] along the edge
    e: Real,
    /// [Soil](soil.md)
    f: Real,
    /// so far [m]
    g: Real,
    /// [m
    /// ]
    h: Real,
    /// [ ] [] [\]
    i: Real) on gmap(2) { left { hook x <>; } right { x; } })");
  std::vector<std::pair<std::string, std::string>> found;
  for (ir::Parameter const& p : rule.parameters) found.emplace_back(p.unit, p.doc);
  std::vector<std::pair<std::string, std::string>> const expected{
      {"m", "how far up"}, {"°", ""},         {"kg m/s", "of each"}, {"m", "(high)"}, {"", "[0, 1] along the edge"}, {"", "[Soil](soil.md)"},
      {"", "so far [m]"},  {"", "[m\n]"}, {"", "[ ] [] [\\]"}};
  EXPECT_EQ(found, expected);
  EXPECT_NE(ir::print(rule).find("\n  parameter a: Real [m]\n"), std::string::npos) << ir::print(rule);
  auto const text = text::print_jrule(rule);
  ASSERT_TRUE(text) << text.error().reason;
  EXPECT_EQ(difference(rule, rule_of(*text), Order::kept), std::nullopt) << *text;
}

TEST(PrintJrule, KeepsDeclarationsVerbatim) {
  std::string const text = R"(model boxes {
  dimensions 0, 1, 3;
  oriented 1;
  exchange (0,1), (1,3);
  closed;
}

model folds(n) {
  dimensions 0..n;
  exchange (i, j) where i + 2 <= j;
}

/// Says
///
///   more.
modeler M on boxes {
  /// All of them.
  embedding a : <> -> Bool { default true; merge first; }
  ///
  /// An Int.
  embedding b : <[1,3],[]> -> Int { default -9223372036854775807 - 1; merge min; }
  embedding c : <0,~1,[~1,3]> -> Real { default -0.0; merge max; }
  embedding d : <3> -> Color { default Color(-log(0.0), log(0.0), sqrt(-1.0)); merge mean; }
}

modeler N on folds(2);

rule reals(a: Real = 1e+22, b: Real = 5e-324, c: Real = 0.1, d: Vec2 = Vec2(-1.0, 1e-05)) on folds(3) {
  left  { hook h <0..3>; }
  right { h; }
}

rule plain on boxes {
  left  { hook h <0,1,3>; }
  right { h; }
}
)";
  EXPECT_EQ(std::regex_replace(printed(text), std::regex(R"(\{\n    (hook )?(h.*;)\n  \})"), "{ $1$2 }"),
            std::regex_replace(text, std::regex("0\\.\\.3>"), "0,1,2,3>"));
}

TEST(PrintJrule, WritesWhatIsLeftOfConstants) {
  std::string const declarations = "modeler M on gmap(2) { embedding p : <1,2> -> Point3; }\n";
  auto const value = [&](std::string const& expression) {
    ir::RuleScheme const rule = rule_of(declarations + "rule r(i: Int, x: Real, b: Bool, p: Point3) on M { left { hook a <0>; let l = " +
                                        expression + "; } right { a; } }");
    auto const text = text::print_jrule(rule);
    EXPECT_TRUE(text) << text.error().reason;
    ir::RuleScheme const again = rule_of(*text);
    EXPECT_EQ(difference(rule, again, Order::kept), std::nullopt) << *text;
    std::size_t const begin = text->find("let l = ") + 8;
    return text->substr(begin, text->find(';', begin) - begin);
  };
  EXPECT_EQ(value("x - (2 - 5)"), "x - -3.0");
  EXPECT_EQ(value("i - (2 - 5)"), "i - -3");
  EXPECT_EQ(value("(9223372036854775807 + 1) * i"), "(-9223372036854775807 - 1) * i");
  EXPECT_EQ(value("x * (1 / 0)"), "x * -log(0.0)");
  EXPECT_EQ(value("x * (-1 / 0)"), "x * log(0.0)");
  EXPECT_EQ(value("x + 0 / 0"), "x + sqrt(-1.0)");
  EXPECT_EQ(value("midpoint(p, Point3(1, -2, 0)).x"), "midpoint(p, Point3(1.0, -2.0, 0.0)).x");
  EXPECT_EQ(value("x / 0"), "x / 0.0");
  EXPECT_EQ(value("not false or b"), "true");
  EXPECT_EQ(value("count(2 for e in <0,1>(a))"), "count(2 for e in <0,1>(a))");
  // A conversion of which only the constant tells.
  EXPECT_EQ(value("if true then i else 0.5"), "if true then i else 0.0");
  EXPECT_EQ(value("i * (if true then i else x) == x"), "(if true then i else 0.0) * (if true then i else 0.0) == x");
  EXPECT_EQ(value("if b then i else if true then i else x"), "if b then if true then i else 0.0 else if true then i else 0.0");
}

TEST(PrintJrule, PutsRequirementsBeforeValuesWithTheNamesOfTheirVariables) {
  std::string const text = R"(rule r on gmap(2) {
  left  {
    hook a <0>;
    let f = a@1;
    require f != a;
    require any(e@2 == e for e in <0>(a));
    let e = a@0;
    let g = e@2;
    require any(h@2 == g for h in <0>(a));
  }
  right {
    a;
  }
}
)";
  EXPECT_EQ(printed(text), text);
}

// ---- Models of one name ----

TEST(PrintJrule, FindsTheDeclarationOfAFamily) {
  std::string const text = R"(model odd(n) {
  dimensions 0, n, n-1;
  oriented n;
  exchange (i, j) where n == 3 and i == 0 and (j == 2 or j == 3) or n == 5 and i == 0 and j == 4;
}
modeler A on odd(3);
modeler B on odd(5);
)";
  ir::Program const program = program_of(text);
  ASSERT_EQ(program.modelers.size(), 2U);
  auto const result = text::print_jrule(program);
  ASSERT_TRUE(result) << result.error().reason;
  ir::Program const again = program_of(*result);
  ASSERT_EQ(again.modelers.size(), 2U);
  EXPECT_EQ(again.modelers[0]->model, program.modelers[0]->model) << *result;
  EXPECT_EQ(again.modelers[1]->model, program.modelers[1]->model) << *result;
}

TEST(PrintJrule, SaysWhenNoDeclarationGivesAllModels) {
  EXPECT_EQ(reason(program_of("model gaps(n) { dimensions 0..n-2, n+3; } modeler A on gaps(2); modeler B on gaps(6);")),
            "no declaration gives all the models `gaps`");
}

// ---- Names ----

TEST(PrintJrule, GivesInstancesNamesOfTheirOwn) {
  ir::Program program = program_of(R"(rule sew_2 on gmap(2) { left { hook a <>; } right { a; } }
rule sew on gmap(2) { left { hook a <>; } right { a; } }
rule sew3 on gmap(2) { left { hook a <>; } right { a; } })");
  program.rules[1].name = "sew[2]";
  program.rules[2].name = "sew[2,1]";
  auto const result = text::print_jrule(program);
  ASSERT_TRUE(result) << result.error().reason;
  std::vector<std::string> names;
  for (ir::RuleScheme const& rule : program_of(*result).rules) names.push_back(rule.name);
  EXPECT_EQ(names, (std::vector<std::string>{"sew_2", "sew_2_", "sew_2_1"}));
}

TEST(PrintJrule, RefusesEveryReservedWordAsAName) {
  std::ifstream grammar(JRULE_SOURCE_DIR "/grammar/JRule.g4");
  std::regex const keyword("KW_[A-Z_]+ : '([a-z_]+)' ;");
  ir::RuleScheme const rule = rule_of("rule r on gmap(2) { left { hook a <0>; } right { a; } }");
  int keywords = 0;
  for (std::string line; std::getline(grammar, line);) {
    std::smatch match;
    if (!std::regex_match(line, match, keyword)) continue;
    ++keywords;
    ir::RuleScheme renamed = rule;
    renamed.name = match[1];
    EXPECT_FALSE(text::print_jrule(renamed)) << match[1];
    renamed = rule;
    renamed.nodes[0].name = match[1];
    EXPECT_FALSE(text::print_jrule(renamed)) << match[1];
    renamed.nodes[0].name = match[1].str() + "_";
    EXPECT_TRUE(text::print_jrule(renamed)) << match[1];
  }
  EXPECT_GE(keywords, 40);
}

TEST(PrintJrule, RefusesWhatIsNoName) {
  ir::RuleScheme const rule = rule_of("rule r(p: Real) on gmap(2) { left { hook a <0>; b <0>; a -2- b; } right { a; b; a -2- b; } }");
  for (std::string const name : {"", "_", "2a", "a b", "a;", "é", "a[2]"}) {
    ir::RuleScheme renamed = rule;
    renamed.parameters[0].name = name;
    EXPECT_FALSE(text::print_jrule(renamed)) << name;
  }
  ir::RuleScheme twice = rule;
  twice.nodes[1].name = "a";
  EXPECT_EQ(reason(twice), "rule `r`: two nodes are called `a`");
  ir::Program program{"test", {}, {rule, rule}};
  EXPECT_EQ(reason(program), "two items are called `r`");
}

// ---- What no text elaborates to ----

TEST(PrintJrule, RefusesRulesThatCannotBeWritten) {
  ir::RuleScheme const rule = rule_of("rule r on omap(2) { left { hook a <1>; hook b <~1>; a -2- a; b -2- b; } right { a; b; a -2- b; } }");
  ir::RuleScheme changed = rule;
  changed.left.arcs.erase(changed.left.arcs.begin());
  EXPECT_EQ(reason(changed), "rule `r`: the hook `a` lacks a loop of its type");
  changed = rule;
  changed.hook_type[0].conjugate = true;
  EXPECT_EQ(reason(changed), "rule `r`: the type of the hook is no list of dimensions");
  changed = rule;
  std::swap(changed.hooks[0], changed.hooks[1]);
  EXPECT_EQ(reason(changed), "rule `r`: the hooks are not in the order of the nodes");
  changed = rule;
  changed.right.arcs.push_back(changed.right.arcs.back());
  EXPECT_EQ(reason(changed), "rule `r`: the 2-arc from `b` to `a` stands twice on one side");
  for (auto const& [unit, doc] : {std::pair{"", "[m] high"}, {"m]", ""}, {"0, 1", ""}, {"m", " high"}}) {
    changed = rule;
    changed.parameters.push_back({.name = "h", .default_value = {}, .doc = doc, .unit = unit});
    EXPECT_EQ(reason(changed), "rule `r`: the unit of `h` is not told apart from its documentation") << unit << " " << doc;
  }
  changed = rule;
  changed.doc = "ends with a space ";
  EXPECT_EQ(reason(changed), "rule `r`: a line of the documentation ends with white space");
  changed = rule;
  auto const modeler = std::make_shared<ir::Modeler>(*rule.modeler);
  modeler->name = "omap(3)";
  changed.modeler = modeler;
  EXPECT_EQ(reason(changed), "the modeler `omap(3)` is of no module, and no model");
}

TEST(PrintJrule, RefusesExpressionsThatCannotBeWritten) {
  ir::RuleScheme const rule = rule_of(R"(modeler M on gmap(2) { embedding n : <0,1> -> Int; }
rule r(i: Int, x: Real) on M { left { hook a <0>; } right { a; } })");
  ir::ExprType const integer{Type::Int}, real{Type::Real}, truth{Type::Bool};
  auto const i = expr(integer, ir::ParameterRef{0});
  auto const with = [&](ir::ExprPtr value) {
    ir::RuleScheme changed = rule;
    changed.lets.push_back({"l", std::move(value)});
    return reason(changed);
  };
  EXPECT_EQ(with(expr(real, ir::Apply{ir::Builtin::multiply, {i, i}})), "rule `r`: `*` is applied to other types than the language would");
  EXPECT_EQ(with(expr(truth, ir::Apply{ir::Builtin::logical_not, {i}})), "rule `r`: `not` is applied to other types than the language would");
  EXPECT_EQ(with(expr(integer, ir::LetRef{0})), "rule `r`: `l` is read before it is declared");

  std::string const folds = "rule `r`: an operation that constants decide stands for its value";
  auto const b = expr(truth, ir::Apply{ir::Builtin::less, {i, i}}), yes = constant(true);
  EXPECT_EQ(with(expr(integer, ir::Apply{ir::Builtin::negate, {constant(std::int64_t{1})}})), folds);
  EXPECT_EQ(with(expr(real, ir::Apply{ir::Builtin::to_real, {constant(std::int64_t{1})}})), folds);
  EXPECT_EQ(with(expr(truth, ir::Apply{ir::Builtin::logical_and, {b, yes}})), folds);
  EXPECT_EQ(with(expr(truth, ir::Apply{ir::Builtin::logical_or, {yes, b}})), folds);
  EXPECT_EQ(with(expr(integer, ir::Conditional{yes, i, i})), folds);
  ir::RuleScheme lets = rule;
  lets.lets = {{"l", yes}, {"m", expr(truth, ir::LetRef{0})}};
  EXPECT_EQ(reason(lets), "rule `r`: `l` is read, and not its constant");

  // Darts and their lists.
  auto const a = expr(ir::dart_type, ir::NodeDart{0});
  auto const on = [&](ir::ExprPtr at, std::vector<int> orbit, std::vector<int> by) {
    return ir::Darts{std::move(at), orbit_of_dimensions(orbit), orbit_of_dimensions(by)};
  };
  auto const walk = [&](ir::ExprPtr from, Word path) { return expr(ir::dart_type, ir::Walk{std::move(from), std::move(path)}); };
  Letter const zero{0, false}, one{1, false};
  EXPECT_EQ(with(walk(a, {zero, zero})), "rule `r`: the path [0,0] is not in normal form");
  EXPECT_EQ(with(walk(a, {})), "rule `r`: the path [] is not in normal form");
  EXPECT_EQ(with(walk(walk(a, {zero}), {one})), "rule `r`: a path starts where another one ends");
  EXPECT_EQ(with(expr(ir::darts_type, on(a, {0, 1}, {}))), "rule `r`: an orbit is not counted, but a value");
  EXPECT_EQ(with(expr({Type::Int, true}, ir::Collect{0, on(a, {0, 1}, {2})})), "rule `r`: the orbits <2> do not lie inside <0,1>");
  ir::ExprType const integers{Type::Int, true};
  auto const each = [&](std::string name, ir::ExprPtr element) {
    return expr(integers, ir::ForEach{{0, std::move(name)}, on(a, {0, 1}, {}), std::move(element)});
  };
  auto const sum = [&](ir::ExprPtr list) { return expr(integer, ir::Apply{ir::Builtin::sum, {std::move(list)}}); };
  EXPECT_EQ(with(each("e", i)), "rule `r`: the list of a comprehension is not aggregated");
  EXPECT_EQ(with(sum(each("i", i))), "rule `r`: the variable `i` has the name of something around it");
  EXPECT_EQ(with(sum(each("a", i))), "rule `r`: the variable `a` has the name of something around it");
  ir::ExprPtr const twice = expr(integers, ir::ForEach{{1, "e"}, on(a, {}, {}), i});
  EXPECT_EQ(with(sum(each("e", sum(twice)))), "rule `r`: the variable `e` has the name of something around it");
  ir::ExprPtr const other = expr(integer, ir::ValueAt{0, expr(ir::dart_type, ir::Bound{0, "f"})});
  EXPECT_EQ(with(sum(each("e", other))), "rule `r`: the variable `f` is called `e` where it is bound");

  ir::RuleScheme hidden = rule;
  hidden.parameters[0].name = "a";
  hidden.requirements.push_back({expr(truth, ir::Apply{ir::Builtin::equal, {expr(integer, ir::ValueAt{0, a}), i}}), "a.n == i"});
  EXPECT_EQ(reason(hidden), "rule `r`: the node `a` is hidden by a value of that name");

  ir::ExprPtr deep = i;
  for (int k = 0; k < 600; ++k) deep = expr(integer, ir::Apply{ir::Builtin::add, {deep, i}});
  EXPECT_EQ(with(deep), "more than 512 operations within each other in one expression");
}

TEST(PrintJrule, RefusesAnEmptyProgram) {
  EXPECT_EQ(reason(ir::Program{"test", {}, {}}), "there is no modeler and no rule, and a file has at least one item");
}

}  // namespace jrule::tests
