// CGAL's Generalized_map, and Linear_cell_complex_for_generalized_map.
#include <CGAL/Generalized_map.h>
#include <CGAL/Linear_cell_complex_for_generalized_map.h>

#include "tests/bench/peers/cgal_maps.h"

namespace jrule::bench {

namespace {

struct Maps {
  using Bare = CGAL::Generalized_map<2>;
  using Traits = CGAL::Linear_cell_complex_traits<3, cgal::Kernel>;
  using Surface = CGAL::Linear_cell_complex_for_generalized_map<2, 3, Traits>;
  using Solid = CGAL::Linear_cell_complex_for_generalized_map<3, 3, Traits>;
  static constexpr int darts_per_edge = 4;

  template <class Map>
  static void add_corners(Map& map, bench::Surface const& s, std::vector<cgal::Handle<Map>>& corner) {
    std::vector<cgal::Handle<Map>> end;  // the other dart of each side
    for (std::size_t c = 0; c < s.corner_count(); ++c) {
      corner.push_back(map.create_dart());
      end.push_back(map.create_dart());
    }
    for (std::uint32_t c = 0; c < s.corner_count(); ++c) {
      map.template link_alpha<0>(corner[c], end[c]);
      map.template link_alpha<1>(end[c], corner[s.next[c]]);
      map.template link_alpha<2>(corner[c], end[s.opposite[c]]);
    }
  }
  /// The dart of the same corner of the face that looks the other way round.
  template <class Map>
  static auto turned(Map& map, cgal::Handle<Map> d) {
    return map.template alpha<1>(d);
  }
  /// `b` starts where `a` ends.
  template <class Map>
  static void sew_faces(Map& map, cgal::Handle<Map> a, cgal::Handle<Map> b) {
    map.template sew<3>(a, map.template alpha<0>(b));
  }
};

}  // namespace

void enter_cgal_gmap(Contest& contest) {
  cgal::enter_surfaces<Maps>(contest, "CGAL G-map");
  cgal::enter_blocks<Maps>(contest, "CGAL G-map");
}

}  // namespace jrule::bench
