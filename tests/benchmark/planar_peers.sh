#!/bin/sh
# SPDX-License-Identifier: GPL-2.0-or-later
# Other programs, those of them that are installed: LAMMPS's rigid/small in two dimensions (`lmp`) from the
# bed at rest of beds.sh, beside run_style verlet/planar; and another binary of stock LIGGGHTS (`liggghts`)
# beside ours, with the built-in multisphere: is ours a fair baseline?
#
#   tests/benchmark/planar_peers.sh BUILD-FOLDER [ROUNDS]
#
# Writes BUILD-FOLDER/benchmark/planar_peers.json.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
build=$(cd "$1" && pwd)
rounds=${2:-5}
work=$build/benchmark/planar_peers
bed=$build/benchmark/beds/ar5
export OMPI_MCA_ess_singleton_isolated=1
"$here/beds.sh" "$build"
mkdir -p "$work"
cd "$work"
rm -f times.txt

# NAME COMMAND …: adds the ns per sphere and step of its last run
clock() {
  name=$1
  shift
  taskset -c 1 "$@" > run.out 2>&1 || { tail -3 run.out; exit 1; }
  # shellcheck disable=SC2016  # awk's
  awk -v name="$name" '/^Loop time/ { time = $4; steps = $9; spheres = $12 }
    END { print name, time / steps / spheres * 1e9 }' run.out >> times.txt
}

"$here/bed_data.sh" "$bed" > bed.data

round=0
while [ $round -lt "$rounds" ]; do
  clock planar "$build/bin/liggghts" -in "$here/in.steps" -var method planar \
    -var start "$bed/restart/deposition.end.restart" -var steps 4000
  if command -v lmp > lmp.path; then
    for skin in 1e-4 3e-4 1e-3; do clock lmp_$skin lmp -in "$here/in.lammps" -var skin $skin; done
  fi
  if command -v liggghts > liggghts.path; then
    clock stock_there liggghts -in "$here/in.stock"
    clock stock_here "$build/bin/liggghts" -in "$here/in.stock"
  fi
  round=$((round + 1))
done
sort -k1,1 -k2,2g times.txt | awk -v file="$build/benchmark/planar_peers.json" "$(cat "$here/medians.awk")"'
  END {
    for (m in count) {
      printf "%-12s %8.2f ns per sphere and step, spread %3.0f %%\n", m, median(m), 100 * spread(m)
      if (m ~ /^lmp/ && (best == "" || median(m) < median(best))) best = m
    }
    print "[" > file
    if (best != "") print pair("rest, LAMMPS " best " over planar", best, "planar") ("stock_here" in count ? "," : "") > file
    if ("stock_here" in count) print pair("built-in multisphere, installed liggghts over ours", "stock_there", "stock_here") > file
    print "]" > file
  }'
