#!/usr/bin/env bash
# A tour: rules are checked, one refines a mesh, and wrong ones are refused. JRULE_BUILD is the build folder.
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd -P)"
jrule="${JRULE_BUILD:-$here/../../build}/compiler/driver/jrule"
out="${JRULE_DEMO_OUT:-$here/out}"
mkdir -p "$out"
cd "$here"

show() {
  printf '\n$ jrule'
  printf ' %q' "$@"
  printf '\n'
  "$jrule" "$@"
}

echo "Rules for surfaces, written as text and proved never to break a map:"
show check surface.jrule halfedges.jrule

echo
echo "The Stanford bunny, each of its triangles split into three quads:"
show apply surface.jrule:quad_subdivision --in ../data/bunny.obj --out "$out/bunny-quads.obj" --picture "$out/bunny-quads.svg"
show info "$out/bunny-quads.obj"

echo
echo "A rule is applied only where it matches: a cone needs a face whose edges are free, and the bunny has none."
if show apply surface.jrule:cone --in ../data/bunny.obj --out "$out/cone.obj" --at face:0 apex=0,0,1; then
  echo "demo: the cone should have been refused" >&2
  exit 1
fi

echo
echo "Wrong rules are refused before anything is run:"
if show check wrong.jrule; then
  echo "demo: wrong.jrule should have been refused" >&2
  exit 1
fi

echo
echo "Written: $out/bunny-quads.obj and its picture $out/bunny-quads.svg"
