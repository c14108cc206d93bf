// The rows of the table, with what each result must have and the bytes that must move for it.
#include <stdexcept>

#include "tests/bench/peers/contest.h"

namespace jrule::bench {

namespace {

using Cells = std::array<std::size_t, 4>;

char const* label(Work work) {
  switch (work) {
    case Work::quad: return "quads, topology";
    case Work::quad_positions: return "quads, positions";
    case Work::catmull_clark: return "Catmull-Clark";
    case Work::triangulate: return "triangulate faces";
    case Work::edge_vertices: return "vertex on edges";
    case Work::dual: return "dual";
    case Work::check: return "check";
    case Work::single_faces: return "10000 faces, positions";
    case Work::single_faces_topology: return "10000 faces, topology";
    case Work::build_block: return "build";
    case Work::sew_block: return "sew";
    case Work::check_block: return "check";
    case Work::triangulate_block: return "triangulate faces";
  }
  throw std::logic_error("no such work");
}

constexpr std::size_t arc = 4, handle = 4, position = 24;

/// Of a 2-G-map with that many darts and values: its arcs, handles and values, each once.
std::size_t size(std::size_t darts, std::size_t dimensions, std::optional<std::size_t> values) {
  return darts * dimensions * arc + (values ? darts * handle + *values * position : 0);
}

bool is_single(Work work) { return work == Work::single_faces || work == Work::single_faces_topology; }

Row row(Work work, std::shared_ptr<Surface const> const& surface) {
  std::size_t const v = surface->points.size(), c = surface->corner_count(), e = c / 2, f = surface->face_count();
  Row row{work,    label(work),  surface->name,
          surface, {v, e, f, 0}, 4 * e,
          0,       0, f >= 200000,  f < 200000 || is_single(work)};
  auto const input = [&](bool positions) { return size(4 * e, 3, positions ? std::optional(v) : std::nullopt); };
  switch (work) {
    case Work::quad:
    case Work::quad_positions:
    case Work::catmull_clark: row.cells = {v + e + f, 2 * e + c, c, 0}; break;
    case Work::triangulate: row.cells = {v + f, e + c, c, 0}; break;
    case Work::edge_vertices: row.cells = {v + e, 2 * e, f, 0}; break;
    case Work::dual: row.cells = {f, e, v, 0}; break;
    case Work::single_faces:
    case Work::single_faces_topology: {
      std::size_t corners = 0, faces = 0;
      for (std::uint32_t const s : sample_faces(*surface, single_face_count + 1)) {
        corners += surface->first[s + 1] - surface->first[s];
        ++faces;
      }
      row.cells = {v + faces, e + corners, f + corners - faces, 0};
      // Only what the operations touch: the darts of each face, and of its triangles.
      bool const positions = work == Work::single_faces;
      row.result_bytes = size(6 * corners, 3, positions ? std::optional(faces) : std::nullopt);
      row.bytes = size(2 * corners, 3, positions ? std::optional(corners) : std::nullopt) + row.result_bytes;
      break;
    }
    default: break;
  }
  row.darts_per_gmap = 4 * row.cells[1];
  if (work == Work::check) {
    row.bytes = input(true);
  } else if (work == Work::quad) {
    row.result_bytes = size(row.darts_per_gmap, 3, std::nullopt);
    row.bytes = input(false) + row.result_bytes;
  } else if (!is_single(work)) {
    row.result_bytes = size(row.darts_per_gmap, 3, row.cells[0]);
    row.bytes = input(true) + row.result_bytes;
  }
  return row;
}

Row block_row(Work work) {
  constexpr std::size_t n = block_side, hexahedra = n * n * n, faces = 3 * n * n * (n + 1);
  Row row{work, label(work), std::to_string(n) + "³ cubes", {}, {}, 48 * hexahedra, 0, 0, true, true};
  std::size_t const values =
      work == Work::build_block || work == Work::sew_block ? 8 * hexahedra : (n + 1) * (n + 1) * (n + 1);
  std::size_t const unrefined = size(row.darts_per_gmap, 4, values);
  row.cells = {(n + 1) * (n + 1) * (n + 1), 3 * n * (n + 1) * (n + 1), faces, hexahedra};
  row.bytes = unrefined;  // written by build, read by check
  if (work == Work::build_block) {
    row.cells = {8 * hexahedra, 12 * hexahedra, 6 * hexahedra, hexahedra};
    row.result_bytes = row.bytes;
  }
  // The 3-arcs and handles of the darts that are glued, read and written.
  if (work == Work::sew_block) row.bytes = 2 * (arc + handle) * 2 * 8 * 3 * n * n * (n - 1);
  if (work == Work::triangulate_block) {
    row.cells = {row.cells[0] + faces, row.cells[1] + 4 * faces, 4 * faces, hexahedra};
    row.darts_per_gmap *= 3;
    row.result_bytes = size(row.darts_per_gmap, 4, row.cells[0]);
    row.bytes = unrefined + row.result_bytes;
  }
  return row;
}

}  // namespace

std::vector<Row> rows() {
  auto const small = std::make_shared<Surface const>(torus(112));
  auto const large = std::make_shared<Surface const>(torus(1000));
  auto const bunny =
      std::make_shared<Surface const>(read_surface("bunny", JRULE_SOURCE_DIR "/examples/data/bunny.obj"));
  std::vector<Row> all;
  for (Work const work : {Work::quad, Work::quad_positions, Work::catmull_clark, Work::triangulate, Work::edge_vertices,
                          Work::dual, Work::check}) {
    for (auto const& surface : {bunny, small, large}) all.push_back(row(work, surface));
  }
  // What they cost must not depend on the size of the map, but for what its memory is behind.
  auto const middle = std::make_shared<Surface const>(torus(300));
  for (Work const work : {Work::single_faces, Work::single_faces_topology}) {
    for (auto const& surface : {small, middle, large}) all.push_back(row(work, surface));
  }
  for (Work const work : {Work::build_block, Work::sew_block, Work::check_block, Work::triangulate_block}) {
    all.push_back(block_row(work));
  }
  return all;
}

}  // namespace jrule::bench
