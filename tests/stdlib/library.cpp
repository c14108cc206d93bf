#include "tests/stdlib/library.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <numeric>

#include "compiler/sema/elaborate.h"

namespace jrule::test {

namespace {

std::string path_of(std::string const& module) { return JRULE_SOURCE_DIR "/stdlib/std/" + module + ".jrule"; }

/// What a rule for all dimensions stands for where maps have dimension n.
std::vector<Module::Rule> instances(std::string const& family, std::size_t parameters, int n) {
  std::vector<Module::Rule> found;
  for (int i = 0; i <= (parameters == 0 ? 0 : n); ++i) {
    auto rule = find_instance(family, std::vector<int>(parameters, i), n);
    if (rule) found.push_back(std::move(*rule));
  }
  return found;
}

}  // namespace

std::vector<std::string> modules() {
  std::vector<std::string> names;
  for (auto const& file : std::filesystem::directory_iterator(JRULE_SOURCE_DIR "/stdlib/std"))
    names.push_back(file.path().stem());
  std::sort(names.begin(), names.end());
  return names;
}

std::vector<ast::Rule> declared_rules(std::string const& module) {
  source::Sources sources;
  source::Diagnostics diagnostics;
  sema::Modules const loaded = sema::load(path_of(module), {JRULE_SOURCE_DIR "/stdlib", {}}, sources, diagnostics);
  EXPECT_FALSE(diagnostics.has_errors());
  std::vector<ast::Rule> rules;
  for (ast::Item const& item : loaded.all.back().ast.items) {
    if (auto const* rule = std::get_if<ast::Rule>(&item)) rules.push_back(*rule);
  }
  return rules;
}

Rules rules_of(std::string const& module) {
  Rules found;
  std::vector<ast::Rule> const declared = declared_rules(module);
  found.declared = declared.size();
  if (module == "basic") {
    for (ast::Rule const& family : declared) {
      for (int n = 1; n <= 3; ++n) {
        for (Module::Rule& rule : instances(family.name.text, family.dimension_parameters.size(), n)) {
          rule.scheme.name += " on gmap(" + std::to_string(n) + ")";
          found.rules.push_back(std::move(rule));
        }
      }
    }
    return found;
  }
  Module const all(path_of(module));
  for (ast::Rule const& rule : declared) found.rules.push_back(all.rule(rule.name.text));
  return found;
}

std::vector<Subject> const& subjects_for(ir::RuleScheme const& rule) {
  static std::map<std::string, std::vector<Subject>> known;
  Model const& model = rule.model();
  std::string const name = std::to_string(model.dimension) + (model.is_oriented(1) ? "O" : "G") +
                           std::to_string(rule.modeler->embeddings.size());
  auto found = known.find(name);
  if (found == known.end()) {
    bool const has_values = !rule.modeler->embeddings.empty();
    found = known.emplace(name, has_values ? subjects(*rule.modeler) : bare_subjects(model.dimension)).first;
  }
  return found->second;
}

std::vector<Value> some_arguments(ir::RuleScheme const& rule) {
  std::vector<Value> values;
  for (ir::Parameter const& parameter : rule.parameters) {
    double const numbers[] = {static_cast<double>(values.size()) + 1, 0.5, 0.25};
    values.push_back(parameter.default_value ? *parameter.default_value : from_components(parameter.type, numbers));
  }
  return values;
}

std::vector<Module::Rule> const& all_rules() {
  static std::vector<Module::Rule> const all = [] {
    std::vector<Module::Rule> found;
    for (std::string const& module : modules()) {
      for (Module::Rule& rule : rules_of(module).rules) found.push_back(std::move(rule));
    }
    return found;
  }();
  return all;
}

std::string family_of(std::string const& name) { return name.substr(0, name.find_first_of("[ ")); }

std::vector<Dart> spread(Map const& map) {
  std::vector<Dart> const darts = map.darts();
  std::size_t const n = darts.size();
  std::size_t step = n * 5 / 13 + 1;
  while (std::gcd(step, n) != 1) ++step;
  std::vector<Dart> found;
  for (std::size_t k = 0; k < n; ++k) found.push_back(darts[k * step % n]);
  return found;
}

}  // namespace jrule::test
