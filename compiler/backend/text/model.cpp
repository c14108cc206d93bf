#include "compiler/backend/text/model.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <set>

namespace jrule::text {

namespace {

using Dimensions = std::set<int>;

Dimensions dimensions_of(Model const& model) { return {model.dimensions.begin(), model.dimensions.end()}; }
Dimensions oriented_of(Model const& model) {
  Dimensions result;
  for (int d = 0; d < 16; ++d) {
    if ((model.oriented >> d & 1) != 0) result.insert(d);
  }
  return result;
}

bool contiguous(Dimensions const& all) {
  return !all.empty() && *all.rbegin() - *all.begin() == static_cast<int>(all.size()) - 1;
}

std::string spell_set(Dimensions const& all) {
  if (all.size() > 1 && contiguous(all)) return fmt::format("{}..{}", *all.begin(), *all.rbegin());
  return fmt::format("{}", fmt::join(all, ", "));
}

Dimensions intersection(Dimensions const& a, Dimensions const& b) {
  Dimensions common;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::inserter(common, common.end()));
  return common;
}

/// Is it what a declaration can give: as Model documents its members?
bool is_well_formed(Model const& model) {
  Dimensions const all = dimensions_of(model);
  bool good = !all.empty() && *all.begin() >= 0 && *all.rbegin() == model.dimension && model.dimension <= max_dimension;
  good = good && std::equal(all.begin(), all.end(), model.dimensions.begin(), model.dimensions.end());
  Dimensions const oriented = oriented_of(model);
  good = good && std::includes(all.begin(), all.end(), oriented.begin(), oriented.end());
  std::set<std::pair<int, int>> const pairs(model.exchange.begin(), model.exchange.end());
  good = good && std::equal(pairs.begin(), pairs.end(), model.exchange.begin(), model.exchange.end());
  return good && std::all_of(pairs.begin(), pairs.end(), [&](auto pair) {
           return pair.first < pair.second && model.has(pair.first) && model.has(pair.second);
         });
}

// ---- Models of one name: one, or a family by its dimension n ----

using Family = std::vector<Model>;  // different ones

/// One list of dimensions that means a set in each model: the same in all, up to n, or some fixed and some counted from n.
std::optional<std::string> spell_sets(Family const& family, Dimensions (*set_of)(Model const&)) {
  Dimensions const first = set_of(family.front());
  auto const all = [&](auto holds) { return std::all_of(family.begin(), family.end(), holds); };
  if (all([&](Model const& m) { return set_of(m) == first; })) return spell_set(first);
  auto const up_to_n = [&](Model const& m) {
    Dimensions const set = set_of(m);
    return contiguous(set) && *set.begin() == *first.begin() && *set.rbegin() == m.dimension;
  };
  if (!first.empty() && all(up_to_n)) return fmt::format("{}..n", *first.begin());

  auto const below_n = [](Dimensions const& set, int n) {
    Dimensions result;
    for (int const d : set) result.insert(n - d);
    return result;
  };
  Dimensions fixed = first, counted = below_n(first, family.front().dimension);
  for (Model const& m : family) {
    fixed = intersection(fixed, set_of(m));
    counted = intersection(counted, below_n(set_of(m), m.dimension));
  }
  auto const both = [&](Model const& m) {
    Dimensions result = below_n(counted, m.dimension);
    result.insert(fixed.begin(), fixed.end());
    return result == set_of(m);
  };
  if (!all(both)) return {};
  std::vector<std::string> texts;
  for (int const d : fixed) texts.push_back(fmt::format("{}", d));
  for (int const d : counted) texts.push_back(d == 0 ? "n" : fmt::format("n-{}", d));
  return fmt::format("{}", fmt::join(texts, ", "));
}

std::string spell_exchange(Family const& family) {
  auto const all = [&](auto holds) { return std::all_of(family.begin(), family.end(), holds); };
  auto const is_distant = [](Model const& m) {
    return std::all_of(m.dimensions.begin(), m.dimensions.end(), [&](int i) {
      return std::all_of(m.dimensions.begin(), m.dimensions.end(), [&](int j) { return i > j || m.exchanges(i, j) == (i + 2 <= j); });
    });
  };
  if (all([](Model const& m) { return m.exchange.empty(); })) return {};
  if (all(is_distant)) return "exchange (i, j) where i + 2 <= j;";
  if (all([&](Model const& m) { return m.exchange == family.front().exchange; })) {
    std::vector<std::string> pairs;
    for (auto const& [i, j] : family.front().exchange) pairs.push_back(fmt::format("({},{})", i, j));
    return fmt::format("exchange {};", fmt::join(pairs, ", "));
  }
  std::vector<std::string> cases;
  for (Model const& m : family) {
    std::vector<std::string> pairs;
    for (auto const& [i, j] : m.exchange) pairs.push_back(fmt::format("i == {} and j == {}", i, j));
    if (!pairs.empty()) cases.push_back(fmt::format("n == {} and ({})", m.dimension, fmt::join(pairs, " or ")));
  }
  return fmt::format("exchange (i, j) where {};", fmt::join(cases, " or "));
}

std::optional<std::string> spell_declaration(Family const& family, bool takes_dimension) {
  auto const dimensions = spell_sets(family, dimensions_of);
  auto const oriented = spell_sets(family, oriented_of);
  if (!dimensions || !oriented) return {};
  std::set<int> closed, numbers;
  for (Model const& m : family) {
    closed.insert(m.closed);
    numbers.insert(m.dimension);
  }
  if (closed.size() > 1 || numbers.size() < family.size()) return {};
  std::string text = fmt::format("model {}{} {{\n  dimensions {};\n", family.front().name, takes_dimension ? "(n)" : "", *dimensions);
  if (!oriented->empty()) text += fmt::format("  oriented {};\n", *oriented);
  if (std::string const exchange = spell_exchange(family); !exchange.empty()) text += fmt::format("  {}\n", exchange);
  if (family.front().closed) text += "  closed;\n";
  return text + "}\n\n";
}

/// What is said of a model by its name.
struct Use {
  Family family;
  bool plain = false, with_dimension = false;  ///< how bare modelers name it
};

}  // namespace

bool is_bare(ir::Modeler const& modeler) { return modeler.module.empty(); }

Spelled<ModelDeclarations> declare_models(std::vector<std::shared_ptr<ir::Modeler const>> const& modelers) {
  std::map<std::string, Use> uses;
  for (auto const& modeler : modelers) {
    Model const& model = modeler->model;
    if (!is_well_formed(model)) return tl::unexpected(Unspellable{fmt::format("the model `{}` is not well-formed", model.name)});
    Use& use = uses[model.name];
    if (std::find(use.family.begin(), use.family.end(), model) == use.family.end()) use.family.push_back(model);
    if (!is_bare(*modeler)) continue;
    bool const plain = modeler->name == model.name;
    if (!modeler->embeddings.empty() || (!plain && modeler->name != fmt::format("{}({})", model.name, model.dimension))) {
      return tl::unexpected(Unspellable{fmt::format("the modeler `{}` is of no module, and no model", modeler->name)});
    }
    (plain ? use.plain : use.with_dimension) = true;
  }
  ModelDeclarations declarations;
  for (auto const& [name, use] : uses) {
    bool const builtin = std::all_of(use.family.begin(), use.family.end(),
                                     [](Model const& m) { return builtin_model(m.name, m.dimension) == m; });
    bool const takes_dimension = builtin || use.with_dimension || use.family.size() > 1;
    auto const text = builtin ? std::string() : spell_declaration(use.family, takes_dimension);
    if (!text || (takes_dimension && use.plain)) {
      return tl::unexpected(Unspellable{fmt::format("no declaration gives all the models `{}`", name)});
    }
    declarations[name] = {*text, takes_dimension};
  }
  return declarations;
}

std::string spell(Model const& model, ModelDeclarations const& declarations) {
  return declarations.at(model.name).takes_dimension ? fmt::format("{}({})", model.name, model.dimension) : model.name;
}

}  // namespace jrule::text
