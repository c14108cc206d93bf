// Memory runs out at each allocation of an application: generated code and the interpreter leave the map as it was.
#include <optional>
#include <tuple>

#include "changes.h"
#include "compiler/backend/interpreter/interpreter.h"
#include "halfedges.h"
#include "paper/surface.h"
#include "smoothing.h"
#include "tests/integration/both.h"
#include "tests/integration/faults.h"
#include "tests/integration/torus.h"
#include "values.h"

namespace {

using jrule::Dart;
using jrule::Map;
using jrule::Value;
using jrule::test::applied;
using jrule::test::every_allocation_fails;
using jrule::test::Fail;
using jrule::test::Module;
using jrule::test::torus;

/// What the interpreter applies rules to.
struct Interpreted {
  Map content;
  jrule::rewrite::Workspace workspace{};
  Map const& map() const { return content; }
};

struct Site {
  std::vector<Dart> hooks;  // none for a rule that creates, or if it is applied everywhere
  bool everywhere = false;
};

class Faults : public testing::TestWithParam<Fail> {
 protected:
  // Generated code first, then the interpreter.
  template <class Class, class Apply>
  void check(Module const& module, std::string const& rule, Class const& start, Site const& site,
             std::vector<Value> const& arguments, Apply const& apply) {
    SCOPED_TRACE(rule + (site.everywhere ? " everywhere" : ""));
    EXPECT_GT(every_allocation_fails(start, apply, GetParam()), 0U);
    SCOPED_TRACE("interpreted");
    Module::Rule const& r = module.rule(rule);
    auto const interpret = [&](Interpreted& i) -> jrule::Result<void> {
      if (site.everywhere) {
        auto const count = jrule::interpreter::apply_all(r.scheme, r.plan, i.content, arguments, i.workspace);
        if (!count) return tl::unexpected(count.error());
      } else {
        auto const result = jrule::interpreter::apply(r.scheme, r.plan, i.content, site.hooks, arguments, i.workspace);
        if (!result) return tl::unexpected(result.error());
      }
      return {};
    };
    EXPECT_GT(every_allocation_fails(Interpreted{start.map()}, interpret, GetParam()), 0U);
  }
};

auto const both_ways = testing::Values(Fail::once, Fail::from_then_on);
auto const name_of_way = [](auto const& how) { return how.param == Fail::once ? "Once" : "FromThenOn"; };
INSTANTIATE_TEST_SUITE_P(Allocations, Faults, both_ways, name_of_way);

template <class Class>
Class read(std::string const& file) {
  auto modeler = Class::read(JRULE_SOURCE_DIR "/tests/data/" + file);
  EXPECT_TRUE(modeler) << to_string(modeler.error());
  jrule::test::number_values(modeler->map());
  return std::move(*modeler);
}

std::string const rules = JRULE_RULES_DIR;

// ---- Darts: created, kept, deleted, split and merged ----

using changes::Field;

class FieldFaults : public Faults {
 protected:
  Module module_{rules + "/changes.jrule"};

  // Squares of which the first darts are erased: new ones take their places, and then those after the last.
  static Field squares_with_gaps() {
    Field field;
    std::optional<changes::SquareResult> first;
    for (int i = 0; i < 4; ++i) {
      auto const made = changes::square(field, 1.0 + i);
      EXPECT_TRUE(made);
      if (!first) first = *made;
    }
    jrule::test::number_values(field.map());
    EXPECT_TRUE(changes::remove_component(field, first->a));
    return field;
  }
};

INSTANTIATE_TEST_SUITE_P(Allocations, FieldFaults, both_ways, name_of_way);

TEST_P(FieldFaults, Creation) {
  check(module_, "square", squares_with_gaps(), {}, {2.5}, [](Field& f) { return changes::square(f, 2.5); });
  check(module_, "square", Field(), {}, {2.5}, [](Field& f) { return changes::square(f, 2.5); });
}

TEST_P(FieldFaults, Merge) {
  check(module_, "sew", squares_with_gaps(), {{8, 16}}, {}, [](Field& f) { return changes::sew(f, 8, 16); });
}

TEST_P(FieldFaults, Split) {
  Field const cube = read<Field>("cube.obj");
  check(module_, "unsew", cube, {{5}}, {}, [](Field& f) { return changes::unsew(f, 5); });
}

TEST_P(FieldFaults, Deletion) {
  check(module_, "remove_component", squares_with_gaps(), {{9}}, {}, [](Field& f) { return changes::remove_component(f, 9); });
  Field const cube = applied(read<Field>("cube.obj"), [](Field& f) { return changes::insert_vertex_everywhere(f); });
  check(module_, "remove_vertex", cube, {{50}}, {}, [](Field& f) { return changes::remove_vertex(f, 50); });
}

TEST_P(FieldFaults, Growth) {
  for (Field const& start : {read<Field>("cube.obj"), squares_with_gaps()}) {
    check(module_, "insert_vertex", start, {{8}}, {}, [](Field& f) { return changes::insert_vertex(f, 8); });
    check(module_, "triangulate_face", start, {{8}}, {}, [](Field& f) { return changes::triangulate_face(f, 8); });
  }
}

// Dense without erased darts, over a list of the places with them.
TEST_P(FieldFaults, Everywhere) {
  for (Field const& start : {read<Field>("cube.obj"), squares_with_gaps()}) {
    check(module_, "insert_vertex", start, {{}, true}, {}, [](Field& f) { return changes::insert_vertex_everywhere(f); });
    check(module_, "triangulate_face", start, {{}, true}, {}, [](Field& f) { return changes::triangulate_face_everywhere(f); });
    check(module_, "remove_component", start, {{}, true}, {}, [](Field& f) { return changes::remove_component_everywhere(f); });
  }
}

// So many values that no dart has that the application ends with dropping them, or puts that off.
TEST_P(FieldFaults, WhereValuesAreDropped) {
  Field field = squares_with_gaps();
  jrule::Embedding& position = field.map().embedding(0);
  while (!position.is_compaction_due()) position.add(jrule::Point3{1, 2, 3});
  check(module_, "remove_component", field, {{8}}, {}, [](Field& f) { return changes::remove_component(f, 8); });
  EXPECT_TRUE(changes::remove_component(field, 8));
  EXPECT_LT(position.value_count(), 16U);
}

// ---- Values ----

TEST_P(Faults, ListsLetsAndRequirements) {
  using values::All;
  Module const module(rules + "/values.jrule");
  All const grid = read<All>("grid.ply");
  std::vector<Value> const arguments = {0.3, jrule::Vec3{0.25, 0.3, -1}, std::int64_t{3}, true, jrule::Point2{0.3, 1}};
  check(module, "shuffle", grid, {{4}}, arguments, [](All& a) {
    return values::shuffle(a, 4, 0.3, {0.25, 0.3, -1}, 3, true, {0.3, 1});
  });
  check(module, "paint", grid, {{}, true}, {}, [](All& a) { return values::paint_everywhere(a); });
}

TEST_P(Faults, Comprehensions) {
  using smoothing::Surface;
  Module const module(rules + "/smoothing.jrule");
  // Small, for the interpreter allocates for each expression.
  Surface const solid = read<Surface>("tetrahedron.off"), cube = read<Surface>("cube.obj");
  check(module, "catmull_clark", solid, {{7}}, {}, [](Surface& s) { return smoothing::catmull_clark(s, 7); });
  check(module, "catmull_clark", solid, {{}, true}, {}, [](Surface& s) { return smoothing::catmull_clark_everywhere(s); });
  check(module, "relax", cube, {{7}}, {0.25}, [](Surface& s) { return smoothing::relax(s, 7, 0.25); });
}

TEST_P(Faults, OrientedMaps) {
  using halfedges::Halfedges;
  Module const module(rules + "/halfedges.jrule");
  Halfedges const cube = read<Halfedges>("cube.obj");
  check(module, "quad_subdivision", cube, {{2}}, {}, [](Halfedges& h) { return halfedges::quad_subdivision(h, 2); });
  check(module, "quad_subdivision", cube, {{}, true}, {}, [](Halfedges& h) { return halfedges::quad_subdivision_everywhere(h); });
  check(module, "reverse", cube, {{2}}, {}, [](Halfedges& h) { return halfedges::reverse(h, 2); });
}

// Beyond some size columns are taken by large pages, and scratch memory from the system. What applications add to a map is
// added here by itself.
TEST(LargeFaults, MapsGrow) {
  using paper::rules::Surface;
  Surface const start = torus<Surface>(182);
  ASSERT_GT(start.map().dart_limit() * sizeof(Dart), std::size_t{1} << 20);
  auto const grow = [](Surface& s) -> jrule::Result<void> {
    try {
      s.workspace().reserve(s.map().dart_limit() + 1);
      s.map().reserve(1, 1);
      std::ignore = s.map().append_darts(1);
      for (int const i : {0, 1, 2}) s.map().set_target(s.map().dart_limit() - 1, i, s.map().dart_limit() - 1);
      for (std::size_t const e : {0U, 1U}) s.map().embedding(e).set_handle(s.map().dart_limit() - 1, 0);
    } catch (std::bad_alloc const&) {
      return tl::unexpected(jrule::rewrite::no_memory("grow"));
    }
    return {};
  };
  // Of the workspace the queue, the handles, stamps and values; of the map a column for each dimension and embedding, and pools.
  EXPECT_GE(every_allocation_fails(start, grow, Fail::once), 11U);
}

// Those that are larger still have pages of their own, which move to where there is room for more.
TEST(LargeFaults, PagesStayWhereTheyAre) {
  constexpr std::size_t size = 9'000'011, more = 12'000'001;
  ASSERT_TRUE(jrule::memory::has_own_pages(size * sizeof(std::uint32_t)));
  jrule::ColumnOf<std::uint32_t> const start(size, 7U);
  std::size_t failures = 0;
  for (std::size_t k = 1;; ++k) {
    jrule::ColumnOf<std::uint32_t> column = start;
    std::uint32_t const* const before = column.data();
    jrule::test::FailingAllocation failing(k, Fail::once);
    try {
      column.reserve(more);
    } catch (std::bad_alloc const&) {
    }
    bool const failed = failing.stop();
    EXPECT_EQ(column.data() == before, failed);
    EXPECT_EQ(column.capacity(), failed ? size : more);
    EXPECT_EQ(column, start);
    if (!failed) break;
    ++failures;
  }
  EXPECT_EQ(failures, 2U);  // no place, and no way there
}

// ---- Refusals ----

// Their texts take memory too: then they say so.
TEST_P(Faults, ARefusalIsOne) {
  using paper::rules::Surface;
  Surface const cube = read<Surface>("cube.obj");
  std::string const before = print_jmap(cube.map());
  auto const cone = [](Surface& s) { return paper::rules::cone(s, 0, {1, 2, 3}); };
  for (std::size_t k = 1;; ++k) {
    Surface subject = cube;
    jrule::test::FailingAllocation failing(k, GetParam());
    auto const result = cone(subject);
    bool const failed = failing.stop();
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().kind, failed ? jrule::Error::Kind::no_memory : jrule::Error::Kind::not_applicable);
    EXPECT_EQ(print_jmap(subject.map()), before);
    if (!failed) break;
  }
}

}  // namespace
