#!/usr/bin/env bash
# A tissue that grows from one cell, with a picture every six steps. JRULE_BUILD is the build folder.
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd -P)"
jrule="${JRULE_BUILD:-$here/../../build}/compiler/driver/jrule"
out="${JRULE_GROWTH_OUT:-$here/out}"
mkdir -p "$out"

for steps in 0 6 12 18 24; do
  "$jrule" run "$here/growth.jrule:grow" --out "$out/$steps.jmap" --picture "$out/$steps.svg" steps=$steps
done
echo "Written: $out/24.jmap, and a picture every six steps beside it"
