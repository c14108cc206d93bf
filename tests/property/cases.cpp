#include "tests/property/cases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <ostream>

#include "jrule/io.h"
#include "tests/property/models.h"
#include "tests/property/mutation.h"
#include "tests/property/operations.h"

namespace jrule::property {

namespace {

std::string variable(char const* name, std::string const& otherwise) {
  char const* const value = std::getenv(name);
  return value ? value : otherwise;
}

/// RapidCheck takes its seed and the number of cases from the environment, at its first property.
class Configuration : public testing::Environment {
 public:
  void SetUp() override {
    std::string const parameters =
        "seed=" + std::to_string(case_seed()) + " max_success=" + std::to_string(case_count());
    setenv("RC_PARAMS", parameters.c_str(), 0);
  }
};
[[maybe_unused]] testing::Environment* const configuration = testing::AddGlobalTestEnvironment(new Configuration);

}  // namespace

std::uint64_t case_seed() { return std::stoull(variable("JRULE_SEED", "1")); }
int case_count() { return std::stoi(variable("JRULE_CASES", "10000")); }

std::ostream& operator<<(std::ostream& out, Case const& c) {
  out << "operation " << c.operation << ", mutations";
  for (std::uint64_t const m : c.mutations) out << ' ' << m;
  return out << ", maps " << c.maps;
}

rc::Gen<Case> cases() {
  auto const number = rc::gen::noShrink(rc::gen::resize(rc::kNominalSize, rc::gen::arbitrary<std::uint64_t>()));
  return rc::gen::build<Case>(
      rc::gen::set(&Case::operation, number),
      rc::gen::set(&Case::mutations, rc::gen::resize(4, rc::gen::container<std::vector<std::uint64_t>>(number))),
      rc::gen::set(&Case::maps, number));
}

ir::RuleScheme make_rule(Case const& c, std::shared_ptr<ir::Modeler const> (*modeler_of)(Model const&)) {
  Random random(c.operation);
  // The first models of the list are drawn more often.
  Model const& model = models()[std::min(random.below(models().size()), random.below(models().size()))];
  ir::RuleScheme rule = random_operation(modeler_of(model), random);
  for (std::uint64_t const number : c.mutations) {
    Random choices(number);
    rule = mutate(rule, choices);
  }
  return rule;
}

std::vector<Site> make_sites(Case const& c, ir::RuleScheme const& rule) {
  Random random(c.maps);
  std::vector<Site> sites;
  auto const add_other_hooks = [&](Map const& map, std::size_t count) {
    std::vector<Dart> const darts = map.darts();
    for (; count > 0; --count) {
      std::vector<Dart> hooks;
      for (std::size_t h = 0; h < rule.hooks.size(); ++h) hooks.push_back(random.pick(darts));
      sites.push_back({map, std::move(hooks)});
    }
  };
  for (int grown = 0; grown < 3; ++grown) {
    std::optional<Site> site;
    for (int attempt = 0; attempt < 4 && !site; ++attempt) site = grow_site(rule, random);
    if (!site) continue;
    add_other_hooks(site->map, 2);
    sites.push_back(std::move(*site));
  }
  for (Map const& map : random_maps(rule.model(), 2, random)) add_other_hooks(map, 2);
  std::stable_sort(sites.begin(), sites.end(),
                   [](Site const& a, Site const& b) { return a.map.dart_count() < b.map.dart_count(); });
  return sites;
}

std::string describe(ir::RuleScheme const& rule, Site const& site) {
  std::string text = ir::print(rule) + print_jmap(site.map) + "hooks";
  for (Dart const d : site.hooks) text += ' ' + std::to_string(d);
  return text + '\n';
}

}  // namespace jrule::property
