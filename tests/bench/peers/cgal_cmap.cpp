// CGAL's Combinatorial_map, and Linear_cell_complex_for_combinatorial_map.
#include <CGAL/Combinatorial_map.h>
#include <CGAL/Linear_cell_complex_for_combinatorial_map.h>

#include "tests/bench/peers/cgal_maps.h"

namespace jrule::bench {

namespace {

struct Maps {
  using Bare = CGAL::Combinatorial_map<2>;
  using Traits = CGAL::Linear_cell_complex_traits<3, cgal::Kernel>;
  using Surface = CGAL::Linear_cell_complex_for_combinatorial_map<2, 3, Traits>;
  using Solid = CGAL::Linear_cell_complex_for_combinatorial_map<3, 3, Traits>;
  static constexpr int darts_per_edge = 2;

  template <class Map>
  static void add_corners(Map& map, bench::Surface const& s, std::vector<cgal::Handle<Map>>& corner) {
    for (std::size_t c = 0; c < s.corner_count(); ++c) corner.push_back(map.create_dart());
    for (std::uint32_t c = 0; c < s.corner_count(); ++c) {
      map.template link_beta<1>(corner[c], corner[s.next[c]]);
      if (c < s.opposite[c]) map.template link_beta<2>(corner[c], corner[s.opposite[c]]);
    }
  }
  template <class Map>
  static auto turned(Map&, cgal::Handle<Map> d) {
    return d;
  }
  /// `b` starts where `a` ends.
  template <class Map>
  static void sew_faces(Map& map, cgal::Handle<Map> a, cgal::Handle<Map> b) {
    map.template sew<3>(a, b);
  }
};

}  // namespace

void enter_cgal_cmap(Contest& contest) {
  cgal::enter_surfaces<Maps>(contest, "CGAL C-map");
  cgal::enter_blocks<Maps>(contest, "CGAL C-map");
}

}  // namespace jrule::bench
