#!/usr/bin/env bash
# The house of the paper's Fig. 31, step by step, each with its picture. JRULE_BUILD is the build folder.
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd -P)"
jrule="${JRULE_BUILD:-$here/../../build}/compiler/driver/jrule"
out="${JRULE_HOUSE_OUT:-$here/out}"
mkdir -p "$out"

for step in square tent roof house; do
  "$jrule" run "$here/house.jrule:$step" --out "$out/$step.obj" --picture "$out/$step.svg"
done
echo "Written: $out/house.obj, and a picture of each step beside it"
