// Surfaces as SVG, by the painter's algorithm: the faces from the farthest to the nearest, each over those before.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <span>

#include "compiler/algebra/group.h"
#include "compiler/backend/draw/draw.h"
#include "compiler/backend/draw/style.h"

namespace jrule::draw {

namespace {

constexpr Color neutral{0.86, 0.85, 0.82};

tl::unexpected<Error> bad(std::string message) { return fail(Error::Kind::bad_input, std::move(message)); }

/// The axes of the picture: to the right, up, and out of it towards the eye. A plane map is seen from the front.
struct View {
  Vec3 right, up, eye;
};

View view_of(Type position) {
  Vec3 const eye = position == Type::Point2 ? Vec3{0, 0, 1} : normalize(Vec3{1, 0.8, 1.2});
  Vec3 const right = normalize(cross(Vec3{0, 1, 0}, eye));
  return {right, cross(eye, right), eye};
}

/// Do both types describe the same orbits? As sets of words, a word and its conjugate counting as one.
bool same_orbit(Model const& model, OrbitType a, OrbitType b) {
  for (OrbitType* type : {&a, &b}) {
    for (Word& word : type->words) word = std::min(word, algebra::conjugate(model, word));
    std::sort(type->words.begin(), type->words.end());
    type->words.erase(std::unique(type->words.begin(), type->words.end()), type->words.end());
  }
  return a == b;
}

/// The first embedding of that type on the cells of dimension i.
Embedding const* find_embedding(Map const& map, int i, Type type) {
  auto const cell = cell_orbit(map.model(), i);
  if (!cell) return nullptr;
  for (std::size_t e = 0; e < map.embedding_count(); ++e) {
    EmbeddingSpec const& spec = map.embedding(e).spec();
    if (spec.type == type && same_orbit(map.model(), spec.orbit, *cell)) return &map.embedding(e);
  }
  return nullptr;
}

Point3 to_point3(Value const& value) {
  if (auto const* flat = std::get_if<Point2>(&value)) return {flat->x, flat->y, 0};
  return std::get<Point3>(value);
}

bool finite(Point3 p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

/// From a corner of a face to the next one, both on the same side of the face; none if the model has no polygons.
std::optional<Word> next_corner(Model const& model) {
  if (!cell_orbit(model, 0) || !cell_orbit(model, 2)) return std::nullopt;
  auto const letter = [](int d) { return Letter{static_cast<std::uint8_t>(d), false}; };
  if (model.has(0)) {  // G-maps: along the edge, then to the next edge
    if (!model.has(1) || model.is_oriented(0) || model.is_oriented(1)) return std::nullopt;
    return Word{letter(0), letter(1)};
  }
  if (model.is_oriented(1)) return Word{letter(1)};  // O-maps
  return Word{letter(1), letter(2)};                 // their duals: to the edge's other end, then around that vertex
}

/// The corners of all faces, face after face, each beginning at its smallest dart.
struct Polygons {
  std::vector<Dart> corners;
  std::vector<std::size_t> ends;
};

Result<Polygons> find_polygons(Map const& map) {
  Model const& model = map.model();
  auto const step = next_corner(model);
  if (!step) return bad(fmt::format("a map of {}({}) has no polygons to draw", model.name, model.dimension));
  if (map.dart_count() == 0) return bad("an empty map has no picture");
  Polygons polygons;
  for (Dart const first : number_orbits(map, *cell_orbit(model, 2)).first) {
    Dart corner = first;
    do {
      polygons.corners.push_back(corner);
      for (Letter letter : *step) {
        Dart const to = map.step(corner, letter);
        if (to == corner && model.has(0)) {
          return bad(fmt::format("the face of dart {} is open: the {}-arc of dart {} is a loop", first,
                                 letter.dimension, corner));
        }
        corner = to;
      }
    } while (corner != first);
    polygons.ends.push_back(polygons.corners.size());
  }
  return polygons;
}

/// The position of each corner.
Result<std::vector<Point3>> corner_positions(Embedding const& positions, std::vector<Dart> const& corners) {
  std::vector<Point3> points;
  points.reserve(corners.size());
  for (Dart d : corners) {
    Handle const handle = positions.handle(d);
    if (handle == no_handle) return bad(fmt::format("dart {} has no `{}`", d, positions.spec().name));
    points.push_back(to_point3(positions.value(handle)));
    if (!finite(points.back())) return bad(fmt::format("the `{}` of dart {} is not finite", positions.spec().name, d));
  }
  return points;
}

/// Moves all points to the middle and scales them so that every coordinate is in -1..1: nothing that is computed from them
/// overflows.
void normalize_points(std::vector<Point3>& points) {
  Point3 low = points.front(), high = low;
  for (Point3 p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  Point3 const middle = midpoint(low, high);
  Vec3 const half = high - middle;
  double const size = std::max({half.x, half.y, half.z});
  for (Point3& p : points) {
    Vec3 const v = size > 0 ? (p - middle) / size : Vec3{};
    p = {v.x, v.y, v.z};
  }
}

/// A corner in pixels.
struct Pixel {
  double x = 0, y = 0;
};

struct Picture {
  int width = 1, height = 1;
  std::vector<Pixel> corners;
};

/// Fits the points into a square of `width` pixels with a small margin, and crops it to them.
Picture project(std::vector<Point3> const& points, View const& view, int width) {
  double constexpr infinity = std::numeric_limits<double>::infinity();
  Pixel low{infinity, infinity}, high{-infinity, -infinity};
  Picture picture;
  picture.corners.reserve(points.size());
  for (Point3 p : points) {
    Vec3 const v{p.x, p.y, p.z};
    Pixel const q{dot(v, view.right), -dot(v, view.up)};
    low = {std::min(low.x, q.x), std::min(low.y, q.y)};
    high = {std::max(high.x, q.x), std::max(high.y, q.y)};
    picture.corners.push_back(q);
  }
  double const margin = 0.04 * width;
  double const extent = std::max(high.x - low.x, high.y - low.y);
  double const scale = extent > 0 ? (width - 2 * margin) / extent : 0;
  auto const pixels = [&](double from, double to) {
    return static_cast<int>(std::clamp(std::ceil((to - from) * scale + 2 * margin), 1.0, static_cast<double>(width)));
  };
  picture.width = pixels(low.x, high.x);
  picture.height = pixels(low.y, high.y);
  for (Pixel& q : picture.corners) {
    q.x = picture.width / 2.0 + (q.x - (low.x + high.x) / 2) * scale;
    q.y = picture.height / 2.0 + (q.y - (low.y + high.y) / 2) * scale;
  }
  return picture;
}

/// The colour of a lit face: both sides alike, a warm sun from the upper left that still grazes what it does not face,
/// a cool sky above.
Color shade(Color base, Vec3 area, View const& view) {
  Vec3 normal = normalize(area);
  if (dot(normal, view.eye) < 0) normal = -normal;
  Vec3 const sun_from = normalize(view.right * -0.5 + view.up * 0.7 + view.eye * 0.75);
  double const lambert = std::max(0.0, dot(normal, sun_from));
  double const sun = 0.75 * lambert + 0.25 * (0.5 + 0.5 * dot(normal, sun_from));
  double const sky = 0.5 + 0.5 * dot(normal, view.up);
  Color const ambient = lerp(Color{0.40, 0.40, 0.45}, Color{0.48, 0.51, 0.56}, sky);
  Color const light = ambient + Color{0.63, 0.60, 0.54} * sun;
  return {base.r * light.r, base.g * light.g, base.b * light.b};
}

/// 0..1 as 0..255; what is outside is held, NaN is 0.
int byte(double component) {
  return component > 0 ? static_cast<int>(std::lround(255 * std::min(component, 1.0))) : 0;
}

/// What is drawn of a map.
struct Scene {
  Map const& map;
  Polygons polygons;
  Embedding const* positions;
  Embedding const* colors;  ///< null if there are none
};

Result<Scene> scene_of(Map const& map) {
  auto polygons = find_polygons(map);
  if (!polygons) return tl::make_unexpected(polygons.error());
  Embedding const* positions = find_embedding(map, 0, Type::Point3);
  if (positions == nullptr) positions = find_embedding(map, 0, Type::Point2);
  if (positions == nullptr) return bad("the map has no embedding of type Point3 or Point2 on vertices");
  return Scene{map, std::move(*polygons), positions, find_embedding(map, 2, Type::Color)};
}

/// `points` and `corners` are those of the scene's corners.
std::string draw(Scene const& scene, std::span<Point3 const> points, std::span<Pixel const> corners, View const& view, int width, int height,
                 bool with_vertices) {
  Polygons const& polygons = scene.polygons;
  std::size_t const count = polygons.ends.size();
  struct Face {
    double depth;  // towards the eye
    std::size_t begin, end;
  };
  std::vector<Face> faces;
  faces.reserve(count);
  for (std::size_t end : polygons.ends) {
    std::size_t const begin = faces.empty() ? 0 : faces.back().end;
    Vec3 sum;
    for (std::size_t c = begin; c < end; ++c) sum = sum + (points[c] - Point3{});
    faces.push_back({dot(sum, view.eye) / static_cast<double>(end - begin), begin, end});
  }
  // Stable: faces of one depth keep the order of the map.
  std::stable_sort(faces.begin(), faces.end(), [](Face const& a, Face const& b) { return a.depth < b.depth; });

  // An edge of a coarse surface is over a pixel wide; the edges of a fine one stay thin beside its faces.
  double const face_size = std::sqrt(2.0 * width * height / static_cast<double>(count));
  double const stroke = std::clamp(0.03 * face_size, 0.1, 1.4);
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\">\n"
      "<title>{2}({3}), {4} {5}</title>\n"
      "<rect width=\"{0}\" height=\"{1}\" fill=\"#ffffff\"/>\n"
      "<g stroke=\"#1f2a38\" stroke-opacity=\"0.6\" stroke-width=\"{6:.2f}\" stroke-linejoin=\"round\">\n",
      width, height, escape(scene.map.model().name), scene.map.model().dimension, count, count == 1 ? "face" : "faces", stroke);
  for (Face const& face : faces) {
    Handle const color = scene.colors != nullptr ? scene.colors->handle(polygons.corners[face.begin]) : no_handle;
    Color const base = color != no_handle ? scene.colors->values<Color>()[color] : neutral;
    Vec3 const area = area_vector(points.subspan(face.begin, face.end - face.begin));
    Color const fill = shade(base, area, view);
    svg += "<polygon points=\"";
    for (std::size_t c = face.begin; c < face.end; ++c) {
      fmt::format_to(std::back_inserter(svg), "{}{:.2f},{:.2f}", c == face.begin ? "" : " ", corners[c].x, corners[c].y);
    }
    fmt::format_to(std::back_inserter(svg), "\" fill=\"#{:02x}{:02x}{:02x}\"/>\n", byte(fill.r), byte(fill.g), byte(fill.b));
    for (std::size_t c = face.begin; with_vertices && c < face.end; ++c) {
      fmt::format_to(std::back_inserter(svg), "<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"1.6\" fill=\"#1f2a38\"/>\n", corners[c].x, corners[c].y);
    }
  }
  return svg + "</g>\n</svg>\n";
}

}  // namespace

Result<std::vector<std::string>> surface_svgs(std::vector<Map const*> const& maps, int width, bool with_vertices) {
  if (width < 1) return bad("a picture is at least one pixel wide");
  std::vector<Scene> scenes;
  std::vector<Point3> points;  // of all scenes, one after another
  std::vector<std::size_t> begins;
  for (Map const* const map : maps) {
    auto scene = scene_of(*map);
    if (!scene) return tl::make_unexpected(scene.error());
    auto const more = corner_positions(*scene->positions, scene->polygons.corners);
    if (!more) return tl::make_unexpected(more.error());
    begins.push_back(points.size());
    points.insert(points.end(), more->begin(), more->end());
    scenes.push_back(std::move(*scene));
  }
  if (scenes.empty()) return std::vector<std::string>{};
  normalize_points(points);
  View const view = view_of(scenes.front().positions->spec().type);
  Picture const picture = project(points, view, width);
  std::vector<std::string> svgs;
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    std::size_t const count = scenes[i].polygons.corners.size();
    svgs.push_back(draw(scenes[i], std::span(points).subspan(begins[i], count), std::span(picture.corners).subspan(begins[i], count), view,
                        picture.width, picture.height, with_vertices));
  }
  return svgs;
}

Result<std::string> surface_svg(Map const& map, int width) {
  auto svgs = surface_svgs({&map}, width, false);
  if (!svgs) return tl::make_unexpected(svgs.error());
  return std::move(svgs->front());
}

}  // namespace jrule::draw
