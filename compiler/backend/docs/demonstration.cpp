#include "compiler/backend/docs/demonstration.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>

#include "compiler/analysis/wording.h"
#include "compiler/backend/docs/shapes.h"
#include "compiler/backend/draw/draw.h"
#include "compiler/backend/interpreter/interpreter.h"
#include "compiler/backend/interpreter/operation.h"
#include "compiler/ir/extern_use.h"
#include "jrule/io.h"

namespace jrule::docs {

namespace {

constexpr int picture_width = 240;
// What is more than this is no small example, and a loop that goes on longer may not end.
constexpr std::size_t most_darts = 20'000, most_applications = 20'000;

/// Values that show something on the shapes, for parameters without a default. Points of what creates are the corners of a square, else
/// a place above the shape.
class Samples {
 public:
  explicit Samples(bool creates) : creates_(creates) {}

  Value next(Type type) {
    static constexpr Point3 corners[] = {{-0.5, 0, 0.5}, {0.5, 0, 0.5}, {0.5, 0, -0.5}, {-0.5, 0, -0.5}};
    static constexpr Point2 flat_corners[] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    switch (type) {
      case Type::Bool: return true;
      case Type::Int: return std::int64_t{2};
      case Type::Real: return 0.5;
      case Type::Vec2: return Vec2{0.5, 0.5};
      case Type::Vec3: return Vec3{0, 0.5, 0};
      case Type::Point2: return flat_corners[points_++ % 4];
      case Type::Color: return Color{0.95, 0.6, 0.3};
      default: break;
    }
    if (creates_) return corners[points_++ % 4];
    return Point3{0, 1.1 + 0.3 * static_cast<double>(points_++), 0};
  }

 private:
  bool creates_;
  std::size_t points_ = 0;
};

std::string call_text(std::string const& name, std::vector<std::string> const& arguments) {
  return arguments.empty() ? name : fmt::format("{}({})", name, fmt::join(arguments, ", "));
}

/// The shape as a map of the modeler. An embedding that has no default, which a shape would need, gets a sample.
Result<Map> make_map(Shape const& shape, ir::Modeler const& modeler) {
  Samples samples(false);
  std::vector<EmbeddingSpec> with_defaults = modeler.embeddings;
  for (EmbeddingSpec& e : with_defaults) {
    if (!e.default_value) e.default_value = samples.next(e.type);
  }
  auto const from = map_of_polygons(shape.points, shape.faces, modeler.model, with_defaults);
  if (!from) return from;
  Map map(modeler.model, modeler.embeddings);
  map.add_darts(from->dart_count());
  for (Dart const d : from->darts()) {
    for (int const dimension : modeler.model.dimensions) map.set_target(d, dimension, from->target(d, dimension));
  }
  for (std::size_t e = 0; e < map.embedding_count(); ++e) {
    for (Handle h = 0; h < from->embedding(e).value_count(); ++h) map.embedding(e).add(from->embedding(e).value(h));
    for (Dart const d : from->darts()) map.embedding(e).set_handle(d, from->embedding(e).handle(d));
  }
  return map;
}

/// The pictures of `before`, if it is not empty, and `after`; nothing if there are none or they are alike.
std::optional<Demonstration> pictured(Map const& before, Map const& after) {
  if (after.dart_count() == 0 || after.dart_count() > most_darts) return {};
  bool const creates = before.dart_count() == 0;
  auto svgs = draw::surface_svgs(creates ? std::vector{&after} : std::vector{&before, &after}, picture_width, true);
  if (!svgs || (!creates && (*svgs)[0] == (*svgs)[1])) return {};
  return Demonstration{"", "", creates ? "" : std::move(svgs->front()), std::move(svgs->back())};
}

/// Tries what takes `darts` darts on each shape, until there is something to see.
using Attempt = std::function<bool(Map& map, std::vector<Dart> const& darts)>;
std::optional<Demonstration> try_shapes(ir::Modeler const& modeler, std::size_t darts, Attempt const& attempt) {
  if (darts > 2) return {};
  for (Shape const& shape : shapes()) {
    if (shape.pair && darts != 2) continue;
    // What is around a surface is a face of an O-map, which would be drawn over it.
    if (shape.border && !modeler.model.has(0)) continue;
    auto const map = make_map(shape, modeler);
    if (!map) continue;
    std::vector<std::vector<Dart>> places;
    if (darts == 1) places.push_back({0});
    if (darts == 2) {
      // From the other end: what is beside the first one says less.
      for (Dart second = map->dart_limit(); second-- > 0 && (!shape.pair || places.empty());) places.push_back({0, second});
    }
    for (std::vector<Dart> const& place : places) {
      Map changed = *map;
      if (!attempt(changed, place)) continue;
      auto found = pictured(*map, changed);
      if (!found) break;
      found->place = shape.name;
      return found;
    }
  }
  return {};
}

}  // namespace

std::optional<Demonstration> demonstrate(ir::RuleScheme const& rule, analysis::Plan const& plan) {
  if (ir::find_extern_use(rule)) return {};
  Samples samples(rule.hooks.empty());
  std::vector<Value> values;
  std::vector<std::string> given;
  for (ir::Parameter const& p : rule.parameters) {
    values.push_back(p.default_value ? *p.default_value : samples.next(p.type));
    if (!p.default_value) given.push_back(fmt::format("{}: {}", p.name, to_string(values.back())));
  }
  rewrite::Workspace workspace;
  std::optional<Demonstration> found;
  if (rule.hooks.empty()) {
    Map const before(rule.model(), rule.modeler->embeddings);
    Map after = before;
    if (!interpreter::apply(rule, plan, after, {}, values, workspace)) return {};
    found = pictured(before, after);
    if (found) found->place = "from nothing";
  } else {
    found = try_shapes(*rule.modeler, rule.hooks.size(), [&](Map& map, std::vector<Dart> const& hooks) {
      return interpreter::apply(rule, plan, map, hooks, values, workspace).has_value();
    });
    OrbitType const type = rule.hook_orbit();
    std::string orbit = analysis::orbit_name(rule.model(), type);
    if (orbit.starts_with("orbit")) orbit = "dart";
    bool const whole = type.words.size() == rule.model().dimensions.size();
    if (found && rule.hooks.size() == 2) {
      found->place = fmt::format("at two darts of {}", found->place);
    } else if (found) {
      found->place = whole ? fmt::format("on {}", found->place)
                           : fmt::format("at {} {} of {}", std::string_view("aeiou").find(orbit[0]) == std::string_view::npos ? "a" : "an", orbit,
                                         found->place);
    }
  }
  if (found) found->call = call_text(rule.name, given);
  return found;
}

std::optional<Demonstration> demonstrate(ir::Program const& program, std::vector<analysis::Verdict> const& verdicts, std::size_t operation) {
  ir::Operation const& o = program.operations[operation];
  if (ir::find_extern_use(o, program)) return {};
  auto const darts = static_cast<std::size_t>(std::count_if(o.parameters.begin(), o.parameters.end(), [](auto const& p) { return p.dart; }));
  Samples samples(darts == 0);
  std::vector<ir::Evaluated> arguments;
  std::vector<std::string> given;
  for (ir::Parameter const& p : o.parameters) {
    if (p.dart) {
      arguments.emplace_back(Dart{0});
      continue;
    }
    Value const value = p.default_value ? *p.default_value : samples.next(p.type);
    arguments.emplace_back(value);
    if (!p.default_value) given.push_back(fmt::format("{}: {}", p.name, to_string(value)));
  }
  rewrite::Workspace workspace;
  auto const attempt = [&](Map& map, std::vector<Dart> const& places) {
    std::size_t next = 0;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
      if (o.parameters[i].dart) arguments[i] = places[next++];
    }
    auto const go_on = [&](std::size_t applications) { return applications < most_applications && map.dart_count() < most_darts; };
    // Rounds of a `while` without an application are asked about, too, with the same number.
    std::size_t asked = 0;
    auto const progress = [&](std::size_t applications) { return go_on(applications) && ++asked < 10 * most_applications; };
    return interpreter::run({program, verdicts}, operation, map, arguments, workspace, progress).has_value();
  };
  std::optional<Demonstration> found;
  if (darts == 0) {
    Map const before(o.model(), o.modeler->embeddings);
    Map after = before;
    if (!attempt(after, {})) return {};
    found = pictured(before, after);
    if (found) found->place = "from nothing";
  } else {
    found = try_shapes(*o.modeler, darts, attempt);
    if (found) found->place = "on " + found->place;
  }
  if (found) found->call = call_text(o.name, given);
  return found;
}

}  // namespace jrule::docs
