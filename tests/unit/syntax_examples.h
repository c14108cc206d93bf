// Source texts that the tests of the parser and of the layout share.
#pragma once

#include <string_view>

namespace jrule::tests {

inline constexpr std::string_view surface_example = R"(/// Surfaces in space.
modeler Surface on gmap(2) {
  embedding position : <1,2> -> Point3;
  embedding color    : <0,1> -> Color { default Color(0.8, 0.8, 0.8); merge mean; }
}

/// Splits every n-gon of a surface into n quads (paper, Fig. 29).
rule quad_subdivision on Surface {
  left  { hook a <0,1,2>; }
  right {
    a <_,1,2>;
    b <_,_,2> { position = mean(<0>(a).position); }  // middle of the edge
    c <2,_,_>;
    d <2,1,_> { position = mean(<0,1>(a).position); }  // centre of the face
    a -0- b -1- c -0- d;
  }
}

/// Raises a cone on an isolated face (paper, Fig. 32).
rule cone(apex: Point3) on Surface {
  left  { hook a <0,1>;  a -2- a; }
  right {
    a; b <0,_>; c <_,2>; d <1,2> { position = apex; }
    a -2- b -1- c -0- d;
  }
}

/// Glues two free edges.
rule sew2 on Surface {
  left  { hook a <0>; hook b <0>; a -2- a; b -2- b; }
  right { a { position = midpoint(a.position, b.position); } b; a -2- b; }
}
)";

inline constexpr std::string_view halfedges_example =
    R"(modeler Halfedges on omap(2) { embedding position : vertex -> Point3; }

rule quad_subdivision on Halfedges {
  left  { hook a <1,2>; }
  right {
    a <_,_>; b; c; d;
    a -1-> c;  c -1[~1]-> d;  d -1-> b;  b -1[1]-> a;  // the four sides of a quad
    a -2[2]- b;  c -2- d;
  }
}
)";

inline constexpr std::string_view models_example =
    R"(model gmap(n) { dimensions 0..n; exchange (i, j) where i + 2 <= j; }  // built in
model omap(n) { dimensions 1..n; oriented 1; exchange (i, j) where i + 2 <= j; }  // built in
model dual_omap(n) { dimensions 1..n; oriented n; exchange (i, j) where i + 2 <= j; }
model closed_gmap(n) { dimensions 0..n; exchange (i, j) where i + 2 <= j; closed; }  // no arc is a loop
model mine { dimensions 0, 2..3; exchange (0,2), (1,3); }
)";

/// Every construct of the language at least once.
inline constexpr std::string_view everything_example = R"(import std.surface;
import std.volume.face;

extern type Soil in "geo/soil.hpp" as "geo::Soil";
extern fn hardness(x: Soil, at: [Point3]) -> Real in "geo/\"soil\".hpp" as "geo::hardness";

modeler Bare on gmap(3);

/// Sews two cells.
/// Of any dimension.
rule sew[i, j](k: Real = -1.5e3, all: Int) on gmap(n) {
  left  {
    hook a <0..i-2,i+2..n>;
    hook b <>;
    a -i- a;
    t <-d[w]- s <-2- r;
    a -(i-2)[2,~1]-> b -0[]- c;
    require a.x <-1 and not b.y == 2 or c.z;
    let q = a@~1.pos + a@[0,1].pos*-a@0.pos - r.c[d] / a@i.pos;
  }
  right {
    /// Carried over.
    a { position = mean(mean(<0,1>(f).position) for f in <1,2>(a) by <1>); }
    b { color = if q > 1 then red else if q > 2 then green else blue; };
    k <_,~1,[2,~1],~i+2,0..n>;
  }
}

operation house(side: Real = 1.0) on Bare -> Dart {
  let base = square(side);  // a rule call returns the darts of its right nodes
  let first = cone(base.a, apex: Point3(0, 0, -side));
  for e in connected(base.a) by <0,2,3> { round(e); }
  if count(<0,1>(base.a) by <0>) == 4 {
    min = max;
  } else if any(cell(i)(base.a).flag) {
    fail "no \\ \"face\"\n";
  } else {
    return;
  }
  apply_all sew[i-2, 3](a, b) on vertex(base.a);
  try { sew[2](a, b); } else { while not (true and false) { r.c[d] = (1 + 2) * 3; } }
  return base.a;
}
)";

}  // namespace jrule::tests
