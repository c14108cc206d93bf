// What is measured and by whom: rows (a work on a mesh) and contenders, each at the rows that it can do.
//
// A repetition makes a fresh input, runs the work on it, and counts what came out. Only the run is timed: no contender
// pays for its copy of the input, and each pays for the memory that it asks for.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tests/bench/peers/meshes.h"

namespace jrule::bench {

enum class Work {
  quad,
  quad_positions,
  catmull_clark,
  triangulate,
  edge_vertices,
  dual,
  check,
  single_faces,
  single_faces_topology,
  build_block,
  sew_block,
  check_block,
  triangulate_block
};

/// The rows that a contender takes part in: not the large ones, if it would take too long.
enum class Size { any, small };

/// How many faces Work::single_faces and single_faces_topology triangulate, one after the other, and one before, so that all is warm.
inline constexpr std::size_t single_face_count = 10000;
/// The block has so many hexahedra along each side.
inline constexpr std::size_t block_side = 40;

/// What a result has. `darts` are what the contender calls so, see Entry; cells are counted if the row wants them.
struct Counts {
  std::size_t darts = 0;
  std::optional<std::array<std::size_t, 4>> cells{};  ///< of dimension 0..3; no volumes of a surface
};

/// One row of the table.
struct Row {
  Work work;
  std::string label;                       ///< "quads, positions"
  std::string mesh;                        ///< "torus 1000²"
  std::shared_ptr<Surface const> surface;  ///< none of a block
  std::array<std::size_t, 4> cells;        ///< that the result must have
  std::size_t darts_per_gmap = 0;          ///< that the result must have as a G-map
  std::size_t bytes = 0;                   ///< that must move: see rows.cpp
  std::size_t result_bytes = 0;            ///< of these, those of the result
  bool large = false;
  bool count_cells = true;  ///< of a large result only where no smaller one shows that the work is done right
};

/// What one repetition came to.
struct Sample {
  double seconds = 0;
  std::size_t heap_bytes = 0;  ///< that the input and the result hold
  Counts counts;
};

/// One cell of the table.
struct Entry {
  std::string contender;
  std::size_t row;
  int darts_per_edge;  ///< 4 for G-maps, 2 for halfedges
  std::function<Sample(bool count)> repeat;
  std::vector<double> seconds{};  ///< of each repetition so far
  double bytes_per_dart = 0;
  std::string fault{};  ///< what is wrong with the result
};

/// "dual/bunny/OpenMesh", as Google Benchmark knows it.
std::string benchmark_name(Entry const& entry, Row const& row);
/// Precondition: not empty.
double median(std::vector<double> seconds);
std::size_t heap_bytes();

class Contest {
 public:
  explicit Contest(std::vector<Row> rows) : rows_(std::move(rows)) {}

  std::vector<Row> const& rows() const { return rows_; }
  std::vector<std::string> const& contenders() const { return contenders_; }
  std::vector<std::unique_ptr<Entry>> const& entries() const { return entries_; }
  /// Null if that contender does not take part in that row.
  Entry const* find(std::size_t row, std::string const& contender) const;

  /// Of each row of that work: `prepare(row)` makes an input, `run(input)` is timed and returns the result (a reference
  /// to the input if the work is done in place), and `count(result, row)` counts.
  template <class Prepare, class Run, class Count>
  void enter(std::string const& contender, int darts_per_edge, Work work, Prepare prepare, Run run, Count count,
             Size size = Size::any) {
    for (std::size_t r = 0; r < rows_.size(); ++r) {
      if (rows_[r].work != work || (rows_[r].large && size == Size::small)) continue;
      add(contender, darts_per_edge, r, [=, &row = rows_[r]](bool counted) {
        Sample sample;
        {
          auto input = prepare(row);
          auto const start = std::chrono::steady_clock::now();
          decltype(auto) result = run(input);
          std::chrono::duration<double> const time = std::chrono::steady_clock::now() - start;
          sample.seconds = time.count();
          if (counted) {
            sample.heap_bytes = heap_bytes();
            sample.counts = count(result, row);
          }
        }
        // What is given back when the result goes: the input that others are copied from stays.
        if (counted) sample.heap_bytes -= heap_bytes();
        return sample;
      });
    }
  }

  /// Makes them known to Google Benchmark, row by row.
  void register_benchmarks();

 private:
  void add(std::string const& contender, int darts_per_edge, std::size_t row, std::function<Sample(bool)> repeat);

  std::vector<Row> rows_;
  std::vector<std::string> contenders_;
  std::vector<std::unique_ptr<Entry>> entries_;  // by row, then contender; their places are given to Google Benchmark
};

/// The contenders. Those of CGAL, OpenMesh and OpenSubdiv are there where the library is installed.
void enter_generated(Contest& contest);
void enter_generated_solid(Contest& contest);
void enter_interpreter(Contest& contest);
void enter_cgal_gmap(Contest& contest);
void enter_cgal_cmap(Contest& contest);
void enter_cgal_surface_mesh(Contest& contest);
void enter_openmesh(Contest& contest);
void enter_opensubdiv(Contest& contest);
/// The roofline: as many bytes as the row must move, copied; where the row is large, the result into pages never touched before.
void enter_copy(Contest& contest);
/// The column of that name is the one that others are compared with.
inline constexpr char const* ours = "G-map";
inline constexpr char const* roofline = "roofline";

/// The rows of the table.
std::vector<Row> rows();

}  // namespace jrule::bench
