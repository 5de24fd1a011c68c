#!/bin/sh
# SPDX-License-Identifier: GPL-2.0-or-later
# The paper's deposition, 9000 rods of AR = 5, with run_style verlet/planar on one core, from the first line
# to rest, insertion and output included; and what the built-in multisphere would take for the same steps,
# composed of its measured times per sphere and step, falling and at rest (planar_engine.sh), and the number
# of particles in each step.
#
#   tests/benchmark/planar_deposition.sh BUILD-FOLDER
#
# The deposition is run once (half an hour to one). Writes BUILD-FOLDER/benchmark/planar_deposition.json.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
build=$(cd "$1" && pwd)
out=$build/benchmark/planar_deposition
times=$build/benchmark/planar_engine
export OMPI_MCA_ess_singleton_isolated=1
for case in rest falling; do
  [ -e "$times/$case.times" ] || "$here/planar_engine.sh" "$build" 5 $case
done
if [ ! -e "$out/result.json" ]; then
  rm -rf "$out"
  mkdir -p "$build/benchmark"
  "$here/core_time.sh" stdbuf -oL "$build/bin/liggghts" -in "$here/../../inputs/deposition/in.deposition" \
    -var engine planar -var output_interval 10 -var restart_interval 10 -var out "$out" > "$out.seconds"
  mv "$out.seconds" "$out/seconds"
fi

# The built-in's smallest median over its skins, ns per sphere and step.
builtin_time() {
  sort -k1,1 -k2,2g "$times/$1.times" | awk '/^builtin/ { v[$1, ++n[$1]] = $2 }
    END { for (m in n) { t = v[m, int((n[m] + 1) / 2)]; if (best == "" || t < best) best = t } print best }'
}
awk -F, -v seconds="$(cat "$out/seconds")" -v falling="$(builtin_time falling)" -v rest="$(builtin_time rest)" \
  -v file="$build/benchmark/planar_deposition.json" -v spheres=9 '
  NR > 1 { n = $3; steps = $1 - last; last = $1
    if (n < 9000) fall += steps * n; else still += steps * n }
  END {
    builtin = (fall * falling + still * rest) * spheres * 1e-9
    printf "deposition of 9000 rods, %d steps: %.3f core-hours; built-in, composed of %.4g ns per sphere and step while lines enter and %.4g after: %.2f core-hours, %.1f times as much\n",
           last, seconds / 3600, falling, rest, builtin / 3600, builtin / seconds
    printf "[\n  {\"name\": \"deposition of 9000 rods, built-in (composed) over planar\", \"ratio\": %.3g, \"core_hours\": [%.4g, %.4g]}\n]\n",
           builtin / seconds, builtin / 3600, seconds / 3600 > file
  }' "$out/energies.csv"
