// The text of generated C++. That it computes the right thing is tested by tests/integration/generated_test.
#include "compiler/backend/cpp/emit.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <limits>

#include "compiler/backend/cpp/names.h"
#include "compiler/backend/cpp/text.h"
#include "compiler/sema/elaborate.h"

namespace jrule::cpp {
namespace {

// ---- Names ----

TEST(Names, Identifiers) {
  EXPECT_EQ(identifier("cone"), "cone");
  EXPECT_EQ(identifier("delete"), "delete_");
  EXPECT_EQ(identifier("errno"), "errno_");
  EXPECT_EQ(identifier("sew[2]"), "sew_2");
  EXPECT_EQ(identifier("glue[1,2]"), "glue_1_2");
  EXPECT_EQ(identifier("gmap(3)"), "gmap_3");
  EXPECT_EQ(identifier("my-rules"), "my_rules");
  EXPECT_EQ(identifier("2d"), "x2d");
  EXPECT_EQ(identifier("a__b"), "a_b");
  EXPECT_EQ(identifier("_Big"), "x_Big");
  EXPECT_EQ(identifier("_"), "x_");
  EXPECT_EQ(identifier("\xc3\xa9t\xc3\xa9"), "_t");
}

TEST(Names, Cases) {
  EXPECT_EQ(camel_case("quad_subdivision"), "QuadSubdivision");
  EXPECT_EQ(camel_case("sew2"), "Sew2");
  EXPECT_EQ(camel_case("gmap_3"), "Gmap3");
  EXPECT_EQ(snake_case("HalfEdges"), "half_edges");
  EXPECT_EQ(snake_case("Surface"), "surface");
  EXPECT_EQ(snake_case("OBJ"), "obj");
}

TEST(Names, Namespaces) {
  EXPECT_EQ(namespace_of("std.surface"), "surface");
  EXPECT_EQ(namespace_of("class"), "class_");
  EXPECT_EQ(namespace_of("truncate"), "truncate_");  // a function of <unistd.h>
  EXPECT_EQ(namespace_of("std"), "std_");
  EXPECT_EQ(namespace_of("\xc3\xa9t\xc3\xa9"), "x_t");  // the global namespace's names must not begin with `_`
}

TEST(Names, Scopes) {
  Scope scope;
  EXPECT_EQ(scope.take("a"), "a");
  EXPECT_EQ(scope.take("a"), "a_");
  EXPECT_EQ(scope.take("a"), "a_2");
  EXPECT_EQ(scope.take("int"), "int_");
  EXPECT_EQ(scope.take("int"), "int_1");
  EXPECT_FALSE(scope.reserve("a_2"));
}

// ---- Pieces ----

TEST(Text, Literals) {
  EXPECT_EQ(literal(Value(0.5)), "0.5");
  EXPECT_EQ(literal(Value(3.0)), "3.0");
  EXPECT_EQ(literal(Value(-0.0)), "-0.0");
  EXPECT_EQ(literal(Value(1e300)), "1e+300");
  EXPECT_EQ(literal(Value(std::numeric_limits<double>::infinity())), "std::numeric_limits<double>::infinity()");
  EXPECT_EQ(literal(Value(std::int64_t{-3})), "std::int64_t{-3}");
  EXPECT_EQ(literal(Value(std::numeric_limits<std::int64_t>::min())), "std::numeric_limits<std::int64_t>::min()");
  EXPECT_EQ(literal(Value(true)), "true");
  EXPECT_EQ(literal(Value(Point3{0, 1, 0.25})), "jrule::Point3{0.0, 1.0, 0.25}");
  EXPECT_EQ(literal(std::string_view("a\"\\\n")), R"("a\"\\\n")");
}

TEST(Text, Words) {
  Word const word{{2, false}, {1, true}};
  EXPECT_EQ(initializer(word), "{{2, false}, {1, true}}");
  EXPECT_EQ(name_part(word), "2_b1");
  EXPECT_EQ(orbit_expression(orbit_of_dimensions({0, 1})), "jrule::orbit_of_dimensions({0, 1})");
  EXPECT_EQ(orbit_expression({{word}}), "jrule::OrbitType{{{{2, false}, {1, true}}}}");
}

TEST(Text, DocumentationCannotSpill) {
  EXPECT_EQ(documentation("one\\ \ntwo  \r\n\nthree\\\\\n\n"), (std::vector<std::string>{"one", "two", "", "three"}));
}

// ---- Whole modules ----

struct Emitted {
  std::string header, code;
  std::vector<source::Diagnostic> problems;
  std::vector<std::string> places;  ///< the source text that each problem is about
};

Emitted emit_module(std::string const& text, Options const& options = {}) {
  std::filesystem::path const folder = std::filesystem::path(testing::TempDir()) / ("jrule_emit_test_" + std::to_string(getpid()));  // tests run side by side
  std::filesystem::create_directories(folder);
  std::string const path = (folder / "shapes.jrule").string();
  std::ofstream(path, std::ios::binary) << text;

  source::Sources sources;
  source::Diagnostics diagnostics;
  ir::Program const program = sema::elaborate(sema::load(path, {}, sources, diagnostics), diagnostics);
  for (source::Diagnostic const& d : diagnostics.all()) ADD_FAILURE() << source::render_human(sources, d);
  std::vector<analysis::Verdict> verdicts;
  for (ir::RuleScheme const& rule : program.rules) {
    verdicts.push_back(analysis::analyze(rule));
    EXPECT_TRUE(verdicts.back().accepted()) << rule.name;
  }
  std::vector<Rule> rules;
  for (std::size_t i = 0; i < program.rules.size(); ++i) rules.push_back({&program.rules[i], &verdicts[i].plan});

  Emitted emitted;
  auto const files = emit(program, rules, sources, options, diagnostics);
  emitted.problems = diagnostics.all();
  for (source::Diagnostic const& d : emitted.problems) {
    emitted.places.emplace_back(d.span.file == source::no_file ? std::string_view("nowhere") : sources.text(d.span));
  }
  EXPECT_EQ(files.empty(), diagnostics.has_errors());
  if (files.size() == 2) {
    EXPECT_EQ(files[0].name, "shapes.h");
    EXPECT_EQ(files[1].name, "shapes.cpp");
    emitted.header = files[0].text;
    emitted.code = files[1].text;
  }
  return emitted;
}

void expect_contains(std::string const& text, std::string const& piece) {
  EXPECT_NE(text.find(piece), std::string::npos) << "missing:\n" << piece << "\nin:\n" << text;
}

std::string const shapes = R"(/// Surfaces.
modeler Shape on gmap(2) {
  embedding position : <1,2> -> Point3;
}

/// Raises a cone.
/// On a free face.
rule cone(scale: Int, height: Real = 0.5, apex: Point3 = Point3(0, 0, 1)) on Shape {
  left {
    hook a <0,1>;
    a -2- a;
    let far = distance(a.position, apex) + height * scale;
    require far > 0 and not (height < 0 or scale == 2);
  }
  right {
    /// The side.
    a; b <0,_>; c <_,2>; d <1,2> { position = apex + (mean(<0,1>(a).position) - a@0.position) * far; }
    a -2- b -1- c -0- d;
  }
}
)";

TEST(Emit, Header) {
  std::string const header = emit_module(shapes).header;
  expect_contains(header, R"(#pragma once
)");
  expect_contains(header, R"(/// Surfaces.
class Shape {
 public:
  static jrule::Model model() { return jrule::gmap(2); }
  static std::vector<jrule::EmbeddingSpec> embeddings() {
    return {
      {"position", jrule::orbit_of_dimensions({1, 2}), jrule::Type::Point3, std::nullopt, jrule::MergePolicy::none},
    };
  }
)");
  expect_contains(header, R"(  jrule::Dart d = jrule::no_dart;  ///< added
)");
  expect_contains(header, R"(/// Raises a cone.
/// On a free face.
///
/// shapes.jrule:8
/// @param a  hook <0,1>
/// @param scale  Int
/// @param height  Real, by default 0.5
/// @param apex  Point3, by default Point3(0, 0, 1)
)");
  expect_contains(
      header,
      "jrule::Result<ConeResult> cone(Shape& shape, jrule::Dart a, std::int64_t scale, double height = 0.5, "
      "jrule::Point3 apex = jrule::Point3{0.0, 0.0, 1.0});\n");
  expect_contains(header,
                  "jrule::Result<void> cone_everywhere(Shape& shape, std::int64_t scale, double height = 0.5, ");
}

TEST(Emit, OperationsReadAsTheyAreWritten) {
  Emitted const emitted = emit_module(shapes + R"(
/// Two cones, if there is room.
operation cones(
    /// of a face
    first: Dart, n: Int = 2) on Shape -> Dart {
  let top = cone(first, n);
  let count = 0;
  for e in face(first) by <0> { try { cone(e@2, n); count = count + 1; } else { fail "no room"; } }
  if count == n { return top.d[first@0]; }
  return top.d;
}
)");
  expect_contains(emitted.header, R"(/// Two cones, if there is room.
///
/// shapes.jrule:23
/// @param first  Dart: of a face
/// @param n  Int, by default 2
/// @param progress  asked before each application of a rule and each round of a `while`; false cancels
/// @return what it gives; or why it has failed, and then nothing has changed
jrule::Result<jrule::Dart> cones(Shape& shape,
        jrule::Dart first,
        std::int64_t n = std::int64_t{2},
        jrule::operation::Progress const& progress = {});
)");
  expect_contains(emitted.code, R"(
static jrule::Dart run_cones(Shape& shape, jrule::operation::Run& run, jrule::Dart first, std::int64_t n) {
  jrule::operation::Call const call(run, "cones");
  jrule::Map& map = shape.map();
  auto const alive = [&](jrule::Dart at) { return jrule::operation::alive(map, at, "cones"); };
  jrule::operation::Undo const undo(run, map, jrule::operation::Undo::Of::operation);
  run.step();
  ConeResult const top = run.applied(cone(shape, first, n, 0.5, jrule::Point3{0.0, 0.0, 1.0}));
  jrule::operation::Copies top_d(top.copies.a, top.copies.d);
  std::int64_t count = std::int64_t{0};
  for (jrule::Dart const e : jrule::rewrite::representatives(map, jrule::orbit_of_dimensions({0, 1}), jrule::orbit_of_dimensions({0}), alive(first))) {
    if (!map.contains(e)) continue;  // deleted meanwhile
    auto const count_before = count;
    try {
      jrule::operation::Undo const undo_(run, map, jrule::operation::Undo::Of::call);
      run.step();
      run.applied(cone(shape, map.target(alive(e), 2), n, 0.5, jrule::Point3{0.0, 0.0, 1.0}));
      count = jrule::add(count, std::int64_t{1});
    } catch (jrule::operation::Failure const& failure) {
      if (!failure.is_tried()) throw;
      count = count_before;
      jrule::operation::fail("cones", "no room");
    }
  }
  if (count == n) {
    return top_d.at(map.target(alive(first), 0), "cones", "top.d");
  }
  return top.d;
}
)");
}

TEST(Emit, AVariableThatIsSetToItselfIsLeftAlone) {
  Emitted const emitted = emit_module(shapes + R"(
operation idle(d: Dart, n: Int) on Shape { let m = n; m = m; d = d; }
)");
  expect_contains(emitted.code, R"(
  [[maybe_unused]] std::int64_t m = n;
}
)");
}

TEST(Emit, CodeReadsFromTopToBottom) {
  std::string const code = emit_module(shapes).code;
  expect_contains(code, "#include \"shapes.h\"\n");
  expect_contains(code, "namespace shapes {\n");
  expect_contains(code, R"(
  // shapes.jrule:11: a -2-> a
  for (std::size_t k = 0; k < n; ++k) {
    jrule::Dart const at = match_a[k], to = to_2[at], expected = match_a[k];
    if (to != expected) return tl::unexpected(jrule::rewrite::arc_differs("cone", "a", 2, "a", at, to, expected));
  }
)");
  expect_contains(code, R"(
  double const far = jrule::distance(position_of[a], apex) + height * static_cast<double>(scale);
)");
  expect_contains(code, R"cpp(
  if (!(far > 0.0 && !(height < 0.0 || scale == std::int64_t{2}))) {
    return tl::unexpected(jrule::rewrite::requirement_failed("cone", "far > 0 and not (height < 0 or scale == 2)", {{"a", a}}));
)cpp");
  expect_contains(code,
                  "    return apex + (jrule::rewrite::total(walk_0_1_by_1, match_a[k], [&](jrule::Dart at) { "
                  "return position_of[at]; }).mean() - position_of[to_0[match_a[k]]]) * all_far[number[k]];\n");
  expect_contains(code, "      for (std::size_t k = begin; k < end; ++k) arcs_2[match_a[k]] = added_b[k];\n");
  std::size_t const room = code.find("// ---- Room"), commit = code.find("// ---- Commit"), end = code.find("return ConeResult{"),
                    match = code.find("// ---- Match"), plan = code.find("// ---- Plan"), call = code.find("return rewrite_cone(");
  EXPECT_TRUE(room < commit && commit < end && end < match && match < plan && plan < call && call != std::string::npos);
}

// A rule without tests at all darts of a map: the map's columns serve as they are, and each is read before it is written.
TEST(Emit, AllDartsAreWrittenInPlace) {
  std::string const code = emit_module(R"(modeler M on omap(2) { }
rule quad on M {
  left  { hook a <1,2>; }
  right {
    a <_,_>; b; c; d;
    a -1-> c;  c -1[~1]-> d;  d -1-> b;  b -1[1]-> a;
    a -2[2]- b;  c -2- d;
  }
}
)").code;
  expect_contains(code, "  if (!map.has_erased_darts() && rewrite_all_quad(m, threads)) return {};\n");
  expect_contains(code, R"cpp(
  jrule::Map::FormerTargets former;
  int const overwritten[] = {2};
  std::size_t const added_b = map.append_darts(std::size_t{3} * n, threads, overwritten, former);
  std::size_t const added_c = added_b + n;
)cpp");
  std::size_t const in_place = code.find("static bool rewrite_all_quad");
  std::string const dense = code.substr(in_place, code.find("return true;", in_place) - in_place);
  expect_contains(dense, "jrule::rewrite::Index const* at_1 = map.targets(1).data();\n");
  expect_contains(dense, "  at_1 = map.targets(1).data();\n");
  expect_contains(dense, "  at_2 = map.targets(2, former).data();\n");
  expect_contains(dense, R"cpp(
      // shapes.jrule:6: b -1[1]-> a
      for (std::size_t k = begin; k < end; ++k) {
        std::size_t const at = added_b + k, to = at_1[k];
        arcs_1[at] = static_cast<jrule::Dart>(to);
        sources_1[to] = static_cast<jrule::Dart>(at);
      }
)cpp");
  // What is counted or read in order has no loop of its own.
  expect_contains(dense, R"cpp(
      // shapes.jrule:6: d -1-> b
      jrule::stream::count_up(arcs_1 + added_d, begin, end, added_b);
      jrule::stream::count_up(sources_1 + added_b, begin, end, added_d);
)cpp");
  expect_contains(dense, "      jrule::stream::shift(arcs_2, at_2, begin, end, added_b);\n");
  EXPECT_LT(dense.find("c -1[~1]-> d"), dense.find("b -1[1]-> a"));
  EXPECT_LT(dense.find("b -1[1]-> a"), dense.find("a -1-> c"));
}

TEST(Emit, WhatIsRequiredOfEachDartIsTestedInPlace) {
  auto const code = [](std::string const& condition) {
    return emit_module("modeler M on gmap(2) { embedding x : <1,2> -> Real; }\nrule dual on M { left { hook a <0,1,2>; require " + condition +
                       "; } right { a <2,1,0> { x = mean(<0,1>(a).x); } } }\n").code;
  };
  expect_contains(code("not any(e@2 == e for e in <0,1,2>(a)) and all(count(<0,1>(f)) == 6 for f in connected(a) by <0,1>)"), R"cpp(
  if (!jrule::parallel::all_of<jrule::Dart>(n, threads, [&](jrule::Dart e) {
    return !(to_2[e] == e);
  })) return false;
  if (!jrule::parallel::all_of<jrule::Dart>(n, threads, [&](jrule::Dart f) {
    return jrule::rewrite::count(walk_0_1, f) == std::int64_t{6};
  })) return false;
)cpp");
  expect_contains(code("all(true for e in connected(a))"), "[&](jrule::Dart) {\n    return true;\n");
  // What depends on the hook, on the dart that stands for a face, or on part of the orbit only.
  for (char const* condition : {"all(e.x < a.x for e in connected(a))", "all(f.x < 1 for f in connected(a) by <0,1>)",
                                "not all(e.x < 1 for e in connected(a))", "all(e.x < 1 for e in <0,1>(a))", "a.x < 1",
                                "any(e.x < 1 for e in connected(a))", "all(e.x < 1 for e in connected(a@1))"}) {
    EXPECT_EQ(code(condition).find("rewrite_all_dual"), std::string::npos) << condition;
  }
}

TEST(Emit, ComprehensionsAreLambdas) {
  std::string const code = emit_module(R"(modeler Shape on gmap(2) { embedding position : <1,2> -> Point3; }
rule smooth on Shape {
  left {
    hook a <1,2>;
    let start = a@[0,1];
    require all(count(<0,1>(k) by <0>) > 3 for k in <1,2>(start) by <1>) and count(1 for e in <1,2>(a)) > 2 + 2;
  }
  right { a { position = if a@2 == a then start.position else mean(mean((<0,1>(f) by <>).position) for f in <1,2>(a)); } }
}
)").code;
  expect_contains(code, "  jrule::Dart const start = to_1[to_0[a]];\n");
  expect_contains(code,
                  "  if (!(jrule::rewrite::all(walk_1_2_by_1, start, [&](jrule::Dart k_) { "
                  "return jrule::rewrite::count(walk_0_1_by_0, k_) > "
                  "std::int64_t{3}; }) && static_cast<std::int64_t>(jrule::rewrite::each(walk_1_2, a, "
                  "[&](jrule::Dart) { return std::int64_t{1}; }).size()) > std::int64_t{4})) {\n");
  expect_contains(code,
                  "    return to_2[match_a[k]] == match_a[k] ? position_of[all_start[number[k]]] : "
                  "jrule::rewrite::total(walk_1_2, match_a[k], [&](jrule::Dart f) { return "
                  "jrule::rewrite::total(walk_0_1, f, [&](jrule::Dart at) { return position_of[at]; }).mean(); }).mean();\n");
}

TEST(Emit, EqualInputsGiveEqualBytes) {
  Emitted const first = emit_module(shapes), second = emit_module(shapes);
  EXPECT_EQ(first.header, second.header);
  EXPECT_EQ(first.code, second.code);
  EXPECT_EQ(first.header.find(testing::TempDir()), std::string::npos);
  EXPECT_EQ(first.code.find(testing::TempDir()), std::string::npos);
}

TEST(Emit, Options) {
  Emitted const emitted = emit_module(shapes, {"my::ops", "my/ops"});
  expect_contains(emitted.code, "#include \"my/ops/shapes.h\"\n");
  expect_contains(emitted.code, "namespace my::ops {\n");
  expect_contains(emitted.header, "}  // namespace my::ops\n");
}

TEST(Emit, HarmlessNamesAreChanged) {
  Emitted const emitted = emit_module(R"(modeler class on gmap(2) { }
rule r(map: Real, r: Int) on class {
  left { hook delete <0>; require map > 0 and r > 0; }
  right { delete; }
}
)");
  EXPECT_TRUE(emitted.problems.empty());
  expect_contains(emitted.header, "class class_ {\n");
  expect_contains(emitted.header, "  jrule::Dart delete_ = jrule::no_dart;  ///< hook <0>\n");
  expect_contains(emitted.header,
                  "jrule::Result<RResult> r(class_& class_1, jrule::Dart delete_, double map, std::int64_t r_);\n");
}

TEST(Emit, NamesThatUsersSeeAreRefused) {
  Emitted const emitted = emit_module(R"(modeler M on gmap(2) {
  embedding map : <1,2> -> Real { default 0.0; merge mean; }
  embedding set_height : <1,2> -> Real { default 0.0; merge mean; }
  embedding height : <1,2> -> Real { default 0.0; merge mean; }
  embedding M : <1,2> -> Int { default 0; merge min; }
}
rule template on M { left { hook a <0>; } right { a; } }
rule a__b on M { left { hook a <0>; } right { a; } }
rule c on M { left { hook a <0>; } right { a; } }
rule c_everywhere on M { left { hook a <0>; } right { a; } }
rule errno on M { left { hook a <0>; } right { a; } }
)");
  EXPECT_EQ(emitted.header, "");
  std::vector<std::string> places = emitted.places;
  std::sort(places.begin(), places.end());
  EXPECT_EQ(places, (std::vector<std::string>{"M", "a__b", "c_everywhere", "errno", "height", "map", "template"}));
  for (source::Diagnostic const& d : emitted.problems) EXPECT_EQ(info(d.code).number, "J0901");
}

TEST(Emit, BadNamespacesAreRefused) {
  for (char const* bad : {"my::class", "std", "my::jrule", "my::", "::my", "a-b", "2d"}) {
    Emitted const emitted = emit_module(shapes, {bad, ""});
    ASSERT_EQ(emitted.places, std::vector<std::string>{"nowhere"}) << bad;
  }
}

TEST(Emit, BareModelsAndCustomModelsGetAClass) {
  Emitted const emitted = emit_module(R"(model ring(n) { dimensions 0..n; oriented 1; exchange (0, 2); }
modeler Rings on ring(2);
rule dart on gmap(1) { left { } right { a; a -0- a; a -1- a; } }
)");
  expect_contains(emitted.header, "class Gmap1 {\n");
  expect_contains(emitted.header, "jrule::Result<DartResult> dart(Gmap1& gmap1);\n");
  expect_contains(emitted.header,
                  "static jrule::Model model() { return {\"ring\", 2, {0, 1, 2}, 0x2, {{0, 2}}, false}; }\n");
  EXPECT_EQ(emitted.header.find("dart_everywhere"), std::string::npos);
}

// ---- C++ from outside ----

TEST(Emit, ExternHeadersAndCalls) {
  Emitted const emitted = emit_module(R"(extern type Soil in "geo/soil.hpp" as "geo::Soil";
extern fn grass() -> Soil in "geo/grass.hpp" as "geo::grass";
extern fn wet(soil: Soil, rain: Real) -> Soil in "geo/soil.hpp" as "geo::wet";
extern fn unused() -> Real in "unused.hpp" as "unused";
modeler Land on gmap(2) { embedding soil : face -> Soil; }
rule water(
    /// [mm] how much fell
    rain: Real = 0.5, other: Soil = grass()) on Land {
  left  { hook a <0,1>; let before = a.soil; }
  right { a { soil = if rain < 1 then wet(before, rain) else other; } }
}
)");
  EXPECT_TRUE(emitted.problems.empty());
  expect_contains(emitted.header, "#include \"geo/grass.hpp\"\n#include \"geo/soil.hpp\"\n\n");
  EXPECT_EQ(emitted.header.find("unused.hpp"), std::string::npos);
  expect_contains(emitted.header, "/// @param rain  Real in mm, by default 0.5: how much fell\n/// @param other  Soil, by default ::geo::grass()\n");
  expect_contains(emitted.header, "water(Land& land, jrule::Dart a, double rain = 0.5, ::geo::Soil const& other = ::geo::grass());");
  expect_contains(emitted.code, "::geo::Soil const before = soil_of[a];\n");
  expect_contains(emitted.code, "rain < 1.0 ? ::geo::wet(all_before[number[k]], rain) : other");
}

TEST(Emit, ExternHeadersOfConditionsOfDarts) {
  Emitted const emitted = emit_module(R"(extern fn far(x: Real) -> Bool in "geo/far.hpp" as "geo::far";
modeler Land on gmap(2) { embedding height : vertex -> Real; }
rule level on Land {
  left  { hook a <0,1>; require (if far(a.height) then a else a@0).height > 0; }
  right { a; }
}
)");
  EXPECT_TRUE(emitted.problems.empty());
  expect_contains(emitted.header, "#include \"geo/far.hpp\"\n");
}

TEST(Emit, ExternNamesThatCppCannotUse) {
  Emitted const emitted = emit_module(R"(extern type Soil in "geo/soil.hpp" as "geo::class";
extern fn grass() -> Soil in "geo/soil.hpp" as "new::grass";
modeler Land on gmap(2) { embedding soil : face -> Soil { default grass(); } }
)");
  ASSERT_EQ(emitted.problems.size(), 2U);
  EXPECT_EQ(emitted.problems[0].message, "the extern type `Soil` cannot be `geo::class` in C++: `class` is a keyword of C++");
  EXPECT_EQ(emitted.problems[1].message, "the extern function `grass` cannot be `new::grass` in C++: `new` is a keyword of C++");
  EXPECT_EQ(emitted.places, (std::vector<std::string>{"Soil", "grass"}));
}

}  // namespace
}  // namespace jrule::cpp
