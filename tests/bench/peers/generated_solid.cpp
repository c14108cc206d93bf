// Generated C++ on 3-G-maps: a block of cubes.
#include "solid.h"
#include "tests/bench/peers/block.h"
#include "tests/bench/peers/own.h"

namespace jrule::bench {

namespace {

using solid::Solid;

/// Cube number c has the darts 48 c to 48 c + 47, in the same order in each.
constexpr Dart cube_darts = 48;

Solid build() {
  Solid solid;
  for_each_cube([&](double x, double y, double z) {
    auto const base = solid::square(solid, Point3{x, y, z}, Vec3{1, 0, 0}, Vec3{0, 1, 0});
    expect(base);
    expect(solid::extrude(solid, base->a0, Vec3{0, 0, 1}));
  });
  return solid;
}

/// The darts of the first cube that are glued: along each axis one of the far face, and the one of the near face of the
/// next cube that it meets.
std::array<std::pair<Dart, Dart>, 3> glued_darts(Solid const& solid) {
  Map const& map = solid.map();
  auto const coordinate = [](Point3 p, std::size_t axis) { return axis == 0 ? p.x : axis == 1 ? p.y : p.z; };
  // All darts of a face at that height along the axis?
  auto const lies_at = [&](Dart d, std::size_t axis, double height) {
    for (Dart const member : orbit(map, orbit_of_dimensions({0, 1}), d)) {
      if (coordinate(solid.position(member), axis) != height) return false;
    }
    return true;
  };
  std::array<std::pair<Dart, Dart>, 3> result{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    Vec3 const along{axis == 0 ? 1.0 : 0.0, axis == 1 ? 1.0 : 0.0, axis == 2 ? 1.0 : 0.0};
    Dart far = 0, near = 0;
    while (!lies_at(far, axis, 1)) ++far;
    while (!lies_at(near, axis, 0) || solid.position(near) + along != solid.position(far) ||
           solid.position(map.target(near, 0)) + along != solid.position(map.target(far, 0))) {
      ++near;
    }
    result[axis] = {far, near};
  }
  return result;
}

Solid& sew(Solid& solid) {
  auto const glued = glued_darts(solid);
  for_each_contact([&](std::size_t cube, std::size_t neighbour, std::size_t axis) {
    expect(solid::sew_faces(solid, static_cast<Dart>(cube) * cube_darts + glued[axis].first,
                            static_cast<Dart>(neighbour) * cube_darts + glued[axis].second));
  });
  return solid;
}

}  // namespace

void enter_generated_solid(Contest& contest) {
  auto const counted = [](Solid const& solid, Row const& row) { return count_cells(solid.map(), row); };
  // Copies of one block, not sewn or sewn.
  Originals<Map> const originals;
  auto const prepare = [originals](bool sewn) {
    return [=](Row const&) {
      Map const& map = originals(sewn ? "sewn" : "built", [&] {
        Solid solid = build();
        if (sewn) sew(solid);
        return solid.map();
      });
      auto solid = Solid::from_map(map);
      expect(solid);
      return std::move(*solid);
    };
  };
  contest.enter(
      ours, 4, Work::build_block, [](Row const&) { return 0; }, [](int) { return build(); }, counted);
  contest.enter(
      ours, 4, Work::sew_block, prepare(false), [](Solid& s) -> Solid& { return sew(s); }, counted);
  contest.enter(
      ours, 4, Work::check_block, prepare(true),
      [](Solid& s) -> Solid& {
        if (auto const violation = find_violation(s.map())) throw std::runtime_error(violation->text);
        return s;
      },
      counted);
  contest.enter(
      ours, 4, Work::triangulate_block, prepare(true),
      [](Solid& s) -> Solid& {
        expect(solid::triangulate_faces_everywhere(s));
        return s;
      },
      counted);
}

}  // namespace jrule::bench
