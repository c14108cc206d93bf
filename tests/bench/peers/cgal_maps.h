// CGAL's Combinatorial_map and Generalized_map, which have one interface but for where darts start: the same code for
// both. `Maps` names the classes: Bare, of dimension 2 without values, and Surface and Solid, linear cell complexes.
#pragma once

#include <CGAL/Simple_cartesian.h>

#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

#include "tests/bench/peers/block.h"
#include "tests/bench/peers/contest.h"

namespace jrule::bench::cgal {

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;

template <class Map>
constexpr bool has_points = requires {
  typename Map::Vertex_attribute_handle;
};

template <class Map>
using Handle = typename Map::Dart_handle;

/// A map, and the dart that starts at each corner of the surface it was made from.
template <class Map>
struct Input {
  std::unique_ptr<Map> map = std::make_unique<Map>();
  std::vector<Handle<Map>> corner{};
  std::vector<Handle<Map>> face{};  ///< one dart of each face
  std::vector<Handle<Map>> edge{};  ///< one dart of each edge
  std::vector<Handle<Map>> vertex{};
};

template <class Maps, class Map>
Input<Map> make(Surface const& s) {
  Input<Map> input;
  Map& map = *input.map;
  Maps::add_corners(map, s, input.corner);
  input.vertex.resize(s.points.size());
  for (std::uint32_t c = 0; c < s.corner_count(); ++c) {
    if (c < s.opposite[c]) input.edge.push_back(input.corner[c]);
    input.vertex[s.vertex[c]] = input.corner[c];
  }
  for (std::size_t f = 0; f < s.face_count(); ++f) input.face.push_back(input.corner[s.first[f]]);
  if constexpr (has_points<Map>) {
    for (std::size_t v = 0; v < s.points.size(); ++v) {
      Point3 const p = s.points[v];
      map.set_vertex_attribute(input.vertex[v], map.create_vertex_attribute(Point(p.x, p.y, p.z)));
    }
  }
  return input;
}

template <class Maps, class Map>
Counts count(Map const& map, Row const& row) {
  Counts counts{map.number_of_darts()};
  if (!row.count_cells) return counts;
  std::vector<unsigned> dimensions;
  for (unsigned i = 0; i <= Map::dimension; ++i) dimensions.push_back(i);
  auto const cells = map.count_cells(dimensions);
  counts.cells.emplace();
  for (unsigned i = 0; i <= Map::dimension; ++i) (*counts.cells)[i] = cells[i];
  return counts;
}

/// Splits the n-gon of a dart, whose every second vertex is the middle of an edge, into n / 2 quads: an edge from the
/// first middle to the second, its middle becomes the centre, and from there an edge to each further middle. The dart
/// starts at a corner.
template <class Maps, class Map, class InsertCentre>
void cut_into_quads(Map& map, Handle<Map> corner, std::vector<Handle<Map>>& middles, InsertCentre insert_centre) {
  middles.clear();
  Handle<Map> at = corner;
  do {
    at = map.next(at);
    middles.push_back(at);
    at = map.next(at);
  } while (at != corner);
  map.insert_cell_1_in_cell_2(middles[0], Maps::turned(map, middles[1]));
  insert_centre(map.previous(middles[1]));
  for (std::size_t k = 2; k < middles.size(); ++k) {
    map.insert_cell_1_in_cell_2(map.previous(middles[k - 1]), Maps::turned(map, middles[k]));
  }
}

template <class Maps, class Map>
void subdivide(Input<Map>& input) {
  Map& map = *input.map;
  std::vector<Handle<Map>> middles;
  if constexpr (has_points<Map>) {
    std::vector<Point> centres;
    for (auto const f : input.face) centres.push_back(map.template barycenter<2>(f));
    for (auto const e : input.edge) map.template insert_barycenter_in_cell<1>(e);
    for (std::size_t f = 0; f < input.face.size(); ++f) {
      cut_into_quads<Maps>(map, input.face[f], middles, [&](auto d) { map.insert_point_in_cell_1(d, centres[f]); });
    }
  } else {
    for (auto const e : input.edge) map.insert_cell_0_in_cell_1(e);
    for (auto const f : input.face)
      cut_into_quads<Maps>(map, f, middles, [&](auto d) { map.insert_cell_0_in_cell_1(d); });
  }
}

template <class Maps, class Map>
void catmull_clark(Input<Map>& input) {
  Map& map = *input.map;
  auto const to_origin = [](Point const& p) { return p - CGAL::ORIGIN; };
  auto const centre = [&](auto d) { return to_origin(map.template barycenter<2>(d)); };
  auto const middle = [&](auto d) { return to_origin(map.template barycenter<1>(d)); };
  std::vector<Point> centres, middles, vertices;
  for (auto const f : input.face) centres.push_back(map.template barycenter<2>(f));
  for (auto const e : input.edge) {
    middles.push_back(CGAL::ORIGIN + (middle(e) / 2 + (centre(e) + centre(map.opposite2(e))) / 4));
  }
  for (auto const v : input.vertex) {
    Vector faces(0, 0, 0), edges(0, 0, 0);
    double n = 0;
    auto d = v;
    do {
      faces = faces + centre(d);
      edges = edges + middle(d);
      ++n;
      d = map.opposite2(map.previous(d));
    } while (d != v);
    vertices.push_back(CGAL::ORIGIN + (faces / n + 2 * edges / n + (n - 3) * to_origin(map.point(v))) / n);
  }
  for (std::size_t v = 0; v < vertices.size(); ++v) map.point(input.vertex[v]) = vertices[v];
  for (std::size_t e = 0; e < middles.size(); ++e) map.insert_point_in_cell_1(input.edge[e], middles[e]);
  std::vector<Handle<Map>> around;
  for (std::size_t f = 0; f < centres.size(); ++f) {
    cut_into_quads<Maps>(map, input.face[f], around, [&](auto d) { map.insert_point_in_cell_1(d, centres[f]); });
  }
}

template <class Maps>
void enter_surfaces(Contest& contest, std::string const& name) {
  using Bare = typename Maps::Bare;
  using Map = typename Maps::Surface;
  auto const prepare_bare = [](Row const& row) { return make<Maps, Bare>(*row.surface); };
  auto const prepare = [](Row const& row) { return make<Maps, Map>(*row.surface); };
  auto const counted = [](auto& input, Row const& row) { return count<Maps>(*input.map, row); };
  auto const enter = [&](Work work, auto make_input, auto run) {
    contest.enter(
        name, Maps::darts_per_edge, work, make_input, [run](auto& input) -> auto& { return run(input), input; },
        counted);
  };
  enter(Work::quad, prepare_bare, [](Input<Bare>& in) { subdivide<Maps>(in); });
  enter(Work::quad_positions, prepare, [](Input<Map>& in) { subdivide<Maps>(in); });
  enter(Work::catmull_clark, prepare, [](Input<Map>& in) { catmull_clark<Maps>(in); });
  enter(Work::triangulate, prepare, [](Input<Map>& in) {
    for (auto const f : in.face) in.map->template insert_barycenter_in_cell<2>(f);
  });
  enter(Work::edge_vertices, prepare, [](Input<Map>& in) {
    for (auto const e : in.edge) in.map->template insert_barycenter_in_cell<1>(e);
  });
  enter(Work::check, prepare, [](Input<Map>& in) {
    if (!in.map->is_valid()) throw std::runtime_error("CGAL finds the map not valid");
  });
  contest.enter(
      name, Maps::darts_per_edge, Work::dual, prepare,
      [](Input<Map>& in) {
        Input<Map> dual;
        in.map->dual_points_at_barycenter(*dual.map);
        return dual;
      },
      counted);
  auto const enter_single_faces = [&]<class Any>(Work work, Input<Any> const*, auto triangulate) {
    enter(
        work,
        [triangulate](Row const& row) {
          Input<Any> in = make<Maps, Any>(*row.surface);
          std::vector<Handle<Any>> sampled;
          for (std::uint32_t const f : sample_faces(*row.surface, single_face_count + 1)) sampled.push_back(in.face[f]);
          triangulate(*in.map, sampled.back());
          sampled.pop_back();
          in.face = std::move(sampled);
          return in;
        },
        [triangulate](Input<Any>& in) {
          for (auto const f : in.face) triangulate(*in.map, f);
        });
  };
  enter_single_faces(Work::single_faces, static_cast<Input<Map>*>(nullptr),
                     [](Map& map, Handle<Map> f) { map.template insert_barycenter_in_cell<2>(f); });
  enter_single_faces(Work::single_faces_topology, static_cast<Input<Bare>*>(nullptr),
                     [](Bare& map, Handle<Bare> f) { map.insert_cell_0_in_cell_2(f); });
}

/// A block of cubes; a dart of each.
template <class Map>
struct Block {
  std::unique_ptr<Map> map = std::make_unique<Map>();
  std::vector<Handle<Map>> cube{};
};

template <class Map>
Block<Map> build_block() {
  Block<Map> block;
  for_each_cube([&](double x, double y, double z) {
    auto const p = [&](int i, int j, int k) { return Point(x + i, y + j, z + k); };
    block.cube.push_back(block.map->make_hexahedron(p(0, 0, 0), p(1, 0, 0), p(1, 1, 0), p(0, 1, 0), p(0, 1, 1),
                                                    p(0, 0, 1), p(1, 0, 1), p(1, 1, 1)));
  });
  return block;
}

/// The way from the dart of a cube to one of another face, the same in every cube: n is next, o is opposite2.
template <class Map>
Handle<Map> walk(Map& map, Handle<Map> d, std::string const& path) {
  for (char const step : path) d = step == 'n' ? map.next(d) : map.opposite2(d);
  return d;
}

/// A way to a dart of the first cube for which the condition holds; each of them is at most so long.
template <class Map, class Condition>
std::string find_way(Map& map, Handle<Map> d, Condition condition) {
  std::vector<std::string> ways{""};
  for (std::size_t k = 0; k < ways.size() && k < 4096; ++k) {
    if (condition(walk(map, d, ways[k]))) return ways[k];
    ways.push_back(ways[k] + 'n');
    ways.push_back(ways[k] + 'o');
  }
  throw std::runtime_error("a cube lacks a dart");
}

template <class Maps, class Map>
void sew_block(Block<Map>& block) {
  Map& map = *block.map;
  auto const lies_at = [&](auto d, int axis, double height) {
    for (int k = 0; k < 4; ++k, d = map.next(d)) {
      if (map.point(d)[axis] != height) return false;
    }
    return true;
  };
  std::array<std::string, 3> far, near;
  for (int axis = 0; axis < 3; ++axis) {
    auto const a = static_cast<std::size_t>(axis);
    far[a] = find_way(map, block.cube[0], [&](auto d) { return lies_at(d, axis, 1); });
    auto const end = walk(map, block.cube[0], far[a]);
    Vector const along(axis == 0, axis == 1, axis == 2);
    near[a] = find_way(map, block.cube[0], [&](auto d) {
      return lies_at(d, axis, 0) && map.point(d) + along == map.point(map.next(end)) &&
             map.point(map.next(d)) + along == map.point(end);
    });
  }
  for_each_contact([&](std::size_t cube, std::size_t neighbour, std::size_t axis) {
    Maps::sew_faces(map, walk(map, block.cube[cube], far[axis]), walk(map, block.cube[neighbour], near[axis]));
  });
}

template <class Map>
void triangulate_faces(Block<Map>& block) {
  std::vector<Handle<Map>> faces;
  auto range = block.map->template one_dart_per_cell<2>();
  for (auto it = range.begin(); it != range.end(); ++it) faces.push_back(it);
  for (auto const f : faces) block.map->template insert_barycenter_in_cell<2>(f);
}

template <class Maps>
void enter_blocks(Contest& contest, std::string const& name) {
  using Map = typename Maps::Solid;
  auto const counted = [](auto& block, Row const& row) { return count<Maps>(*block.map, row); };
  auto const built = [](Row const&) { return build_block<Map>(); };
  auto const sewn = [](Row const&) {
    Block<Map> block = build_block<Map>();
    sew_block<Maps>(block);
    return block;
  };
  auto const enter = [&](Work work, auto prepare, auto run) {
    contest.enter(
        name, Maps::darts_per_edge, work, prepare, [run](auto& block) -> auto& { return run(block), block; }, counted);
  };
  contest.enter(
      name, Maps::darts_per_edge, Work::build_block, [](Row const&) { return 0; },
      [](int) { return build_block<Map>(); }, counted);
  enter(Work::sew_block, built, [](Block<Map>& b) { sew_block<Maps>(b); });
  enter(Work::check_block, sewn, [](Block<Map>& b) {
    if (!b.map->is_valid()) throw std::runtime_error("CGAL finds the map not valid");
  });
  enter(Work::triangulate_block, sewn, [](Block<Map>& b) { triangulate_faces(b); });
}

}  // namespace jrule::bench::cgal
