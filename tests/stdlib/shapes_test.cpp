// std.shapes: each operation makes the shape of its name.
#include "tests/stdlib/shapes.h"

#include <cmath>
#include <set>

#include "compiler/backend/interpreter/operation.h"
#include "compiler/sema/elaborate.h"
#include "jrule/typed.h"
#include "tests/reference/plain_map.h"
#include "tests/stdlib/application.h"
#include "tests/stdlib/measure.h"

namespace jrule::test {
namespace {

struct Shapes {
  ir::Program program;
  std::vector<analysis::Verdict> verdicts{};

  Shapes() {
    source::Sources sources;
    source::Diagnostics diagnostics;
    auto const modules =
        sema::load(JRULE_SOURCE_DIR "/stdlib/std/shapes.jrule", {JRULE_SOURCE_DIR "/stdlib", {}}, sources, diagnostics);
    program = sema::elaborate(modules, diagnostics);
    for (source::Diagnostic const& d : diagnostics.all()) ADD_FAILURE() << source::render_human(sources, d);
    for (ir::RuleScheme const& rule : program.rules) verdicts.push_back(analysis::analyze(rule));
  }

  /// The map that an operation makes from nothing; its result is a dart of it.
  Result<Map> make(std::string const& name, std::vector<ir::Evaluated> const& arguments) const {
    for (std::size_t i = 0; i < program.operations.size(); ++i) {
      if (program.operations[i].name != name) continue;
      Map map(program.operations[i].modeler->model, program.operations[i].modeler->embeddings);
      rewrite::Workspace workspace;
      auto const result = interpreter::run({program, verdicts}, i, map, arguments, workspace);
      if (!result) return tl::unexpected(result.error());
      EXPECT_TRUE(map.contains(std::get<Dart>(result->value())));
      EXPECT_FALSE(find_violation(map));
      EXPECT_EQ(degeneracy(map) + misplaced(map), "") << name;
      return map;
    }
    throw std::out_of_range("there is no operation " + name);
  }
};

Shapes const& shapes() {
  static Shapes const all;
  return all;
}
ir::Evaluated integer(std::size_t n) { return Value{static_cast<std::int64_t>(n)}; }
ir::Evaluated real(double x) { return Value{x}; }

bool same(Map const& a, Map const& b) {
  return reference::isomorphic(reference::plain(a), reference::plain(b), {}, {}, {});
}

TEST(Shapes, PlatonicSolids) {
  for (Shape const& solid : platonic_solids()) {
    SCOPED_TRACE(solid.name);
    auto const made = shapes().make(solid.name, {real(2.5)});
    ASSERT_TRUE(made) << made.error().message;
    EXPECT_TRUE(same(*made, build(*shapes().program.operations[0].modeler, solid.polygons)));
    rewrite::Values<Point3> const at(made->embedding(0));
    double const edge = distance(at[0], at[made->target(0, 0)]);
    for (Dart const d : made->darts()) {
      EXPECT_NEAR(norm(at[d] - Point3{}), 2.5, 1e-12);
      EXPECT_NEAR(distance(at[d], at[made->target(d, 0)]), edge, 1e-12);
    }
  }
}

TEST(Shapes, EachWithItsDefaults) {
  for (ir::Operation const& operation : shapes().program.operations) {
    std::vector<ir::Evaluated> arguments;
    for (ir::Parameter const& parameter : operation.parameters) arguments.emplace_back(parameter.default_value.value());
    auto const made = shapes().make(operation.name, arguments);
    ASSERT_TRUE(made) << operation.name << ": " << made.error().message;
    EXPECT_EQ(summarize(*made).components, 1U) << operation.name;
  }
}

TEST(Shapes, OfManySides) {
  using Cells = std::vector<std::size_t>;
  for (std::size_t const n : {3U, 4U, 5U, 8U, 13U}) {
    SCOPED_TRACE(n);
    auto const polygon = shapes().make("polygon", {integer(n), real(2)});
    ASSERT_TRUE(polygon) << polygon.error().message;
    EXPECT_EQ(summarize(*polygon).cells, (Cells{n, n, 1}));
    for (auto const& [name, cells] : std::map<std::string, Cells>{{"regular_prism", {2 * n, 3 * n, n + 2}},
                                                                  {"regular_pyramid", {n + 1, 2 * n, n + 1}},
                                                                  {"bipyramid", {n + 2, 3 * n, 2 * n}},
                                                                  {"antiprism", {2 * n, 4 * n, 2 * n + 2}}}) {
      SCOPED_TRACE(name);
      auto const made = shapes().make(name, {integer(n), real(2), real(3)});
      ASSERT_TRUE(made) << made.error().message;
      EXPECT_EQ(summarize(*made).cells, cells);
      EXPECT_EQ(summarize(*made).euler, 2);
      EXPECT_EQ(summarize(*made).boundary_darts, 0U);
      // All but the tips of pyramids lie on a cylinder.
      rewrite::Values<Point3> const at(made->embedding(0));
      std::size_t round = 0;
      for (Dart const d : jrule::cells(*made, 0)) round += std::abs(std::hypot(at[d].x, at[d].y) - 2) < 1e-12 ? 1 : 0;
      EXPECT_EQ(round, name.ends_with("prism") ? 2 * n : n);
    }
  }
  for (char const* name : {"regular_prism", "antiprism"}) {
    auto const none = shapes().make(name, {integer(2), real(1), real(1)});
    ASSERT_FALSE(none);
    EXPECT_NE(none.error().message.find("at least three sides"), std::string::npos) << none.error().message;
  }
}

TEST(Shapes, Grids) {
  for (auto const& [columns, rows] :
       std::vector<std::pair<std::size_t, std::size_t>>{{1, 1}, {3, 1}, {1, 4}, {3, 2}, {5, 6}}) {
    auto const made = shapes().make("grid", {integer(columns), integer(rows)});
    ASSERT_TRUE(made) << made.error().message;
    EXPECT_TRUE(same(*made, build(*shapes().program.operations[0].modeler, grid(columns, rows).polygons)));
  }
  EXPECT_FALSE(shapes().make("grid", {integer(0), integer(1)}));
}

}  // namespace
}  // namespace jrule::test
