#!/usr/bin/env bash
# A landscape, step by step, each with its picture. JRULE_BUILD is the build folder.
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd -P)"
jrule="${JRULE_BUILD:-$here/../../build}/compiler/driver/jrule"
out="${JRULE_TERRAIN_OUT:-$here/out}"
mkdir -p "$out"

for step in plain hills landscape; do
  "$jrule" run "$here/terrain.jrule:$step" --out "$out/$step.obj" --picture "$out/$step.svg"
done
echo "Written: $out/landscape.obj, and a picture of each step beside it"
