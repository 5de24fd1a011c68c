#!/bin/sh
# SPDX-License-Identifier: GPL-2.0-or-later
# Time of a step of run_style verlet/planar against the built-in multisphere and the sphere-level
# multisphere/ab: whole decks from the same settled bed, one core, in turns.
#
#   tests/benchmark/planar_engine.sh BUILD-FOLDER [rounds]
#
# The bed, 1500 rods of AR = 5 settled by the built-in, is made once (some minutes). The built-in
# gets the best of three skins. Prints ns per sphere and step and adds the ratios to
# BUILD-FOLDER/benchmark/benchmark.json.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
build=$(cd "$1" && pwd)
rounds=${2:-5}
liggghts=$build/bin/liggghts
out=$build/benchmark
bed=$out/builtin_bed
export OMPI_MCA_ess_singleton_isolated=1
mkdir -p "$out"
if [ ! -e "$bed/result.json" ]; then
  rm -rf "$bed"
  stdbuf -oL "$liggghts" -in "$here/../../inputs/deposition/in.deposition" -var integrator builtin \
    -var particles 1500 -var particles_per_line 27 -var width_in_lengths 30 -var line_fall 0.0165 \
    -var container_height 0.4 -var timestep 2.2e-5 -var relaxation_ratio 1e-7 \
    -var restart_interval 100 -var output_interval 100 -var out "$bed"
fi

work=$out/planar_engine
mkdir -p "$work"
cd "$work"
# name, deck variables
methods="builtin_1e-4|builtin|1e-4|yes builtin_3e-4|builtin|3e-4|yes builtin_1e-3|builtin|1e-3|yes \
spheres_events|spheres|3e-4|yes spheres_plain|spheres|3e-4|no \
planar_events|planar|3e-4|yes planar_plain|planar|3e-4|no"
: > times.txt
round=0
while [ $round -lt "$rounds" ]; do
  for entry in $methods; do
    IFS='|' read -r name method skin events <<EOF
$entry
EOF
    steps=2000
    if [ "$method" = planar ]; then steps=10000; fi
    taskset -c 1 "$liggghts" -in "$here/in.planar_engine" -var start "$bed/restart/deposition.end.restart" \
      -var width 0.45 -var method "$method" -var skin "$skin" -var events "$events" -var steps $steps \
      > "$name.out" 2>&1 || { tail -3 "$name.out"; exit 1; }
    awk -v name="$name" '/^Loop time/ { t = $4; n = $9; a = $12 } END { print name, t / n / a * 1e9 }' \
      "$name.out" >> times.txt
  done
  round=$((round + 1))
done

# Medians and spread (largest over smallest, less 1), ns per sphere and step; ratios of medians.
sort -k1,1 -k2,2g times.txt | awk -v file="$out/benchmark.json" '
  { if ($1 != last) { names[++k] = $1; last = $1 } v[$1, ++count[$1]] = $2 }
  function median(name) { return v[name, int((count[name] + 1) / 2)] }
  function spread(name) { return v[name, count[name]] / v[name, 1] - 1 }
  function entry(name, over, under) {
    return sprintf("  {\"name\": \"%s\", \"ratio\": %.3g, \"medians_ns_per_sphere_and_step\": [%.4g, %.4g], \"spread\": [%.2g, %.2g]}",
                   name, median(over) / median(under), median(over), median(under), spread(over), spread(under))
  }
  END {
    best = "builtin_1e-4"
    for (i = 1; i <= k; ++i) {
      printf "%-16s %8.2f ns per sphere and step, spread %.0f %%\n", names[i], median(names[i]), 100 * spread(names[i])
      if (names[i] ~ /^builtin/ && median(names[i]) < median(best)) best = names[i]
    }
    print "["                                                                          > file
    print entry("planar engine at rest, over built-in at best skin", best, "planar_events") ","       > file
    print entry("planar engine without events at rest, over built-in at best skin", best, "planar_plain") "," > file
    print entry("planar engine at rest, over sphere level", "spheres_events", "planar_events") ","    > file
    print entry("planar engine without events at rest, over sphere level", "spheres_plain", "planar_plain") > file
    print "]"                                                                          > file
    close(file)
    while ((getline line < file) > 0) print line
  }'
