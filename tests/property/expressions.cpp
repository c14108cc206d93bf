#include "tests/property/expressions.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

#include "compiler/ir/evaluate.h"
#include "compiler/sema/application.h"
#include "compiler/sema/expressions.h"
#include "compiler/sema/externs.h"
#include "compiler/sema/overloads.h"
#include "tests/property/models.h"

namespace jrule::property {

using ir::Builtin;
using ir::ExprPtr;
using ir::ExprType;

namespace {

constexpr std::array all_types{Type::Bool, Type::Int, Type::Real, Type::Vec2, Type::Vec3, Type::Point2, Type::Point3, Type::Color};

template <class Node>
ExprPtr make(ExprType type, Node node) {
  return std::make_shared<ir::Expr const>(ir::Expr{type, std::move(node), {}});
}

// ---- Constants ----

double random_magnitude(Random& random) {
  switch (random.below(5)) {
    case 0: return static_cast<double>(random.below(4));
    case 1: return 0.1 * static_cast<double>(random.below(100));
    case 2: return random.pick<double>({1e22, 5e-324, 2.2250738585072014e-308, 1.7976931348623157e308, 123456789012345678.0, 1e16, 1e-5});
    default: break;
  }
  double const any = std::abs(std::bit_cast<double>(random.seed()));
  return std::isfinite(any) ? any : 0.0;
}

std::int64_t random_natural(Random& random) {
  if (random.chance(70)) return static_cast<std::int64_t>(random.below(5));
  return static_cast<std::int64_t>(random.seed() >> random.between(1, 40));
}

double random_real(Random& random) {
  if (random.chance(10)) return random.pick<double>({-0.0, std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
                                                     std::numeric_limits<double>::quiet_NaN()});
  return random.chance(50) ? random_magnitude(random) : -random_magnitude(random);
}

/// Any value: what a default may be, and an operation on constants.
Value random_value(Type type, Random& random) {
  switch (type) {
    case Type::Bool: return random.chance(50);
    case Type::Int:
      if (random.chance(10)) return std::numeric_limits<std::int64_t>::min();
      return random.chance(50) ? random_natural(random) : -random_natural(random);
    case Type::Real: return random_real(random);
    case Type::Vec2: return Vec2{random_real(random), random_real(random)};
    case Type::Vec3: return Vec3{random_real(random), random_real(random), random_real(random)};
    case Type::Point2: return Point2{random_real(random), random_real(random)};
    case Type::Point3: return Point3{random_real(random), random_real(random), random_real(random)};
    case Type::Color: return Color{random_real(random), random_real(random), random_real(random)};
    case Type::Extern: break;  // has none
  }
  return false;
}

// ---- C++ from outside ----

ir::ExternTypePtr const& soil() {
  static auto const type = std::make_shared<ir::ExternType const>(ir::ExternType{"Soil", "What the ground\nis made of.", "geo/soil.hpp", "geo::Soil", {}});
  return type;
}

std::vector<ir::ExternFunctionPtr> const& extern_functions() {
  static auto const all = [] {
    ExprType const soil_type{Type::Extern, false, false, soil()}, soils{Type::Extern, true, false, soil()};
    std::vector<ir::ExternFunctionPtr> functions;
    auto const add = [&](std::string name, std::vector<ExprType> const& parameters, ExprType result) {
      ir::ExternFunction function{name, name.size() > 4 ? "Says what it does." : "", {}, std::move(result), "geo/soil.hpp", "geo::" + name, {}};
      for (ExprType const& type : parameters) function.parameters.push_back({"p" + std::to_string(function.parameters.size()), type, {}});
      functions.push_back(std::make_shared<ir::ExternFunction const>(std::move(function)));
    };
    add("grass", {}, soil_type);
    add("mix", {soil_type, soil_type}, soil_type);
    add("wet", {soil_type, {Type::Real}}, soil_type);
    add("blend", {soils}, soil_type);
    add("hardness", {soil_type, {Type::Real}, {Type::Int}}, {Type::Real});
    add("hardest", {soils, {Type::Bool}}, {Type::Real});
    add("between", {{Type::Real}, {Type::Real}}, {Type::Real});
    add("deepest", {{Type::Point3, true}}, {Type::Point3});
    add("layers", {soil_type}, {Type::Int});
    add("is_soft", {soil_type}, {Type::Bool});
    add("soft", {{Type::Bool, true}}, {Type::Bool});
    return functions;
  }();
  return all;
}

ir::ExternFunctionPtr find_extern(std::string const& name) {
  auto const& all = extern_functions();
  return *std::find_if(all.begin(), all.end(), [&](auto const& function) { return function->name == name; });
}

ExprPtr call(std::string const& name, std::vector<ExprPtr> arguments) {
  ir::ExternFunctionPtr const function = find_extern(name);
  return make(function->result, ir::Call{function, std::move(arguments)});
}

/// A default that calls functions, of Soil or Real.
ExprPtr computed_default(Type type, Random& random) {
  ExprPtr ground = random.chance(50) ? call("grass", {}) : call("wet", {call("grass", {}), make({Type::Real}, ir::Constant{random_real(random)})});
  if (type == Type::Extern) return ground;
  ExprPtr const layers = call("layers", {ground});
  ExprPtr const x = make({Type::Real}, ir::Apply{Builtin::to_real, {layers}});
  return call("hardness", {std::move(ground), x, layers});
}

// ---- Expressions ----

ExprType element_of(ExprType type) {
  type.list = false;
  return type;
}
ExprType list_of(ExprType type) {
  type.list = true;
  return type;
}

struct Generator {
  ir::RuleScheme const& rule;
  algebra::Group const& group;
  Random& random;
  std::vector<std::string> variables{};  // of the comprehensions around, the outermost first

  ExprPtr expression(ExprType type, int depth) {
    if (type == ir::dart_type) return dart(depth);
    for (int attempt = 0; depth > 0 && attempt < 6; ++attempt) {
      ExprPtr const made = random.chance(15) ? conditional(type, depth) : application(type, depth);
      if (made && made->type == type) return made;
    }
    if (ExprPtr leaf = random_leaf(type, depth)) return leaf;
    return type.list ? nullptr : constant(type);
  }

  /// Of a type that sema would convert to this one.
  ExprPtr operand(ExprType type, int depth) {
    bool const integer = type == ExprType{Type::Real} && random.chance(30);
    return expression(integer ? ExprType{Type::Int} : type, depth);
  }

  ExprPtr constant(ExprType const& type) {
    return type.external ? call("grass", {}) : make(type, ir::Constant{random_value(type.element, random)});
  }

  ExprPtr random_leaf(ExprType type, int depth) {
    std::vector<ExprPtr> leaves;
    for (std::size_t i = 0; i < rule.parameters.size(); ++i) {
      if (rule.parameters[i].value_type() == type) leaves.push_back(make(type, ir::ParameterRef{i}));
    }
    append_lets(type, leaves);
    for (std::size_t e = 0; e < rule.modeler->embeddings.size(); ++e) {
      if (rule.modeler->value_type(e) != element_of(type)) continue;
      if (ExprPtr read = type.list ? collect(e, depth) : value_at(e, depth)) leaves.push_back(std::move(read));
    }
    if (!type.list && random.chance(40)) leaves.push_back(constant(type));
    return leaves.empty() ? nullptr : random.pick(leaves);
  }

  /// Not those of constants: what reads them is the constant.
  void append_lets(ExprType type, std::vector<ExprPtr>& leaves) {
    for (std::size_t i = 0; i < rule.lets.size(); ++i) {
      ir::Expr const& value = *rule.lets[i].value;
      if (value.type == type && !std::holds_alternative<ir::Constant>(value.value)) leaves.push_back(make(type, ir::LetRef{i}));
    }
  }

  // ---- Reading the map: null, if the left side has no node ----

  Word random_path() {
    Word word;
    for (std::size_t k = random.between(1, 3); k > 0; --k) {
      int const d = random.pick(rule.model().dimensions);
      word.push_back({static_cast<std::uint8_t>(d), rule.model().is_oriented(d) && random.chance(50)});
    }
    return group.normal_form(word);
  }

  OrbitType random_orbit() {
    OrbitType orbit;
    for (int const d : rule.model().dimensions) {
      if (random.chance(50)) orbit.words.push_back({{static_cast<std::uint8_t>(d), rule.model().is_oriented(d) && random.chance(20)}});
    }
    if (random.chance(20)) orbit.words.push_back(random_path());
    return orbit;
  }

  /// Orbits that lie inside.
  OrbitType random_part(OrbitType const& orbit) {
    OrbitType part;
    for (Word const& word : orbit.words) {
      if (random.chance(40)) part.words.push_back(word);
    }
    if (!orbit.words.empty() && random.chance(30)) {
      Word product = random.pick(orbit.words);
      Word const& other = random.pick(orbit.words);
      product.insert(product.end(), other.begin(), other.end());
      if (group.in_orbit(product, orbit)) part.words.push_back(std::move(product));
    }
    return part;
  }

  ExprPtr dart(int depth) {
    if (depth > 0 && random.chance(15)) {
      ExprPtr choice = conditional(ir::dart_type, depth);
      if (choice) return choice;
    }
    if (random.chance(40)) {
      ExprPtr from = dart(depth - 1);
      return from ? walk(std::move(from), random_path()) : nullptr;
    }
    if (!variables.empty() && random.chance(60)) {
      std::size_t const level = random.below(variables.size());
      return make(ir::dart_type, ir::Bound{level, variables[level]});
    }
    std::vector<ExprPtr> leaves;
    append_lets(ir::dart_type, leaves);
    for (ir::NodeId id = 0; id < rule.nodes.size(); ++id) {
      if (!rule.nodes[id].added()) leaves.push_back(make(ir::dart_type, ir::NodeDart{id}));
    }
    return leaves.empty() ? nullptr : random.pick(leaves);
  }

  ExprPtr walk(ExprPtr from, Word path) {
    if (auto const* before = std::get_if<ir::Walk>(&from->value)) {
      path = group.product(before->path, path);
      from = before->from;
    }
    return path.empty() ? from : make(ir::dart_type, ir::Walk{std::move(from), std::move(path)});
  }

  ExprPtr value_at(std::size_t embedding, int depth) {
    ExprPtr at = dart(depth - 1);
    return at ? make(rule.modeler->value_type(embedding), ir::ValueAt{embedding, std::move(at)}) : nullptr;
  }

  std::optional<ir::Darts> darts(int depth) {
    ExprPtr at = dart(depth - 1);
    if (!at) return {};
    OrbitType orbit = random_orbit();
    OrbitType by = random.chance(30) ? OrbitType() : random_part(orbit);
    return ir::Darts{std::move(at), std::move(orbit), std::move(by)};
  }

  ExprPtr collect(std::size_t embedding, int depth) {
    auto over = darts(depth);
    if (!over) return {};
    if (random.chance(50)) over->by = sema::common_orbit(group, over->orbit, rule.modeler->embeddings[embedding].orbit);
    return make(list_of(rule.modeler->value_type(embedding)), ir::Collect{embedding, std::move(*over)});
  }

  ExprPtr count(int depth) {
    auto over = darts(depth);
    return over ? make({Type::Int}, ir::Apply{Builtin::count, {make(ir::darts_type, std::move(*over))}}) : nullptr;
  }

  /// The list of a comprehension, which is to be aggregated: both are one step of the depth.
  ExprPtr for_each(ExprType const& type, int depth) {
    auto over = darts(depth);
    if (!over) return {};
    // Names of constants and functions are free, and so are those of comprehensions that are not around.
    ir::Bound variable{variables.size(), random.chance(90) ? "v" + std::to_string(variables.size()) : random.pick<std::string>({"pi", "mean", "x", "Point3", "grass"})};
    if (std::find(variables.begin(), variables.end(), variable.name) != variables.end()) return {};
    variables.push_back(variable.name);
    ExprPtr element = expression(element_of(type), depth - 1);
    variables.pop_back();
    return make(type, ir::ForEach{std::move(variable), std::move(*over), std::move(element)});
  }

  // ---- Operations, folded as sema does ----

  ExprPtr conditional(ExprType type, int depth) {
    ExprPtr const condition = expression({Type::Bool}, depth - 1);
    ExprPtr then_value = operand(type, depth - 1), else_value = operand(type, depth - 1);
    if (!condition || !then_value || !else_value) return {};
    if (then_value->type != else_value->type) {
      source::Diagnostics diagnostics;
      then_value = sema::convert(then_value, type, diagnostics);
      else_value = sema::convert(else_value, type, diagnostics);
    }
    ExprType const common = then_value->type;
    return ir::fold({common, ir::Conditional{condition, std::move(then_value), std::move(else_value)}, {}});
  }

  ExprPtr application(ExprType type, int depth) {
    source::Diagnostics diagnostics;
    if (type == ExprType{Type::Real} && random.chance(10)) return component(depth);
    if (type == ExprType{Type::Int} && random.chance(10)) return count(depth);
    // What is left of `if true then i else 0.0`.
    if (type == ExprType{Type::Real} && random.chance(5)) return sema::convert(expression({Type::Int}, depth - 1), type, diagnostics);
    if (random.chance(type.external ? 50 : 10)) return outside(type, depth);
    if (type.external) return first(type, depth);
    bool const nests = !variables.empty() && random.chance(40);  // a comprehension within one
    std::vector<std::pair<Builtin, sema::Signature const*>> fitting;
    for (std::size_t f = 0; f <= static_cast<std::size_t>(Builtin::any); ++f) {
      auto const function = static_cast<Builtin>(f);
      for (sema::Signature const& s : sema::signatures(function)) {
        if (s.result == type && (!nests || s.parameters[0].list)) fitting.emplace_back(function, &s);
      }
    }
    if (fitting.empty()) return {};
    auto const [function, signature] = random.pick(fitting);
    std::vector<ExprPtr> arguments;
    for (ExprType const& parameter : signature->parameters) {
      bool const comprehends = parameter.list && (nests || random.chance(60));
      arguments.push_back(comprehends ? for_each(parameter, depth) : operand(parameter, depth - 1));
      if (!arguments.back()) return {};
    }
    return sema::apply(function, {}, std::move(arguments), {}, diagnostics);
  }

  ExprPtr outside(ExprType const& type, int depth) {
    std::vector<ir::ExternFunctionPtr> fitting;
    for (ir::ExternFunctionPtr const& function : extern_functions()) {
      if (function->result == type) fitting.push_back(function);
    }
    if (fitting.empty()) return {};
    ir::ExternFunctionPtr const function = random.pick(fitting);
    std::vector<ExprPtr> arguments;
    for (auto const& parameter : function->parameters) {
      bool const comprehends = parameter.type.list && function->parameters.size() == 1 && random.chance(60);
      arguments.push_back(comprehends ? for_each(parameter.type, depth) : operand(parameter.type, depth - 1));
      if (!arguments.back()) return {};
    }
    source::Diagnostics diagnostics;
    return sema::call_extern(function, {}, std::move(arguments), {}, diagnostics);
  }

  /// The only aggregate of values from outside that is one of them.
  ExprPtr first(ExprType const& type, int depth) {
    if (type.list) return {};
    ExprPtr list = random.chance(60) ? for_each(list_of(type), depth) : expression(list_of(type), depth - 1);
    source::Diagnostics diagnostics;
    return list ? sema::apply(Builtin::first, {}, {std::move(list)}, {}, diagnostics) : nullptr;
  }

  ExprPtr component(int depth) {
    Type const of = random.pick<Type>({Type::Vec2, Type::Vec3, Type::Point2, Type::Point3, Type::Color});
    static constexpr std::array components{Builtin::component_0, Builtin::component_1, Builtin::component_2};
    auto const which = components[random.below(static_cast<std::size_t>(component_count(of)))];
    return ir::fold({{Type::Real}, ir::Apply{which, {expression({of}, depth - 1)}}, {}});
  }
};

std::string random_documentation(Random& random) {
  return random.pick<std::string>({"", "", "Says what it is.", "Two lines,\nthe second one.", "\n  indented,\n\nafter an empty line", "/ a slash, `code` and ⟨0,1⟩", "\n"});
}

}  // namespace

ExprPtr random_expression(ir::RuleScheme const& rule, algebra::Group const& group, ExprType type, int depth, Random& random) {
  return Generator{rule, group, random}.expression(type, depth);
}

std::shared_ptr<ir::Modeler const> of_all_types(Model const& model) {
  auto modeler = std::make_shared<ir::Modeler>(*embedded(model));
  modeler->name = "M";
  modeler->module = "test";
  Random random(model.dimensions.size());
  modeler->doc = random_documentation(random);
  for (std::size_t i = 0; i < modeler->embeddings.size(); ++i) {
    EmbeddingSpec& embedding = modeler->embeddings[i];
    embedding.type = all_types[(i + model.dimensions.size()) % all_types.size()];
    bool const number = embedding.type == Type::Int || embedding.type == Type::Real;
    bool const mixes = embedding.type != Type::Bool && embedding.type != Type::Int;
    std::vector<MergePolicy> policies{MergePolicy::none, MergePolicy::first};
    if (number) policies.insert(policies.end(), {MergePolicy::min, MergePolicy::max});
    if (mixes) policies.push_back(MergePolicy::mean);
    embedding.merge = random.pick(policies);
    embedding.default_value.reset();
    ir::EmbeddingExterns externs;
    if (embedding.type == Type::Real && random.chance(50)) {
      externs = {{}, computed_default(Type::Real, random), find_extern("between")};
      embedding.merge = MergePolicy::function;
    } else if (random.chance(60)) {
      embedding.default_value = random_value(embedding.type, random);
    }
    modeler->externs.push_back(std::move(externs));
    modeler->embedding_docs[i] = random_documentation(random);
  }
  for (std::string const name : {"ground", "cover"}) {
    EmbeddingSpec embedding{name, component_orbit(model), Type::Extern};
    embedding.extern_name = soil()->cpp_name;
    embedding.merge = random.pick<MergePolicy>({MergePolicy::none, MergePolicy::first, MergePolicy::function});
    ir::ExternFunctionPtr const merge = embedding.merge == MergePolicy::function ? find_extern(random.chance(50) ? "mix" : "blend") : nullptr;
    modeler->externs.push_back({soil(), random.chance(50) ? computed_default(Type::Extern, random) : nullptr, merge});
    modeler->embeddings.push_back(std::move(embedding));
    modeler->embedding_docs.push_back(random_documentation(random));
    modeler->embedding_spans.emplace_back();
  }
  return modeler;
}

ir::RuleScheme with_expressions(ir::RuleScheme rule, Random& random) {
  algebra::Group const group(rule.model());
  rule.doc = random_documentation(random);
  for (ir::Node& node : rule.nodes) node.doc = random_documentation(random);
  for (std::size_t i = random.below(4); i > 0; --i) {
    ir::Parameter parameter{.name = "p" + std::to_string(i), .default_value = {}};
    parameter.doc = random_documentation(random);
    if (random.chance(20)) {
      parameter.type = Type::Extern;
      parameter.external = soil();
      if (random.chance(50)) parameter.computed_default = computed_default(Type::Extern, random);
    } else {
      parameter.type = random.pick<Type>({all_types.begin(), all_types.end()});
      if (random.chance(50)) parameter.default_value = random_value(parameter.type, random);
    }
    rule.parameters.push_back(std::move(parameter));
  }
  auto const some = [&](ExprType type) { return random_expression(rule, group, type, static_cast<int>(random.below(5)), random); };
  for (std::size_t i = random.below(4); i > 0; --i) {
    ExprType type{random.pick<Type>({all_types.begin(), all_types.end()}), random.chance(20)};
    if (random.chance(10)) type = {Type::Extern, type.list, false, soil()};
    ExprPtr value = some(random.chance(20) ? ir::dart_type : type);
    if (value) rule.lets.push_back({"l" + std::to_string(i), std::move(value)});
  }
  for (std::size_t i = random.below(3); i > 0; --i) rule.requirements.push_back({some({Type::Bool}), "a condition"});
  for (ir::NodeId id = 0; id < rule.nodes.size(); ++id) {
    if (rule.nodes[id].deleted()) continue;
    for (std::size_t e = 0; e < rule.modeler->embeddings.size(); ++e) {
      if (!random.chance(5)) continue;
      ExprType const type = rule.modeler->value_type(e);
      source::Diagnostics diagnostics;
      ExprPtr value = some(random.chance(20) && type == ExprType{Type::Real} ? ExprType{Type::Int} : type);
      rule.clauses.push_back({id, e, sema::convert(std::move(value), type, diagnostics), {}});
    }
  }
  return rule;
}

}  // namespace jrule::property
