// The library as a whole: its modules side by side, on modelers that store more than positions.
#include <filesystem>
#include <set>

#include "tests/stdlib/library.h"

namespace jrule::test {
namespace {

Module const& all() {
  static Module const module(JRULE_SOURCE_DIR "/tests/stdlib/all.jrule");
  return module;
}

TEST(Library, StandsSideBySide) {
  std::set<std::string> names;
  for (auto const& file : std::filesystem::directory_iterator(JRULE_SOURCE_DIR "/stdlib/std")) {
    if (file.path().stem() == "basic") continue;  // families, of which there are notes
    Module const module(file.path().string());
    for (Module::Rule const& rule : module.rules()) {
      if (rule.scheme.module != file.path().stem()) continue;  // operations use those of other modules
      EXPECT_TRUE(names.insert(rule.scheme.name).second) << rule.scheme.name << " is the name of two rules";
      EXPECT_NE(rule.scheme.doc, "") << rule.scheme.name;
      for (ir::Parameter const& parameter : rule.scheme.parameters) {
        // Corners of what is added from nothing, in their order, say enough.
        EXPECT_TRUE(!parameter.doc.empty() || rule.scheme.name.starts_with("add_"))
            << rule.scheme.name << ": " << parameter.name;
      }
    }
  }
  std::set<std::string> together;
  for (Module::Rule const& rule : all().rules()) together.insert(rule.scheme.name);
  EXPECT_EQ(together, names);
}

Map sample(ir::Modeler const& modeler, std::size_t k) {
  if (modeler.model.dimension == 2) {
    std::vector<Shape> const& solids = platonic_solids();
    return k == 0 && !modeler.model.is_oriented(1) ? build(modeler, grid(3, 2).polygons)
                                                   : build(modeler, solids[k].polygons);
  }
  // A cube with its faces free, then solids without a border.
  return k == 0 && !modeler.model.is_oriented(1) ? build(modeler, solids()[1]) : build(modeler, solids()[k + 5]);
}

// Wherever a rule is applied, each orbit of each embedding has one value afterwards.
TEST(Library, KeepsTheValuesOfMoreEmbeddings) {
  for (Module::Rule const& rule : all().rules()) {
    SCOPED_TRACE(rule.scheme.name);
    int applied = 0;
    for (std::size_t k = 0; k < 5; ++k) {
      Map start = sample(*rule.scheme.modeler, k);
      number_values(start);
      ASSERT_FALSE(find_violation(start));
      std::vector<std::vector<Dart>> sites{{}};
      for (std::size_t hook = 0; hook < rule.scheme.hooks.size(); ++hook) {
        std::vector<std::vector<Dart>> more;
        for (std::vector<Dart> const& site : sites) {
          for (Dart const d : start.darts()) {
            if (hook == 0 ? d % (start.dart_count() / 4) != 0 : d > 60) continue;
            more.push_back(site);
            more.back().push_back(d);
          }
        }
        sites = std::move(more);
      }
      for (std::vector<Dart> const& site : sites) {
        Map map = start;
        if (!refusal(rule, map, site, some_arguments(rule.scheme)).empty()) continue;
        apply(rule, map, site, some_arguments(rule.scheme));
        if (++applied % 4 == 0) break;
      }
    }
    // What stands by itself is made from nothing, the corner of two edges by insert_vertex, and open sides by add_side.
    std::set<std::string> const elsewhere{
        "cone", "cone_halfedges", "join_sides", "prism", "prism_solid", "cone_solid", "remove_vertex", "remove_vertex_halfedges"};
    if (!elsewhere.contains(rule.scheme.name)) {
      EXPECT_GT(applied, 0);
    }
  }
}

}  // namespace
}  // namespace jrule::test
