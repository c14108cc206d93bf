// parse(print(program)) = program, for every .jrule file of the repository that the front end accepts.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "compiler/backend/text/print_jrule.h"
#include "compiler/sema/elaborate.h"
#include "compiler/syntax/format.h"
#include "tests/text/again.h"
#include "tests/text/difference.h"

namespace jrule::tests {

namespace {

namespace fs = std::filesystem;

std::vector<std::string> corpus() {
  std::vector<std::string> paths;
  for (char const* const folder : {"examples", "stdlib", "tests/golden", "tests/paper", "tests/integration"}) {
    for (auto const& entry : fs::recursive_directory_iterator(fs::path(JRULE_SOURCE_DIR) / folder)) {
      if (entry.path().extension() == ".jrule") paths.push_back(entry.path().string());
    }
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

struct Loaded {
  source::Sources sources;
  source::Diagnostics diagnostics;
  sema::Modules modules;

  explicit Loaded(std::string const& path) {
    sema::SearchPath const search{std::string(JRULE_SOURCE_DIR) + "/stdlib", {std::string(JRULE_SOURCE_DIR) + "/tests/integration/rules"}};
    modules = sema::load(path, search, sources, diagnostics);
  }
};

void expect_same_modeler(ir::Modeler const& before, ir::Modeler const& after, std::string const& module) {
  auto const found = difference(before, after);
  EXPECT_FALSE(found) << *found << " differs: " << before.name;
  // Imported modelers are declared in the text.
  EXPECT_EQ(after.module, before.module.empty() ? "" : module);
}

/// What an item is called in the text: `Terrain.quad`, of several modelers, and `sew[2]`.
std::string text_name(std::string name) {
  std::erase(name, ']');
  std::replace_if(name.begin(), name.end(), [](char c) { return c == '.' || c == '[' || c == ','; }, '_');
  return name;
}

/// The operation as IR, its rules and operations under the names of the text.
std::string print_under(ir::Program program, std::size_t operation, std::vector<std::string> const& rules) {
  for (std::size_t i = 0; i < rules.size(); ++i) program.rules[i].name = rules[i];
  for (ir::Operation& o : program.operations) o.name = text_name(o.name);
  return ir::print(program.operations[operation], program);
}

void expect_same(ir::Program const& before, std::vector<std::string> const& names, std::string const& text) {
  Again const after = elaborate_again(text, before.module);
  ASSERT_EQ(after.errors, "") << text;
  ASSERT_GE(after.program.modelers.size(), before.modelers.size()) << text;
  for (std::size_t i = 0; i < before.modelers.size(); ++i) expect_same_modeler(*before.modelers[i], *after.program.modelers[i], before.module);
  ASSERT_EQ(after.program.rules.size(), before.rules.size()) << text;
  for (std::size_t i = 0; i < before.rules.size(); ++i) {
    ir::RuleScheme const& rule = before.rules[i];
    EXPECT_EQ(after.program.rules[i].name, names[i]);
    EXPECT_EQ(after.program.rules[i].module, rule.import ? before.module : rule.module);  // as modelers
    expect_same_modeler(*rule.modeler, *after.program.rules[i].modeler, before.module);
    auto const found = difference(rule, after.program.rules[i], Order::kept);
    EXPECT_FALSE(found) << *found << " differ\n" << ir::print(rule) << text << ir::print(after.program.rules[i]);
  }
  ASSERT_EQ(after.program.operations.size(), before.operations.size()) << text;
  for (std::size_t i = 0; i < before.operations.size(); ++i) {
    EXPECT_EQ(after.program.operations[i].name, text_name(before.operations[i].name));
    EXPECT_EQ(after.program.operations[i].doc, before.operations[i].doc);
    EXPECT_EQ(print_under(before, i, names), print_under(after.program, i, names)) << text;
  }
  EXPECT_EQ(syntax::format(text), text);
}

}  // namespace

TEST(Corpus, ElaboratesToTheSameProgramWhenPrinted) {
  int programs = 0;
  std::size_t rules = 0, operations = 0;
  for (std::string const& path : corpus()) {
    SCOPED_TRACE(path);
    Loaded loaded(path);
    ir::Program const program = sema::elaborate(loaded.modules, loaded.diagnostics);
    if (loaded.diagnostics.has_errors()) continue;
    auto const text = text::print_jrule(program);
    if (program.modelers.empty() && program.rules.empty()) {  // families, imports
      EXPECT_FALSE(text);
      continue;
    }
    ASSERT_TRUE(text) << text.error().reason;
    std::vector<std::string> names;
    for (ir::RuleScheme const& rule : program.rules) {
      names.push_back(text_name(rule.name));
    }
    expect_same(program, names, *text);
    ++programs;
    rules += program.rules.size();
    operations += program.operations.size();
  }
  RecordProperty("programs", programs);
  RecordProperty("rules", static_cast<int>(rules));
  EXPECT_GE(programs, 80);
  EXPECT_GE(rules, 150U);
  EXPECT_GE(operations, 10U);
}

TEST(Corpus, InstancesOfFamiliesElaborateToTheSameRuleWhenPrinted) {
  int instances = 0;
  for (std::string const& path : corpus()) {
    SCOPED_TRACE(path);
    Loaded const loaded(path);
    if (loaded.diagnostics.has_errors()) continue;
    for (ast::Item const& item : loaded.modules.all.back().ast.items) {
      auto const* const family = std::get_if<ast::Rule>(&item);
      if (!family || family->dimension_parameters.size() != 1) continue;
      for (int n = 0; n <= 3; ++n) {
        for (int i = 0; i <= 3; ++i) {
          source::Diagnostics diagnostics;
          auto const rule = sema::instantiate(loaded.modules, family->name.text, {i}, n, diagnostics);
          if (!rule || diagnostics.has_errors()) continue;
          auto const text = text::print_jrule(*rule);
          ASSERT_TRUE(text) << text.error().reason;
          expect_same({rule->module, {}, {*rule}}, {family->name.text + "_" + std::to_string(i)}, *text);
          ++instances;
        }
      }
    }
  }
  RecordProperty("instances", instances);
  EXPECT_GE(instances, 20);
}

}  // namespace jrule::tests
